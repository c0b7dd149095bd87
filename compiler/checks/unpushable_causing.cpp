// Header: compiler/checks/check.hpp. Test: compiler/checks/unpushable_causing.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/causing_cycles.hpp"
#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/waiting.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/states/stopped_values.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/proposals.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

namespace director::checks {

namespace {

using dsl::Diagnostic;

/// Why one task does not go before another, where they meet.
struct Obstacle {
  Meeting meeting;
  GroupId waiter{};
  bool one_unit = false;
  bool waits_with = false;            ///< it is not granted while the task waits, except in one unit with it
  const Use<GroupId>* need = nullptr; ///< by which their requester claims the group before both; null: there is none
};

struct Obstacles {
  std::vector<Obstacle> all;
  bool meet = false;         ///< somewhere; false: one is always below the other
  bool none_waits = false;   ///< each has another way to run, so that rank does not matter
  bool waits_itself = false; ///< the causing provider runs only while the condition holds already
};

const Use<GroupId>* need_of(const Model& model, const Together& together, GroupId group) {
  if (!together.provider) return nullptr;
  const std::vector<Use<GroupId>>& needs = model.providers[*together.provider].needs;
  const auto at = std::find_if(needs.begin(), needs.end(), [&](const Use<GroupId>& need) { return need.id == group; });
  return at == needs.end() ? nullptr : &*at;
}

/// For the meetings of a waiting task and a group, the first at each pair of entries.
void find_obstacles(const Model& model, const Chains& chains, GroupId waiter, GroupId other, Obstacles& to) {
  std::vector<Obstacle> out;
  chains.visit(waiter, {other}, [&](const Meeting& meeting, GroupId) {
    to.meet = true;
    const bool known = std::any_of(out.begin(), out.end(), [&](const Obstacle& obstacle) {
      return obstacle.meeting.first == meeting.first && obstacle.meeting.second == meeting.second;
    });
    const bool in_unit = meeting.one_unit();
    const Use<GroupId>* const need = need_of(model, *meeting.together, other);
    if (!known && (need != nullptr || in_unit || !meeting.first_goes_before()))
      out.push_back({meeting, waiter, in_unit && meeting.second->target == other,
                     in_unit && meeting.first->target == waiter, need});
  });
  to.all.insert(to.all.end(), out.begin(), out.end());
}

std::string rank(const Level& level, bool optional) {
  return fmt::format("{}priority {}", optional ? "optional, " : "", level.priority);
}

void explain(const Model& model, const Obstacle& obstacle, GroupId waiter, GroupId other, Diagnostic& finding) {
  const Meeting& meeting = obstacle.meeting;
  const std::string first = name_of(model, meeting.first->target), second = name_of(model, meeting.second->target);
  if (obstacle.need != nullptr) {
    finding.notes.push_back(
        {obstacle.need->span, fmt::format("{} needs {}, and claims it before anything that it requests is tried",
                                          name_of(model, *meeting.together->provider), name_of(model, other))});
    return;
  }
  if (obstacle.one_unit) {
    finding.notes.push_back(
        {meeting.second->span,
         fmt::format("{} is granted together with {}, before anything below them is tried", second, first)});
    finding.notes.push_back({meeting.first->span, meeting.first->target == waiter
                                                      ? fmt::format("{} waits here", first)
                                                      : fmt::format("{} is below {}", name_of(model, waiter), first)});
    return;
  }
  const auto side = [&](GroupId entry, GroupId meant, const std::string& text) {
    return entry == meant ? text : fmt::format("{}, which leads to {},", text, name_of(model, meant));
  };
  finding.notes.push_back(
      {meeting.second->span, fmt::format("here {} has {}", side(meeting.second->target, other, second),
                                         rank(meeting.second_level, meeting.second_optional))});
  finding.notes.push_back({meeting.first->span, fmt::format("and {} has {}", side(meeting.first->target, waiter, first),
                                                            rank(meeting.first_level, meeting.first_optional))});
}

/// If it were mandatory it would be granted together with the other one, so it has to be `apart`.
std::string propose_mandatory(const Model& model, const Obstacle& obstacle) {
  const Meeting& meeting = obstacle.meeting;
  const std::string first = name_of(model, meeting.first->target), second = name_of(model, meeting.second->target);
  const bool ranks = meeting.first_level.priority > meeting.second_level.priority;
  const std::string begin = "an optional task goes after all others: ";
  if (!meeting.first_level.optional)
    return begin + fmt::format("let what leads from {} to {} be mandatory", first, name_of(model, obstacle.waiter)) +
           (ranks ? "" : fmt::format(", and give {} a higher priority than {}", first, second));
  return begin + fmt::format("make {} {}", first, meeting.together->provider ? "`apart` instead" : "mandatory") +
         (ranks ? "" : fmt::format(", with a higher priority than {}", second));
}

/// Of a flat list, a run may request the one without the other.
std::string in_packs(const Obstacle& obstacle, const std::string& help) {
  const Together& together = *obstacle.meeting.together;
  if (!together.provider || together.whole) return help;
  return "say with `packs` that both are requested, and " + help;
}

/// A provider before the waiting one, and a condition of it: while that is false, the group waits for it. If nothing
/// promises it, the group pushes nothing; otherwise what promises it.
struct Before {
  ProviderId waiter{}, earlier{};
  ConditionUse condition;
  std::optional<ProviderId> causer;
};

std::optional<Before> find_before(const Input& input, ProviderId waiter) {
  const Model& model = input.model;
  std::optional<Before> promised;
  for (const ProviderId earlier : model.groups[model.providers[waiter].group].providers) {
    if (earlier == waiter) break;
    if (!input.facts.capable.contains(earlier) || !needs_no_more(model.providers[earlier], model.providers[waiter]))
      continue;
    for (const ConditionUse& use : model.providers[earlier].when) {
      if (input.facts.holds_always(model, use.id, Region{})) continue;
      const std::vector<ProviderId>& causers = input.shared.causers()[use.id];
      if (causers.empty()) return Before{waiter, earlier, use, std::nullopt};
      if (!promised) promised = Before{waiter, earlier, use, causers.front()};
    }
  }
  return promised;
}

/// What lets the provider wait, and push, although another one comes first.
std::string propose_order(const Model& model, const Before& before) {
  const std::string waiter = name_of(model, before.waiter), earlier = name_of(model, before.earlier);
  if (find_own_step(model, before.waiter) != nullptr) // in front of the others, it would be left as soon as it waits
    return fmt::format("let {} request a group that waits instead", waiter);
  if (before.causer)
    return fmt::format("let {} only choose between {} and {}, each of which requests a group that waits",
                       name_of(model, model.providers[before.waiter].group), earlier, waiter);
  // If both could run, the order would decide which of them does.
  const bool exclude = !compatible(region_of(model, model.providers[before.waiter].when),
                                   region_of(model, model.providers[before.earlier].when));
  return exclude ? fmt::format("put {0} before {1}, or choose between the two in a group above, so that {0} waits in a "
                               "group of its own",
                               waiter, earlier)
                 : fmt::format("choose between {1} and {0} in a group above, so that {0} waits in a group of its own",
                               waiter, earlier);
}

std::string propose_rank(const Model& model, const Obstacle& obstacle) {
  if (obstacle.need != nullptr)
    return fmt::format("instead of needing {} here, request it `apart`, with a lower priority",
                       name_of(model, obstacle.need->id));
  const std::string first = name_of(model, obstacle.meeting.first->target);
  const std::string second = name_of(model, obstacle.meeting.second->target);
  if (obstacle.one_unit && obstacle.meeting.first_goes_before())
    return in_packs(obstacle, fmt::format("make {} `apart`, or request it one level lower", second));
  if (obstacle.meeting.first_optional != obstacle.meeting.second_optional) return propose_mandatory(model, obstacle);
  if (obstacle.one_unit || obstacle.waits_with)
    return in_packs(obstacle, fmt::format("make {} `apart`, with a higher priority than {}", first, second));
  return in_packs(obstacle, fmt::format("give {} a higher priority than {}", first, second));
}

std::string propose(const Model& model, const NeverKept& promise, const Obstacles& obstacles,
                    const std::optional<Before>& before) {
  if (obstacles.meet && obstacles.all.empty() && before) return propose_order(model, *before);
  if (obstacles.meet && obstacles.all.empty() && obstacles.waits_itself) return {};
  if (obstacles.meet && (obstacles.none_waits || obstacles.all.empty())) {
    const bool other_ways = std::any_of(promise.waiting.begin(), promise.waiting.end(), [&](const auto& each) {
      return model.group_of(each.provider).providers.size() > 1;
    });
    return fmt::format("leave out {}{} and what waits for it",
                       other_ways ? "either the other ways of those that wait for it, or " : "",
                       name_of(model, promise.causer));
  }
  if (obstacles.all.empty())
    return fmt::format("request the two side by side, what waits with the higher priority and, in a pack, `apart`{}: a "
                       "task pushes nothing below itself, nothing above, and nothing that is never requested with it",
                       obstacles.none_waits ? ", and let those that wait for it have no other way" : "");
  const Obstacle& obstacle = obstacles.all.front();
  const std::string rank = propose_rank(model, obstacle);
  if (!before || model.providers[before->waiter].group != obstacle.waiter) return rank;
  return fmt::format("{}; and {}", rank, propose_order(model, *before));
}

/// Why it runs only while its promise holds already.
void add_own_conditions(const Model& model, const PushExclusion& exclusion, const NeverKept& promise,
                        Diagnostic& finding) {
  std::vector<ProviderId> all = exclusion.needed(promise.causer);
  all.insert(all.begin(), promise.causer);
  for (const ProviderId id : all) {
    for (const ConditionUse& use : model.providers[id].when) {
      if (model.conditions[use.id].state == model.conditions[promise.promise.id].state)
        add_once(runs_only_while(model, id, use), finding.notes);
    }
  }
}

/// Those that may wait for it; for others, whose group can always run another provider, rank does not matter. All of
/// them, if none may.
std::vector<NeverKept::Waiting> find_waiting(const Model& model, Waiting& waiting, const NeverKept& promise) {
  std::vector<NeverKept::Waiting> out;
  std::copy_if(promise.waiting.begin(), promise.waiting.end(), std::back_inserter(out),
               [&](const NeverKept::Waiting& each) { return waiting.may_wait(model.providers[each.provider].group); });
  return out.empty() ? promise.waiting : out;
}

void report(const Input& input, const CausingCycles& cycles, Waiting& waits, const NeverKept& promise,
            Findings& findings) {
  const Model& model = input.model;
  const Chains& chains = input.shared.chains();
  const GroupId group = model.providers[promise.causer].group;
  Diagnostic& finding = findings.add(
      promise.promise.span,
      fmt::format("{} could cause {}, but nothing that waits for it can ever push {}{}", name_of(model, promise.causer),
                  name_of(model, promise.promise.id), name_of(model, group),
                  promise.at_first ? ": once it is false, it never becomes true again" : ""));
  Obstacles obstacles;
  std::optional<Before> earlier;
  std::string causer_help; // if conditions exclude each other
  obstacles.none_waits = std::none_of(promise.waiting.begin(), promise.waiting.end(), [&](const auto& each) {
    return waits.may_wait(model.providers[each.provider].group);
  });
  finding.rules_out = {promise.promise.span};
  for (const NeverKept::Waiting& waiting : promise.waiting) finding.rules_out.push_back(waiting.condition.span);
  for (const NeverKept::Waiting& waiting : find_waiting(model, waits, promise)) {
    finding.notes.push_back({waiting.condition.span, fmt::format("{} waits for {}", name_of(model, waiting.provider),
                                                                 name_of(model, waiting.condition.id))});
    if (!model.satisfies(promise.promise.id, waiting.condition.id)) continue;
    const PushExclusion& exclusion = input.shared.push_exclusion();
    if (cycles.waits_for(promise.causer, waiting.condition.id)) {
      obstacles.waits_itself = true;
      add_own_conditions(model, exclusion, promise, finding);
    }
    if (const std::optional<StateId> state = exclusion.find(waiting.provider, promise.causer);
        state && !obstacles.none_waits) {
      add_exclusion(model, exclusion, *state, waiting.provider, promise.causer, finding.notes);
      if (causer_help.empty())
        causer_help =
            propose_causer(model, *state, exclusion.values_of(*state, waiting.provider), waiting.condition.id);
      continue;
    }
    if (const std::optional<Before> found = find_before(input, waiting.provider)) {
      const std::string order =
          fmt::format("{} comes first: where that cannot run either, {} waits for {}", name_of(model, found->earlier),
                      name_of(model, model.providers[found->earlier].group), name_of(model, found->condition.id));
      finding.notes.push_back({found->condition.span,
                               found->causer ? fmt::format("{}, which {} causes", order, name_of(model, *found->causer))
                                             : fmt::format("{}, which nothing promises, and pushes nothing", order)});
      if (!earlier) earlier = found;
    }
    const GroupId waiter = model.providers[waiting.provider].group;
    const std::size_t before = obstacles.all.size();
    find_obstacles(model, chains, waiter, group, obstacles);
    for (std::size_t i = before; i < obstacles.all.size() && !obstacles.none_waits; ++i)
      explain(model, obstacles.all[i], waiter, group, finding);
  }
  finding.help = causer_help.empty() || obstacles.meet ? propose(model, promise, obstacles, earlier) : causer_help;
  if (obstacles.waits_itself)
    finding.help = fmt::format("let {} begin while {} is false{}{}", name_of(model, promise.causer),
                               name_of(model, promise.promise.id), finding.help.empty() ? "" : ", and ", finding.help);
}

} // namespace

void unpushable_causing(const Input& input, Findings& findings) {
  Waiting waiting(input.model, input.facts);
  const CausingCycles cycles(input.model, input.facts, input.shared.causers());
  for (const NeverKept& promise : input.shared.promises().never_kept) {
    if (!promise.pushable) report(input, cycles, waiting, promise, findings);
  }
}

} // namespace director::checks
