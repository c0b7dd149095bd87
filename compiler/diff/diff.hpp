#pragma once
// SPDX-License-Identifier: MIT
// What changes from one behaviour to another: changes of meaning, the most dangerous first. It looks at models and at
// what the analyses and the engine say of them, never at text: comments, moves between files, other spellings of the
// same and the order of what has none are no changes.

#include "compiler/base/json.hpp"
#include "compiler/diff/change.hpp"
#include "compiler/emit/findings_sarif.hpp"
#include "compiler/pipeline.hpp"
#include "dsl/source_file.hpp"

#include <set>
#include <string>
#include <vector>

namespace director::compiler {

/// The places of both are in one set of sources. `played`: what was played of transitions, for whoever asks.
std::vector<BehaviourChange> find_changes(const Checked& before, const Checked& after,
                                          TransitionsPlayed* played = nullptr);

/// Which kinds are not to be: those that are named; `all` and what breaks C++ are asked for by themselves.
struct Breaking {
  std::set<ChangeKind> kinds;
  bool code = false; ///< also whatever breaks C++ that was written for the old behaviour
  bool has(const BehaviourChange& change) const {
    return kinds.count(change.kind) != 0 || (code && change.breaks_code);
  }
};

/// For people: a heading for each kind, and each change with its places.
std::string changes_text(const std::vector<BehaviourChange>& changes, const Breaking& breaking,
                         const dsl::Sources& sources);
/// As schemas/diff.schema.json says.
Json changes_json(const std::vector<BehaviourChange>& changes, const Breaking& breaking, const dsl::Sources& sources);
/// As results of SARIF: what breaks is an error, all else a warning.
Json changes_sarif(const std::vector<BehaviourChange>& changes, const Breaking& breaking, const dsl::Sources& sources);

} // namespace director::compiler
