// Header: compiler/analysis/code/code_words.hpp. Test: compiler/checks/pack_never_requested.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/code/code_words.hpp"

#include <algorithm>

namespace director::analysis {

bool is_pack(const CodeWord& word, const Pack& pack) {
  return word.kind == CodeWord::Kind::pack && word.pack == pack.name;
}

bool requests_pack(const Body& body, const Pack& pack) {
  return std::any_of(body.possible.begin(), body.possible.end(),
                     [&](const CodeWord* word) { return is_pack(*word, pack); });
}

bool gives(const CodeInput& input, const CodeWord& word, GroupId task) {
  return std::any_of(word.tasks.begin(), word.tasks.end(), [&](const std::string& name) {
    const auto at = input.names.tasks.find(name);
    return at != input.names.tasks.end() && at->second == task;
  });
}

bool only_keeps_going(const Body& body) {
  bool keeps = false;
  for (const CodeWord* word : body.possible) {
    if (word->kind == CodeWord::Kind::set) continue;
    if (word->kind != CodeWord::Kind::keep) return false;
    keeps = true;
  }
  return keeps;
}

} // namespace director::analysis
