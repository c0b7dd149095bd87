// Header: compiler/analysis/causing/causing_cycles.hpp. Test: compiler/checks/uncovered_state.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/causing_cycles.hpp"

#include "compiler/analysis/states/sources.hpp"

#include <algorithm>

namespace director::analysis {

namespace {

/// Cycles that would take more steps to follow are left out.
constexpr std::size_t most_causing_steps = 200;

/// Follows the chains of pushes, each provider once.
class CircleSearch {
public:
  CircleSearch(const Model& model, const Facts& facts, const Causers& causers)
      : model_(model),
        facts_(facts),
        causers_(causers) {}

  /// From its condition `from` on, each holds already or is caused in turn.
  void add(ProviderId causer, std::size_t from, const Region& with, std::vector<Region>& out) {
    const std::vector<ConditionUse>& when = model_.providers[causer].when;
    if (with.empty() || ++steps_ > most_causing_steps) return;
    if (from == when.size()) {
      out.push_back(with);
      return;
    }
    const Condition& condition = model_.conditions[when[from].id];
    Region holds = with;
    holds.meet(condition.state, condition.accepts);
    add(causer, from + 1, holds, out);
    std::vector<Region> served;
    above_.push_back(causer);
    for (const ProviderId id : causers_[when[from].id]) {
      if (facts_.active.contains(id) && std::find(above_.begin(), above_.end(), id) == above_.end())
        add(id, 0, with, served);
    }
    above_.pop_back();
    for (const Region& each : served) add(causer, from + 1, each, out);
  }

  bool is_too_long() const { return steps_ > most_causing_steps; }

private:
  const Model& model_;
  const Facts& facts_;
  const Causers& causers_;
  std::vector<ProviderId> above_;
  std::size_t steps_ = 0;
};

} // namespace

CausingCycles::CausingCycles(const Model& model, const Facts& facts, const Causers& causers)
    : model_(model),
      facts_(facts),
      causers_(causers),
      given_(model.conditions.size()),
      free_(model.providers.size()) {
  const auto sources = find_sources(model);
  for (const ConditionId id : model.conditions.ids()) {
    const Condition& condition = model.conditions[id];
    const std::vector<Source>& all = sources[condition.state];
    const auto gives = [&](const Source& source) {
      return source.kind != Source::Kind::causing && source.kind != Source::Kind::external &&
             source.values.overlaps(condition.accepts);
    };
    if (std::any_of(all.begin(), all.end(), gives)) given_.add(id);
  }
  for (bool more = true; more;) {
    more = false;
    for (const ProviderId id : model.providers.ids()) {
      const std::vector<ConditionUse>& when = model.providers[id].when;
      if (free_.contains(id) || !facts.active.contains(id)) continue;
      if (model.providers[id].stay.empty() &&
          !std::all_of(when.begin(), when.end(), [&](const ConditionUse& use) { return comes_otherwise(id, use); }))
        continue;
      more = true;
      free_.add(id);
    }
  }
}

bool CausingCycles::comes_otherwise(ProviderId waiter, const ConditionUse& use) const {
  const std::vector<ProviderId>& all = causers_[use.id];
  return all.empty() || given_.contains(use.id) || facts_.is_impossible(waiter, model_.conditions[use.id].state) ||
         std::any_of(all.begin(), all.end(), [&](ProviderId id) { return free_.contains(id); });
}

Region CausingCycles::around(ProviderId causer) const {
  const Provider& row = model_.providers[causer];
  Region out = region_of(model_, row.when);
  if (!row.stay.empty()) out = hull(out, region_of(model_, row.stay));
  for (const Use<GroupId>& need : row.needs) {
    const std::vector<ProviderId>& all = model_.groups[need.id].providers;
    if (all.size() == 1) out.meet(active_region(model_, model_.providers[all.front()]));
  }
  return out;
}

bool CausingCycles::waits_for(ProviderId causer, ConditionId condition) const {
  const Condition& row = model_.conditions[condition];
  const Region region = around(causer);
  const auto at = region.states.find(row.state);
  return at != region.states.end() && at->second.subset_of(row.accepts);
}

std::optional<std::vector<Region>> CausingCycles::beginnings(ConditionId condition,
                                                             const std::function<bool(ProviderId)>& counts) const {
  std::vector<Region> out;
  CircleSearch search(model_, facts_, causers_);
  bool any = false;
  for (const ProviderId causer : causers_[condition]) {
    if (!counts(causer)) continue;
    any = true;
    if (waits_for(causer, condition)) continue;
    if (free_.contains(causer)) return std::nullopt;
    search.add(causer, 0, Region{}, out);
    if (search.is_too_long()) return std::nullopt;
  }
  return any ? std::optional(std::move(out)) : std::nullopt;
}

} // namespace director::analysis
