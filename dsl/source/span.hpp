#pragma once
// SPDX-License-Identifier: MIT
// A place in a source text. Offsets are bytes from the beginning of the file; the end is exclusive.

#include <compare>
#include <cstdint>
#include <string>

namespace director::dsl {

/// Index into Sources.
struct FileId {
  std::uint32_t value = 0;
  auto operator<=>(const FileId&) const = default;
};

struct Span {
  FileId file{};
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  auto operator<=>(const Span&) const = default;
  bool contains(const Span& other) const { return file == other.file && begin <= other.begin && other.end <= end; }
};

/// A value and its place. A default has the place of the thing that it belongs to.
template <class T>
struct Located {
  T value{};
  Span span{};
  bool operator==(const Located&) const = default;
};

using Word = Located<std::string>;

} // namespace director::dsl
