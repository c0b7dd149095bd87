// Header: compiler/analysis/conflicts/contenders.hpp. Test: compiler/checks/undeclared_need.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/contenders.hpp"

#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/requests/company.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::analysis {

namespace {

using ChainEntry = Chains::Entry;

/// Limit for the candidates of one group that are examined closely; those with the shortest chains are taken.
constexpr std::size_t most_candidates_kept = 8;
/// Limit for collected candidates, in the order of declaration.
constexpr std::size_t most_collected = 64;

class ContenderSearch {
public:
  ContenderSearch(const Input& input, ProviderId provider, GroupId group)
      : input_(input),
        own_(input.model.providers[provider].group),
        region_(active_region(input.model, input.model.providers[provider])),
        group_(group) {}

  std::optional<Contender> run() {
    const Chains& chains = input_.shared.chains();
    const std::vector<ChainEntry>& theirs = chains.entries_above(group_, Chains::End::held);
    auto first = theirs.begin();
    for (const ChainEntry& ours : chains.entries_above(own_)) {
      if (candidates_.size() >= most_collected) break;
      while (first != theirs.end() && first->together < ours.together) ++first;
      for (auto at = first; at != theirs.end() && at->together == ours.together; ++at) {
        if (at->task->target != ours.task->target && at->task->target != own_ && candidates_.size() < most_collected &&
            may_win(ours, *at))
          look_at(ours, *at);
      }
    }
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.steps < b.steps; });
    if (candidates_.size() > most_candidates_kept) candidates_.resize(most_candidates_kept);
    for (const Candidate& candidate : candidates_) {
      if (auto contender = confirm(candidate)) return contender;
    }
    return std::nullopt;
  }

private:
  struct Candidate {
    Meeting meeting;
    Reach reach = Reach::own;
    std::size_t steps = 0;
  };

  /// Whether there are levels at which the other one does not go after.
  bool may_win(const ChainEntry& ours, const ChainEntry& theirs) const {
    const std::vector<Level>& a = input_.model.edges[ours.task->edge].levels;
    const std::vector<Level>& b = input_.model.edges[theirs.task->edge].levels;
    return std::any_of(ours.task->levels.begin(), ours.task->levels.end(), [&](const Task::NamedLevel& own) {
      return std::any_of(theirs.task->levels.begin(), theirs.task->levels.end(), [&](const Task::NamedLevel& other) {
        const bool optional = a[own.level].optional || ours.optional;
        return b[other.level].priority >= a[own.level].priority || (optional && !b[other.level].optional);
      });
    });
  }

  /// Examines the nearest path of one entry, at all levels at which the two meet.
  void look_at(const ChainEntry& ours, const ChainEntry& theirs) {
    const Model& model = input_.model;
    const Claims& claims = input_.shared.claims(theirs.task->target);
    std::optional<Candidate> best;
    for (const Task::NamedLevel& a : ours.task->levels) {
      for (const Task::NamedLevel& b : theirs.task->levels) {
        Meeting meeting{ours.together, ours.task, theirs.task, model.edges[ours.task->edge].levels[a.level],
                        model.edges[theirs.task->edge].levels[b.level]};
        // The worst case for its own chain is the optional one.
        meeting.first_optional = meeting.first_level.optional || ours.optional;
        for (const Reach reach : all_reaches) {
          const Claim* claim = claims.find(group_, reach);
          if (claim == nullptr || (best && best->steps <= claim->steps) || !compatible(claim->region, region_))
            continue;
          meeting.second_optional = meeting.second_level.optional || reach == Reach::optional;
          // What a unit holds from the beginning is left to another check.
          if (meeting.first_goes_before() || (meeting.one_unit() && reach == Reach::own)) continue;
          best = Candidate{meeting, reach, claim->steps};
        }
      }
    }
    if (best) candidates_.push_back(*best);
  }

  /// A group is held once: the two chains have no common group above.
  std::optional<Contender> confirm(const Candidate& candidate) const {
    const Meeting& meeting = candidate.meeting;
    std::vector<GroupId> above{own_, meeting.first->target};
    for (const ChainStep& step : input_.shared.claims(meeting.first->target).path(own_)) above.push_back(step.from);
    if (std::find(above.begin(), above.end(), meeting.second->target) != above.end()) return std::nullopt;
    const auto serves = [&](GroupId group, Reach reach, const Claim& claim) {
      return group == group_ && reach == candidate.reach && compatible(claim.region, region_);
    };
    const Claims claims(input_.shared.branches(), meeting.second->target, above, serves);
    const Claim* claim = claims.find(group_, candidate.reach);
    if (claim == nullptr || !compatible(claim->region, region_)) return std::nullopt;
    return Contender{meeting, claims.path(group_, candidate.reach)};
  }

  const Input& input_;
  GroupId own_;
  Region region_;
  GroupId group_;
  std::vector<Candidate> candidates_;
};

/// Groups that the provider holds from the beginning with each of its plans.
std::vector<GroupId> reserved_groups(const Input& input, const Provider& provider) {
  std::vector<GroupId> out;
  for (const Use<GroupId>& need : provider.needs) {
    const auto& parts = input.shared.indispensable().of(need.id);
    if (parts) out.insert(out.end(), parts->begin(), parts->end());
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// If it were needed, other tasks of the provider might want what it takes, and never get it.
bool is_wanted_below(const Input& input, const Provider& provider, GroupId task) {
  const auto& parts = input.shared.indispensable().of(task);
  return parts && std::any_of(provider.packs.begin(), provider.packs.end(), [&](const Pack& pack) {
           return std::any_of(pack.tasks.begin(), pack.tasks.end(), [&](const Task& other) {
             const Claims& below = input.shared.claims(other.target);
             return other.target != task &&
                    std::any_of(parts->begin(), parts->end(), [&](GroupId part) { return below.contains(part); });
           });
         });
}

} // namespace

std::optional<Contender> find_contender(const Input& input, ProviderId provider, GroupId group) {
  return ContenderSearch(input, provider, group).run();
}

void add_contender(const Model& model, const Contender& contender, GroupId group, dsl::Diagnostic& finding) {
  const Meeting& meeting = contender.meeting;
  finding.notes.push_back(
      {meeting.second->span,
       fmt::format("{} may hold {}, and {} {}", name_of(model, meeting.second->target),
                   meeting.second->target == group ? "this" : name_of(model, group),
                   meeting.equal() ? "has the same rank as" : "goes before", name_of(model, meeting.first->target))});
  add_chain(model, contender.path, finding.notes);
}

std::vector<ContendedTask> find_contended_tasks(const Input& input, ProviderId id) {
  const Model& model = input.model;
  const Provider& provider = model.providers[id];
  const std::vector<GroupId> reserved = reserved_groups(input, provider);
  const auto is_reserved = [&](GroupId group) { return std::binary_search(reserved.begin(), reserved.end(), group); };
  /// Whether a group requests it that is neither the provider itself nor part of the task.
  const auto is_wanted_elsewhere = [&](GroupId group, const std::vector<GroupId>& parts) {
    const std::vector<EdgeId>& requesters = model.groups[group].requesters;
    return std::any_of(requesters.begin(), requesters.end(), [&](EdgeId edge) {
      const std::optional<GroupId> requester = model.edges[edge].requester;
      return !requester ||
             (*requester != provider.group && !std::binary_search(parts.begin(), parts.end(), *requester));
    });
  };
  std::vector<ContendedTask> out;
  SparseSet<GroupId> seen;
  for (const Pack& pack : provider.packs) {
    for (const Task* task : unit_members(model, pack)) {
      if (is_reserved(task->target) || !seen.add(task->target)) continue;
      const auto& parts = input.shared.indispensable().of(task->target);
      // What the provider itself holds the task never gets: another check reports that.
      if (!parts || std::any_of(parts->begin(), parts->end(), is_reserved)) continue;
      std::optional<ContendedTask> found;
      std::vector<GroupId> wanted{task->target};
      wanted.insert(wanted.end(), parts->begin(), parts->end());
      for (const GroupId part : wanted) {
        if (found || !is_wanted_elsewhere(part, *parts)) continue;
        if (auto contender = find_contender(input, id, part)) found = ContendedTask{task, part, std::move(*contender)};
      }
      if (found) out.push_back(std::move(*found));
    }
  }
  return out;
}

bool is_pushed_below(const Input& input, const Provider& above, GroupId task) {
  const auto leads_to = [&](GroupId group) {
    return std::any_of(above.packs.begin(), above.packs.end(), [&](const Pack& pack) {
      return std::any_of(pack.tasks.begin(), pack.tasks.end(),
                         [&](const Task& each) { return input.shared.claims(each.target).contains(group); });
    });
  };
  const auto is_held = [&](ProviderId causer) {
    const GroupId group = input.model.providers[causer].group;
    return group == task || input.shared.indispensable().contains(task, group);
  };
  return std::any_of(input.shared.wants().begin(), input.shared.wants().end(), [&](const Wanting& wanting) {
    return std::any_of(
               wanting.wants.begin(), wanting.wants.end(),
               [&](const Want& want) { return std::any_of(want.causers.begin(), want.causers.end(), is_held); }) &&
           leads_to(wanting.task);
  });
}

bool may_be_needed(const Input& input, ProviderId provider, const ContendedTask& contended) {
  const Meeting& meeting = contended.contender.meeting;
  // A unit takes its needs before anything below it is tried.
  const bool from_unit = meeting.one_unit() && !contended.contender.path.empty();
  // What is pushed would lack it while the other one has it.
  return !from_unit && !input.facts.may_wait.contains(contended.task->target) &&
         !input.facts.pushed.contains(provider) &&
         !is_pushed_below(input, input.model.providers[provider], contended.task->target) &&
         !is_wanted_below(input, input.model.providers[provider], contended.task->target);
}

bool stop_matters(const Model& model, GroupId group) {
  const Group& row = model.groups[group];
  return row.stop || std::any_of(row.providers.begin(), row.providers.end(),
                                 [&](ProviderId id) { return !model.providers[id].causing.empty(); });
}

std::optional<Deferring> find_deferring(const Input& input, const Pack& pack, const Task& task, GroupId skill) {
  const Model& model = input.model;
  const auto& parts = input.shared.indispensable().of(skill);
  if (!parts) return std::nullopt;
  // A group that waits for a promise of the skill requests nothing meanwhile.
  const auto waits_for_skill = [&](GroupId group) {
    const std::vector<ProviderId>& providers = model.groups[group].providers;
    return std::all_of(providers.begin(), providers.end(), [&](ProviderId id) {
      const std::vector<ConditionUse>& when = model.providers[id].when;
      return std::any_of(when.begin(), when.end(), [&](const ConditionUse& use) {
        const std::vector<ProviderId>& causers = input.shared.causers()[use.id];
        return std::any_of(causers.begin(), causers.end(),
                           [&](ProviderId causer) { return model.providers[causer].group == skill; });
      });
    });
  };
  for (const Task& other : pack.tasks) {
    if (other.edge == task.edge || (model.is_always_member(other) && model.is_always_member(task)) ||
        !Company::goes_first(model, other, task) || Company::goes_first(model, task, other))
      continue;
    const Claims& below = input.shared.claims(other.target);
    if (below.contains(skill) || waits_for_skill(other.target)) continue;
    for (const GroupId part : *parts) {
      if (part != skill && below.contains(part) && !input.shared.indispensable().contains(other.target, part))
        return Deferring{&other, part};
    }
  }
  return std::nullopt;
}

const Use<GroupId>* find_needed_task(const Model& model, const Provider& provider) {
  for (const Use<GroupId>& need : provider.needs) {
    for (const Pack& pack : provider.packs) {
      for (const Task* task : unit_members(model, pack)) {
        if (task->target == need.id) return &need;
      }
    }
  }
  return nullptr;
}

} // namespace director::analysis
