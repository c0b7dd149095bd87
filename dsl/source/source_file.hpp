#pragma once
// SPDX-License-Identifier: MIT
// The texts that a run has read, and lines and columns in them. Both count from 1, columns in UTF-8 bytes.

#include "dsl/source/span.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace director::dsl {

struct Place {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
  bool operator==(const Place&) const = default;
};

class SourceFile {
public:
  /// `path` as it is printed: relative to the working directory, as it was given.
  SourceFile(std::string path, std::string text);

  const std::string& path() const { return path_; }
  const std::string& text() const { return text_; }
  std::uint32_t line_count() const { return static_cast<std::uint32_t>(line_starts_.size()); }
  /// An offset behind the end counts as the end.
  Place place(std::uint32_t offset) const;
  /// Without its line break. `line` from 1; empty behind the last one.
  std::string_view line_text(std::uint32_t line) const;
  /// Offset of the first byte of the line.
  std::uint32_t line_begin(std::uint32_t line) const;

private:
  std::string path_;
  std::string text_;
  std::vector<std::uint32_t> line_starts_;
};

/// Owns the texts; references stay valid while files are added.
class Sources {
public:
  FileId add(std::string path, std::string text);
  const SourceFile& operator[](FileId id) const { return files_[id.value]; }
  std::size_t size() const { return files_.size(); }
  auto begin() const { return files_.begin(); }
  auto end() const { return files_.end(); }
  /// The text that a span covers.
  std::string_view text(const Span& span) const;

private:
  std::deque<SourceFile> files_;
};

} // namespace director::dsl
