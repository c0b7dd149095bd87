// Header: compiler/checks/check.hpp. Test: compiler/checks/equal_priority.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/chains/overlaps.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/told.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <list>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace director::checks {

namespace {

using dsl::Diagnostic;

/// A group that two tasks may want at the same time, at equal rank, and how each comes to it.
struct Contest {
  GroupId group{};
  Reach first = Reach::own, second = Reach::own;
  std::size_t steps = 0;
  std::vector<ChainStep> first_path, second_path;
};

/// What the first one may hold while it waits for the group of the contest, and the second one waits for that while it
/// holds the group of the contest.
struct Deadlock {
  GroupId held{};
  std::vector<ChainStep> first_path, second_path; ///< to what is held
};

/// So many steps down are gone to look closely, for all pairs together. A behaviour of 10,000 groups, as people write
/// them, takes a hundredth.
constexpr std::size_t most_effort = 10'000'000;

class ContestSearch {
public:
  explicit ContestSearch(const Input& input) : model_(input.model), shared_(input.shared) {}

  /// Where two levels of two entries are equal: what both may want, those with the shortest chains first.
  std::vector<Contest> find_candidates(const Meeting& meeting) {
    std::vector<Contest> out;
    if (meeting.first_level.priority != meeting.second_level.priority) return out;
    const Claims& first = shared_.claims(meeting.first->target);
    const Claims& second = shared_.claims(meeting.second->target);
    for (const GroupId group : in_common(first.groups(), second.groups())) {
      for (const Reach a : all_reaches) {
        for (const Reach b : all_reaches) {
          const Claim* x = first.find(group, a);
          const Claim* y = second.find(group, b);
          if (match(meeting, x, a, y, b)) out.push_back({group, a, b, x->steps + y->steps, {}, {}});
        }
      }
    }
    std::stable_sort(out.begin(), out.end(), [](const Contest& x, const Contest& y) { return x.steps < y.steps; });
    return out;
  }

  /// The first one with chains that do not meet before the end. All are looked at: of two that lead to each other the
  /// nearest hundreds may be none.
  std::optional<Contest> find(const Meeting& meeting, const std::vector<Contest>& candidates) {
    Lookups lookups;
    for (const Contest& candidate : candidates) {
      if (effort_ > most_effort) {
        leave_open(meeting);
        return std::nullopt;
      }
      Contest contest = candidate;
      if (find_paths(meeting, contest, lookups)) return contest;
    }
    return std::nullopt;
  }

  /// For a contest that was found.
  std::optional<Deadlock> find_deadlock(const Meeting& meeting, const std::vector<Contest>& candidates,
                                        const Contest& contest) {
    const std::set<GroupId> held = held_before(contest.first_path);
    if (held.empty()) return std::nullopt;
    Lookups lookups;
    for (Contest other : candidates) {
      if (effort_ > most_effort) return std::nullopt;
      // A group has one holder: nobody waits for what both hold.
      if (other.group == contest.group || held.count(other.group) == 0 || !find_paths(meeting, other, lookups))
        continue;
      if (held_before(other.second_path).count(contest.group) != 0)
        return Deadlock{other.group, std::move(other.first_path), std::move(other.second_path)};
    }
    return std::nullopt;
  }

private:
  /// The last step before a contested group on the first one's way, and what is known of what is above that.
  struct Above {
    bool leads_through = false;    ///< the second one is there
    std::optional<Claims> without; ///< what the second one comes to by none of it
  };
  /// Of one pair, by whether there is such a step, and from where and how it goes: many groups hang on the same one.
  using Lookups = std::map<std::tuple<bool, GroupId, Reach>, Above>;

  /// What is held for certain when the last request of a chain is made: what comes by needs comes all at once.
  std::set<GroupId> held_before(const std::vector<ChainStep>& chain) const {
    const auto last = std::find_if(chain.rbegin(), chain.rend(), [](const ChainStep& step) { return !step.by_need; });
    std::set<GroupId> out;
    for (auto step = last; step != chain.rend(); ++step) {
      const auto& parts = shared_.indispensable().of(step->from);
      if (parts) out.insert(parts->begin(), parts->end());
    }
    return out;
  }

  static bool match(const Meeting& meeting, const Claim* a, Reach how_a, const Claim* b, Reach how_b) {
    if (a == nullptr || b == nullptr) return false;
    const bool first_optional = meeting.first_level.optional || how_a == Reach::optional;
    const bool second_optional = meeting.second_level.optional || how_b == Reach::optional;
    // What a unit holds from the beginning is not decided by rank: nothing below it is tried before.
    const bool granted_before = meeting.one_unit() && (how_a == Reach::own || how_b == Reach::own);
    return first_optional == second_optional && !granted_before && compatible(a->region, b->region);
  }

  /// Once for all pairs from there on.
  void leave_open(const Meeting& meeting) {
    if (std::exchange(is_open_, true)) return;
    shared_.budget().leave_open(meeting.second->span,
                                fmt::format("whether two tasks with equal rank compete, from {} and {} on",
                                            name_of(model_, meeting.first->target),
                                            name_of(model_, meeting.second->target)));
  }

  /// Two chains that have no group in common above the contested one: a group is held once, so else they would meet
  /// there.
  bool find_paths(const Meeting& meeting, Contest& contest, Lookups& lookups) {
    const Claims& first = shared_.claims(meeting.first->target);
    const Claim* ours = first.find(contest.group, contest.first);
    Above& known = lookups[{ours->steps > 0, ours->from, ours->reach_from}];
    ++effort_;
    if (known.leads_through) return false;
    const auto serves = [&](GroupId group, Reach reach, const Claim& claim) {
      return group == contest.group && reach == contest.second &&
             match(meeting, ours, contest.first, &claim, contest.second);
    };
    const auto find_second = [&](const Claims& second) {
      const Claim* theirs = second.find(contest.group, contest.second);
      if (!match(meeting, ours, contest.first, theirs, contest.second)) return false;
      contest.first_path = first.path(contest.group, contest.first);
      contest.second_path = second.path(contest.group, contest.second);
      return true;
    };
    if (known.without) return find_second(*known.without);
    std::vector<GroupId> above;
    for (const ChainStep& step : first.path(contest.group, contest.first)) above.push_back(step.from);
    effort_ += above.size();
    known.leads_through = std::find(above.begin(), above.end(), meeting.second->target) != above.end();
    if (known.leads_through) return false;
    Claims second(shared_.branches(), meeting.second->target, above, serves);
    effort_ += second.effort();
    if (find_second(second)) return true;
    known.without = std::move(second); // the search went to the end
    return false;
  }

  const Model& model_;
  const Shared& shared_;
  std::size_t effort_ = 0;
  bool is_open_ = false;
};

/// Each step once: two chains of one task often begin alike.
void add_new(const Model& model, const std::vector<ChainStep>& chain, dsl::Note::Link begins, Diagnostic& finding) {
  std::vector<dsl::Note> steps;
  add_chain(model, chain, steps, begins);
  for (dsl::Note& step : steps) {
    const auto same = [&](const dsl::Note& note) { return note.span == step.span && note.message == step.message; };
    if (std::none_of(finding.notes.begin(), finding.notes.end(), same)) finding.notes.push_back(std::move(step));
  }
}

void report(const Model& model, const Meeting& meeting, const Contest& contest, const std::optional<Deadlock>& deadlock,
            Findings& findings) {
  using Link = dsl::Note::Link;
  const std::string first = name_of(model, meeting.first->target), second = name_of(model, meeting.second->target);
  const std::string wanted = name_of(model, contest.group);
  Diagnostic& finding = findings.add(
      meeting.second->span,
      deadlock
          ? fmt::format("{0} and {1} have equal rank: {0} may hold {2} and want {3} while {1} holds {3} and wants {2}, "
                        "and then each waits for the other",
                        first, second, name_of(model, deadlock->held), wanted)
          : fmt::format("{0} and {1} have equal rank and may both want {2}: who asks first keeps it, and if both ask "
                        "at once {0} does",
                        first, second, wanted));
  finding.notes.push_back(
      {meeting.first->span,
       fmt::format("{} is requested here, with the same priority {}", first, meeting.first_level.priority),
       Link::first});
  if (deadlock) add_new(model, deadlock->first_path, Link::next, finding);
  add_new(model, contest.first_path, Link::next, finding);
  add_new(model, contest.second_path, Link::first, finding);
  if (deadlock) add_new(model, deadlock->second_path, Link::next, finding);
  finding.help = deadlock ? "give one of them a higher priority, or let each need at once all that it wants"
                          : "give one of them a higher priority";
}

/// The group that two tasks want, and the priority that both have.
using Stake = std::pair<GroupId, std::int32_t>;

/// Two entries of one list, by their places in it, and what they compete for.
struct Rivalling {
  std::size_t earlier = 0, later = 0;
  Meeting meeting;
  Contest contest;
  std::optional<Deadlock> deadlock;
  std::vector<Stake> stakes; ///< all that it may be about
};

/// One finding for a pair, whatever its levels.
std::optional<Rivalling> look_at(const Model& model, const Together& together, const Task& first, const Task& second,
                                 ContestSearch& search) {
  for (const Task::NamedLevel& a : first.levels) {
    for (const Task::NamedLevel& b : second.levels) {
      const Meeting meeting{&together, &first, &second, model.edges[first.edge].levels[a.level],
                            model.edges[second.edge].levels[b.level]};
      const std::vector<Contest> candidates = search.find_candidates(meeting);
      const auto contest = search.find(meeting, candidates);
      if (!contest) continue;
      Rivalling out{0, 0, meeting, *contest, search.find_deadlock(meeting, candidates, *contest), {}};
      for (const Contest& one : candidates) out.stakes.emplace_back(one.group, meeting.first_level.priority);
      return out;
    }
  }
  return std::nullopt;
}

/// So many entries of one list that compete at one priority, each with another one of them, are one finding: it is one
/// decision that nobody took, and not as many as there are pairs.
constexpr std::size_t many = 4;

/// Entries that compete at one priority, by their places, and for what.
struct Crowd {
  std::set<std::size_t> entries;
  std::set<GroupId> groups;
};

void report_many(const Model& model, const std::vector<Task>& tasks, const Crowd& crowd, std::int32_t priority,
                 Findings& findings) {
  std::vector<std::string> names, groups;
  for (const std::size_t entry : crowd.entries) names.push_back(name_of(model, tasks[entry].target));
  for (const GroupId group : crowd.groups) groups.push_back(name_of(model, group));
  const std::size_t second = *std::next(crowd.entries.begin());
  const std::string what =
      groups.size() == 1 ? fmt::format(" and may all want {}", groups.front())
                         : fmt::format(", and each may want what another one of them wants, {}", few_of(groups, "or"));
  Diagnostic& finding =
      findings.add(tasks[second].span, fmt::format("{} have equal rank{}: who asks first keeps it, and of those that "
                                                   "ask at once the one that is declared first does",
                                                   few_of(names), what));
  for (const std::size_t entry : crowd.entries) {
    if (entry == second) continue;
    finding.notes.push_back({tasks[entry].span, fmt::format("{} is requested here, with the same priority {}",
                                                            name_of(model, tasks[entry].target), priority)});
  }
  shorten_list(finding.notes);
  finding.help = "give them priorities that tell who goes before whom";
}

/// The pairs of one priority, put together where they have an entry in common.
std::list<Crowd> find_crowds(const std::vector<Rivalling>& all, std::int32_t priority) {
  std::list<Crowd> out;
  for (const Rivalling& pair : all) {
    if (pair.deadlock || pair.meeting.first_level.priority != priority) continue;
    Crowd* home = nullptr;
    for (auto at = out.begin(); at != out.end();) {
      const bool meets = at->entries.count(pair.earlier) != 0 || at->entries.count(pair.later) != 0;
      if (meets && home != nullptr) {
        home->entries.merge(at->entries);
        home->groups.merge(at->groups);
        at = out.erase(at);
        continue;
      }
      if (meets) home = &*at;
      ++at;
    }
    if (home == nullptr) home = &out.emplace_back();
    home->entries.insert({pair.earlier, pair.later});
    home->groups.insert(pair.contest.group);
  }
  return out;
}

/// Of one list.
void report_all(const Model& model, const std::vector<Task>& tasks, const std::vector<Rivalling>& all,
                Findings& findings) {
  std::map<std::int32_t, std::set<std::size_t>> crowded; ///< by priority: entries of which one finding tells
  std::set<std::int32_t> priorities;
  for (const Rivalling& pair : all) priorities.insert(pair.meeting.first_level.priority);
  for (const std::int32_t priority : priorities) {
    for (const Crowd& crowd : find_crowds(all, priority)) {
      if (crowd.entries.size() < many) continue;
      report_many(model, tasks, crowd, priority, findings);
      crowded[priority].insert(crowd.entries.begin(), crowd.entries.end());
    }
  }
  for (const Rivalling& pair : all) {
    if (pair.deadlock || crowded[pair.meeting.first_level.priority].count(pair.earlier) == 0)
      report(model, pair.meeting, pair.contest, pair.deadlock, findings);
  }
}

/// For each entry those before it that have a priority in common with it and may come to hold the same group, in order.
/// Of many entries only few meet, so they are not all compared with each other, and what an entry may come to hold is
/// asked only of one that overlaps with another one of its priority: in a chain of groups all that is below would be
/// kept for each of them.
class Rivalry {
public:
  Rivalry(const Input& input, Overlaps& overlaps, const std::vector<Task>& tasks) : stakes_(tasks.size()) {
    if (tasks.size() < 2) return;
    const std::vector<std::vector<std::int32_t>> priorities = overlaps.priorities(tasks);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      if (priorities[i].empty()) continue;
      for (const GroupId group : input.shared.claims(tasks[i].target).groups()) {
        for (const std::int32_t priority : priorities[i]) {
          std::vector<std::size_t>& all = claimed_by_[{group, priority}];
          all.push_back(i);
          stakes_[i].push_back(&all);
        }
      }
    }
  }

  std::vector<std::size_t> before(std::size_t entry) const {
    std::vector<std::size_t> out;
    for (const std::vector<std::size_t>* all : stakes_[entry])
      out.insert(out.end(), all->begin(), std::lower_bound(all->begin(), all->end(), entry));
    if (stakes_[entry].size() > 1) {
      std::sort(out.begin(), out.end());
      out.erase(std::unique(out.begin(), out.end()), out.end());
    }
    return out;
  }

private:
  std::map<Stake, std::vector<std::size_t>> claimed_by_;
  std::vector<std::vector<const std::vector<std::size_t>*>> stakes_; ///< of each entry
};

} // namespace

void equal_priority(const Input& input, Findings& findings) {
  const Model& model = input.model;
  ContestSearch search(input);
  Overlaps overlaps(model, input.shared.branches());
  std::set<std::pair<const Task*, const Task*>> lost; // one side always loses, or both: another finding
  for (const PackConflict& conflict : input.conflicts.pack_conflicts()) {
    if (conflict.verdict != UnitVerdict::impossible) continue;
    for (const Task* first : conflict.members) {
      for (const Task* second : conflict.members) lost.insert({first, second});
    }
  }
  for (const StarvingTask& starving : input.conflicts.starving_tasks()) {
    for (const Refused& place : starving.places) {
      const Taker& taker = place.refusals.front().taker;
      lost.insert({taker.by, taker.over});
      lost.insert({taker.over, taker.by});
    }
  }
  std::set<const Task*> kept_off; // by what the requester keeps for itself
  for (const Loser& loser : input.conflicts.losers()) {
    if (loser.taker.kind == Taker::Kind::above && loser.refused.task == loser.entry) kept_off.insert(loser.entry);
  }
  for (const Together& together : input.shared.chains().together()) {
    const std::vector<Task>& tasks = *together.tasks;
    const Rivalry rivalry(input, overlaps, tasks);
    Told<Stake> told(tasks.size());
    std::vector<Rivalling> all;
    for (std::size_t j = 1; j < tasks.size(); ++j) {
      for (const std::size_t i : rivalry.before(j)) {
        if (told.covers(i, j) || lost.count({&tasks[i], &tasks[j]}) != 0) continue;
        if (kept_off.count(&tasks[i]) + kept_off.count(&tasks[j]) != 0) continue;
        // Asked at once, the edge that is declared first wins.
        const bool swapped = tasks[j].edge < tasks[i].edge;
        auto found = look_at(model, together, tasks[swapped ? j : i], tasks[swapped ? i : j], search);
        if (!found) continue;
        for (const Stake& stake : found->stakes) told.tell(i, j, stake);
        found->earlier = i;
        found->later = j;
        all.push_back(std::move(*found));
      }
    }
    report_all(model, tasks, all, findings);
  }
}

} // namespace director::checks
