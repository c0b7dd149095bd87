// Header: compiler/analysis/rounds/ended_requests.hpp. Test: compiler/checks/undone_by_stop.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/rounds/ended_requests.hpp"

#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

class EndedSearch {
public:
  explicit EndedSearch(const Input& input) : model_(input.model), facts_(input.facts), shared_(input.shared) {}

  std::vector<EndedRequests> run(const IdTable<StateId, std::vector<GroupId>>& stopping) {
    for (const StateId state : model_.states.ids()) {
      for (const GroupId group : stopping[state]) {
        for (const ProviderId id : model_.groups[group].providers) {
          if (facts_.active.contains(id)) look_at(group, state, id);
        }
      }
    }
    return std::move(found_);
  }

private:
  void look_at(GroupId group, StateId state, ProviderId id) {
    const Provider& row = model_.providers[id];
    for (const std::vector<ConditionUse>* entries : {&row.causing, &row.sets}) {
      for (const ConditionUse& entry : *entries) {
        const Condition& set = model_.conditions[entry.id];
        if (set.state != state) continue;
        for (StopValue& stop : stop_values(model_, group, state)) {
          const std::optional<Ended> ended = find_ended(group, state, set.accepts, stop.values);
          if (ended && seen_.insert({group, state}).second)
            found_.push_back({group, state, id, entry, entries == &row.causing, std::move(stop), ended->requester,
                              ended->waits, find_next(ended->requester, set)});
        }
      }
    }
  }

  /// Who begins again, and who cannot run any more.
  struct Ended {
    ProviderId requester{};
    ProviderId waits{};
  };

  /// The first provider that requests the group and begins again with a value of its stop, if the values that the group
  /// sets end all that request it.
  std::optional<Ended> find_ended(GroupId group, StateId state, const ValueSet& set, const ValueSet& stop) const {
    const auto accepts_any = [&](const Region& region, const ValueSet& values) {
      const auto at = region.states.find(state);
      return at == region.states.end() || at->second.overlaps(values);
    };
    std::optional<Ended> out;
    for (const Request& request : shared_.requests().of(group)) {
      if (!request.requester) return std::nullopt;
      const ProviderId requester = *request.requester;
      std::vector<ProviderId> all = shared_.push_exclusion().needed(requester);
      all.insert(all.begin(), requester);
      const auto waits = std::find_if(all.begin(), all.end(), [&](ProviderId id) {
        if (id == requester) return !accepts_any(facts_.region_to_run(model_, id, facts_.pushed.contains(id)), set);
        const bool runs = is_granted_with(model_, model_.providers[requester].group, {id, {}, {}});
        const Provider& row = model_.providers[id];
        return !accepts_any(runs ? active_region(model_, row) : region_of(model_, row.when), set);
      });
      if (waits == all.end()) return std::nullopt;
      const bool begins = std::all_of(all.begin(), all.end(), [&](ProviderId id) {
        return accepts_any(region_of(model_, model_.providers[id].when), stop);
      });
      if (!out && facts_.chosen.contains(requester) && begins) out = {requester, *waits};
    }
    return out;
  }

  /// Another provider of the group that may run then: with a `stay` it would not.
  std::optional<ProviderId> find_next(ProviderId ended, const Condition& set) const {
    for (const ProviderId id : model_.group_of(ended).providers) {
      if (id == ended || !facts_.active.contains(id)) continue;
      const Region region = facts_.region_to_run(model_, id, facts_.pushed.contains(id));
      const auto at = region.states.find(set.state);
      if (at == region.states.end() || at->second.overlaps(set.accepts)) return id;
    }
    return std::nullopt;
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  std::set<std::pair<GroupId, StateId>> seen_;
  std::vector<EndedRequests> found_;
};

} // namespace

std::vector<EndedRequests> find_ended_requests(const Input& input,
                                               const IdTable<StateId, std::vector<GroupId>>& stopping) {
  return EndedSearch(input).run(stopping);
}

} // namespace director::analysis
