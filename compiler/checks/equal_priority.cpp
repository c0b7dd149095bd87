// Header: compiler/checks/check.hpp. Test: compiler/checks/equal_priority.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/equals/equals.hpp"
#include "compiler/analysis/equals/withheld.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/reported_pairs.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/base/counted.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <list>
#include <set>
#include <utility>

namespace director::checks {

namespace {

using dsl::Diagnostic;

/// Adds each step once: two chains of one task often begin alike.
void add_new(const Model& model, const std::vector<ChainStep>& chain, dsl::Note::Link begins, Diagnostic& finding) {
  std::vector<dsl::Note> steps;
  add_chain(model, chain, steps, begins);
  for (dsl::Note& step : steps) add_once(std::move(step), finding.notes);
}

std::string message(const Model& model, const EqualPair& pair) {
  const Contest& contest = pair.contest;
  const std::string first = name_of(model, pair.meeting.first->target);
  const std::string second = name_of(model, pair.meeting.second->target);
  const std::string wanted = name_of(model, contest.group);
  if (pair.mutual_wait)
    return fmt::format("{0} and {1} have equal rank: {0} may hold {2} and want {3} while {1} holds {3} and wants {2}, "
                       "and then each waits for the other",
                       first, second, name_of(model, pair.mutual_wait->held), wanted);
  if (pair.leader != nullptr) {
    const std::string leader = name_of(model, pair.leader->target);
    return fmt::format("{0} and {1} have equal rank, and {0} and {2}, which may be granted together with {1}, may both "
                       "want {3}: the older request of {0} and {1} goes first",
                       second, leader, first, wanted);
  }
  const std::string both = fmt::format("{} and {} have equal rank and may both want {}", first, second, wanted);
  if (!contest.unpushed)
    return fmt::format("{}: whichever takes it first keeps it{}", both,
                       pair.open ? "" : fmt::format(", and if both want it at once {} takes it", first));
  return fmt::format("{}: while {} has it, {} is blocked and pushes nothing for {}", both,
                     contest.unpushed->second ? first : second, name_of(model, contest.unpushed->task),
                     name_of(model, contest.unpushed->want->condition.id));
}

void report(const Model& model, const EqualPair& pair, Findings& findings) {
  const auto& [meeting, contest, mutual_wait, stakes] = static_cast<const Rivalling&>(pair);
  using Link = dsl::Note::Link;
  Diagnostic& finding = findings.add(meeting.second->span, message(model, pair));
  const Task& equal = pair.leader != nullptr ? *pair.leader : *meeting.first;
  finding.notes.push_back({equal.span,
                           fmt::format("{} is requested here, with the same priority {}", name_of(model, equal.target),
                                       meeting.second_level.priority),
                           Link::first});
  if (pair.leader != nullptr)
    finding.notes.push_back(
        {meeting.first->span, fmt::format("{} is granted together with {}", name_of(model, meeting.first->target),
                                          name_of(model, equal.target))});
  if (mutual_wait) add_new(model, mutual_wait->first_path, Link::next, finding);
  add_new(model, contest.first_path, Link::next, finding);
  add_new(model, contest.second_path, Link::first, finding);
  if (mutual_wait) add_new(model, mutual_wait->second_path, Link::next, finding);
  if (contest.unpushed) {
    const Want& want = *contest.unpushed->want;
    finding.notes.push_back(runs_only_while(model, want.waiter, want.condition));
    finding.notes.push_back(causes(model, want.causers.front(), want.condition.id));
  }
  finding.help = pair.leader == nullptr
                     ? "give one of them a higher priority"
                     : fmt::format("give one of {} and {} a higher priority", name_of(model, meeting.second->target),
                                   name_of(model, pair.leader->target));
}

/// Limit, from which entries of one list that compete at one priority, each with another one of them, are one finding:
/// a list without priorities is one omission, not as many as it has pairs. The same for so many sets of a long list
/// (reported_pairs.hpp).
constexpr std::size_t many = 4;

/// `blocked`: the conditions of some of them exclude each other.
std::string_view winner_rule(bool blocked) {
  return blocked ? "whichever takes it first keeps it"
                 : "whichever takes it first keeps it, and of those that want it at once the one that is declared "
                   "first takes it";
}
constexpr std::string_view what_helps = "give them priorities that say which goes first";

/// Entries that compete at one priority, by index, and what they compete for.
struct Crowd {
  std::int32_t priority = 0;
  std::set<std::size_t> entries;
  std::set<GroupId> groups;
  std::vector<const EqualPair*> pairs;

  std::size_t second() const { return *std::next(entries.begin()); }
  bool blocked() const {
    return std::any_of(pairs.begin(), pairs.end(), [](const EqualPair* pair) { return pair->contest.unpushed; });
  }
};

/// Whether it is reported as a pair, whatever else is reported of the list.
bool is_alone(const EqualPair& pair) { return pair.mutual_wait || pair.leader != nullptr; }

/// The pairs of one list, merged if they share a priority and an entry.
std::list<Crowd> find_crowds(const std::vector<EqualPair>& all) {
  std::list<Crowd> out;
  for (const EqualPair& pair : all) {
    if (is_alone(pair)) continue;
    const std::int32_t priority = pair.meeting.first_level.priority;
    Crowd* home = nullptr;
    for (auto at = out.begin(); at != out.end();) {
      const bool meets =
          at->priority == priority && (at->entries.count(pair.earlier) != 0 || at->entries.count(pair.later) != 0);
      if (meets && home != nullptr) {
        home->entries.merge(at->entries);
        home->groups.merge(at->groups);
        home->pairs.insert(home->pairs.end(), at->pairs.begin(), at->pairs.end());
        at = out.erase(at);
        continue;
      }
      if (meets) home = &*at;
      ++at;
    }
    if (home == nullptr) {
      home = &out.emplace_back();
      home->priority = priority;
    }
    home->entries.insert({pair.earlier, pair.later});
    home->groups.insert(pair.contest.group);
    home->pairs.push_back(&pair);
  }
  return out;
}

class Reports {
public:
  Reports(const Model& model, const EqualList& list, Findings& findings)
      : model_(model),
        list_(list),
        tasks_(*list.together->tasks),
        findings_(findings) {}

  void run() {
    for (const EqualPair& pair : list_.pairs) {
      if (is_alone(pair)) report(model_, pair, findings_);
    }
    std::list<Crowd> crowds = find_crowds(list_.pairs);
    if (tasks_.size() > longest_with_all_pairs) report_list(crowds);
    for (const Crowd& crowd : crowds) {
      if (crowd.entries.size() >= many) {
        report_many(crowd);
      } else {
        for (const EqualPair* pair : crowd.pairs) report(model_, *pair, findings_);
      }
    }
  }

private:
  /// Reports many sets of a long list together, and removes them: correcting one leads to the others.
  void report_list(std::list<Crowd>& crowds) {
    std::vector<Crowd> reported;
    for (const Crowd& crowd : crowds) {
      if (!is_allowed(crowd)) reported.push_back(crowd);
    }
    if (reported.size() < many) return;
    crowds.remove_if([&](const Crowd& crowd) { return !is_allowed(crowd); });
    std::sort(reported.begin(), reported.end(), [](const Crowd& a, const Crowd& b) {
      return std::pair(*a.entries.begin(), a.priority) < std::pair(*b.entries.begin(), b.priority);
    });
    std::set<std::size_t> entries;
    for (const Crowd& crowd : reported) entries.insert(crowd.entries.begin(), crowd.entries.end());
    const auto by = list_.together->provider;
    Diagnostic& finding = findings_.add(
        tasks_[reported.front().second()].span,
        fmt::format(
            "of the tasks that {} requests {} have equal rank with others that may want the same, in {} sets: {}",
            by ? name_of(model_, *by) : "the program", entries.size(), reported.size(),
            winner_rule(
                std::any_of(reported.begin(), reported.end(), [](const Crowd& each) { return each.blocked(); }))));
    for (const Crowd& crowd : reported) {
      finding.notes.push_back(
          {tasks_[*crowd.entries.begin()].span, fmt::format("{} have priority {} and may want {}", few_of(names(crowd)),
                                                            crowd.priority, few_of(groups(crowd), "or"))});
    }
    finding.help = what_helps;
  }

  void report_many(const Crowd& crowd) {
    const std::vector<std::string> wanted = groups(crowd);
    const std::string what = wanted.size() == 1 ? fmt::format(" and may all want {}", wanted.front())
                                                : fmt::format(", and each may want what another one of them wants, {}",
                                                              few_of(wanted, "or"));
    Diagnostic& finding =
        findings_.add(tasks_[crowd.second()].span, fmt::format("{} have equal rank{}: {}", few_of(names(crowd)), what,
                                                               winner_rule(crowd.blocked())));
    for (const std::size_t entry : crowd.entries) {
      if (entry == crowd.second()) continue;
      finding.notes.push_back({tasks_[entry].span, fmt::format("{} is requested here, with the same priority {}",
                                                               name_of(model_, tasks_[entry].target), crowd.priority)});
    }
    shorten_list(finding.notes);
    finding.help = what_helps;
  }

  /// Whether an `allow` would cover a finding of its own.
  bool is_allowed(const Crowd& crowd) const {
    return std::any_of(model_.allowances.begin(), model_.allowances.end(), [&](const Allowance& allowance) {
      return allowance.id.value == "equal_priority" && allowance.scope.contains(tasks_[crowd.second()].span);
    });
  }

  std::vector<std::string> names(const Crowd& crowd) const {
    std::vector<std::string> out;
    for (const std::size_t entry : crowd.entries) out.push_back(name_of(model_, tasks_[entry].target));
    return out;
  }
  std::vector<std::string> groups(const Crowd& crowd) const {
    std::vector<std::string> out;
    for (const GroupId group : crowd.groups) out.push_back(name_of(model_, group));
    return out;
  }

  const Model& model_;
  const EqualList& list_;
  const std::vector<Task>& tasks_;
  Findings& findings_;
};

/// A provider that its group does not change to.
void report(const Model& model, const WithheldNeed& withheld, Findings& findings) {
  using Link = dsl::Note::Link;
  const std::string wanting = name_of(model, withheld.wanting), task = name_of(model, withheld.task->target);
  const std::string wanted = name_of(model, withheld.group);
  const GroupId group = model.providers[withheld.wanting].group;
  Diagnostic& finding =
      findings.add(withheld.task->span,
                   fmt::format("{} and {} have equal rank and may both want {}: while {} has it, {} stays with {}",
                               wanting, task, wanted, task, name_of(model, group), name_of(model, withheld.running)));
  finding.notes.push_back({withheld.need->span,
                           fmt::format("{} needs {}, with the same priority {}", wanting,
                                       name_of(model, withheld.need->id), withheld.level.priority),
                           Link::first});
  add_chain(model, need_path(model, withheld.need->id, withheld.group), finding.notes, Link::next);
  add_chain(model, withheld.path, finding.notes, Link::first);
  finding.help = fmt::format("give {} another priority: then {} takes {}", task, wanting, wanted);
}

} // namespace

void equal_priority(const Input& input, Findings& findings) {
  for (const EqualList& list : find_equals(input)) Reports(input.model, list, findings).run();
  for (const WithheldNeed& withheld : find_withheld_needs(input)) report(input.model, withheld, findings);
}

} // namespace director::checks
