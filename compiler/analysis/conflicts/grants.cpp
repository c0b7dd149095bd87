// Header: compiler/analysis/conflicts/grants.hpp. Test: compiler/checks/self_conflict.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/grants.hpp"

#include "compiler/analysis/conflicts/spoilers.hpp"
#include "compiler/analysis/shared/shared.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace director::analysis {

namespace {

/// Decides whether what a provider takes is available while others hold something, and if not, which of them prevents
/// it.
class Availability {
public:
  /// `only_steady`: also of a unit. `granted`: the task may be granted already, with another provider.
  Availability(const Input& input, Takers& takers, Packmates& packmates, std::optional<GroupId> requester,
               const Task& task, const Held& held, const Groups& must, bool only_steady, bool granted)
      : input_(input),
        takers_(takers),
        packmates_(packmates),
        requester_(requester),
        task_(task),
        held_(held),
        must_(must),
        is_needed_(input.model.edges[task.edge].needed),
        only_steady_(only_steady),
        granted_(granted) {}

  /// A claim to the group by a request or need of `by`. `whole`: with some plan for its needs.
  bool can_have(std::optional<GroupId> by, GroupId group) {
    const auto at = held_.find(group);
    if (at == held_.end() || !counts(at->second) || (by && has(at->second.needers, *by))) return true;
    if (!taker_) taker_ = at->second;
    return false;
  }

  bool can_meet(const Provider& provider) {
    return std::all_of(provider.needs.begin(), provider.needs.end(),
                       [&](const Use<GroupId>& need) { return can_meet(provider.group, need.id); });
  }

  const std::optional<Taker>& taker() const { return taker_; }

private:
  bool can_meet(GroupId by, GroupId group) {
    if (!can_have(by, group)) return false;
    const auto [at, is_new] = met_.try_emplace(group, false); // at a cycle: no
    if (!is_new) return at->second;
    bool out = false;
    for (const ProviderId id : input_.model.groups[group].providers) {
      if (!out && input_.facts.capable.contains(id)) out = can_meet(input_.model.providers[id]);
    }
    return met_[group] = out;
  }

  bool counts(const Taker& taker) const {
    // What was granted before is not deferred with the taker, and may take something else now.
    if (granted_ && taker.unit != nullptr && taker.over == &task_ &&
        packmates_.may_be_deferred(*requester_, *taker.unit))
      return false;
    if (taker.steady) return true;
    if (taker.kind == Taker::Kind::unit || taker.kind == Taker::Kind::above) return !only_steady_;
    // Nothing new is granted beside a stale entry of the same group either. If another requester withholds something
    // from the taker, the task may get it, unless it must have that too; and it has that if its requester needs it.
    return taker.over == &task_ && !is_needed_ &&
           std::all_of(taker.spoilers.begin(), taker.spoilers.end(),
                       [&](GroupId group) { return keeps_it_from_both(group) && !may_inherit(group); });
  }

  /// Whoever holds the group holds something that the task must have.
  bool keeps_it_from_both(GroupId group) const {
    return has(must_, group) || !in_common(takers_.held_by(group), must_).empty();
  }

  /// Whether another requester may run what needs the group for the task: if control of that group passes, so does
  /// control of this one.
  bool may_inherit(GroupId group) const {
    const Groups& needed = input_.shared.units().needed(task_.target);
    const std::vector<EdgeId>& all = input_.model.groups[group].requesters;
    return std::any_of(all.begin(), all.end(), [&](EdgeId id) {
      const Edge& edge = input_.model.edges[id];
      if (!edge.needed || !has(needed, *edge.requester)) return false;
      const std::vector<EdgeId>& above = input_.model.groups[*edge.requester].requesters;
      if (*edge.requester == task_.target)
        return std::any_of(above.begin(), above.end(), [&](EdgeId each) { return may_hand_over(each); });
      return std::count_if(above.begin(), above.end(), [&](EdgeId each) { return takers_.is_alive(each); }) > 1;
    });
  }

  /// For an equal the taker leaves the group alone, and the task need not.
  bool may_hand_over(EdgeId id) const {
    const Edge& edge = input_.model.edges[id];
    if (id == task_.edge || !takers_.is_alive(id)) return false;
    return edge.needed || !edge.requester || !requester_ || takers_.may_be_equals(*edge.requester, *requester_);
  }

  const Input& input_;
  Takers& takers_;
  Packmates& packmates_;
  std::optional<GroupId> requester_; ///< of the task
  const Task& task_;
  const Held& held_;
  const Groups& must_;
  bool is_needed_, only_steady_, granted_;
  std::map<GroupId, bool> met_;
  std::optional<Taker> taker_;
};

void put(Held& into, const Taker& taker) {
  const auto [at, is_new] = into.try_emplace(taker.group, taker);
  if (!is_new && !at->second.steady && taker.steady) at->second = taker;
}

bool is_same(const Taker& a, const Taker& b) { return a.kind == b.kind && a.by == b.by && a.holder == b.holder; }

bool is_among(const Taker& taker, const std::vector<Taker>& all) {
  return std::any_of(all.begin(), all.end(), [&](const Taker& each) { return is_same(each, taker); });
}

Held held_by_these(const Held& held, const std::vector<Taker>& all) {
  Held out;
  for (const auto& [group, taker] : held) {
    if (is_among(taker, all)) out.emplace(group, taker);
  }
  return out;
}

/// Intersects the two; false: `into` is unchanged.
bool meet(Held& into, const Held& other) {
  bool changed = false;
  for (auto at = into.begin(); at != into.end();) {
    const auto same = other.find(at->first);
    if (same == other.end()) {
      at = into.erase(at);
      changed = true;
      continue;
    }
    const auto add = [&](Groups& to, const Groups& from) {
      for (const GroupId group : from) {
        const auto place = std::lower_bound(to.begin(), to.end(), group);
        if (place != to.end() && *place == group) continue;
        to.insert(place, group);
        changed = true;
      }
    };
    add(at->second.needers, same->second.needers);
    add(at->second.spoilers, same->second.spoilers);
    changed = changed || (at->second.steady && !same->second.steady);
    at->second.steady = at->second.steady && same->second.steady;
    ++at;
  }
  return changed;
}

} // namespace

Grants::Grants(const Input& input, Takers& takers, Packmates& packmates)
    : input_(input),
      takers_(takers),
      packmates_(packmates) {
  for (const Task& task : input.model.roots) {
    const Entry entry{&task, false, is_grantable(std::nullopt, task, {}), {}, {}};
    if (entry.grantable) enter(std::nullopt, entry);
  }
  run();
  for (const auto& [group, standing] : standing_) visit(group, true);
}

Grants::Grants(const Input& input, Takers& takers, Packmates& packmates, ProviderId above, const Pack& pack,
               Running running)
    : input_(input),
      takers_(takers),
      packmates_(packmates),
      origin_(above),
      pack_(&pack),
      running_(running) {
  const Provider& provider = input.model.providers[above];
  standing_[provider.group];
  visit(provider, pack, standing_of(provider.group), false);
  run();
  visit(provider, pack, standing_of(provider.group), true);
  for (const auto& [group, standing] : standing_) {
    if (group != provider.group) visit(group, true);
  }
}

std::vector<ChainStep> Grants::chain_to(GroupId group) const {
  if (!origin_) return {};
  const GroupId begin = input_.model.providers[*origin_].group;
  std::map<GroupId, ChainStep> first; ///< by which it is reached
  std::vector<GroupId> open{begin};
  for (std::size_t next = 0; next < open.size() && first.count(group) == 0; ++next) {
    for (const ProviderId id : input_.model.groups[open[next]].providers) {
      if (open[next] == begin ? id != *origin_ : !granted_.contains(id)) continue;
      for (const Pack& pack : input_.model.providers[id].packs) {
        if (open[next] == begin && &pack != pack_) continue;
        for (const Task& task : pack.tasks) {
          if (fed_.contains(task.edge) && task.target != begin &&
              first.try_emplace(task.target, ChainStep{open[next], task.target, false, task.span}).second)
            open.push_back(task.target);
        }
      }
    }
  }
  std::vector<ChainStep> out;
  for (auto at = first.find(group); at != first.end(); at = first.find(at->second.from)) out.push_back(at->second);
  std::reverse(out.begin(), out.end());
  return out;
}

void Grants::run() {
  // Requesters first, so that most groups are visited once.
  while (!open_.empty()) {
    const GroupId group = open_.begin()->second;
    open_.erase(open_.begin());
    visit(group, false);
  }
}

void Grants::visit(GroupId group, bool last) {
  const Standing above = standing_of(group);
  for (const ProviderId id : input_.model.groups[group].providers) {
    const Provider& provider = input_.model.providers[id];
    if (!granted_.contains(id)) continue;
    for (const Pack& pack : provider.packs) visit(provider, pack, above, last);
  }
}

void Grants::visit(const Provider& provider, const Pack& pack, const Standing& above, bool last) {
  ++visits_;
  const GroupId requester = provider.group;
  const std::vector<Entry> entries = entries_of(provider, pack, above);
  const bool unit_is_granted =
      !takers_.is_never_whole(pack) &&
      std::all_of(entries.begin(), entries.end(), [](const Entry& entry) { return !entry.in_unit || entry.grantable; });
  for (const Entry& entry : entries) {
    if (last) {
      refuse(requester, entry);
    } else if (entry.grantable && (!entry.in_unit || unit_is_granted)) {
      enter(requester, entry);
    }
  }
}

/// Includes what the group itself holds as long as it runs, with any of its providers: its requests remain until
/// another provider requests something else.
Grants::Standing Grants::standing_of(GroupId group) {
  Standing out = standing_[group];
  std::vector<ProviderId> running;
  for (const ProviderId id : input_.model.groups[group].providers) {
    const bool is_origin = origin_ && input_.model.providers[*origin_].group == group;
    const bool may_keep = running_ == Running::any && input_.facts.active.contains(id);
    if (is_origin ? id == *origin_ || may_keep : granted_.contains(id)) running.push_back(id);
  }
  for (const GroupId taken : takers_.held_by(group, running)) {
    if (!takers_.is_contested(taken)) continue;
    Taker taker;
    taker.group = taken;
    taker.holder = group;
    if (taken != group) taker.needers = takers_.needers(group, taken);
    out.held.insert_or_assign(taken, taker);
    out.optional.insert_or_assign(taken, std::move(taker));
  }
  return out;
}

std::vector<Grants::Entry> Grants::entries_of(const Provider& provider, const Pack& pack, const Standing& above) {
  const GroupId requester = provider.group;
  // When another provider takes over, the group is stale: each of its tasks goes on or is lost by itself.
  static const std::vector<Packmate> none;
  const bool is_kept = running_ == Running::any && &pack == pack_;
  std::vector<Entry> out;
  for (const PackEntry& each : packmates_.of(provider, pack)) {
    Entry entry{
        each.task, each.unit != nullptr, false, takers_.is_optional(*each.task) ? above.optional : above.held, {}};
    entry.below = {entry.held, above.optional};
    for (const Packmate& mate : is_kept ? none : each.mates) {
      if (each.unit != mate.unit) {
        if (!std::all_of(mate.unit->begin(), mate.unit->end(),
                         [&](const Task* member) { return is_grantable(requester, *member, above.held); }))
          continue;
      }
      if (mate.from_entry) put(entry.held, mate.taker);
      if (mate.from_below) put(entry.below.held, mate.taker);
      put(entry.below.optional, mate.taker);
    }
    entry.grantable = is_grantable(requester, *each.task, entry.held);
    out.push_back(std::move(entry));
  }
  return out;
}

std::optional<Taker> Grants::find_taker(std::optional<GroupId> requester, const Task& task, ProviderId id,
                                        const Held& held, bool granted) {
  if (held.empty()) return std::nullopt;
  Availability availability(input_, takers_, packmates_, requester, task, held, takers_.must(id), !origin_, granted);
  if (availability.can_have(requester, task.target) && availability.can_meet(input_.model.providers[id]))
    return std::nullopt;
  return availability.taker();
}

bool Grants::is_grantable(std::optional<GroupId> requester, const Task& task, const Held& held) {
  const std::vector<ProviderId>& all = input_.model.groups[task.target].providers;
  return std::any_of(all.begin(), all.end(), [&](ProviderId id) {
    return input_.facts.active.contains(id) && !find_taker(requester, task, id, held);
  });
}

void Grants::enter(std::optional<GroupId> requester, const Entry& entry) {
  const GroupId target = entry.task->target;
  fed_.add(entry.task->edge);
  bool changed = false;
  for (const ProviderId id : input_.model.groups[target].providers) {
    if (input_.facts.active.contains(id) && !granted_.contains(id) &&
        !find_taker(requester, *entry.task, id, entry.held, entry.grantable))
      changed = granted_.add(id);
  }
  const auto [at, is_new] = standing_.try_emplace(target, entry.below);
  Standing& standing = at->second;
  if (is_new) {
    changed = true;
  } else {
    changed = meet(standing.held, entry.below.held) || changed;
    changed = meet(standing.optional, entry.below.optional) || changed;
  }
  if (changed) open_.emplace(takers_.place_of(target), target);
}

/// Called when everything is known.
void Grants::refuse(std::optional<GroupId> requester, const Entry& entry) {
  const std::vector<ProviderId>& all = input_.model.groups[entry.task->target].providers;
  const bool runs = std::any_of(all.begin(), all.end(), [&](ProviderId id) { return granted_.contains(id); });
  Refused refused{requester, entry.task, {}, {}};
  for (const ProviderId id : all) {
    if (!input_.facts.active.contains(id)) continue;
    auto taker = find_taker(requester, *entry.task, id, entry.held, entry.grantable);
    if (!taker) continue;
    refused.refusals.push_back({id, *taker, {}});
    if (runs && !granted_.contains(id))
      idle_.try_emplace(id, Refused{requester, entry.task, {{id, std::move(*taker), {}}}, {}});
  }
  if (fed_.contains(entry.task->edge) || entry.grantable || refused.refusals.empty()) return;
  for (Refusal& refusal : refused.refusals) refusal.others = find_others(refused, refusal, entry.held);
  refused.together = find_together(refused, entry.held);
  refused_[entry.task->edge].push_back(std::move(refused));
}

std::vector<Taker> Grants::find_others(const Refused& refused, const Refusal& refusal, Held held) {
  std::vector<Taker> out;
  for (std::optional<Taker> next = refusal.taker; next;) {
    const Taker last = *next;
    for (auto at = held.begin(); at != held.end();) at = is_same(at->second, last) ? held.erase(at) : std::next(at);
    next = find_taker(refused.requester, *refused.task, refusal.provider, held);
    if (next) out.push_back(*next);
  }
  return out;
}

/// Of the takers those without which some provider would be granted.
std::vector<Taker> Grants::find_together(const Refused& refused, const Held& held) {
  std::vector<Taker> out;
  for (const Refusal& refusal : refused.refusals) {
    if (!is_among(refusal.taker, out)) out.push_back(refusal.taker);
    for (const Taker& other : refusal.others) {
      if (!is_among(other, out)) out.push_back(other);
    }
  }
  for (std::size_t i = out.size(); i-- > 0 && out.size() > 1;) {
    std::vector<Taker> fewer = out;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (!is_grantable(refused.requester, *refused.task, held_by_these(held, fewer))) out = std::move(fewer);
  }
  return out.size() > 1 ? out : std::vector<Taker>{};
}

} // namespace director::analysis
