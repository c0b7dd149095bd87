// Header: compiler/explore/search/watch.hpp. Test: tests/compiler/explore/verdict_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/explore/search/watch.hpp"

#include "compiler/explore/search/blame.hpp"

#include <algorithm>
#include <cassert>

namespace director::compiler {

void unite(std::vector<bool>& all, const std::vector<bool>& more) {
  all.resize(std::max(all.size(), more.size()), false);
  for (std::size_t i = 0; i < more.size(); ++i) all[i] = all[i] || more[i];
}

Happened::Happened(const Tables& tables)
    : ran(tables.providers.size()),
      requested(tables.edges.size()),
      granted(tables.edges.size()),
      runnable(tables.edges.size()) {}

void Happened::add(const Happened& other) {
  unite(ran, other.ran);
  unite(requested, other.requested);
  unite(granted, other.granted);
  unite(runnable, other.runnable);
}

bool under(const Engine& engine, Index edge, Index group) {
  const Tables& t = engine.tables();
  for (std::size_t steps = 0; edge < t.edges.size() && steps <= t.groups.size(); ++steps) { // limbo ends it
    const Index requester = t.edges[edge].requester;
    if (requester == group) return true;
    if (requester == nil) return false;
    edge = engine.holder(requester);
  }
  return false;
}

Watch::Watch(const Ground& ground, const std::vector<std::size_t>& assertions)
    : happened(ground.tables),
      doubted(ground.model.assertions.size(), false),
      ground_(ground),
      before_(ground.tables.groups.size()) {
  for (Index e = 0; e < ground.tables.edges.size(); ++e) waiting_.push_back(e);
  std::uint64_t bit = 1;
  for (const std::size_t at : assertions) {
    const Assertion& assertion = ground.model.assertions[at];
    One one;
    one.assertion = at;
    one.kind = assertion.kind;
    for (const Use<GroupId>& use : assertion.groups) one.groups.push_back(static_cast<Index>(use.id.value));
    if (one.kind == Assertion::Kind::soft) {
      assert(bit != 0); // search() checks no more of them at once
      one.ran_since = bit;
      one.active_since = bit << 1;
      bit <<= 2;
      minds_puts_ = true;
    }
    watched_.push_back(std::move(one));
  }
}

void Watch::before(const Machine& machine, std::uint64_t bits) {
  bits_ = bits;
  const Engine& engine = machine.engine();
  for (Index g = 0; g < before_.size(); ++g)
    before_[g] = {engine.holder(g), engine.active(g), engine.granted(g), engine.in_force(g)};
}

std::uint64_t Watch::after(const Machine& machine, std::vector<std::size_t>& seen) {
  std::uint64_t bits = bits_;
  for (const One& one : watched_) {
    bool is_seen = false;
    switch (one.kind) {
    case Assertion::Kind::never_together: is_seen = together(one, machine); break;
    case Assertion::Kind::beats: is_seen = machine.phase() == Phase::rest && blocked(one, machine); break;
    case Assertion::Kind::can_run:
      is_seen = std::any_of(machine.actions().begin(), machine.actions().end(), [&](const Action& action) {
        return action.kind == Action::Kind::run && action.group == one.groups.front();
      });
      break;
    case Assertion::Kind::soft:
      bits = remember(one, machine, bits);
      is_seen = (bits & (one.ran_since | one.active_since)) == 0 && hard_cut(one, machine);
      if (machine.engine().granted(one.groups.back()) || !requested(one.groups.back(), machine)) bits &= ~one.ran_since;
      if (machine.engine().active(one.groups.front()) != before_[one.groups.front()].active) bits &= ~one.active_since;
      break;
    }
    if (is_seen) seen.push_back(one.assertion);
  }
  note(machine);
  return bits;
}

bool Watch::together(const One& one, const Machine& machine) const {
  return std::count_if(one.groups.begin(), one.groups.end(),
                       [&](Index group) { return machine.engine().granted(group); }) > 1;
}

/// At rest: a task of the first one's side is blocked by a group that the second one's side holds.
bool Watch::blocked(const One& one, const Machine& machine) {
  const Engine& engine = machine.engine();
  const Tables& t = ground_.tables;
  for (Index edge = 0; edge < t.edges.size(); ++edge) {
    if (engine.queued(edge).why != Why::blocked || engine.state(edge) != RunState::queued) continue;
    if (t.edges[edge].target != one.groups.front() && !under(engine, edge, one.groups.front())) continue;
    switch (find_blame(engine, edge, one.groups.back())) {
    case Blame::loser: blocked_request = edge; return true;
    case Blame::shared: doubted[one.assertion] = true; break;
    case Blame::others: break;
    }
  }
  return false;
}

bool Watch::requested(Index group, const Machine& machine) const {
  const auto edges = ground_.tables.list(ground_.tables.groups[group].requesters);
  return std::any_of(edges.begin(), edges.end(),
                     [&](Index edge) { return machine.engine().state(edge) != RunState::none; });
}

/// Whether a causing provider of the first one ran while the second one is requested; or it set its state and has been
/// active since.
std::uint64_t Watch::remember(const One& one, const Machine& machine, std::uint64_t bits) const {
  for (const Action& action : machine.actions()) {
    if (action.kind != Action::Kind::run || action.group != one.groups.front() || !causes(action.provider)) continue;
    if (requested(one.groups.back(), machine)) bits |= one.ran_since;
    for (const Put& put : ground_.bodies[action.provider].puts[action.puts]) {
      if (keeps_promise(action.provider, put)) bits |= one.active_since;
    }
  }
  return bits;
}

bool Watch::keeps_promise(Index provider, const Put& put) const {
  const Model& model = ground_.model;
  const std::vector<ConditionUse>& promises = model.providers[ProviderId{provider}].causing;
  return std::any_of(promises.begin(), promises.end(), [&](const ConditionUse& promise) {
    const Condition& condition = model.conditions[promise.id];
    return condition.state.value == put.state && condition.accepts.contains(put.value);
  });
}

namespace {

/// Whether no level of the edge shares a unit with others.
bool is_apart(const Tables& t, Index edge) {
  const Range levels = t.edges[edge].levels;
  for (Index i = levels.begin; i != levels.end; ++i) {
    if (!t.levels[i].apart) return false;
  }
  return true;
}

} // namespace

/// Whether the conditions of this provider let it go on, or begin. What handlers set in the same micro-step is staged,
/// so the values are those by which was decided who holds what.
bool Watch::may_go_on(Index provider, const Machine& machine) const {
  const Tables& t = ground_.tables;
  const director::Provider& row = t.providers[provider];
  const bool was_active = before_[row.group].active == provider;
  const auto own = t.list(row.causing);
  const auto holds = [&](Index c) { return t.accepts(t.conditions[c], machine.engine().value(t.conditions[c].state)); };
  const auto when = t.list(row.when), stay = t.list(row.stay);
  const bool begins = std::all_of(when.begin(), when.end(), [&](Index c) {
    const bool waived = was_active && before_[row.group].in_force &&
                        std::find(own.begin(), own.end(), t.conditions[c].state) != own.end();
    return waived || holds(c);
  });
  return begins || (was_active && !stay.empty() && std::all_of(stay.begin(), stay.end(), holds));
}

bool Watch::may_go_on_at_all(Index group, const Machine& machine) const {
  const Range providers = ground_.tables.groups[group].providers;
  for (Index p = providers.begin; p != providers.end; ++p) {
    if (may_go_on(p, machine)) return true;
  }
  return false;
}

/// Whether a group that has not answered yet may still request this one, directly or over others; or could have, but
/// that it lost its task, which nobody withdrew.
bool Watch::has_heir(Index group, const Machine& machine) const {
  const Engine& engine = machine.engine();
  const Tables& t = ground_.tables;
  std::vector<Index> above{group};
  for (std::size_t i = 0; i < above.size(); ++i) {
    for (const Index edge : t.list(t.groups[above[i]].requesters)) {
      const Index requester = t.edges[edge].requester;
      if (requester == nil || std::find(above.begin(), above.end(), requester) != above.end()) continue;
      above.push_back(requester);
      if (engine.granted(requester)) {
        if (engine.memory().run_queue[requester].pending != 0) return true;
        continue;
      }
      const Held& was = before_[requester];
      if (!was.granted) continue;
      const Index over = was.holder < t.edges.size() ? t.edges[was.holder].requester : requester;
      const bool withdrawn = over == nil || (over != requester && engine.active(over) != nil);
      if (!withdrawn || engine.state(was.holder) != RunState::none) return true;
    }
  }
  return false;
}

/// Whether a group that limbo held would have stopped anyway: all have answered for whom it was kept, and its
/// conditions are lost, or none of them requests it.
bool Watch::is_left(Index group, const Machine& machine) const {
  if (has_heir(group, machine)) return false;
  if (!may_go_on_at_all(group, machine)) return true;
  const Tables& t = ground_.tables;
  const auto edges = t.list(t.groups[group].requesters);
  return std::none_of(edges.begin(), edges.end(), [&](Index edge) {
    const Index requester = t.edges[edge].requester;
    return machine.engine().state(edge) != RunState::none &&
           (requester == nil || machine.engine().active(requester) != nil);
  });
}

/// Whether a group that stops does so without the help of others: it is requested no more, by a requester that goes
/// on, or by the program; or its conditions are lost; or this is so of a group above it, with which it stops.
bool Watch::ends_by_itself(Index group, const Machine& machine) const {
  const Engine& engine = machine.engine();
  const Tables& t = ground_.tables;
  for (std::size_t steps = 0; group != nil && steps <= t.groups.size(); ++steps) {
    const Index edge = before_[group].holder;
    if (edge != nil && edge >= t.edges.size()) return is_left(group, machine);
    if (edge == nil || !before_[group].granted) return false;
    if (!may_go_on_at_all(group, machine)) return true;
    if (engine.state(edge) != RunState::none) return false;
    const Index requester = t.edges[edge].requester;
    if (requester == nil || engine.active(requester) != nil) return true;
    group = requester;
  }
  return false;
}

/// Whether all that a provider needs was held for it before, or for another one of its group.
bool Watch::keeps_needs(Index provider, const Machine& machine, std::size_t depth) const {
  const Tables& t = ground_.tables;
  const auto needs = t.list(t.providers[provider].needs);
  return depth <= t.groups.size() && std::all_of(needs.begin(), needs.end(), [&](Index need) {
           const Index target = t.edges[need].target, active = machine.engine().active(target);
           return before_[target].holder == need && active != nil && before_[target].active == active &&
                  keeps_needs(active, machine, depth + 1);
         });
}

/// Whether a group that goes on has let go of what it held by this edge: it requests it no more, and none of its
/// providers that may run needs it. It prefers the one that is active to later ones, if nothing that others lost made
/// that one possible.
bool Watch::let_go(Index edge, const Machine& machine) const {
  const Tables& t = ground_.tables;
  const Index requester = t.edges[edge].requester;
  if (machine.engine().active(requester) == nil || machine.engine().state(edge) != RunState::none) return false;
  const Index active = machine.engine().active(requester);
  const bool is_pushed = before_[requester].in_force || machine.engine().in_force(requester);
  const bool prefers = !is_pushed && (active == before_[requester].active || keeps_needs(active, machine));
  const Range providers = t.groups[requester].providers;
  for (Index p = providers.begin; p != (prefers ? active + 1 : providers.end); ++p) {
    const auto needs = t.list(t.providers[p].needs);
    if (std::find(needs.begin(), needs.end(), edge) != needs.end() && may_go_on(p, machine)) return false;
  }
  return true;
}

/// Whether the target was held as a need of its requester. One that is not live, since it is a need itself, holds only
/// such.
bool Watch::was_needed(Index edge) const {
  const Tables& t = ground_.tables;
  const Index provider = before_[t.edges[edge].requester].active;
  if (provider == nil) return true;
  const auto needs = t.list(t.providers[provider].needs);
  return std::find(needs.begin(), needs.end(), edge) != needs.end();
}

/// Whether the second one is granted, and thereby something is taken that the first one, live, held: a request or need
/// of it; or something that a group above it held, so that it stops. Not if the first one continues to hold it through
/// the second one, nor if it would have stopped, or let go of it, without the second one.
bool Watch::hard_cut(const One& one, const Machine& machine) const {
  const Engine& engine = machine.engine();
  const Tables& t = ground_.tables;
  const Index from = one.groups.front(), to = one.groups.back();
  if (!engine.granted(to) || before_[to].granted || before_[from].active == nil) return false;
  const bool stops = engine.active(from) == nil;
  if (stops && ends_by_itself(from, machine)) return false;
  // It, and what it was requested for: not if that goes on and requests it no more.
  std::vector<bool> holders(t.groups.size(), false);
  for (Index at = from; at != nil && !holders[at];) {
    holders[at] = true;
    const Index edge = before_[at].holder;
    const Index above = stops && edge < t.edges.size() ? t.edges[edge].requester : nil;
    at = above == nil || engine.active(above) == nil || engine.state(edge) != RunState::none ? above : nil;
  }
  // A member that lost its conditions ended by itself, if its requester goes on; otherwise that might have been kept.
  const auto was_stopped = [&](Index edge, Index requester) {
    const Index member = t.edges[edge].target;
    if (engine.active(member) != nil) return false;
    const Range levels = t.edges[edge].levels; // none: a need that is never live
    if (levels.begin == levels.end && engine.holder(member) == edge) return false;
    return engine.active(requester) == nil || may_go_on_at_all(member, machine);
  };
  // Whether one of these had it: by need or request, or by a member of its unit, which has it by needs.
  const auto was_theirs = [&](Index edge) {
    for (std::size_t steps = 0; edge < t.edges.size() && steps <= t.groups.size(); ++steps) {
      const Index requester = t.edges[edge].requester;
      if (requester == nil) return false;
      const bool is_need = was_needed(edge);
      if (holders[requester]) {
        if (steps > 0 && ((!is_need && is_apart(t, edge)) || !was_stopped(edge, requester))) return false;
        return !let_go(edge, machine);
      }
      if (steps > 0 && !is_need) return false;
      edge = before_[requester].holder;
    }
    return false;
  };
  for (Index g = 0; g < t.groups.size(); ++g) {
    const Index was = before_[g].holder, is = engine.holder(g);
    if (is == was || is >= t.edges.size() || !was_theirs(was)) continue;
    if ((g == to || under(engine, is, to)) && !under(engine, is, from)) return true;
  }
  const Index is = engine.holder(from);
  return before_[from].holder != is && is < t.edges.size() && under(engine, is, to) && stops;
}

void Watch::note(const Machine& machine) {
  const Engine& engine = machine.engine();
  const Tables& t = ground_.tables;
  for (const Action& action : machine.actions()) {
    if (action.kind == Action::Kind::run) happened.ran[action.provider] = true;
  }
  const auto met = [&](Index provider) {
    const auto conditions = t.list(t.providers[provider].when);
    return std::all_of(conditions.begin(), conditions.end(),
                       [&](Index c) { return t.accepts(t.conditions[c], engine.value(t.conditions[c].state)); });
  };
  for (std::size_t i = 0; i < waiting_.size();) {
    const Index e = waiting_[i];
    const RunState state = engine.state(e);
    if (state != RunState::none) happened.requested[e] = true;
    if (state == RunState::running) {
      happened.granted[e] = true;
      waiting_[i] = waiting_.back();
      waiting_.pop_back();
      continue;
    }
    ++i;
    if (state != RunState::queued || happened.runnable[e]) continue;
    const Range providers = t.groups[t.edges[e].target].providers;
    for (Index p = providers.begin; p != providers.end; ++p) happened.runnable[e] = happened.runnable[e] || met(p);
  }
}

} // namespace director::compiler
