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
      depends_on_puts_ = true;
    }
    watched_.push_back(std::move(one));
  }
}

void Watch::before(const Machine& machine, std::uint64_t bits) {
  bits_ = bits;
  const Engine& engine = machine.engine();
  for (Index g = 0; g < before_.size(); ++g) before_[g] = {engine.holder(g), engine.active(g), engine.granted(g)};
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
    if (!t.levels[i].apart && !t.levels[i].optional) return false;
  }
  return true;
}

} // namespace

/// Whether the target was held as a need of its requester. One that is not live, since it is a need itself, holds only
/// such.
bool Watch::was_needed(Index edge) const {
  const Tables& t = ground_.tables;
  const Index provider = before_[t.edges[edge].requester].active;
  if (provider == nil) return true;
  const auto needs = t.list(t.providers[provider].needs);
  return std::find(needs.begin(), needs.end(), edge) != needs.end();
}

/// The groups that the second one's side got in this micro-step, and the first one, live, held until then: by a request
/// or need of its own or, if it stops, of a group above it. Not if it continues to hold them through the second one.
std::vector<Index> Watch::passed_on(Index from, Index to, const Engine& engine) const {
  const Tables& t = ground_.tables;
  const bool stops = engine.active(from) == nil;
  std::vector<bool> holders(t.groups.size(), false);
  for (Index at = from; at != nil && !holders[at];) {
    holders[at] = true;
    const Index edge = before_[at].holder;
    at = stops && edge < t.edges.size() ? t.edges[edge].requester : nil;
  }
  const auto stopped = [&](Index edge) {
    const Index member = t.edges[edge].target;
    const bool is_never_live = t.edges[edge].levels.empty() && engine.holder(member) == edge;
    return engine.active(member) == nil && !is_never_live;
  };
  // By need or request, or by a member of its unit, which has it by needs.
  const auto was_theirs = [&](Index edge) {
    for (std::size_t steps = 0; edge < t.edges.size() && steps <= t.groups.size(); ++steps) {
      const Index requester = t.edges[edge].requester;
      if (requester == nil) return false;
      const bool is_need = was_needed(edge);
      if (holders[requester]) return steps == 0 || ((is_need || !is_apart(t, edge)) && stopped(edge));
      if (steps > 0 && !is_need) return false;
      edge = before_[requester].holder;
    }
    return false;
  };
  std::vector<Index> out;
  for (Index g = 0; g < t.groups.size(); ++g) {
    const Index was = before_[g].holder, is = engine.holder(g);
    if (is == was || is >= t.edges.size() || under(engine, is, from) || !(g == to || under(engine, is, to))) continue;
    if (was_theirs(was) || (g == from && stops)) out.push_back(g);
  }
  return out;
}

namespace {

/// Whether limbo keeps what the edge leads to for a group that lost its condition: a member of a task that goes on.
bool is_let_go_of(Index edge, Index task, const Engine& engine) {
  const Tables& t = engine.tables();
  Index top = nil;
  for (std::size_t steps = 0; edge < t.edges.size() && steps <= t.groups.size(); ++steps) {
    top = t.edges[edge].requester;
    if (top == nil || top == task) return false;
    edge = engine.holder(top);
  }
  if (top == nil || edge == nil) return false;
  const auto requests = t.list(t.groups[top].requesters);
  return std::any_of(requests.begin(), requests.end(), [&](Index request) {
    return engine.state(request) == RunState::queued && engine.queued(request).why == Why::waiting;
  });
}

} // namespace

/// Whether the second one is granted, and takes something that the first one would have kept.
bool Watch::hard_cut(const One& one, const Machine& machine) {
  const Engine& engine = machine.engine();
  const Index from = one.groups.front(), to = one.groups.back();
  if (!engine.granted(to) || before_[to].granted || before_[from].active == nil) return false;
  const std::vector<Index> passed = passed_on(from, to, engine);
  const std::optional<Index> taken = passed.empty() ? std::nullopt : kept_without(to, from, passed, machine);
  if (taken) cut = {*taken, before_[*taken].holder, engine.active(from) == nil};
  return taken.has_value();
}

/// The first of these groups that keeps its holder if the micro-step is taken again without the request by which the
/// second one is granted, and without those of others that take it instead. The first one has to go on then.
std::optional<Index> Watch::kept_without(Index to, Index from, const std::vector<Index>& groups,
                                         const Machine& machine) {
  const Tables& t = ground_.tables;
  if (!again_) again_ = std::make_unique<Machine>(ground_, Breadth::all);
  std::vector<Index> left_out{machine.engine().holder(to)};
  for (std::size_t tried = 0; tried < left_out.size();) {
    tried = left_out.size();
    again_->repeat(machine, left_out);
    const Engine& engine = again_->engine();
    const bool goes_on = engine.active(from) != nil;
    for (const Index g : groups) {
      Index is = engine.holder(g);
      if (is == before_[g].holder || under(engine, is, from)) {
        if (goes_on && !is_let_go_of(is, from, engine)) return g;
        continue;
      }
      while (is < t.edges.size() && engine.state(is) == RunState::none) // a need
        is = engine.holder(t.edges[is].requester);
      if (is < t.edges.size() && std::find(left_out.begin(), left_out.end(), is) == left_out.end())
        left_out.push_back(is);
    }
  }
  return {};
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
