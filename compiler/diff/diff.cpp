// Header: compiler/diff/diff.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/diff/diff.hpp"

#include "compiler/diff/side.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <map>

namespace director::compiler {

namespace diff {

namespace {

void add_errors(const Checked& checked, ChangeKind kind, Changes& changes) {
  for (const dsl::Diagnostic& finding : checked.findings) {
    if (finding.level != dsl::Level::error) continue;
    const bool is_new = kind == ChangeKind::refused;
    const std::optional<Span> place = finding.span, nowhere;
    changes.add(kind, finding.id, finding.message, is_new ? nowhere : place, is_new ? place : nowhere);
  }
}

/// What identifies an error, without its place. Messages about files have their paths, which differ between the sides:
/// then it is what the import says.
std::pair<std::string, std::string> identity_of(const Checked& checked, const dsl::Diagnostic& error) {
  for (const dsl::BehaviourSpec& file : checked.spec.files) {
    for (const dsl::ImportSpec& import : file.imports) {
      if (import.path.span == error.span) return {error.id, import.path.value};
    }
  }
  return {error.id, error.message};
}

/// The errors of `after` that `before` has not, or has fewer times.
void add_new_errors(const Checked& before, const Checked& after, Changes& changes) {
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  for (const dsl::Diagnostic& finding : before.findings) {
    if (finding.level == dsl::Level::error) ++known[identity_of(before, finding)];
  }
  for (const dsl::Diagnostic& finding : after.findings) {
    if (finding.level != dsl::Level::error) continue;
    std::size_t& left = known[identity_of(after, finding)];
    if (left == 0)
      changes.add(ChangeKind::refused, finding.id, finding.message, std::nullopt, finding.span);
    else
      --left;
  }
}

} // namespace

} // namespace diff

std::vector<BehaviourChange> find_changes(const Checked& before, const Checked& after, TransitionsPlayed* played) {
  diff::Changes changes;
  if (!before.resolved || !after.resolved) {
    if (before.resolved)
      diff::add_errors(after, ChangeKind::refused, changes);
    else if (after.resolved)
      diff::add_errors(before, ChangeKind::accepted, changes);
    else
      diff::add_new_errors(before, after, changes);
    return changes.take();
  }
  const diff::Pair pair{before, after};
  diff::compare_program(pair, changes);
  diff::compare_states(pair, changes);
  diff::compare_groups(pair, changes);
  diff::compare_requests(pair, changes);
  diff::compare_ranks(pair, changes);
  diff::compare_pushes(pair, changes);
  // Consequences of the changes. Without any change there are none: then the unspecified order of things is no change,
  // and nothing has to be computed.
  const bool alike = changes.all().empty();
  if (!alike) diff::compare_reach(pair, changes);
  const TransitionsPlayed transitions = alike ? TransitionsPlayed{} : diff::compare_transitions(pair, changes);
  if (played != nullptr) *played = transitions;
  diff::compare_findings(pair, alike, changes);
  return changes.take();
}

} // namespace director::compiler
