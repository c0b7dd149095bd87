// Header: compiler/diff/side.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
//
// Compares what the checks find on each side. Findings are equal if their check and their text are; if nothing else has
// changed, the check is enough, as the text may name another one of two.
#include "compiler/diff/side.hpp"

#include <fmt/format.h>

#include <map>

namespace director::compiler::diff {

namespace {

using Finding = dsl::Diagnostic;

std::map<std::string, std::vector<const Finding*>> sorted(const std::vector<Finding>& findings, bool by_check) {
  std::map<std::string, std::vector<const Finding*>> out;
  for (const Finding& each : findings) {
    if (each.level != dsl::Level::lint) out[by_check ? each.id : each.id + ": " + each.message].push_back(&each);
  }
  return out;
}

/// For each kind of finding, as many of the first as there are more than in the second.
std::vector<const Finding*> more_than(const std::map<std::string, std::vector<const Finding*>>& first,
                                      const std::map<std::string, std::vector<const Finding*>>& second) {
  std::vector<const Finding*> out;
  for (const auto& [key, all] : first) {
    const auto at = second.find(key);
    for (std::size_t i = at == second.end() ? 0 : at->second.size(); i < all.size(); ++i) out.push_back(all[i]);
  }
  return out;
}

/// Whether it is proven that a thing never happens.
bool reports_never(const Finding& finding) {
  const checks::Registered* const check = checks::find_registered(finding.id);
  return check != nullptr && checks::reports_never(*check) && !checks::may_over_report(*check);
}

} // namespace

void compare_findings(const Pair& pair, bool alike, Changes& changes) {
  const auto was = sorted(pair.before.findings, alike), is = sorted(pair.after.findings, alike);
  for (const Finding* each : more_than(is, was))
    changes.add(reports_never(*each) ? ChangeKind::became_dead : ChangeKind::finding_new, each->id,
                fmt::format("{} is new: {}", name_of(each->level), each->message), {}, each->span);
  for (const Finding* each : more_than(was, is))
    changes.add(reports_never(*each) ? ChangeKind::became_reachable : ChangeKind::finding_gone, each->id,
                fmt::format("{} is gone: {}", name_of(each->level), each->message), each->span, {});
}

} // namespace director::compiler::diff
