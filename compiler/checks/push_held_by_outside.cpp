// Header: compiler/checks/check.hpp. Test: compiler/checks/push_held_by_outside.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/facts/waiting.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/shared/shared.hpp"
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

std::string help_of(const Input& input, const HeldPush& held) {
  const Model& model = input.model;
  const GroupId group = model.providers[held.earlier].group;
  const std::string earlier = name_of(model, held.earlier), later = name_of(model, held.later);
  std::string out;
  if (held.with != held.waits)
    out = fmt::format("make {} `apart`, so that {} does not wait for it, or ", name_of(model, held.with->target),
                      name_of(model, held.waits->target));
  // Otherwise the other one would never run.
  if (is_free_of_outside(input, held.later) && !can_always_replace(model, held.later, held.earlier))
    out += fmt::format("put {} before {}, or ", later, earlier);
  return out + fmt::format("let a group that {} requests, and does not need, choose between {} and {}",
                           name_of(model, group), earlier, later);
}

} // namespace

void push_held_by_outside(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const HeldPush& held : input.conflicts.held_pushes()) {
    const std::string waits = name_of(model, held.waits->target), outside = name_of(model, held.outside.id);
    const std::string first = name_of(model, held.first), later = name_of(model, held.later);
    dsl::Diagnostic& finding = findings.add(
        held.wanted.span,
        fmt::format("while {} is false, {} does not push {} for {}: {} comes first and waits for the outside, and {} "
                    "is not tried",
                    outside, waits, name_of(model, held.causer), name_of(model, held.wanted.id), first, later));
    if (held.with != held.waits)
      finding.notes.push_back({held.with->span, fmt::format("{} is granted only together with {}",
                                                            name_of(model, held.with->target), waits)});
    add_chain(model, need_path(model, held.with->target, model.providers[held.first].group), finding.notes);
    finding.notes.push_back({held.outside.span, fmt::format("{} waits for this, which nothing promises", first)});
    finding.notes.push_back({model.providers[held.later].span, fmt::format("{} needs only the push", later)});
    finding.notes.push_back(causes(model, held.causer, held.wanted.id));
    finding.help = help_of(input, held);
  }
}

} // namespace director::checks
