// Header: compiler/analysis/facts/shadows.hpp. Test: compiler/checks/shadowed_provider.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/shadows.hpp"

#include "compiler/analysis/facts/waiting.hpp"

#include <algorithm>
#include <utility>

namespace director::analysis {

namespace {

/// A state whose missing value is reported may have it: a provider that is shadowed only without that value is not
/// reported again.
IdTable<StateId, ValueSet> corrected_values(const Model& model, const Facts& facts) {
  IdTable<StateId, ValueSet> out = facts.values;
  for (const Impossible& fault : facts.impossible) {
    if (fault.why != Impossible::Why::contradictory) out[fault.state] = model.states[fault.state].domain();
  }
  return out;
}

} // namespace

Shadows::Shadows(const Model& model, const Facts& facts, const Rivals& rivals, Budget& budget)
    : model_(model),
      facts_(facts),
      rivals_(rivals),
      budget_(budget),
      corrected_(corrected_values(model, facts)) {}

bool Shadows::is_shadowed(ProviderId id) const {
  return find_choice_here(id, rivals_.of(id), corrected_) == Covering::covered;
}

Culprits Shadows::find_culprits(ProviderId id) const {
  const auto are_enough = [&](const std::vector<Rival>& some) {
    return find_choice_here(id, some, corrected_) == Covering::covered;
  };
  const Region own = region_here(id);
  Culprits out;
  std::vector<Rival> some;
  for (const Rival& rival : rivals_.of(id)) {
    if (out.all.size() < most_left_out && are_enough({rival}))
      out.all.push_back(rival.provider);
    else if (std::any_of(rival.ways.begin(), rival.ways.end(), [&](const Region& way) { return compatible(own, way); }))
      some.push_back(rival);
  }
  if (!out.all.empty()) {
    out.each = true;
    out.others_are_enough = are_enough(some);
    add_after_rivals(id, out.all);
    return out;
  }
  // The preferred ones stay.
  for (std::size_t i = some.size(); i-- > 0 && some.size() <= most_left_out;) {
    std::vector<Rival> fewer = some;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (are_enough(fewer)) some = std::move(fewer);
  }
  for (const Rival& rival : some) out.all.push_back(rival.provider);
  return out;
}

bool Shadows::would_be_shadowed(ProviderId earlier, ProviderId id) const {
  if (!facts_.chosen.contains(earlier)) return false;
  std::vector<Rival> rivals = rivals_.of(earlier);
  rivals.push_back({id, {region_of(model_, model_.providers[id].when)}});
  return find_choice_here(earlier, rivals, facts_.values) == Covering::covered;
}

/// Its own conditions, where its group is requested.
Region Shadows::region_here(ProviderId id) const {
  Region out = region_of(model_, model_.providers[id].when);
  out.meet(facts_.grants[model_.providers[id].group]);
  return out;
}

/// What the conditions of earlier providers leave of that.
Covering Shadows::find_choice_here(ProviderId id, const std::vector<Rival>& rivals,
                                   const IdTable<StateId, ValueSet>& values) const {
  return find_choice(model_, region_here(id), rivals, values, budget_);
}

/// Adds those after the last one that was tried: that one always can run, so none after it matters, unless it is
/// changed.
void Shadows::add_after_rivals(ProviderId id, std::vector<ProviderId>& out) const {
  const std::vector<ProviderId>& all = model_.group_of(id).providers;
  for (auto at = std::find(all.begin(), all.end(), out.back()) + 1; *at != id && out.size() < most_left_out; ++at) {
    if (facts_.capable.contains(*at) && can_always_replace(model_, *at, id)) out.push_back(*at);
  }
}

} // namespace director::analysis
