// Header: compiler/checks/check.hpp. Test: compiler/checks/waiting_company.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/requests/company.hpp"
#include "compiler/analysis/requests/gaps.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/choice.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace director::checks {

namespace {

class HeldBack {
public:
  HeldBack(const Input& input, Findings& findings)
      : input_(input),
        findings_(findings),
        ways_(input.model, input.facts, false, [](ProviderId, const ConditionUse&) { return true; }),
        sources_(find_sources(input.model)),
        explained_(input.model.groups.size()) {
    for (const PackConflict& conflict : input.conflicts.pack_conflicts()) conflicts_.insert(conflict.pack);
    for (const Impossible& fault : input.facts.impossible) explain(fault.provider);
    for (const NeverKept& promise : input.shared.promises().never_kept) {
      for (const NeverKept::Waiting& waiting : promise.waiting) explain(waiting.provider);
    }
    for (const ProviderId id : input.model.providers.ids()) {
      if (input.shared.promises().explained.contains(id)) explain(id);
    }
  }

  void look_at(const Provider& provider, const Pack& pack) {
    if (conflicts_.count(&pack) != 0) return;
    const std::vector<const Task*> members = unit_members(input_.model, pack);
    if (members.size() < 2) return;
    const Region region = active_region(input_.model, provider);
    std::vector<const Task*> waiting;
    for (const Task* member : members) {
      if (may_run(member->target) && !is_explained(member->target) && may_wait(member->target, region))
        waiting.push_back(member);
    }
    for (const Task* member : members) {
      for (const Task* other : waiting) {
        if (other->target == member->target) continue;
        if (share(member->target, other->target) &&
            (need_the_same(member->target, other->target) || !sets_what_it_waits_for(member->target, other->target)))
          continue;
        if (takes_from_causers(member->target, other->target) || takes_from_causers(other->target, member->target))
          continue;
        if (go_round(member->target, other->target)) continue;
        const auto where = find_held_back(member->target, other->target, region);
        if (!where) continue;
        report(*member, *other, *where);
        break;
      }
    }
  }

private:
  void explain(ProviderId id) { explained_.add(input_.model.providers[id].group); }

  /// Whether another finding explains its own wait, or that of something it needs.
  bool is_explained(GroupId group) const {
    const std::vector<GroupId>& needed = input_.shared.units().needed(group);
    return std::any_of(needed.begin(), needed.end(), [&](GroupId id) { return explained_.contains(id); });
  }

  /// Otherwise another finding reports that it never runs.
  bool may_run(GroupId group) const { return input_.model.has_any(group, input_.facts.active); }

  /// Where the member could run while the other one waits.
  std::optional<Region> find_held_back(GroupId member, GroupId waiting, const Region& region) {
    if (!may_run(member)) return std::nullopt;
    for (const Region& way : ways_.of(member)) {
      Region out = region;
      out.meet(way);
      if (!out.empty() && may_wait(waiting, out)) return out;
    }
    return std::nullopt;
  }

  /// Whether each of its providers, or of their plans, can lack something while the requester runs.
  bool may_wait(GroupId group, const Region& region) {
    return find_covering(input_.model, region, ways_.of(group), input_.facts.values, input_.shared.budget()) ==
           Covering::open;
  }

  /// Whether they have a group in common over needs and requests, at any depth.
  bool share(GroupId a, GroupId b) const {
    const Claims& first = input_.shared.claims(a);
    const std::vector<GroupId>& second = input_.shared.claims(b).groups();
    return std::any_of(second.begin(), second.end(), [&](GroupId group) { return first.contains(group); });
  }

  /// Whether some choice for each of them needs one group: by itself, the member would take that for ever.
  bool need_the_same(GroupId a, GroupId b) const {
    const std::vector<GroupId>& first = input_.shared.units().needed(a);
    const std::vector<GroupId>& second = input_.shared.units().needed(b);
    return std::any_of(first.begin(), first.end(),
                       [&](GroupId group) { return std::binary_search(second.begin(), second.end(), group); });
  }

  /// Whether it may take what a provider needs that the other one pushes, or all that request that: it would, if the
  /// two did not wait together.
  bool takes_from_causers(GroupId member, GroupId waiting) const {
    const auto is_lost = [&](ProviderId causer) {
      std::set<GroupId> seen;
      return takes_need(member, causer) || takes_requests(member, input_.model.providers[causer].group, seen);
    };
    const std::vector<const Want*> wants = input_.shared.wants_of(waiting);
    return std::any_of(wants.begin(), wants.end(), [&](const Want* want) {
      return std::any_of(want->causers.begin(), want->causers.end(), is_lost);
    });
  }

  bool takes_need(GroupId member, ProviderId id) const {
    const Claims& claims = input_.shared.claims(member);
    const Provider& provider = input_.model.providers[id];
    if (claims.contains(provider.group)) return false;
    return std::any_of(provider.needs.begin(), provider.needs.end(), [&](const Use<GroupId>& need) {
      const auto& parts = input_.shared.indispensable().of(need.id);
      return parts && std::any_of(parts->begin(), parts->end(), [&](GroupId part) { return claims.contains(part); });
    });
  }

  /// Whether it takes a need from each provider that requests the group, or from all that request that one in turn. It
  /// takes nothing from what is above it.
  bool takes_requests(GroupId member, GroupId group, std::set<GroupId>& seen) const {
    if (!seen.insert(group).second) return true;
    const std::vector<Request>& requests = input_.shared.requests().of(group);
    return !requests.empty() && std::all_of(requests.begin(), requests.end(), [&](const Request& request) {
      if (!request.requester) return false;
      const GroupId above = input_.model.providers[*request.requester].group;
      return !input_.shared.claims(member).contains(above) && !input_.shared.claims(above).contains(member) &&
             (takes_need(member, *request.requester) || takes_requests(member, above, seen));
    });
  }

  /// Whether the member, or what is below it, ends what the other one waits for, and only its stop brings that back:
  /// then undone_by_itself reports the two, unless a `stay` lets the other one go on; and by itself the member would
  /// only keep the other one waiting.
  bool go_round(GroupId member, GroupId waiting) const {
    const std::vector<GroupId>& below = input_.shared.claims(member).groups();
    return std::any_of(below.begin(), below.end(),
                       [&](GroupId group) { return keeps_waiting(member, group, waiting); });
  }

  bool keeps_waiting(GroupId member, GroupId group, GroupId waiting) const {
    const Model& model = input_.model;
    const Group& row = model.groups[group];
    const auto ends = [&](const std::vector<ConditionUse>& entries, ProviderId waiter, const ConditionUse& use) {
      return std::any_of(entries.begin(), entries.end(), [&](const ConditionUse& entry) {
        const Condition &set = model.conditions[entry.id], &wanted = model.conditions[use.id];
        if (set.state != wanted.state) return false;
        return (group == member && !undoing_values(model, waiter, use.id, set.accepts).empty()) ||
               (!set.accepts.overlaps(wanted.accepts) && !could_satisfy(member, wanted));
      });
    };
    const auto undoes = [&](ProviderId waiter, const ConditionUse& use) {
      return (row.start && ends(row.start->sets, waiter, use)) ||
             std::any_of(row.providers.begin(), row.providers.end(), [&](ProviderId id) {
               return ends(model.providers[id].sets, waiter, use) || ends(model.providers[id].causing, waiter, use);
             });
    };
    const std::vector<ProviderId>& waiters = model.groups[waiting].providers;
    return row.requesters.size() == 1 && std::any_of(waiters.begin(), waiters.end(), [&](ProviderId waiter) {
             const std::vector<ConditionUse>& when = model.providers[waiter].when;
             return std::any_of(when.begin(), when.end(), [&](const ConditionUse& use) {
               return stop_that_causes(model, group, use.id) && undoes(waiter, use);
             });
           });
  }

  /// The member itself: even if the other one requests it, that happens only after the other one runs.
  bool sets_what_it_waits_for(GroupId member, GroupId waiting) const {
    const auto is_its_own = [&](const Source& source) {
      return source.provider && input_.model.providers[*source.provider].group == member;
    };
    for (const GroupId group : input_.shared.units().needed(waiting)) {
      for (const ProviderId id : input_.model.groups[group].providers) {
        for (const ConditionUse& use : input_.model.providers[id].when) {
          if (any_source(input_.model.conditions[use.id], is_its_own)) return true;
        }
      }
    }
    return false;
  }

  /// Whether it, or something that it leads to, could satisfy the condition while it runs.
  bool could_satisfy(GroupId member, const Condition& condition) const {
    const Claims& claims = input_.shared.claims(member);
    return any_source(condition, [&](const Source& source) {
      const auto by = source.provider ? std::optional(input_.model.providers[*source.provider].group) : source.group;
      return by && source.kind != Source::Kind::stop && claims.contains(*by);
    });
  }

  /// Whether it, or something that it leads to, promises the condition.
  bool could_promise(GroupId member, ConditionId condition) const {
    const Claims& claims = input_.shared.claims(member);
    const std::vector<ProviderId>& causers = input_.shared.causers()[condition];
    return std::any_of(causers.begin(), causers.end(),
                       [&](ProviderId id) { return claims.contains(input_.model.providers[id].group); });
  }

  /// Of those that may set a value that the condition accepts.
  template <class Is>
  bool any_source(const Condition& condition, const Is& is) const {
    const std::vector<Source>& all = sources_[condition.state];
    return std::any_of(all.begin(), all.end(), [&](const Source& source) {
      return is(source) && source.values.overlaps(condition.accepts);
    });
  }

  void report(const Task& member, const Task& waiting, const Region& region) {
    const Model& model = input_.model;
    const std::string name = name_of(model, member.target), other = name_of(model, waiting.target);
    dsl::Diagnostic& finding = findings_.add(member.span, "");
    bool for_member = false, may_push = false;
    finding.notes.push_back({waiting.span, fmt::format("{} is granted only together with {}", other, name)});
    std::vector<GroupId> groups{waiting.target};
    for (const GroupId needed : input_.shared.units().needed(waiting.target)) {
      if (needed != waiting.target) groups.push_back(needed);
    }
    for (const GroupId group : groups) {
      for (const ProviderId id : model.groups[group].providers) {
        for (const ConditionUse& use : model.providers[id].when) {
          if (holds_in(region, use)) continue;
          for_member = for_member || could_satisfy(member.target, model.conditions[use.id]);
          may_push = may_push || could_promise(member.target, use.id);
          if (group != waiting.target) add_chain(model, need_path(model, waiting.target, group), finding.notes);
          finding.notes.push_back(
              {use.span, fmt::format("{} waits for {}", name_of(model, id), name_of(model, use.id))});
        }
      }
    }
    finding.message = fmt::format("{} is held back while {} waits for a condition, {}", name, other,
                                  for_member ? "and could bring it about" : "and shares nothing with it");
    finding.help = may_push && Company::goes_first(model, member, waiting)
                       ? fmt::format("make {} `apart`, with a lower priority than {}: then it goes on by itself, and "
                                     "{} can push it",
                                     name, other, other)
                       : fmt::format("make {} `apart`: it keeps its rank and goes on by itself", name);
  }

  bool holds_in(const Region& region, const ConditionUse& use) const {
    const Condition& condition = input_.model.conditions[use.id];
    const auto at = region.states.find(condition.state);
    return at != region.states.end() && at->second.subset_of(condition.accepts);
  }

  const Input& input_;
  Findings& findings_;
  Ways ways_;
  IdTable<StateId, std::vector<Source>> sources_;
  std::set<const Pack*> conflicts_;
  IdSet<GroupId> explained_; ///< another finding explains why it waits
};

} // namespace

void waiting_company(const Input& input, Findings& findings) {
  HeldBack company(input, findings);
  for (const ProviderId id : input.model.providers.ids()) {
    const Provider& provider = input.model.providers[id];
    if (!provider.has_packs || !input.facts.active.contains(id)) continue;
    for (const Pack& pack : provider.packs) company.look_at(provider, pack);
  }
}

} // namespace director::checks
