#pragma once
// SPDX-License-Identifier: MIT
// Parses the page of a check: its specimens and their expected findings.
//
// A specimen is a ```yaml block. A comment has the expected finding of its line (`# reported: ...`, `# note: ...`), or,
// on a line of its own, of the nearest line above that is not such a comment (`# reported above: ...`, `# note above:
// ...`); `# help: ...` may be anywhere. A message may end in the id of another check, ` [redefined_name]`. If neither
// `behaviour:` nor `language:` begins a line, both are added in front. `# file: other.yaml` begins a further file; one
// that ends in .scenario.yaml is played, and its faults are findings too.
//
// ```cpp blocks that follow belong to the specimen: the user's C++, with the same words behind `//`. The first file is
// modules.cpp unless `// file: ...` names another one.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace director::tests {

struct Expected {
  std::string file;
  std::uint32_t line = 0;
  std::string id; ///< of a finding; empty for a note
  std::string message;
  auto operator<=>(const Expected&) const = default;
};

struct Specimen {
  std::uint32_t line = 0; ///< of the page
  std::map<std::string, std::string> files;
  std::vector<Expected> findings;
  std::vector<Expected> notes;    ///< if none is written, notes are not compared
  std::vector<std::string> helps; ///< likewise
  bool has_code = false;          ///< some of its files are C++
};

struct Page {
  std::string title;
  std::vector<Specimen> reported, accepted;
};

/// The file that is checked.
inline constexpr std::string_view main_file = "example.yaml";

Page read_page(std::string_view text);

} // namespace director::tests
