// Header: compiler/analysis/conflicts/held_pushes.hpp. Test: compiler/checks/push_held_by_outside.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/held_pushes.hpp"

#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/facts/pushes.hpp"
#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/requests/company.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/covering.hpp"
#include "compiler/analysis/states/stopped_values.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

/// A unit with more combinations is not examined.
constexpr std::size_t most_combinations = 256;
/// Nor are requests below more than this many others.
constexpr std::size_t most_above = 32;

struct Choice {
  std::vector<ProviderId> picks; ///< each member before its needs
  Region region;                 ///< of their `when`
  bool taken = false;            ///< another task of the pack may keep one of its groups
};

class HeldPushSearch {
public:
  explicit HeldPushSearch(const Input& input)
      : model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        causers_(input.shared.causers()) {
    for (const Clash& clash : input.conflicts.clashes()) {
      clashing_.insert({model_.providers[clash.first_waiter].group, clash.first.id});
      clashing_.insert({model_.providers[clash.second_waiter].group, clash.second.id});
    }
  }

  std::vector<HeldPush> run() {
    for (const Task& root : model_.roots) look_at({std::nullopt, nullptr, &root}, {&root});
    for (const ProviderId id : model_.providers.ids()) {
      if (!facts_.active.contains(id)) continue;
      for (const Pack& pack : model_.providers[id].packs) look_at(id, pack);
    }
    return std::move(out_);
  }

private:
  void look_at(ProviderId requester, const Pack& pack) {
    const std::vector<const Task*> members = unit_members(model_, pack);
    if (members.size() > 1) look_at({requester, &pack, members.front()}, members);
    for (const Task& task : pack.tasks) {
      // A run may request one entry of a flat list alone.
      const bool alone = members.size() < 2 || pack.name.empty() || !model_.is_always_member(task);
      if (alone) look_at({requester, &pack, &task}, {&task});
    }
  }

  void look_at(const Request& request, const std::vector<const Task*>& members) {
    if (!may_be_held(members)) return;
    if (request.requester && std::any_of(members.begin(), members.end(), [&](const Task* member) {
          return model_.providers[*request.requester].needs_group(member->target);
        }))
      return; // it is granted with its requester
    const std::vector<Choice> choices = find_choices(request, members);
    if (choices.size() < 2) return;
    const auto front = std::find_if(choices.begin(), choices.end(), [](const Choice& choice) { return !choice.taken; });
    if (front == choices.end()) return;
    for (const ProviderId first : front->picks) {
      for (const ConditionUse& use : model_.providers[first].when) {
        HeldPush held;
        if (!is_from_outside(first, use)) {
          held.hopes = hopes_for(use);
          if (held.hopes.empty()) continue;
        }
        held.first = first;
        held.outside = use;
        held.with = member_of(*front, first, members);
        for (auto later = front + 1; later != choices.end(); ++later) {
          if (!later->taken && find_later(request, members, choices, *front, *later, held)) break;
        }
      }
    }
  }

  /// Cheap: whether some condition is promised, and another one is not, or not always.
  bool may_be_held(const std::vector<const Task*>& members) const {
    bool promised = false, outside = false;
    for (const Task* member : members) {
      if (!facts_.requested.contains(member->target) || !facts_.capable_groups.contains(member->target)) return false;
      if (!facts_.may_wait.contains(member->target)) continue;
      for (const GroupId group : shared_.units().needed(member->target)) {
        for (const ProviderId id : model_.groups[group].providers) {
          for (const ConditionUse& use : model_.providers[id].when) {
            promised = promised || !causers_[use.id].empty();
            outside = outside || is_from_outside(id, use) || !hopes_for(use).empty();
          }
        }
      }
    }
    return promised && outside;
  }

  /// Whether no provider promises it, so that a unit that lacks it pushes nothing. What never holds is reported by
  /// another check.
  bool is_from_outside(ProviderId id, const ConditionUse& use) const {
    return causers_[use.id].empty() && !facts_.is_impossible(id, model_.conditions[use.id].state) &&
           facts_.may_hold(model_, id, use);
  }

  /// The providers that promise it, if each of them waits for an external state, so that a unit that lacks it pushes
  /// nothing meanwhile.
  std::vector<Hope> hopes_for(const ConditionUse& use) const {
    std::vector<Hope> out;
    for (const ProviderId causer : causers_[use.id]) {
      if (!facts_.capable.contains(causer) || !facts_.requested.contains(model_.providers[causer].group)) continue;
      const std::vector<ConditionUse>& when = model_.providers[causer].when;
      const auto outside = std::find_if(when.begin(), when.end(), [&](const ConditionUse& each) {
        return model_.states[model_.conditions[each.id].state].external && is_from_outside(causer, each);
      });
      if (outside == when.end()) return {};
      out.push_back({causer, *outside});
    }
    return out;
  }

  /// The combinations whose groups are available if only what is above the request holds some, in the order in which
  /// they are tried; none: there are too many.
  std::vector<Choice> find_choices(const Request& request, const std::vector<const Task*>& members) const {
    std::vector<GroupId> targets;
    for (const Task* member : members) targets.push_back(member->target);
    const std::vector<ProviderId> above = providers_above(request);
    std::vector<Choice> out;
    std::size_t tried = 0;
    const bool complete = shared_.units().visit(targets, true, [&](const Combination& combination) {
      Choice choice;
      for (const Combination::Pick& pick : combination.picks) {
        if (is_held(pick.group, above)) return ++tried <= most_combinations;
        choice.taken = choice.taken || is_taken(pick.group, request, members);
        choice.picks.push_back(pick.provider);
        for (const ConditionUse& use : model_.providers[pick.provider].when) {
          const Condition& condition = model_.conditions[use.id];
          if (!facts_.is_impossible(pick.provider, condition.state))
            choice.region.meet(condition.state, condition.accepts);
        }
      }
      out.push_back(std::move(choice));
      return ++tried <= most_combinations;
    });
    if (!complete || tried > most_combinations) out.clear();
    return out;
  }

  /// The providers that certainly run while this request is tried.
  std::vector<ProviderId> providers_above(const Request& request) const {
    std::vector<ProviderId> out;
    for (const Request* next = &request; next->requester && out.size() < most_above;) {
      out.push_back(*next->requester);
      const std::vector<Request>& requests = shared_.requests().of(model_.providers[*next->requester].group);
      if (requests.size() != 1) break;
      next = &requests.front();
    }
    return out;
  }

  bool is_held(GroupId group, const std::vector<ProviderId>& above) const {
    return std::any_of(above.begin(), above.end(), [&](ProviderId id) {
      return model_.providers[id].group == group || shared_.indispensable().needs_contain(model_.providers[id], group);
    });
  }

  /// Whether another task of the pack wants the group itself, and does not go after the members.
  bool is_taken(GroupId group, const Request& request, const std::vector<const Task*>& members) const {
    if (!request.requester || request.pack->name.empty()) return false;
    const std::vector<Task>& tasks = request.pack->tasks;
    return std::any_of(tasks.begin(), tasks.end(), [&](const Task& task) {
      return task.target == group && std::find(members.begin(), members.end(), &task) == members.end() &&
             Company::goes_first(model_, task, *members.front());
    });
  }

  /// Adds what is held, if the choice needs only a push while the outside condition is false.
  bool find_later(const Request& request, const std::vector<const Task*>& members, const std::vector<Choice>& choices,
                  const Choice& front, const Choice& later, HeldPush held) {
    if (std::any_of(later.picks.begin(), later.picks.end(),
                    [&](ProviderId id) { return !facts_.capable.contains(id); }))
      return false;
    for (const ProviderId id : later.picks) {
      for (const ConditionUse& use : model_.providers[id].when) {
        if (causers_[use.id].empty() || clashing_.count({model_.providers[id].group, use.id}) != 0) continue;
        held.waiter = id;
        held.wanted = use;
        held.waits = member_of(later, id, members);
        const auto causer = find_causer(request, choices, later, held);
        if (!causer) continue;
        held.causer = *causer;
        const auto differ = std::mismatch(front.picks.begin(), front.picks.end(), later.picks.begin());
        held.earlier = *differ.first;
        held.later = *differ.second;
        if (known_.insert({held.outside.span, held.wanted.span}).second) out_.push_back(held);
        return true;
      }
    }
    return false;
  }

  std::optional<ProviderId> find_causer(const Request& request, const std::vector<Choice>& choices, const Choice& later,
                                        const HeldPush& held) {
    for (const ProviderId id : causers_[held.wanted.id]) {
      if (!may_be_pushed(id, later, held)) continue;
      for (const Region& region : shared_.requests().regions(request)) {
        auto box = box_of_wait(region, later, held);
        if (box && meet_outside(*box, id) && stays_open(*box, id, choices)) return id;
      }
    }
    return std::nullopt;
  }

  bool may_be_pushed(ProviderId causer, const Choice& later, const HeldPush& held) {
    const GroupId group = model_.providers[causer].group;
    if (!facts_.capable.contains(causer) || !facts_.requested.contains(group) ||
        shared_.promises().explained.contains(causer))
      return false;
    if (std::any_of(later.picks.begin(), later.picks.end(),
                    [&](ProviderId id) { return model_.providers[id].group == group; }))
      return false;
    if (!pushes_) pushes_.emplace(model_, facts_, shared_.chains(), causers_);
    PushSearch& search = searches_.try_emplace(held.waits->target, *pushes_, held.waits->target).first->second;
    const std::vector<ConditionUse>& when = model_.providers[causer].when;
    return search.beats(group) &&
           std::all_of(when.begin(), when.end(), [&](const ConditionUse& use) { return search.is_servable(use.id); });
  }

  /// The states in which the outside condition and the wanted one are false, and all others of the later choice hold.
  std::optional<Box> box_of_wait(const Region& region, const Choice& later, const HeldPush& held) const {
    Box out = box_of(facts_.values, region);
    const StateId pushed = model_.conditions[held.wanted.id].state;
    for (const ProviderId id : later.picks) {
      for (const ConditionUse& use : model_.providers[id].when) {
        const Condition& condition = model_.conditions[use.id];
        if (facts_.is_impossible(id, condition.state)) continue;
        if (condition.state == pushed && !causers_[use.id].empty()) continue; // it is pushed for too
        Possible& here = possible_in(model_, facts_, condition.state, out);
        here = {here.values.intersected(condition.accepts), false};
      }
    }
    std::vector<ConditionId> lacking{held.wanted.id, held.outside.id};
    for (const Hope& hope : held.hopes) lacking.push_back(hope.outside.id);
    for (const ConditionId id : lacking) {
      Possible& here = possible_in(model_, facts_, model_.conditions[id].state, out);
      here.values = here.values.without(model_.conditions[id].accepts);
    }
    for (auto& [id, here] : out) {
      const State& state = model_.states[id];
      if (!state.of || state.of->id != held.waits->target) continue;
      const Possible at_rest = values_while_stopped(model_, state); // it does not run while it waits
      here = {here.values.intersected(at_rest.values), here.unset && at_rest.unset};
    }
    const bool is_empty = std::any_of(out.begin(), out.end(), [](const auto& entry) { return entry.second.empty(); });
    return is_empty ? std::nullopt : std::optional(std::move(out));
  }

  /// Leaves of the box what the causing provider waits for and nothing promises. False: nothing.
  bool meet_outside(Box& box, ProviderId causer) const {
    Region region;
    for (const ConditionUse& use : model_.providers[causer].when) {
      const Condition& condition = model_.conditions[use.id];
      if (is_from_outside(causer, use)) region.meet(condition.state, condition.accepts);
    }
    return meet(facts_, box, region);
  }

  /// Whether in part of the box no choice can be granted, and the causing provider does not run without a push.
  bool stays_open(const Box& box, ProviderId causer, const std::vector<Choice>& choices) const {
    std::vector<Region> ways;
    for (const Choice& choice : choices) ways.push_back(choice.region);
    for (const ProviderId earlier : model_.group_of(causer).providers) {
      if (earlier == causer) break;
      if (!facts_.capable.contains(earlier)) continue;
      Box here = box;
      if (!meet(facts_, here, region_of(model_, model_.providers[earlier].when))) continue;
      if (find_covering(model_, facts_.values, here, ways, shared_.budget()) == Covering::open) return true;
    }
    return false;
  }

  const Task* member_of(const Choice& choice, ProviderId wanted, const std::vector<const Task*>& members) const {
    const Task* out = nullptr;
    for (const ProviderId id : choice.picks) {
      for (const Task* member : members) {
        if (member->target == model_.providers[id].group) out = member;
      }
      if (id == wanted) break;
    }
    return out;
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const Causers& causers_;
  std::set<std::pair<GroupId, ConditionId>> clashing_; ///< what a group waits for, according to other findings
  std::optional<Pushes> pushes_;
  std::map<GroupId, PushSearch> searches_;
  std::set<std::pair<Span, Span>> known_;
  std::vector<HeldPush> out_;
};

} // namespace

std::vector<HeldPush> find_held_pushes(const Input& input) { return HeldPushSearch(input).run(); }

} // namespace director::analysis
