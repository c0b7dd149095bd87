// Header: compiler/checks/report_starving_task.hpp. Test: compiler/checks/starved_task.md.
// SPDX-License-Identifier: MIT
#include "compiler/checks/report_starving_task.hpp"

#include "compiler/analysis/conflicts/outranked.hpp"
#include "compiler/analysis/pairs/ways.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/requests/company.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace director::checks {

namespace {

std::string taken_by(const Model& model, const Taker& one) {
  return name_of(model, one.kind == Taker::Kind::above ? one.holder : one.by->target);
}

/// All that refuses one provider.
std::vector<std::string> refused_by(const Model& model, const Refusal& refusal) {
  std::vector<std::string> out{taken_by(model, refusal.taker)};
  for (const Taker& other : refusal.others) {
    std::string name = taken_by(model, other);
    if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(std::move(name));
  }
  return out;
}

/// Of those that are requested with the task, the others that would take as much once the first ones are not requested.
std::vector<std::string> find_next_takers(const Input& input, const Refused& refused,
                                          const std::vector<std::string>& first) {
  std::vector<std::string> out;
  const Model& model = input.model;
  const Task& task = *refused.task;
  const auto ways = find_ways(input.shared.units(), task.target);
  if (!ways || !refused.requester) return out;
  const auto takes_all = [&](const Task& each) {
    const auto others = find_ways(input.shared.units(), each.target);
    return others && Company::goes_first(model, each, task) && !leaves_all(input, *others, *ways, true);
  };
  for (const ProviderId id : model.groups[*refused.requester].providers) {
    for (const Pack& pack : model.providers[id].packs) {
      const bool is_its =
          std::any_of(pack.tasks.begin(), pack.tasks.end(), [&](const Task& one) { return &one == &task; });
      if (!is_its) continue;
      for (const Task& each : pack.tasks) {
        std::string name = name_of(model, each.target);
        const bool is_known = &each == &task || std::find(first.begin(), first.end(), name) != first.end();
        if (!is_known && takes_all(each)) out.push_back(std::move(name));
      }
    }
  }
  return out;
}

/// Places where the task would run: each of its providers has what refuses it.
std::string propose_elsewhere(const Input& input, const Refused& refused) {
  const Model& model = input.model;
  std::vector<std::vector<std::string>> all;
  for (const Refusal& refusal : refused.refusals) {
    std::vector<std::string> names = refused_by(model, refusal);
    if (std::find(all.begin(), all.end(), names) == all.end()) all.push_back(std::move(names));
  }
  if (refused.together.empty() || all.size() == 1) {
    std::vector<std::string> fewest =
        *std::min_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
    for (std::string& next : find_next_takers(input, refused, fewest)) fewest.push_back(std::move(next));
    if (fewest.size() == 1) return fmt::format("request it where {} is not requested", fewest.front());
    return fmt::format("request it where {} {} is requested", fewest.size() == 2 ? "neither" : "none of",
                       list_of(fewest, fewest.size() == 2 ? "nor" : "and"));
  }
  // Otherwise the one that is still refused, or comes later, would never run.
  std::string out = "request it ";
  for (std::size_t i = 0; i < all.size(); ++i)
    out += fmt::format("{}{} pack without {}",
                       i == 0                ? "in "
                       : i + 1 == all.size() ? " and in "
                                             : ", in ",
                       i == 0 ? "one" : "another", list_of(all[i]));
  return out;
}

/// Whether each run of the group requests the task, directly or by what it requests.
bool leads_always(const Input& input, GroupId from, GroupId task, std::set<GroupId>& seen) {
  if (from == task) return true;
  if (!seen.insert(from).second) return false;
  const std::vector<ProviderId>& all = input.model.groups[from].providers;
  return std::all_of(all.begin(), all.end(), [&](ProviderId id) {
    const Provider& provider = input.model.providers[id];
    if (!input.facts.active.contains(id)) return true;
    return provider.has_packs && std::all_of(provider.packs.begin(), provider.packs.end(), [&](const Pack& pack) {
             return std::any_of(pack.tasks.begin(), pack.tasks.end(),
                                [&](const Task& each) { return leads_always(input, each.target, task, seen); });
           });
  });
}

/// Whether the taker would still run if the order were reversed, with each of its providers.
bool may_go_after(const Input& input, const Refused& refused, const Taker& taker) {
  const GroupId task = refused.task->target;
  std::set<GroupId> seen;
  if (taker.over != refused.task && !leads_always(input, taker.over->target, task, seen)) return true;
  const auto first = find_ways(input.shared.units(), task), second = find_ways(input.shared.units(), taker.by->target);
  return first && second && leaves_all(input, *first, *second);
}

/// Whether there is a chain of requests between the two groups without an optional one.
bool leads_firmly(const Input& input, GroupId from, GroupId to) {
  return from == to || input.shared.claims(from).on_path(to, Reach::mandatory) != nullptr;
}

/// Help for a mandatory task. A lower rank within one unit does not change that its needs are taken before anything
/// below is tried.
std::string propose(const Input& input, const Refused& refused, const Taker& taker) {
  const Model& model = input.model;
  if (taker.kind == Taker::Kind::above)
    return fmt::format("request it where {} is not above it", name_of(model, taker.holder));
  const std::string elsewhere = propose_elsewhere(input, refused);
  // Priorities decide only between tasks of which both or neither are optional.
  const Takers& takers = input.conflicts.takers();
  if (taker.kind == Taker::Kind::unit || !refused.together.empty() ||
      std::any_of(refused.refusals.begin(), refused.refusals.end(),
                  [](const Refusal& refusal) { return !refusal.others.empty(); }))
    return elsewhere;
  const bool is_own = taker.over == refused.task;
  if (!is_own && model.is_always_member(*taker.by) && model.is_always_member(*taker.over)) return elsewhere;
  if (!may_go_after(input, refused, taker)) return elsewhere;
  if (is_own) {
    const Task* const leader = taker.led_by();
    return fmt::format("give it a higher priority{}, or {}",
                       leader == nullptr ? "" : " than " + name_of(model, leader->target), elsewhere);
  }
  if (!leads_firmly(input, taker.over->target, *refused.requester) && takers.is_mandatory(*taker.by)) return elsewhere;
  const bool goes_after_all = !takers.is_mandatory(*taker.over) && !takers.is_optional(*taker.by);
  const std::string over = name_of(model, taker.over->target), by = name_of(model, taker.by->target);
  return goes_after_all ? fmt::format("make {} `apart` instead of `optional`, with a higher priority than {}, or {}",
                                      over, by, elsewhere)
                        : fmt::format("give {} a higher priority than {}, or {}", over, by, elsewhere);
}

/// Null: the task that takes it cannot be pushed for what it waits for.
const Outranked* find_pushed_taker(const Input& input, const Task& task, const Taker& taker) {
  if (taker.kind != Taker::Kind::before) return nullptr;
  const std::vector<Outranked>& all = input.conflicts.outranked();
  const auto at = std::find_if(all.begin(), all.end(), [&](const Outranked& one) {
    return one.request == &task && one.first != nullptr && one.first->target == taker.by->target;
  });
  return at == all.end() ? nullptr : &*at;
}

/// Several tasks that go before it take everything only together.
std::string message_of(const Model& model, const Refused& refused) {
  std::vector<std::string> by, groups;
  for (const Taker& taker : refused.together) {
    by.push_back(taken_by(model, taker));
    std::string group = name_of(model, taker.group);
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(std::move(group));
  }
  return fmt::format(
      "{} never runs for {}: {}, which go before it and never have to wait, are always requested with it and take {}",
      name_of(model, refused.task->target), name_of(model, *refused.requester), list_of(by), list_of(groups));
}

} // namespace

void report_starving_task(const Input& input, const StarvingTask& starving, Findings& findings) {
  const Model& model = input.model;
  const Refused& first = starving.places.front();
  const Taker& taker = starving.taker();
  const std::string name = name_of(model, first.task->target), requester = name_of(model, *first.requester);
  const std::string by = taken_by(model, taker), group = name_of(model, taker.group);
  dsl::Diagnostic& finding = findings.add(
      first.task->span,
      taker.kind == Taker::Kind::above
          ? fmt::format("{} never runs for {}: {}, which is above it, keeps {}", name, requester, by, group)
          : fmt::format(
                "{} never runs for {}: {}, which goes before it and never has to wait, is always requested with it "
                "and takes {}",
                name, requester, by, group));
  finding.rules_out = {first.task->span};
  const bool several =
      !first.together.empty() && std::all_of(first.together.begin(), first.together.end(),
                                             [](const Taker& one) { return one.kind == Taker::Kind::before; });
  if (several) {
    finding.message = message_of(model, first);
    for (const Taker& one : first.together) add_taker(input, first, one, finding.notes);
  } else {
    add_taker(input, first, taker, finding.notes);
  }
  std::set<const Task*> reported{first.task};
  for (std::size_t i = 1; i < starving.places.size(); ++i) {
    const Refused& place = starving.places[i];
    const Taker& one = place.refusals.front().taker;
    if (reported.insert(place.task).second)
      finding.notes.push_back({place.task->span, fmt::format("the same here, by {}, which takes {}",
                                                             taken_by(model, one), name_of(model, one.group))});
  }
  // Where that is not requested, it would wait for ever.
  if (const Outranked* pushed = find_pushed_taker(input, *first.task, taker)) {
    finding.help = propose_going_first(model, *pushed);
    return;
  }
  finding.help = starving.optional && taker.kind != Taker::Kind::above
                     ? propose_elsewhere(input, first) + ": what is optional goes after all that is mandatory"
                 : starving.optional
                     ? fmt::format("request it where {} is not requested: what is optional goes after all "
                                   "that is mandatory",
                                   by)
                     : propose(input, first, taker);
}

} // namespace director::checks
