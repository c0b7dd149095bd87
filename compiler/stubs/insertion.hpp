#pragma once
// SPDX-License-Identifier: MIT
// Text that is inserted into a user's file. By design such a file cannot be changed otherwise: nothing can be replaced
// or removed.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler::stubs {

struct Insertion {
  std::string path;
  std::size_t offset = 0; ///< in bytes, of the file as it is; at most its size
  std::string text;
  bool operator==(const Insertion&) const = default;
};

/// path -> content.
using Texts = std::map<std::string, std::string>;

/// By path and offset; those at one offset stay in their order and become one.
std::vector<Insertion> joined(std::vector<Insertion> insertions);

/// The insertions of each file together. `all` is joined.
std::vector<std::vector<Insertion>> by_file(const std::vector<Insertion>& insertions);

/// The places of the insertions in the new text, each with a text; in order of the joined insertions of this file.
struct Range {
  std::size_t begin = 0, end = 0;
  bool operator==(const Range&) const = default;
};
struct Applied {
  std::string text;
  std::vector<Range> ranges;
};

/// Those of one file, joined.
Applied insert_into(std::string_view text, const std::vector<Insertion>& insertions);

/// The input of insert_into().
std::string without(const Applied& applied);

/// Where a byte of the new text comes from.
struct Origin {
  std::size_t offset = 0; ///< in the text as it was; of an inserted byte: where that is inserted
  bool is_inserted = false;
  bool operator==(const Origin&) const = default;
};
Origin origin_of(const Applied& applied, std::size_t offset);

/// A replacement of bytes of the new text, from a formatter.
struct Replacement {
  std::size_t offset = 0, length = 0;
  std::string text;
};

/// The same insertions, formatted: only replacements within the insertions are applied.
std::vector<Insertion> formatted(const std::vector<Insertion>& insertions, const Applied& applied,
                                 const std::vector<Replacement>& replacements);

/// A unified diff that `patch -p1` takes. `insertions` of one file, joined.
std::string diff(const std::string& path, std::string_view text, const std::vector<Insertion>& insertions);

/// The same for a file that is new.
std::string diff_of_new(const std::string& path, std::string_view text);

} // namespace director::compiler::stubs
