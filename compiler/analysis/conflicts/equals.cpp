// Header: compiler/analysis/conflicts/equals.hpp. Test: compiler/checks/equal_priority.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/equals.hpp"

#include "compiler/analysis/chains/overlaps.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/words/reported_pairs.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

/// For each entry the earlier ones that share a priority with it and may come to hold the same group, in order. In a
/// long list few entries meet, so not all pairs are compared, and claims are computed only for an entry that overlaps
/// with another one of its priority: for a chain of groups they would hold everything below each of them.
class Claimants {
public:
  Claimants(const Input& input, Overlaps& overlaps, const Together& together)
      : stakes_(together.tasks->size()),
        added_for_(together.tasks->size(), 0) {
    const std::vector<Task>& tasks = *together.tasks;
    if (tasks.size() < 2) return;
    const std::vector<std::vector<std::int32_t>> priorities = overlaps.priorities(tasks);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      if (priorities[i].empty()) continue;
      const bool in_unit = together.provider && input.model.is_always_member(tasks[i]);
      const Claims& claims = input.shared.claims(tasks[i].target);
      for (const GroupId group : claims.groups()) {
        const bool by_request =
            claims.find(group, Reach::mandatory) != nullptr || claims.find(group, Reach::optional) != nullptr;
        for (const std::int32_t priority : priorities[i]) {
          Claimed& by = claimed_by_[{group, priority}];
          by.all.push_back(i);
          if (!in_unit || by_request) by.contested.push_back(i);
          if (!in_unit) by.outside.push_back(i);
          stakes_[i].push_back(!in_unit ? &by.all : by_request ? &by.contested : &by.outside);
        }
      }
    }
  }

  /// Entries that meet in much, as in a cycle of requests, share most of their groups: each is added once, and none is
  /// left after a few of the groups.
  std::vector<std::size_t> before(std::size_t entry) {
    std::vector<std::size_t> out;
    for (const std::vector<std::size_t>* all : stakes_[entry]) {
      if (out.size() == entry) break;
      for (const std::size_t each : *all) {
        if (each >= entry) break;
        if (std::exchange(added_for_[each], entry) != entry) out.push_back(each);
      }
    }
    std::sort(out.begin(), out.end());
    return out;
  }

private:
  /// What a member of a unit holds from the beginning is no contest with other members (have_equal_rank): so an entry
  /// is compared with all others only if it is outside the unit.
  struct Claimed {
    std::vector<std::size_t> all;
    std::vector<std::size_t> contested; ///< outside the unit, or members that request it further down
    std::vector<std::size_t> outside;
  };

  std::map<Stake, Claimed> claimed_by_;
  std::vector<std::vector<const std::vector<std::size_t>*>> stakes_; ///< of each entry
  std::vector<std::size_t>
      added_for_; ///< the entry for whose list each was added last; never the first one, which has none before it
};

/// Pairs that another check reports.
class Lost {
public:
  explicit Lost(const Input& input) : units_(input.shared.units()), model_(input.model) {
    for (const PackConflict& conflict : input.conflicts.pack_conflicts()) {
      if (conflict.verdict != UnitVerdict::impossible) continue;
      for (const Task* first : conflict.members) {
        for (const Task* second : conflict.members) pairs_.insert({first, second});
      }
    }
    for (const StarvingTask& starving : input.conflicts.starving_tasks()) {
      for (const Refused& place : starving.places) {
        kept_off_.insert(place.task);
        const Taker& taker = place.refusals.front().taker;
        pairs_.insert({taker.by, taker.over});
        pairs_.insert({taker.over, taker.by});
      }
    }
    for (const Loser& loser : input.conflicts.losers()) {
      const bool never =
          loser.refused.task == loser.entry || input.conflicts.grants().refused().count(loser.refused.task->edge) != 0;
      if (loser.taker.kind == Taker::Kind::above && never) kept_off_.insert(loser.refused.task);
    }
  }

  /// Whether one of the two always loses, or both.
  bool contains(const Task& first, const Task& second) const {
    return pairs_.count({&first, &second}) != 0 || kept_off_.count(&first) + kept_off_.count(&second) != 0;
  }

  /// Two members of a long unit that exclude each other: each of them is reported with another one.
  bool excludes(const Together& together, const Task& first, const Task& second) const {
    return together.provider && together.tasks->size() > longest_with_all_pairs && model_.is_always_member(first) &&
           model_.is_always_member(second) && units_.verdict({first.target, second.target}) == UnitVerdict::impossible;
  }

private:
  Units& units_;
  const Model& model_;
  std::set<std::pair<const Task*, const Task*>> pairs_;
  std::set<const Task*> kept_off_; ///< by what the requester holds itself, or by several together
};

std::int32_t priority_of(const Model& model, const Task& task) {
  return model.edges[task.edge].levels[task.levels.front().level].priority;
}

bool is_tried_first(const Model& model, const Task& a, const Task& b) {
  const std::int32_t first = priority_of(model, a), second = priority_of(model, b);
  return first == second ? a.edge < b.edge : first > second;
}

/// The member at whose place its unit is tried: of those with the highest priority, the first. The task itself if it is
/// no member, or if a member has several levels.
const Task& leader_of(const Model& model, const Together& together, const Task& task) {
  if (!together.provider || !model.is_always_member(task)) return task;
  const Task* out = &task;
  for (const Task& other : *together.tasks) {
    if (!model.is_always_member(other)) continue;
    if (other.levels.size() != 1) return task;
    if (is_tried_first(model, other, *out)) out = &other;
  }
  return *out;
}

/// The places at which two entries of equal rank are tried.
struct Order {
  bool swapped = false; ///< the second one comes first, if both are requested at once
  bool open = false;    ///< that depends on what else is requested of a flat list
};

Order order_of(const Model& model, const Together& together, const Task& a, const Task& b) {
  const Task &first = leader_of(model, together, a), &second = leader_of(model, together, b);
  const bool alone = b.edge < a.edge; // without other members
  if (&first == &second) return {alone, false};
  const bool has_levels = a.levels.size() != 1 || b.levels.size() != 1;
  const bool swapped = has_levels ? second.edge < first.edge : is_tried_first(model, second, first);
  return together.whole ? Order{swapped, false} : Order{alone, swapped != alone};
}

} // namespace

std::vector<EqualList> find_equals(const Input& input) {
  Contests contests(input.model, input.shared, input.conflicts.takers());
  Overlaps overlaps(input.model, input.shared.branches());
  const Lost lost(input);
  std::vector<EqualList> out;
  for (const Together& together : input.shared.chains().together()) {
    const std::vector<Task>& tasks = *together.tasks;
    Claimants claimants(input, overlaps, together);
    ReportedPairs<Stake> reported(tasks.size()), reported_by_others(tasks.size());
    EqualList list{&together, {}};
    for (std::size_t j = 1; j < tasks.size(); ++j) {
      for (const std::size_t i : claimants.before(j)) {
        if (reported.covers(i, j) || reported_by_others.covers(i, j) || lost.contains(tasks[i], tasks[j])) continue;
        // If both are requested at once, the one that is tried first wins.
        const Order order = order_of(input.model, together, tasks[i], tasks[j]);
        auto found = contests.look_at(together, tasks[order.swapped ? j : i], tasks[order.swapped ? i : j]);
        if (!found) continue;
        const bool excluded = lost.excludes(together, tasks[i], tasks[j]);
        for (const Stake& stake : found->stakes) (excluded ? reported_by_others : reported).add(i, j, stake);
        if (!excluded) list.pairs.push_back({std::move(*found), i, j, order.open});
      }
    }
    if (!list.pairs.empty()) out.push_back(std::move(list));
  }
  return out;
}

} // namespace director::analysis
