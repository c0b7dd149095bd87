// Door: compiler/checks/analysis/needs/units.hpp. Test: tests/checks/analysis/needs/units_test.cpp.
#include "compiler/checks/analysis/needs/units.hpp"

#include "compiler/checks/analysis/chains/sparse_set.hpp"
#include "compiler/checks/analysis/plans/agenda.hpp"

#include <algorithm>
#include <set>

namespace director::checks {

namespace {

/// Depth first over what is still to be had. The agenda is a linked list on the stack, as in the search for plans.
class UnitSearch {
public:
  UnitSearch(const Model& model, const Facts& facts, const Units& units, bool by_groups_alone,
             const std::function<bool(const Combination&)>& visitor)
      : model_(model),
        facts_(facts),
        units_(units),
        by_groups_alone_(by_groups_alone),
        visitor_(visitor) {}

  /// False: it ran out of steps.
  bool run(const std::vector<GroupId>& members) {
    std::vector<Use<GroupId>> needs;
    for (const GroupId member : members) needs.push_back({member, {}});
    const Agenda agenda{&needs, 0, nullptr};
    meet(&agenda);
    return steps_ >= 0;
  }

private:
  void meet(const Agenda* agenda) {
    agenda = next_need(agenda);
    if (agenda == nullptr) {
      stopped_ = !visitor_(now_);
      return;
    }
    const GroupId group = agenda->group();
    if (!held_.add(group)) return;
    const Agenda rest = agenda->rest();
    for (const ProviderId provider : model_.groups[group].providers) {
      if (stopped_ || --steps_ < 0) break;
      const Region before = now_.region;
      now_.region.meet(units_.region_at_best(provider));
      if (by_groups_alone_ || !now_.region.empty()) {
        now_.picks.push_back({group, provider});
        // A provider without a plan is reported as such; here it is taken to need nothing.
        const Agenda below{&model_.providers[provider].needs, 0, &rest};
        meet(facts_.plans[provider] == PlanVerdict::found ? &below : &rest);
        now_.picks.pop_back();
      }
      now_.region = before;
    }
    held_.remove(group);
  }

  const Model& model_;
  const Facts& facts_;
  const Units& units_;
  bool by_groups_alone_;
  const std::function<bool(const Combination&)>& visitor_;
  SparseSet<GroupId> held_;
  Combination now_;
  int steps_ = Units::most_steps;
  bool stopped_ = false;
};

} // namespace

std::vector<const Task*> unit_members(const Model& model, const Pack& pack) {
  std::vector<const Task*> out;
  for (const Task& task : pack.tasks) {
    const std::vector<Level>& levels = model.edges[task.edge].levels;
    if (std::none_of(task.levels.begin(), task.levels.end(), [&](const Task::NamedLevel& named) {
          return levels[named.level].optional || levels[named.level].apart;
        }))
      out.push_back(&task);
  }
  return out;
}

const std::vector<GroupId>& Units::needed(GroupId group) {
  const auto [at, is_new] = needed_.try_emplace(group);
  std::vector<GroupId>& out = at->second;
  if (!is_new) return out;
  SparseSet<GroupId> seen;
  seen.add(group);
  out.push_back(group);
  for (std::size_t next = 0; next < out.size(); ++next) {
    for (const ProviderId id : model_.groups[out[next]].providers) {
      for (const Use<GroupId>& need : model_.providers[id].needs) {
        if (seen.add(need.id)) out.push_back(need.id);
      }
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

Region Units::region_at_best(ProviderId id) const {
  const Provider& provider = model_.providers[id];
  Region out = active_region(model_, provider);
  for (const Impossible& fault : facts_.impossible_of(id)) out.states.erase(fault.state);
  for (const ConditionUse& promise : provider.causing) out.states.erase(model_.conditions[promise.id].state);
  return out;
}

Region Units::region_at_best(GroupId group) {
  const auto [at, is_new] = regions_.try_emplace(group); // in a circle of needs: anywhere
  if (!is_new) return at->second;
  std::optional<Region> out;
  for (const ProviderId id : model_.groups[group].providers) {
    Region region = region_at_best(id);
    for (const Use<GroupId>& need : model_.providers[id].needs) region.meet(region_at_best(need.id));
    out = out ? hull(*out, region) : region;
  }
  return regions_[group] = out.value_or(Region{});
}

bool Units::may_clash(const std::vector<GroupId>& members) {
  SparseSet<GroupId> groups;
  std::set<StateId> states;
  for (const GroupId member : members) {
    std::set<StateId> own;
    for (const GroupId group : needed(member)) {
      if (!groups.add(group)) return true;
      for (const ProviderId id : model_.groups[group].providers) {
        for (const auto& [state, values] : region_at_best(id).states) own.insert(state);
      }
    }
    for (const StateId state : own) {
      if (!states.insert(state).second) return true;
    }
  }
  return false;
}

UnitVerdict Units::verdict(const std::vector<GroupId>& members, bool by_groups_alone) {
  if (!may_clash(members)) return UnitVerdict::possible;
  bool found = false;
  const bool complete = visit(members, by_groups_alone, [&](const Combination&) {
    found = true;
    return false;
  });
  return found ? UnitVerdict::possible : complete ? UnitVerdict::impossible : UnitVerdict::undecided;
}

bool Units::visit(const std::vector<GroupId>& members, bool by_groups_alone,
                  const std::function<bool(const Combination&)>& visitor) {
  return UnitSearch(model_, facts_, *this, by_groups_alone, visitor).run(members);
}

} // namespace director::checks
