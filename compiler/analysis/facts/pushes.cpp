// Header: compiler/analysis/facts/pushes.hpp. Test: tests/compiler/analysis/facts/facts_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/pushes.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

/// The providers of the group and of every group that their plans may hold, if one of them has conditions. `waiting`:
/// without those that are never what it waits for; null: with these.
std::vector<ProviderId> providers_of_plans(const Model& model, const Facts& facts, Waiting* waiting, GroupId waiter) {
  std::vector<ProviderId> out;
  if (!facts.may_wait.contains(waiter) || (waiting != nullptr && !waiting->may_wait(waiter))) return out;
  std::vector<GroupId> open{waiter};
  SparseSet<GroupId> seen;
  seen.add(waiter);
  while (!open.empty()) {
    const GroupId group = open.back();
    open.pop_back();
    for (const ProviderId id : model.groups[group].providers) {
      if (waiting != nullptr && !waiting->may_be_first(id)) continue;
      out.push_back(id);
      for (const Use<GroupId>& need : model.providers[id].needs) {
        if (facts.may_wait.contains(need.id) && seen.add(need.id)) open.push_back(need.id);
      }
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// Limit for the earlier causing providers that are considered.
constexpr std::size_t most_earlier = 16;

} // namespace

Pushes::Pushes(const Model& model, const Facts& facts, const Chains& chains, const Causers& causers)
    : model_(model),
      facts_(facts),
      chains_(chains),
      causers_(causers),
      waiting_(model, facts),
      exclusion_(model, facts, causers),
      could_be_pushed_(model.providers.size()) {
  find_hopeful();
}

bool Pushes::may_hold(ConditionId id) const {
  const Condition& condition = model_.conditions[id];
  return facts_.values[condition.state].overlaps(condition.accepts);
}

bool Pushes::may_lack_with(ConditionId id, ConditionId wanted) const {
  const Condition& own = model_.conditions[id];
  const Condition& other = model_.conditions[wanted];
  return own.state != other.state || model_.states[own.state].may_be_unset() ||
         !facts_.values[own.state].without(other.accepts).subset_of(own.accepts);
}

bool Pushes::holds_with(ProviderId rival, ProviderId causer, ConditionId wanted) const {
  const std::vector<ConditionUse>& when = model_.providers[rival].when;
  const Provider& other = model_.providers[causer];
  return std::all_of(when.begin(), when.end(), [&](const ConditionUse& use) {
    const Condition& own = model_.conditions[use.id];
    const bool is_shared = std::any_of(other.when.begin(), other.when.end(), [&](const ConditionUse& each) {
      const Condition& theirs = model_.conditions[each.id];
      return theirs.state == own.state && theirs.accepts.subset_of(own.accepts);
    });
    return (is_shared && other.stay.empty()) || !may_lack_with(use.id, wanted) ||
           facts_.holds_always(model_, use.id, Region{});
  });
}

bool Pushes::is_passed_over(ProviderId causer, ConditionId wanted) const {
  const Condition& condition = model_.conditions[wanted];
  const Provider& provider = model_.providers[causer];
  const bool waits_too = std::any_of(provider.when.begin(), provider.when.end(), [&](const ConditionUse& use) {
    const Condition& own = model_.conditions[use.id];
    return own.state == condition.state && own.accepts.subset_of(condition.accepts) && !is_corrected(causer, use.id);
  });
  return (waits_too && provider.stay.empty()) || earlier_causer(causer, wanted).has_value();
}

std::optional<ProviderId> Pushes::earlier_causer(ProviderId causer, ConditionId wanted) const {
  std::size_t tried = 0;
  for (const ProviderId rival : model_.group_of(causer).providers) {
    if (rival == causer || tried == most_earlier) break;
    if (model_.providers[rival].causing.empty() || !model_.causes(rival, wanted)) continue;
    ++tried;
    if (facts_.plans[rival] == PlanVerdict::found && holds_with(rival, causer, wanted) &&
        needs_no_more(model_.providers[rival], model_.providers[causer]))
      return rival;
  }
  return std::nullopt;
}

/// Whether it is reported as impossible, and treated as corrected.
bool Pushes::is_corrected(ProviderId provider, ConditionId id) const {
  return facts_.is_impossible(provider, model_.conditions[id].state);
}

/// Whether it cannot push all that cause this condition of it.
bool Pushes::excludes_some_causer(ProviderId waiter, ConditionId id) const {
  return std::any_of(causers_[id].begin(), causers_[id].end(),
                     [&](ProviderId causer) { return exclusion_.excludes(waiter, causer); });
}

/// Each provider counts the conditions that it lacks, and each condition notifies the providers that wait for it.
void Pushes::find_hopeful() {
  IdTable<ConditionId, std::vector<ProviderId>> waiting(model_.conditions.size());
  IdTable<ProviderId, std::size_t> lacking(model_.providers.size(), 0);
  std::vector<ProviderId> open;
  for (const ProviderId id : model_.providers.ids()) {
    const Provider& provider = model_.providers[id];
    if (provider.causing.empty() || !facts_.requested.contains(provider.group)) continue;
    for (const ConditionUse& use : provider.when) {
      if (may_hold(use.id) || is_corrected(id, use.id)) continue;
      waiting[use.id].push_back(id);
      ++lacking[id];
    }
    if (lacking[id] == 0) open.push_back(id);
  }
  IdTable<StateId, std::vector<ConditionId>> by_state(model_.states.size());
  for (const ConditionId id : model_.conditions.ids()) {
    if (!waiting[id].empty()) by_state[model_.conditions[id].state].push_back(id);
  }
  while (!open.empty()) {
    const ProviderId causer = open.back();
    open.pop_back();
    if (!could_be_pushed_.add(causer)) continue;
    for (const ConditionUse& promise : model_.providers[causer].causing) {
      for (const ConditionId id : by_state[model_.conditions[promise.id].state]) {
        if (waiting[id].empty() || !model_.causes(causer, id)) continue;
        for (const ProviderId waiter : waiting[id]) {
          if (--lacking[waiter] == 0) open.push_back(waiter);
        }
        waiting[id].clear();
      }
    }
  }
}

PushSearch::PushSearch(Pushes& all, GroupId waiter)
    : all_(all),
      waiter_(waiter),
      providers_(providers_of_plans(all.model_, all.facts_, &all.waiting_, waiter)) {}

bool PushSearch::beats(GroupId group) {
  if (!compared_.add(group)) return beaten_.contains(group);
  return all_.chains_.may_beat(waiter_, group) && beaten_.add(group);
}

bool PushSearch::is_servable(ConditionId id) {
  if (all_.may_hold(id)) return true;
  if (!settled_.contains(id)) settle(id);
  return servable_.contains(id);
}

/// Collects what the condition waits for through causing providers, unless it holds anyway, and decides all of it.
void PushSearch::settle(ConditionId id) {
  std::vector<ConditionId> open{id};
  settled_.add(id);
  for (std::size_t next = 0; next < open.size(); ++next) {
    for (const ProviderId causer : all_.causers_[open[next]]) {
      if (!may_serve(causer)) continue;
      for (const ConditionUse& use : all_.model_.providers[causer].when) {
        if (!all_.may_hold(use.id) && !all_.is_corrected(causer, use.id) && settled_.add(use.id))
          open.push_back(use.id);
      }
    }
  }
  // Backwards: what a condition waits for was collected after it.
  for (bool changed = true; changed;) {
    changed = false;
    for (auto at = open.rbegin(); at != open.rend(); ++at) {
      if (servable_.contains(*at)) continue;
      const std::vector<ProviderId>& causers = all_.causers_[*at];
      if (std::any_of(causers.begin(), causers.end(), [&](ProviderId causer) { return serves(causer); }))
        changed = servable_.add(*at);
    }
  }
}

bool PushSearch::may_serve(ProviderId causer) {
  return all_.could_be_pushed_.contains(causer) && beats(all_.model_.providers[causer].group);
}

/// A soft transition begins only if it can be completed.
bool PushSearch::can_be_completed(ProviderId provider) {
  const std::vector<ConditionUse>& when = all_.model_.providers[provider].when;
  return std::all_of(when.begin(), when.end(), [&](const ConditionUse& use) {
    return all_.is_corrected(provider, use.id) || is_servable_for(provider, use.id);
  });
}

/// Not if it excludes all that could be pushed for it.
bool PushSearch::is_servable_for(ProviderId provider, ConditionId id) {
  if (all_.may_hold(id)) return true;
  const std::vector<ProviderId>& causers = all_.causers_[id];
  return is_servable(id) && std::any_of(causers.begin(), causers.end(), [&](ProviderId causer) {
           return may_serve(causer) && !all_.exclusion_.excludes(provider, causer);
         });
}

bool PushSearch::serves(ProviderId causer) { return may_serve(causer) && can_be_completed(causer); }

bool PushSearch::may_push(ProviderId causer, ConditionId condition) {
  if (!wanted_) {
    wanted_.emplace();
    for (const ProviderId provider : providers_) {
      if (!can_be_completed(provider)) continue;
      wanting_.push_back(provider);
      for (const ConditionUse& use : all_.model_.providers[provider].when) {
        if (!all_.is_corrected(provider, use.id)) wanted_->add(use.id);
      }
    }
  }
  return wanted_->contains(condition) && serves(causer) && !all_.is_passed_over(causer, condition) &&
         std::any_of(wanting_.begin(), wanting_.end(), [&](ProviderId provider) {
           const std::vector<ConditionUse>& when = all_.model_.providers[provider].when;
           return std::any_of(when.begin(), when.end(), [&](const ConditionUse& use) { return use.id == condition; }) &&
                  !all_.is_corrected(provider, condition) && !all_.exclusion_.excludes(provider, causer);
         });
}

bool PushSearch::may_push_for(ProviderId pushed, ProviderId causer, ConditionId condition) {
  return serves(causer) && !all_.is_passed_over(causer, condition) && !all_.exclusion_.excludes(pushed, causer);
}

std::vector<ProviderId> PushSearch::explore(Explored& explored) {
  struct Wanted {
    ConditionId id{};
    std::optional<ProviderId> by; ///< that excludes some of its causers; empty: those do not matter
  };
  std::vector<ProviderId> out;
  std::vector<Wanted> wanted;
  SparseSet<ConditionId> seen;
  std::set<std::pair<ProviderId, ConditionId>> seen_by;
  SparseSet<ProviderId> passed;
  const auto want = [&](ProviderId provider, std::optional<ConditionId> lacking) {
    for (const ConditionUse& use : all_.model_.providers[provider].when) {
      if (seen.contains(use.id) || explored.conditions.contains(use.id) || all_.causers_[use.id].empty() ||
          all_.is_corrected(provider, use.id) || (lacking && !all_.may_lack_with(use.id, *lacking)))
        continue;
      if (!all_.excludes_some_causer(provider, use.id)) {
        seen.add(use.id);
        wanted.push_back({use.id, std::nullopt});
      } else if (seen_by.emplace(provider, use.id).second) {
        wanted.push_back({use.id, provider});
      }
    }
  };
  // Also for the groups that it may need.
  const auto want_below = [&](ProviderId causer) {
    SparseSet<GroupId> needed;
    std::vector<ProviderId> open{causer};
    while (!open.empty()) {
      const ProviderId provider = open.back();
      open.pop_back();
      if (provider != causer) want(provider, std::nullopt);
      for (const Use<GroupId>& need : all_.model_.providers[provider].needs) {
        if (!all_.facts_.may_wait.contains(need.id) || !needed.add(need.id)) continue;
        const std::vector<ProviderId>& below = all_.model_.groups[need.id].providers;
        open.insert(open.end(), below.begin(), below.end());
      }
    }
  };
  for (const ProviderId provider : providers_) {
    if (can_be_completed(provider)) want(provider, std::nullopt);
  }
  for (std::size_t next = 0; next < wanted.size(); ++next) {
    const auto [id, by] = wanted[next];
    for (const ProviderId causer : all_.causers_[id]) {
      if (!serves(causer) || all_.is_passed_over(causer, id) || (by && all_.exclusion_.excludes(*by, causer))) continue;
      want(causer, id);
      if (!passed.add(causer)) continue;
      if (explored.pushable.add(causer)) out.push_back(causer);
      want_below(causer);
    }
  }
  for (auto at = wanted.rbegin(); at != wanted.rend(); ++at) {
    const std::vector<ProviderId>& causers = all_.causers_[at->id];
    const bool all_found = std::all_of(causers.begin(), causers.end(), [&](ProviderId causer) {
      if (all_.is_passed_over(causer, at->id)) return true;
      const std::vector<ConditionUse>& when = all_.model_.providers[causer].when;
      const std::vector<Use<GroupId>>& needs = all_.model_.providers[causer].needs;
      if (std::any_of(needs.begin(), needs.end(),
                      [&](const Use<GroupId>& need) { return all_.facts_.may_wait.contains(need.id); }))
        return false;
      return explored.pushable.contains(causer) && std::all_of(when.begin(), when.end(), [&](const ConditionUse& use) {
               return explored.conditions.contains(use.id) || all_.causers_[use.id].empty() ||
                      all_.is_corrected(causer, use.id) || !all_.may_lack_with(use.id, at->id);
             });
    });
    if (all_found) explored.conditions.add(at->id);
  }
  return out;
}

std::vector<ProviderId> find_pushable(const Model& model, Pushes& all, GroupId waiter) {
  Explored explored(model);
  std::vector<ProviderId> out = PushSearch(all, waiter).explore(explored);
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<std::pair<ProviderId, ConditionUse>> waited_conditions(const Model& model, const Facts& facts,
                                                                   GroupId waiter) {
  std::vector<std::pair<ProviderId, ConditionUse>> out;
  for (const ProviderId id : providers_of_plans(model, facts, nullptr, waiter)) {
    for (const ConditionUse& use : model.providers[id].when) out.emplace_back(id, use);
  }
  return out;
}

std::vector<std::pair<GroupId, ProviderId>> find_all_pushes(const Model& model, const Facts& facts) {
  const Chains chains(model, [&](ProviderId id) {
    return facts.capable.contains(id) && facts.requested.contains(model.providers[id].group);
  });
  const Causers causers = find_causers(model);
  Pushes pushes(model, facts, chains, causers);
  std::vector<std::pair<GroupId, ProviderId>> out;
  for (const GroupId waiter : model.groups.ids()) {
    if (!facts.requested.contains(waiter)) continue;
    for (const ProviderId causer : find_pushable(model, pushes, waiter)) out.emplace_back(waiter, causer);
  }
  return out;
}

} // namespace director::analysis
