#pragma once
// SPDX-License-Identifier: MIT
// A stream to a terminal that breaks long lines between words; the terminal would break them anywhere.

#include <cstddef>
#include <streambuf>
#include <string>
#include <string_view>

namespace director::compiler::cli {

/// A line, or several where it is wider than that; what follows stands further right than it begins. Lines that show
/// source (`   12 | when: …`) stay whole, they are cut already. Without a line break at the end.
std::string wrapped_line(std::string_view line, std::size_t width);

class WrappingBuffer final : public std::streambuf {
public:
  /// `to` must live longer.
  WrappingBuffer(std::streambuf& to, std::size_t width) : to_(to), width_(width) {}
  WrappingBuffer(const WrappingBuffer&) = delete;
  WrappingBuffer& operator=(const WrappingBuffer&) = delete;
  ~WrappingBuffer() override { sync(); }

protected:
  int_type overflow(int_type letter) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  /// A line that has not ended, as of progress, is shown as it is.
  int sync() override;

private:
  bool put(std::string_view text);

  std::streambuf& to_;
  std::size_t width_;
  std::string line_;       ///< so far
  bool has_begun_ = false; ///< its beginning has been shown
};

} // namespace director::compiler::cli
