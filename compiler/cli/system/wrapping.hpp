#pragma once
// SPDX-License-Identifier: MIT
// A stream to a terminal that breaks long lines between words; the terminal would break them anywhere.

#include <cstddef>
#include <streambuf>
#include <string>
#include <string_view>

namespace director::compiler::cli {

/// A line, or several if it is wider than that; the continuation is indented further. Lines with source (`   12 | when:
/// …`) are not broken, as they are shortened already. Without a line break at the end.
std::string wrapped_line(std::string_view line, std::size_t width);

class WrappingBuffer final : public std::streambuf {
public:
  /// `to` must outlive this.
  WrappingBuffer(std::streambuf& to, std::size_t width) : to_(to), width_(width) {}
  WrappingBuffer(const WrappingBuffer&) = delete;
  WrappingBuffer& operator=(const WrappingBuffer&) = delete;
  ~WrappingBuffer() override { sync(); }

protected:
  int_type overflow(int_type letter) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  /// Prints an incomplete line, such as that of progress, as it is.
  int sync() override;

private:
  bool put(std::string_view text);

  std::streambuf& to_;
  std::size_t width_;
  std::string line_;       ///< so far
  bool has_begun_ = false; ///< its beginning has been printed
};

} // namespace director::compiler::cli
