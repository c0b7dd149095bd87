// Header: compiler/analysis/plans/work.hpp. Test: tests/compiler/analysis/plans/bounds_test.cpp,
// tests/property/property_test.cpp. SPDX-License-Identifier: MIT
#include "compiler/analysis/plans/work.hpp"

#include "compiler/model/closure.hpp"
#include "runtime/core/base/parts.hpp"
#include "runtime/core/base/tables.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace director::analysis {

namespace {

constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();

constexpr std::int64_t sum(std::int64_t a, std::int64_t b) { return a > most - b ? most : a + b; }
constexpr std::int64_t product(std::int64_t a, std::int64_t b) { return b != 0 && a > most / b ? most : a * b; }

/// How often one unit may be tried: with its conditions, and then without them if that failed, or again if new claims
/// are deferred.
constexpr std::int64_t attempts = 2;

class Working {
public:
  Working(const Model& model, const Tables& tables, Trials& trials, WorkBound& out)
      : model_(model),
        t_(tables),
        trials_(trials),
        out_(out),
        pushes_(model.groups.size(), -1),
        walks_(model.groups.size(), -1),
        searches_(tables.conditions.size(), -1) {}

  /// Of a sweep over each component: what its root tasks and its groups request.
  std::vector<std::int64_t> sweeps() {
    std::vector<std::int64_t> out(t_.components.size());
    const auto add = [&](Index group, std::int64_t work) {
      std::int64_t& to = out[t_.groups[group].component];
      to = sum(to, work);
    };
    for (std::size_t c = 0; c < out.size(); ++c) // each group is placed, and each edge decided, once
      out[c] = static_cast<std::int64_t>(t_.components[c].groups.size() + t_.components[c].edges.size());
    for (const Task& root : model_.roots) add(static_cast<Index>(root.target.value), alone(root));
    for (const GroupId group : model_.groups.ids())
      add(static_cast<Index>(group.value), sum(largest_pack(group), walk(group))); // a walk if it loses its holder
    return out;
  }

private:
  std::int64_t ways(GroupId group) {
    const TrialCount& count = trials_.ways(group);
    out_.counted = out_.counted && count.complete;
    return count.count;
  }

  /// All choices of a member, once: examined providers, found plans, and one search for the next.
  std::int64_t choices(GroupId group) {
    return sum(static_cast<std::int64_t>(model_.groups[group].providers.size()), product(2, ways(group)));
  }

  /// Decided by itself: if an equal may deny it something all choices, and then up to the first. If it waits for a
  /// condition, it searches for a push.
  std::int64_t alone(const Task& task) {
    const std::int64_t scans = t_.groups[task.target.value].deniable ? 2 : 1;
    return sum(product(scans * attempts, choices(task.target)), sum(attempts * walk(task.target), pushes(task.target)));
  }

  /// Decided whole or not at all: each member by itself, one after the other, and members that can claim the same group
  /// in all combinations. That bounds the cost of deciding each member alone. All may search.
  std::int64_t together(const CountedUnit& unit) {
    std::int64_t work = 0;
    for (const Task* member : unit.members) work = sum(work, product(2, choices(member->target)));
    for (const std::vector<const Task*>& members : unit.colliding) {
      std::int64_t before = 1;
      for (const Task* member : members) {
        work = sum(work, product(before, choices(member->target)));
        before = product(before, std::max<std::int64_t>(1, ways(member->target)));
      }
    }
    work = product(attempts, work);
    for (const Task* member : unit.members)
      work = sum(work, sum(attempts * walk(member->target), pushes(member->target)));
    return work;
  }

  /// Of the search for a stale group that may request the group, or one that a plan of it may contain.
  std::int64_t walk(GroupId group) {
    std::int64_t& known = walks_[group.value];
    if (known >= 0) return known;
    IdSet<GroupId> seen(model_.groups.size());
    std::vector<GroupId> found = needed_by(model_, group);
    if (std::find(found.begin(), found.end(), group) == found.end()) found.push_back(group);
    for (const GroupId each : found) seen.add(each);
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (const EdgeId edge : model_.groups[found[i]].requesters) {
        const std::optional<GroupId> above = model_.edges[edge].requester;
        if (above && seen.add(*above)) found.push_back(*above);
      }
    }
    return known = static_cast<std::int64_t>(found.size() / director::walked_a_unit);
  }

  /// A group requests one pack at a time; what is not in its unit is decided alone.
  std::int64_t largest_pack(GroupId group) {
    std::int64_t largest = 0;
    for (const ProviderId provider : model_.groups[group].providers) {
      for (const Pack& pack : model_.providers[provider].packs) {
        CountedUnit unit = trials_.together(pack);
        if (unit.members.size() == 1) unit.members.clear();
        std::int64_t work = unit.members.empty() ? 0 : together(unit);
        for (const Task& task : pack.tasks) {
          if (std::find(unit.members.begin(), unit.members.end(), &task) == unit.members.end())
            work = sum(work, alone(task));
        }
        largest = std::max(largest, work);
      }
    }
    return largest;
  }

  /// For each condition that a choice of the group can lack, a search; for the choice that costs the most.
  std::int64_t pushes(GroupId group) {
    std::int64_t& known = pushes_[group.value];
    if (known >= 0) return known;
    known = 0; // a group that needs itself has no plan
    std::int64_t dearest = 0;
    for (const ProviderId id : model_.groups[group].providers) {
      const director::Provider& row = t_.providers[id.value];
      std::int64_t work = 0;
      for (const Index condition : t_.list(row.when)) work = sum(work, search(condition));
      for (const Index need : t_.list(row.needs)) work = sum(work, pushes(GroupId{t_.edges[need].target}));
      dearest = std::max(dearest, work);
    }
    return known = dearest;
  }

  /// Of a chain that makes the condition true: all plans of each provider that may be in it, again until no length
  /// decreases.
  std::int64_t search(Index condition) {
    std::int64_t& out = searches_[condition];
    if (out >= 0) return out;
    std::vector<Index> lacking{condition};
    std::vector<bool> lacks(t_.conditions.size()), looked_at(t_.providers.size());
    lacks[condition] = true;
    std::int64_t plans = 0;
    for (std::size_t i = 0; i < lacking.size(); ++i) {
      for (const Index provider : t_.list(t_.conditions[lacking[i]].causers)) {
        if (looked_at[provider]) continue;
        looked_at[provider] = true;
        const PlanCount found = trials_.plans(ProviderId{provider});
        out_.counted = out_.counted && found.complete;
        plans = sum(plans, found.tried());
        for (const Index aim : t_.list(t_.providers[provider].aims)) {
          if (lacks[aim]) continue;
          lacks[aim] = true;
          lacking.push_back(aim);
        }
      }
    }
    // After as many rounds as there are conditions no length changes any more; then the order of declaration counts,
    // and then nothing.
    const auto rounds = static_cast<std::int64_t>(lacking.size()) + 2;
    return out = product(rounds, plans);
  }

  const Model& model_;
  const Tables& t_;
  Trials& trials_;
  WorkBound& out_;
  std::vector<std::int64_t> pushes_, walks_, searches_; ///< below 0: not known yet
};

} // namespace

WorkBound bound_work(const Model& model, const Tables& tables, Trials& trials) {
  WorkBound out;
  std::vector<std::int64_t> repetitions(tables.components.size());
  for (const director::Group& group : tables.groups) {
    if (group.equals) ++repetitions[group.component];
  }
  const std::vector<std::int64_t> sweeps = Working(model, tables, trials, out).sweeps();
  for (std::size_t c = 0; c < sweeps.size(); ++c) {
    // Before the first repetition an incomplete pass begins again.
    const bool begins_again = repetitions[c] != 0 && tables.components[c].groups.size() > director::most_decided_whole;
    const std::int64_t pass = product(1 + repetitions[c] + (begins_again ? 1 : 0), sweeps[c]);
    out.pass = std::max(out.pass, pass);
    out.micro_step = sum(out.micro_step, pass);
  }
  return out;
}

} // namespace director::analysis
