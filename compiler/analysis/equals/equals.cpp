// Header: compiler/analysis/equals/equals.hpp. Test: compiler/checks/equal_priority.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/equals/equals.hpp"

#include "compiler/analysis/chains/overlaps.hpp"
#include "compiler/analysis/chains/unit_places.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/words/reported_pairs.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

/// The priorities at which each entry may be tried: its own, and of a member of a unit those of other members, if
/// something that is apart has the same.
std::vector<std::set<std::int32_t>> priorities_of(const Model& model, const Together& together) {
  std::vector<std::set<std::int32_t>> out;
  std::set<std::int32_t> of_members, of_apart;
  for (const Task& task : *together.tasks) {
    std::set<std::int32_t>& own = out.emplace_back();
    for (const Task::NamedLevel& named : task.levels) {
      const Level& level = model.edges[task.edge].levels[named.level];
      own.insert(level.priority);
      if (level.shares_unit()) of_members.insert(level.priority);
      if (level.apart && !level.optional) of_apart.insert(level.priority);
    }
  }
  if (!together.provider) return out;
  std::erase_if(of_members, [&](std::int32_t priority) { return of_apart.count(priority) == 0; });
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (model.may_be_member((*together.tasks)[i]))
      out[i].insert(of_members.upper_bound(*out[i].begin()), of_members.end());
  }
  return out;
}

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
    const std::vector<std::vector<std::int32_t>> priorities =
        overlaps.among(tasks, priorities_of(input.model, together));
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

/// The places at which two entries of equal rank are tried.
struct Order {
  bool swapped = false; ///< the second one comes first, if both are requested at once
  bool open = false;    ///< that depends on what else is requested of a flat list
};

/// The one that is declared later comes first by a member of its unit that does.
Order order_of(const Model& model, const Together& together, const Task& a, const Task& b) {
  const bool swapped = b.edge < a.edge;
  if (!together.provider) return {swapped, false};
  const Task &rival = swapped ? b : a, &member = swapped ? a : b;
  const std::vector<Mate> mates = mates_of(model, *together.tasks, member.edge, rival.edge);
  bool some = false, always = together.whole;
  for (const Task::NamedLevel& one : member.levels) {
    for (const Task::NamedLevel& other : rival.levels) {
      const Level &own = model.edges[member.edge].levels[one.level],
                  &rivals = model.edges[rival.edge].levels[other.level];
      if (own.priority != rivals.priority) continue;
      const auto goes_before = [&](const Mate& mate) {
        return mate.priority > rivals.priority || (mate.priority == rivals.priority && mate.task->edge < rival.edge);
      };
      const bool placed = is_placed(own, rivals);
      some = some || (placed && std::any_of(mates.begin(), mates.end(), goes_before));
      always = always && placed && any_always(mates, goes_before);
    }
  }
  return {swapped != always, some && !always};
}

/// How a member comes to equal rank with an entry that is apart only by another member, at whose place its unit is
/// tried.
std::optional<EqualPair> find_by_place(const Model& model, Contests& contests, const Together& together,
                                       const Task& member, const Task& apart) {
  if (!together.provider) return std::nullopt;
  for (const Task::NamedLevel& one : member.levels) {
    for (const Task::NamedLevel& other : apart.levels) {
      const Level &own = model.edges[member.edge].levels[one.level],
                  &rivals = model.edges[apart.edge].levels[other.level];
      if (!is_placed(own, rivals) || own.priority >= rivals.priority) continue;
      const std::vector<Mate> mates = mates_of(model, *together.tasks, member.edge, apart.edge);
      const auto leader =
          std::find_if(mates.begin(), mates.end(), [&](const Mate& mate) { return mate.priority == rivals.priority; });
      const bool goes_before =
          together.whole && any_always(mates, [&](const Mate& mate) { return mate.priority > rivals.priority; });
      if (leader == mates.end() || goes_before) continue;
      if (auto found = contests.look_at_place({&together, &member, &apart, own, rivals}))
        return EqualPair{std::move(*found), 0, 0, false, leader->task};
    }
  }
  return std::nullopt;
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
    std::set<const Task*> by_place; // those that are apart: each once, and in a long list one for each group
    std::set<GroupId> wanted;
    const auto look_at_place = [&](const Task& member, const Task& apart) {
      if (by_place.count(&apart) != 0) return;
      auto found = find_by_place(input.model, contests, together, member, apart);
      if (!found) return;
      by_place.insert(&apart);
      const bool is_new = wanted.insert(found->contest.group).second;
      if (is_new || tasks.size() <= longest_with_all_pairs) list.pairs.push_back(std::move(*found));
    };
    for (std::size_t j = 1; j < tasks.size(); ++j) {
      for (const std::size_t i : claimants.before(j)) {
        if (reported.covers(i, j) || reported_by_others.covers(i, j) || lost.contains(tasks[i], tasks[j])) continue;
        // If both are requested at once, the one that is tried first wins.
        const Order order = order_of(input.model, together, tasks[i], tasks[j]);
        auto found = contests.look_at(together, tasks[order.swapped ? j : i], tasks[order.swapped ? i : j]);
        if (!found) {
          look_at_place(tasks[i], tasks[j]);
          look_at_place(tasks[j], tasks[i]);
          continue;
        }
        const bool excluded = lost.excludes(together, tasks[i], tasks[j]);
        for (const Stake& stake : found->stakes) (excluded ? reported_by_others : reported).add(i, j, stake);
        if (!excluded) list.pairs.push_back({std::move(*found), i, j, order.open, nullptr});
      }
    }
    if (!list.pairs.empty()) out.push_back(std::move(list));
  }
  return out;
}

} // namespace director::analysis
