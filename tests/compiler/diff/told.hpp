#pragma once
// SPDX-License-Identifier: MIT
// What `directorc diff` reports of two behaviours, as text.

#include "compiler/diff/diff.hpp"
#include "dsl/source/file_access.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace director::tests {

struct Files {
  std::string main, other;
};

/// `other` is what `main` may import as `parts.yaml`.
inline std::vector<compiler::BehaviourChange> changes(const Files& before, const Files& after) {
  dsl::MemoryFiles files;
  files.add("old/robot.yaml", "behaviour: robot\nlanguage: 1\n" + before.main);
  files.add("old/parts.yaml", "behaviour: parts\nlanguage: 1\n" + before.other);
  files.add("new/robot.yaml", "behaviour: robot\nlanguage: 1\n" + after.main);
  files.add("new/parts.yaml", "behaviour: parts\nlanguage: 1\n" + after.other);
  dsl::Sources sources;
  const compiler::Checked was = compiler::check("old/robot.yaml", files, sources),
                          is = compiler::check("new/robot.yaml", files, sources);
  return compiler::find_changes(was, is);
}

/// Kind and message of each change, a line each.
inline std::string told(const Files& before, const Files& after) {
  std::string out;
  for (const compiler::BehaviourChange& change : changes(before, after)) {
    CHECK((change.before || change.after));
    out += std::string(compiler::page_of(change.kind).id) + ": " + change.message + "\n";
    if (!change.hint.empty()) out += "hint: " + change.hint + "\n";
  }
  return out;
}

inline std::string told(const std::string& before, const std::string& after) {
  return told(Files{before, {}}, {after, {}});
}

} // namespace director::tests
