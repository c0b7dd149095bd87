// Header: compiler/checks/run_checks.hpp. Test: tests/compiler/checks/run_checks_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/checks/run_checks.hpp"

#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/checks/code_check.hpp"
#include "compiler/checks/report_decisions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace director::checks {

using dsl::Diagnostic;

namespace {

/// A finding in C++ has a note at the place in the YAML: that is the place that an `allow` can cover.
bool covers(const Allowance& allowance, const Diagnostic& finding) {
  if (allowance.id.value != finding.id || finding.level == dsl::Level::error) return false;
  if (allowance.scope.contains(finding.span)) return true;
  const Registered* check = find_registered(finding.id);
  return check != nullptr && check->read_code != nullptr &&
         std::any_of(finding.notes.begin(), finding.notes.end(),
                     [&](const dsl::Note& note) { return allowance.scope.contains(note.span); });
}

/// Whether it is for `verify`, whose findings depend on the C++, or for `--explore`.
bool is_for_others(const Allowance& allowance) {
  const Registered* check = find_registered(allowance.id.value);
  if (check == nullptr || level_of(*check) == dsl::Level::error) return false;
  return check->read_code != nullptr || check->id == "never_runs";
}

/// Moves what the allowances cover to `allowed`, and marks those that covered something.
void move_covered(const Model& model, std::vector<Diagnostic>& findings, std::vector<Diagnostic>& allowed,
                  std::vector<bool>& used) {
  const auto is_reported = [&](const Diagnostic& finding) {
    bool covered = false;
    for (std::size_t i = 0; i < model.allowances.size(); ++i) {
      if (!covers(model.allowances[i], finding)) continue;
      used[i] = true;
      covered = true;
    }
    return !covered;
  };
  const auto first = std::stable_partition(findings.begin(), findings.end(), is_reported);
  std::move(first, findings.end(), std::back_inserter(allowed));
  findings.erase(first, findings.end());
}

/// Whether another warning is about the same element. It may be the reason why nothing else was found there.
bool is_suppressed(const Allowance& allowance, const std::vector<Diagnostic>& findings) {
  return std::any_of(findings.begin(), findings.end(), [&](const Diagnostic& finding) {
    const auto is_here = [&](const dsl::Note& note) { return allowance.scope.contains(note.span); };
    return finding.level == dsl::Level::warning && finding.id != allowance.id.value &&
           (allowance.scope.contains(finding.span) || std::any_of(finding.notes.begin(), finding.notes.end(), is_here));
  });
}

bool names_error(const Allowance& allowance) {
  const Registered* check = find_registered(allowance.id.value);
  return check != nullptr && level_of(*check) == dsl::Level::error;
}

Diagnostic unused(const Allowance& allowance) {
  const std::string& id = allowance.id.value;
  Diagnostic finding{"unused_allow", dsl::Level::warning, allowance.id.span, {}, {}, {}};
  if (names_error(allowance)) {
    finding.message = fmt::format("`{}` is an error, which no `allow` covers", id);
    finding.help = "mend what it reports and remove this";
  } else {
    finding.message = fmt::format("`{}` finds nothing here that could be allowed", id);
    finding.help = "remove it, so that the next one does not go unseen";
  }
  return finding;
}

/// One finding for all questions that the searches of a run have left open.
Diagnostic not_decided(const Budget& budget) {
  std::vector<OpenQuestion> open = budget.open();
  std::stable_sort(open.begin(), open.end(),
                   [](const OpenQuestion& a, const OpenQuestion& b) { return a.span < b.span; });
  const std::size_t more = open.size() - 1;
  Diagnostic finding{"not_decided", dsl::Level::warning, open.front().span, {}, {}, {}};
  finding.message = fmt::format("{} was not decided{}", open.front().words,
                                more == 0   ? ""
                                : more == 1 ? ", nor one other question"
                                            : fmt::format(", nor {} other questions", more));
  for (std::size_t i = 1; i < open.size(); ++i)
    finding.notes.push_back({open[i].span, fmt::format("nor {}", open[i].words)});
  shorten_list(finding.notes);
  finding.help = "with fewer alternatives it would be: fewer providers of one group, or conditions on fewer states";
  return finding;
}

/// Adds the notes that only `more` has, each before the next note that both have, but not inside a chain of notes.
void add_notes(std::vector<dsl::Note>& notes, const std::vector<dsl::Note>& more) {
  auto next = more.begin();
  while (next != more.end()) {
    auto place = notes.end();
    std::vector<dsl::Note> added;
    for (; next != more.end() && place == notes.end(); ++next) {
      place = std::find(notes.begin(), notes.end(), *next);
      if (place == notes.end()) added.push_back({next->span, next->message});
    }
    const bool within_chain = place != notes.end() && place->link == dsl::Note::Link::next;
    notes.insert(within_chain ? notes.end() : place, added.begin(), added.end());
  }
}

/// Merges findings with the same place and message, which differ in their notes only.
std::vector<Diagnostic> merge_alike(std::vector<Diagnostic> findings) {
  std::vector<Diagnostic> out;
  std::map<std::tuple<dsl::Span, std::string>, std::size_t> known;
  for (Diagnostic& finding : findings) {
    const auto [at, is_new] = known.try_emplace({finding.span, finding.message}, out.size());
    if (is_new) {
      out.push_back(std::move(finding));
      continue;
    }
    Diagnostic& first = out[at->second];
    add_notes(first.notes, finding.notes);
    for (const dsl::Span& span : finding.rules_out) first.rules_out.push_back(span);
    for (const dsl::Span& span : finding.rules_out_together) first.rules_out_together.push_back(span);
  }
  return out;
}

/// Whether any finding of it would be reported.
bool is_wanted(const Registered& check, const Selection& selection, const Model& model) {
  if (selection.only_errors) return level_of(check) == dsl::Level::error;
  return level_of(check) != dsl::Level::lint || selection.every_lint || selection.lints.contains(check.id) ||
         std::any_of(model.allowances.begin(), model.allowances.end(),
                     [&](const Allowance& allowance) { return allowance.id.value == check.id; });
}

} // namespace

const Registered* find_registered(std::string_view id) {
  for (const Registered& check : registered()) {
    if (check.id == id) return &check;
  }
  return nullptr;
}

std::vector<Diagnostic> run_checks(const Model& model, const Graph& graph, const Facts& facts,
                                   const Selection& selection) {
  const Shared shared(model, graph, facts);
  const Conflicts conflicts(model, graph, facts, shared);
  std::vector<Diagnostic> all;
  for (const Registered& check : registered()) {
    if (check.run == nullptr || !is_wanted(check, selection, model)) continue;
    Findings findings(check.id, level_of(check));
    check.run(conflicts.input(), findings);
    for (Diagnostic& finding : merge_alike(findings.take())) all.push_back(std::move(finding));
  }
  if (!selection.only_errors) {
    for (Diagnostic& finding : report_decisions(conflicts.input(), all)) all.push_back(std::move(finding));
    if (!shared.budget().open().empty()) all.push_back(not_decided(shared.budget()));
  }
  dsl::sort_by_place(all);
  return all;
}

std::vector<Diagnostic> run_code_checks(const CodeInput& input) {
  std::vector<Diagnostic> all;
  for (const Registered& check : registered()) {
    if (check.read_code == nullptr) continue;
    Findings findings(check.id, level_of(check));
    check.read_code(input, findings);
    for (Diagnostic& finding : findings.take()) all.push_back(std::move(finding));
  }
  dsl::sort_by_place(all);
  return all;
}

Sifted apply_allowances(const Model& model, std::vector<Diagnostic> all, bool all_checks_ran) {
  Sifted out{std::move(all), {}};
  std::vector<Diagnostic>& findings = out.reported;
  std::vector<bool> used(model.allowances.size(), false);
  move_covered(model, findings, out.allowed, used);
  if (!all_checks_ran) return out;
  // An error may suppress a warning anywhere.
  const bool errors = dsl::has_errors(findings);
  // An `allow: [unused_allow]` is applied last: only now is it known what it covers.
  std::vector<Diagnostic> leftover;
  const auto collect = [&](bool last) {
    for (std::size_t i = 0; i < used.size(); ++i) {
      const Allowance& allowance = model.allowances[i];
      if (used[i] || is_for_others(allowance) || (allowance.id.value == "unused_allow") != last) continue;
      const bool may_return = errors || is_suppressed(allowance, findings);
      // Another behaviour that imports the file may need it.
      const bool is_imported = allowance.id.span.file != model.name_span.file;
      if ((!may_return && !is_imported) || names_error(allowance)) leftover.push_back(unused(allowance));
    }
  };
  collect(false);
  move_covered(model, leftover, out.allowed, used);
  collect(true);
  findings.insert(findings.end(), leftover.begin(), leftover.end());
  dsl::sort_by_place(findings);
  return out;
}

std::vector<Diagnostic> apply_selection(const Selection& selection, std::vector<Diagnostic> findings) {
  const auto is_unwanted = [&](const Diagnostic& finding) {
    if (finding.level == dsl::Level::error) return false;
    if (selection.only_errors || selection.allowed.count(finding.id) != 0) return true;
    return finding.level == dsl::Level::lint && !selection.every_lint && selection.lints.count(finding.id) == 0;
  };
  findings.erase(std::remove_if(findings.begin(), findings.end(), is_unwanted), findings.end());
  for (Diagnostic& finding : findings) {
    shorten(finding.notes);
    const bool is_warning = finding.level == dsl::Level::warning;
    if ((is_warning && selection.every_warning_is_error) || selection.warnings_as_errors.count(finding.id) != 0)
      finding.level = dsl::Level::error;
  }
  return findings;
}

} // namespace director::checks
