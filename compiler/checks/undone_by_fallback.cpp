// Header: compiler/checks/check.hpp. Test: compiler/checks/undone_by_fallback.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/rounds/fallback_rounds.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace director::checks {

namespace {

void report_fallback(const Model& model, const FallbackRound& round, Findings& findings) {
  const auto& [waits, granted, want, setting, loser, needs, taking, fallback] = round;
  std::vector<std::string> names;
  for (const GroupId need : needs) names.push_back(name_of(model, need));
  if (loser.spoilt) names.push_back(name_of(model, loser.spoilt->condition.id));
  const std::string losing = name_of(model, loser.provider), lost = list_of(names);
  const std::string set = fmt::format("{} may {} {}", name_of(model, fallback.provider),
                                      fallback.promised ? "cause" : "set", name_of(model, fallback.entry.id));
  dsl::Diagnostic& finding = findings.add(
      loser.span(), fmt::format("{} loses {} when {}, which waits for {}; instead of it {}: the two go round", losing,
                                lost, granted, name_of(model, want.condition.id), set));
  std::vector<dsl::Note> notes;
  add_chain(model, loser.down, notes);
  Taking how = taking;
  how.notes.insert(how.notes.begin(), notes.begin(), notes.end());
  add_taking(model, want, setting.note, std::move(how), finding);
  finding.notes.push_back({fallback.entry.span, set});
  const std::string keep = loser.spoilt
                               ? stay_help(model, {loser.provider, loser.spoilt->condition, {}}, loser.spoilt->values)
                               : fmt::format("let {} do without {}", losing, lost);
  finding.help = fmt::format("{}, or {}", keep, stay_help(model, waits, want, fallback.values));
}

} // namespace

void undone_by_fallback(const Input& input, Findings& findings) {
  for (const FallbackRound& round : find_fallback_rounds(input)) report_fallback(input.model, round, findings);
}

} // namespace director::checks
