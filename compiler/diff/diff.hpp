#pragma once
// SPDX-License-Identifier: MIT
// Finds the differences between two behaviours: changes of meaning, the most dangerous first. It compares models and
// the results of analyses and the engine, never text: comments, moves between files, other spellings and an unspecified
// order are no changes.

#include "compiler/base/json.hpp"
#include "compiler/diff/change.hpp"
#include "compiler/emit/findings_sarif.hpp"
#include "compiler/pipeline.hpp"
#include "dsl/source/source_file.hpp"

#include <set>
#include <string>
#include <vector>

namespace director::compiler {

/// The places of both are in one set of sources. If both have errors in their text or their names, only the new errors
/// are changes. `played`: gets the number of played transitions.
std::vector<BehaviourChange> find_changes(const Checked& before, const Checked& after,
                                          TransitionsPlayed* played = nullptr);

/// Which kinds count as breaking: the named ones; `all` and `code` are flags of their own.
struct Breaking {
  std::set<ChangeKind> kinds;
  bool code = false; ///< also whatever breaks C++ that was written for the old behaviour
  bool has(const BehaviourChange& change) const {
    return kinds.count(change.kind) != 0 || (code && change.breaks_code);
  }
};

/// As text: a heading for each kind, and each change with its places.
std::string changes_text(const std::vector<BehaviourChange>& changes, const Breaking& breaking,
                         const dsl::Sources& sources);
/// As schemas/diff.schema.json says.
/// `compared`: both exist, without errors in text and names; otherwise only these errors are compared.
Json changes_json(const std::vector<BehaviourChange>& changes, bool compared, const Breaking& breaking,
                  const dsl::Sources& sources);
/// As SARIF: what breaks is an error, everything else a warning.
Json changes_sarif(const std::vector<BehaviourChange>& changes, const Breaking& breaking, const dsl::Sources& sources);

} // namespace director::compiler
