// Header: compiler/checks/check.hpp. Test: compiler/checks/push_held_by_outside.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace director::checks {

namespace {

/// Whether every condition of it is promised by a provider, so that the order of the two would decide.
bool is_free_of_outside(const Input& input, ProviderId id) {
  const std::vector<ConditionUse>& when = input.model.providers[id].when;
  return std::none_of(when.begin(), when.end(), [&](const ConditionUse& use) {
    return input.shared.causers()[use.id].empty() && !input.facts.holds_always(input.model, use.id, Region{});
  });
}

/// The conditions from outside that have to be false: of the first way, or of those that would cause its own.
std::vector<std::string> outside_of(const Model& model, const HeldPush& held) {
  std::vector<std::string> out;
  if (held.hopes.empty()) out.push_back(name_of(model, held.outside.id));
  for (const Hope& hope : held.hopes) {
    std::string name = name_of(model, hope.outside.id);
    if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(std::move(name));
  }
  return out;
}

std::string help_of(const Input& input, const HeldPush& held) {
  const Model& model = input.model;
  const GroupId group = model.providers[held.earlier].group;
  const std::string earlier = name_of(model, held.earlier), later = name_of(model, held.later);
  std::string out;
  if (held.with != held.waits)
    out = fmt::format("make {} `apart`, so that {} does not wait for it, or ", name_of(model, held.with->target),
                      name_of(model, held.waits->target));
  // If both could run, the order would decide which of them does.
  if (held.hopes.empty() && is_free_of_outside(input, held.later) &&
      !compatible(region_of(model, model.providers[held.later].when),
                  region_of(model, model.providers[held.earlier].when)))
    out += fmt::format("put {} before {}, or ", later, earlier);
  // In a group below, the same two would wait in the same order.
  if (model.providers[held.waiter].group == group)
    return out + fmt::format("let {} only choose, by {}, and request a group for each of {} and {} that waits for what "
                             "can be caused",
                             name_of(model, group), list_of(outside_of(model, held)), earlier, later);
  return out + fmt::format("let a group that {} requests, and does not need, choose between {} and {}",
                           name_of(model, group), earlier, later);
}

} // namespace

void push_held_by_outside(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const HeldPush& held : input.conflicts.held_pushes()) {
    const std::string waits = name_of(model, held.waits->target);
    const std::vector<std::string> outside = outside_of(model, held);
    const std::string first = name_of(model, held.first), later = name_of(model, held.later);
    dsl::Diagnostic& finding = findings.add(
        held.wanted.span,
        fmt::format("while {} {} false, {} does not push {} for {}: {} comes first and waits for the outside, and {} "
                    "is not tried",
                    list_of(outside), outside.size() == 1 ? "is" : "are", waits, name_of(model, held.causer),
                    name_of(model, held.wanted.id), first, later));
    if (held.with != held.waits)
      finding.notes.push_back({held.with->span, fmt::format("{} is granted only together with {}",
                                                            name_of(model, held.with->target), waits)});
    add_chain(model, need_path(model, held.with->target, model.providers[held.first].group), finding.notes);
    finding.notes.push_back({held.outside.span, held.hopes.empty()
                                                    ? fmt::format("{} waits for this, which nothing promises", first)
                                                    : fmt::format("{} waits for this", first)});
    for (const Hope& hope : held.hopes) {
      finding.notes.push_back(causes(model, hope.causer, held.outside.id));
      finding.notes.push_back(
          {hope.outside.span, fmt::format("{} waits for this, which nothing promises", name_of(model, hope.causer))});
    }
    finding.notes.push_back({model.providers[held.later].span, fmt::format("{} needs only the push", later)});
    finding.notes.push_back(causes(model, held.causer, held.wanted.id));
    finding.help = help_of(input, held);
  }
}

} // namespace director::checks
