// Header: compiler/analysis/equals/contests.hpp. Test: compiler/checks/equal_priority.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/equals/contests.hpp"

#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::analysis {

namespace {

/// Limit for the edges that are followed closely, for all pairs together. A real behaviour of 10,000 groups takes a
/// hundredth.
constexpr std::size_t most_effort = 10'000'000;

/// Whether they may claim a group at equal rank, whatever their conditions.
bool have_equal_rank(const Meeting& meeting, Reach first, Reach second) {
  const bool first_optional = meeting.first_level.optional || first == Reach::optional;
  const bool second_optional = meeting.second_level.optional || second == Reach::optional;
  // What a unit holds from the beginning is not decided by rank: nothing below it is tried before.
  const bool granted_before = meeting.one_unit() && (first == Reach::own || second == Reach::own);
  return first_optional == second_optional && !granted_before;
}

} // namespace

std::optional<Rivalling> Contests::look_at(const Together& together, const Task& first, const Task& second) {
  for (const Task::NamedLevel& a : first.levels) {
    for (const Task::NamedLevel& b : second.levels) {
      const Meeting meeting{&together, &first, &second, model_.edges[first.edge].levels[a.level],
                            model_.edges[second.edge].levels[b.level]};
      if (meeting.first_level.priority != meeting.second_level.priority) continue;
      const std::vector<Contest> candidates = find_candidates(meeting);
      const auto contest = find(meeting, candidates);
      if (!contest) continue;
      Rivalling out{meeting, *contest, find_mutual_wait(meeting, candidates, *contest), {}};
      for (const Contest& one : candidates) out.stakes.emplace_back(one.group, meeting.first_level.priority);
      return out;
    }
  }
  return std::nullopt;
}

std::optional<Rivalling> Contests::look_at_place(const Meeting& meeting) {
  std::vector<Contest> candidates = find_candidates(meeting);
  std::erase_if(candidates, [](const Contest& each) { return each.first != Reach::own || each.unpushed; });
  const auto contest = find(meeting, candidates);
  if (!contest || contest->unpushed) return std::nullopt;
  return Rivalling{meeting, *contest, {}, {}};
}

const Claims& Contests::claims(const Meeting& meeting, const Task& entry) const {
  const std::optional<ProviderId> by = meeting.together->provider;
  return by ? shared_.claims(entry.target, model_.providers[*by].group) : shared_.claims(entry.target);
}

/// Sets `contest.unpushed` if their conditions exclude each other.
bool Contests::match(const Meeting& meeting, const Side& first, const Side& second, Contest& contest) const {
  if (first.claim == nullptr || second.claim == nullptr || !have_equal_rank(meeting, first.reach, second.reach))
    return false;
  contest.unpushed.reset();
  if (compatible(first.claim->region, second.claim->region)) return true;
  contest.unpushed = find_unpushed(contest.group, first, second.claim->region);
  if (!contest.unpushed) {
    contest.unpushed = find_unpushed(contest.group, second, first.claim->region);
    if (contest.unpushed) contest.unpushed->second = true;
  }
  return contest.unpushed.has_value();
}

/// Whether the task that waits for the group could push for all of its conditions that are false while the other one
/// has it. A task above it waits for its own conditions by itself, and not for the group.
std::optional<BlockedPusher> Contests::find_unpushed(GroupId group, const Side& waiting, const Region& other) const {
  const Claim* claim = waiting.claim;
  LastStep last = claim->held.value_or(claim->last);
  while (claim->steps > 0 && last.step.by_need) {
    group = last.step.from;
    claim = waiting.claims.on_path(group, last.reach_from);
    last = claim->last;
  }
  const std::vector<const Want*> wants = shared_.wants_of(group);
  if (wants.empty()) return std::nullopt;
  if (claim->steps > 0) {
    const std::vector<Branch>& branches = shared_.branches().from(last.step.from);
    const bool requested = std::any_of(branches.begin(), branches.end(), [&](const Branch& branch) {
      return branch.to == group && !branch.by_need && compatible(branch.region, other);
    });
    if (!requested || !compatible(waiting.claims.on_path(last.step.from, last.reach_from)->region, other))
      return std::nullopt;
  }
  std::optional<BlockedPusher> out;
  for (const auto& [state, values] : waiting.claim->region.states) {
    const auto theirs = other.states.find(state);
    if (theirs == other.states.end() || values.overlaps(theirs->second)) continue;
    const auto want = std::find_if(wants.begin(), wants.end(), [&, &state = state, &values = values](const Want* each) {
      const Condition& condition = model_.conditions[each->condition.id];
      return condition.state == state && values.subset_of(condition.accepts);
    });
    if (want == wants.end()) return std::nullopt;
    if (!out) out = BlockedPusher{false, group, *want};
  }
  return out;
}

/// What both may want, those with the shortest chains first.
std::vector<Contest> Contests::find_candidates(const Meeting& meeting) const {
  std::vector<Contest> out;
  const Claims& first = claims(meeting, *meeting.first);
  const Claims& second = claims(meeting, *meeting.second);
  const std::optional<ProviderId> by = meeting.together->provider;
  // What their requester needs is held before either is tried: which of the two has it does not depend on rank.
  const Groups* const kept = by ? &takers_.held_by(model_.providers[*by].group) : nullptr;
  for (const GroupId group : in_common(first.groups(), second.groups())) {
    if (kept != nullptr && has(*kept, group)) continue;
    for (const Reach a : all_reaches) {
      for (const Reach b : all_reaches) {
        const Side x{first, first.find(group, a), a}, y{second, second.find(group, b), b};
        Contest contest{group, a, b, 0, {}, {}, {}};
        if (!match(meeting, x, y, contest)) continue;
        contest.steps = x.claim->steps + y.claim->steps;
        out.push_back(std::move(contest));
      }
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const Contest& x, const Contest& y) { return x.steps < y.steps; });
  return out;
}

/// The first one with chains that do not meet before the end, and rather one whose conditions can hold at once. All are
/// tried: for two that lead to each other the nearest hundreds may have none.
std::optional<Contest> Contests::find(const Meeting& meeting, const std::vector<Contest>& candidates) {
  Lookups lookups;
  std::optional<Contest> out;
  for (const Contest& candidate : candidates) {
    if (effort_ > most_effort) {
      leave_open(meeting);
      return out;
    }
    if (out && candidate.unpushed) continue;
    Contest contest = candidate;
    if (!find_paths(meeting, contest, lookups)) continue;
    if (!contest.unpushed) return contest;
    if (!out) out = std::move(contest);
  }
  return out;
}

/// For a contest that was found.
std::optional<MutualWait> Contests::find_mutual_wait(const Meeting& meeting, const std::vector<Contest>& candidates,
                                                     const Contest& contest) {
  const std::set<GroupId> held = held_before(contest.first_path);
  if (held.empty() || contest.unpushed) return std::nullopt;
  Lookups lookups;
  for (Contest other : candidates) {
    if (effort_ > most_effort) return std::nullopt;
    // A group has one holder: nothing waits for a group that both hold.
    if (other.group == contest.group || held.count(other.group) == 0 || other.unpushed ||
        !find_paths(meeting, other, lookups) || other.unpushed)
      continue;
    if (held_before(other.second_path).count(contest.group) != 0)
      return MutualWait{other.group, std::move(other.first_path), std::move(other.second_path)};
  }
  return std::nullopt;
}

/// What is certainly held when the last request of a chain is made: needs are granted all at once.
std::set<GroupId> Contests::held_before(const std::vector<ChainStep>& chain) const {
  const auto last = std::find_if(chain.rbegin(), chain.rend(), [](const ChainStep& step) { return !step.by_need; });
  std::set<GroupId> out;
  for (auto step = last; step != chain.rend(); ++step) {
    const auto& parts = shared_.indispensable().of(step->from);
    if (parts) out.insert(parts->begin(), parts->end());
  }
  return out;
}

/// Recorded once for all pairs from there on.
void Contests::leave_open(const Meeting& meeting) {
  if (std::exchange(is_open_, true)) return;
  shared_.budget().leave_open(meeting.second->span,
                              fmt::format("whether two tasks with equal rank compete, from {} and {} on",
                                          name_of(model_, meeting.first->target),
                                          name_of(model_, meeting.second->target)));
}

/// Two chains that have no group in common above the contested one: otherwise they would meet at that group.
bool Contests::find_paths(const Meeting& meeting, Contest& contest, Lookups& lookups) {
  const Claims& first = claims(meeting, *meeting.first);
  const Claim* ours = first.find(contest.group, contest.first);
  const LastStep last = ours->held.value_or(ours->last);
  Above& known = lookups[{ours->steps > 0, last.step.from, last.reach_from}];
  ++effort_;
  if (known.leads_through) return false;
  const auto serves = [&](GroupId group, Reach reach, const Claim& claim) {
    return group == contest.group && reach == contest.second &&
           have_equal_rank(meeting, contest.first, contest.second) && compatible(ours->region, claim.region);
  };
  const auto find_second = [&](const Claims& second) {
    const Side theirs{second, second.find(contest.group, contest.second), contest.second};
    if (!match(meeting, {first, ours, contest.first}, theirs, contest)) return false;
    contest.first_path = first.path(contest.group, contest.first);
    contest.second_path = second.path(contest.group, contest.second);
    return true;
  };
  if (known.without) return find_second(*known.without);
  std::vector<GroupId> above;
  if (meeting.together->provider) above.push_back(model_.providers[*meeting.together->provider].group);
  for (const ChainStep& step : first.path(contest.group, contest.first)) above.push_back(step.from);
  effort_ += above.size();
  known.leads_through = std::find(above.begin(), above.end(), meeting.second->target) != above.end();
  if (known.leads_through) return false;
  Claims second(shared_.branches(), meeting.second->target, above, serves);
  effort_ += second.effort();
  if (find_second(second)) return true;
  known.without = std::move(second); // the search was complete
  return false;
}

} // namespace director::analysis
