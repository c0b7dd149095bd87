// Door: runtime/core/engine.hpp. Test: tests/runtime/core/engine_test.cpp.
//
// Section 5: acting on the difference between the last assignment and the new one. First stops, in the old order, so
// that a group is cleaned up before others begin; then, in the new order, starts and reasons to run.

#include "runtime/core/engine.hpp"
#include "runtime/core/marks.hpp"
#include "runtime/core/order.hpp"

namespace director {

void Engine::act(Index passes) {
  Counters& c = *s_.counters;
  for (Index i = 0; i < passes && observed(); ++i) report_decisions(s_.work[i]);
  for (const Index group : in_order(passes, true)) {
    if (s_.last.active[group] != nil && s_.now.active[group] == nil) stop_group(group);
  }
  for (const Index group : in_order(passes, false)) {
    if ((s_.now.flags[group] & flag::granted) != 0) give_reasons(group);
  }
  for (Index i = 0; i < c.touched_count; ++i) s_.in_queue[s_.touched[i]] &= static_cast<std::uint8_t>(~place::touched);
  c.touched_count = 0;
  if (passes != 0) filter_queue();
  for (Index i = 0; i < passes; ++i) adopt(s_.work[i]);
  for (Index i = 0; i < passes; ++i) {
    for (const Index group : t_.list(t_.components[s_.work[i]].groups)) keep_promises(group);
  }
  finish_act();
}

/// Nothing was arbitrated, so nothing starts, stops or changes hands.
void Engine::act_on_touched() {
  Counters& c = *s_.counters;
  if (c.touched_count == 1) {
    give_touched(s_.touched[0]);
  } else {
    for (const Index group : in_order(0, false)) give_touched(group);
    for (Index i = 0; i < c.touched_count; ++i)
      s_.in_queue[s_.touched[i]] &= static_cast<std::uint8_t>(~place::touched);
  }
  c.touched_count = 0;
  finish_act();
}

void Engine::give_touched(Index group) {
  if (granted(group)) {
    const Index holder = s_.last.holder[group];
    s_.data_from[group] = holder;
    if (s_.anew[holder] != 0) add_reason(group, Reason::new_task);
    enqueue(group);
  }
  s_.in_queue[group] &= static_cast<std::uint8_t>(~place::touched);
}

void Engine::finish_act() {
  if (ran_ != nil) keep_promises(ran_);
  if (anew_.empty()) return;
  settle_data(anew_);
  for (Index e = anew_.begin; e != anew_.end; ++e) s_.anew[e] = 0;
  anew_ = {};
}

/// The groups to look at, in the old order (those that were held) or in the new one (those that are held now, and those
/// with a new reason elsewhere). Nothing is sorted where all are of one component.
std::span<const Index> Engine::in_order(Index passes, bool before) {
  const Counters& c = *s_.counters;
  const auto part = [&](Index component) -> std::span<const Index> {
    const Index begin = t_.components[component].order;
    return before ? std::span<const Index>{s_.order + begin, s_.order_count[component]}
                  : std::span<const Index>{s_.next_order + begin, s_.next_count[component]};
  };
  const auto passed = [&](Index group) { // its component is among those that were passed over
    const Index component = t_.groups[group].component;
    for (Index i = 0; i < passes; ++i) {
      if (s_.work[i] == component) return true;
    }
    return false;
  };
  Index elsewhere = 0;
  for (Index i = 0; i < c.touched_count && !before; ++i) elsewhere += passed(s_.touched[i]) ? Index{0} : Index{1};
  if (passes == 0 && elsewhere == 0) return {};
  if (passes == 1 && elsewhere == 0) return part(s_.work[0]);
  Index count = 0;
  bool one_component = passes == 0;
  for (Index i = 0; i < passes; ++i) {
    for (const Index group : part(s_.work[i])) s_.sorted[count++] = group;
  }
  for (Index i = 0; i < c.touched_count && !before; ++i) {
    const Index group = s_.touched[i];
    if (passed(group) || !granted(group)) continue;
    one_component = one_component && t_.groups[group].component == t_.groups[s_.touched[0]].component;
    s_.sorted[count++] = group;
  }
  if (one_component) { // their order is known; they mostly come in order
    for (Index i = 1; i < count; ++i) {
      const Index group = s_.sorted[i];
      Index at = i;
      for (; at > 0 && s_.place[s_.sorted[at - 1]] > s_.place[group]; --at) s_.sorted[at] = s_.sorted[at - 1];
      s_.sorted[at] = group;
    }
  } else {
    Order(t_, s_).sort({s_.sorted, count}, before ? Order::Along::last : Order::Along::now);
  }
  return {s_.sorted, count};
}

/// Runs of groups that are not granted leave the queue; what is pending stays.
void Engine::filter_queue() {
  Counters& c = *s_.counters;
  const auto row = [&](Index i) {
    const std::size_t at = std::size_t{c.queue_begin} + i, size = t_.groups.size();
    return static_cast<Index>(at < size ? at : at - size);
  };
  Index left = 0;
  for (Index i = 0; i < c.queue_count; ++i) {
    const Index group = s_.queue[row(i)];
    if ((s_.now.flags[group] & flag::granted) != 0) {
      s_.queue[row(left++)] = group;
    } else {
      s_.in_queue[group] &= static_cast<std::uint8_t>(~place::queue);
    }
  }
  c.queue_count = left;
}

void Engine::enqueue(Index group) {
  Counters& c = *s_.counters;
  if (s_.pending[group] == 0 || (s_.in_queue[group] & place::queue) != 0) return;
  s_.in_queue[group] |= place::queue;
  std::size_t at = std::size_t{c.queue_begin} + c.queue_count++;
  if (at >= t_.groups.size()) at -= t_.groups.size();
  s_.queue[at] = group;
}

void Engine::stop_group(Index group) {
  for (const Index state : t_.list(t_.groups[group].owned)) {
    s_.handler_values[state] = t_.states[state].initial;
    s_.counters->handlers_set = 1;
  }
  handle(group, Reason::stopped);
  s_.pending[group] = s_.done[group] = 0;
  s_.wait[group] = s_.every[group] = never;
  s_.data_from[group] = nil;
  const Range listens = t_.groups[group].listens, edges = t_.groups[group].edges;
  for (Index slot = listens.begin; slot != listens.end; ++slot) s_.fired[slot] = 0;
  for (Index e = edges.begin; e != edges.end; ++e) s_.request[e] = nil;
}

/// Calls the start or stop handler.
void Engine::handle(Index group, Reason reason) {
  const bool starts = reason == Reason::started;
  if (starts ? !t_.groups[group].start : !t_.groups[group].stop) return;
  if (observed()) tell(event(starts ? Event::Kind::start : Event::Kind::stop, group));
  Handling handling(*this, group, Reasons{static_cast<std::uint8_t>(reason)});
  inside_ = true;
  (starts ? bodies_.start : bodies_.stop)[group](bodies_.self, handling);
  inside_ = false;
  if (!handling.faulted_) return;
  tell(event(Event::Kind::fault, group));
  faulted_ = true;
}

void Engine::give_reasons(Index group) {
  const Index holder = s_.now.holder[group], provider = s_.now.active[group];
  const bool starts = s_.last.active[group] == nil;
  const bool was_granted = (s_.last.flags[group] & flag::granted) != 0;
  s_.data_from[group] = holder;
  if (starts) {
    starting_ = group;
    handle(group, Reason::started);
    starting_ = nil;
  }
  if (starts || !was_granted || s_.last.holder[group] != holder || s_.anew[holder] != 0)
    add_reason(group, Reason::new_task);
  if (s_.last.active[group] != provider) {
    add_reason(group, (s_.now.flags[group] & flag::in_force) != 0 ? Reason::pushed : Reason::new_task);
    const Time every = t_.providers[provider].every; // the period begins when the provider becomes active
    s_.every[group] = never;
    if (every != 0) arm(s_.every[group], s_.counters->now + every);
  }
  const Service& serves = s_.now.serves[group];
  if (serves.condition != nil && serves != s_.last.serves[group]) add_reason(group, Reason::pushed);
  enqueue(group);
}

/// Section 7: a promise ends with its push, and when its condition has come true.
void Engine::keep_promises(Index group) {
  const Index provider = s_.promised_provider[group];
  if (provider == nil) return;
  const Push& push = s_.last.push[group];
  const bool stands = in_force(group) && push.edge == s_.promised_edge[group] && push.provider == provider;
  const Range promises = t_.providers[provider].promises;
  for (Index i = promises.begin; i != promises.end; ++i) {
    if (!stands || holds(t_, s_, t_.promises[i].condition)) s_.promise_due[i] = never;
  }
  if (!stands) s_.promised_edge[group] = s_.promised_provider[group] = nil;
}

/// The data of new requests take their slots. What was there is kept for a group that still lives on it.
void Engine::settle_data(Range edges) {
  if (bodies_.data == nullptr) return;
  for (Index e = edges.begin; e != edges.end; ++e) {
    if (s_.anew[e] == 0) continue;
    const Index group = t_.edges[e].target;
    const bool given = granted(group) && s_.last.holder[group] == e;
    if (!given && s_.last.active[group] != nil && s_.data_from[group] == e) {
      bodies_.data(bodies_.self, Bodies::Data::retain, e, nil);
      s_.data_from[group] = nil;
    }
    bodies_.data(bodies_.self, Bodies::Data::settle, e, nil);
  }
}

/// The new assignment becomes the last one.
void Engine::adopt(Index component) {
  const Component& row = t_.components[component];
  for (const Index g : t_.list(row.groups)) {
    s_.last.holder[g] = s_.now.holder[g];
    s_.last.active[g] = s_.now.active[g];
    s_.last.planned[g] = s_.now.planned[g];
    s_.last.flags[g] = s_.now.flags[g];
    s_.last.push[g] = s_.now.push[g];
    s_.last.serves[g] = s_.now.serves[g];
    const Range slots = t_.groups[g].slots;
    for (Index slot = slots.begin; slot != slots.end; ++slot) s_.last.plan[slot] = s_.now.plan[slot];
  }
  for (const Index e : t_.list(row.edges)) s_.queued[e] = s_.next_queued[e];
  const Index count = s_.order_count[component] = s_.next_count[component];
  for (Index i = 0; i < count; ++i) {
    const Index group = s_.next_order[row.order + i];
    s_.order[row.order + i] = group;
    s_.place[group] = i;
  }
}

void Engine::report_decisions(Index component) const {
  const Component& row = t_.components[component];
  for (const Index g : t_.list(row.groups)) {
    if (s_.last.push[g].edge != nil && s_.now.push[g].edge == nil) tell(event(Event::Kind::release, g));
  }
  for (const Index g : t_.list(row.groups)) {
    const Push &now = s_.now.push[g], &last = s_.last.push[g];
    if (now.edge == nil || (now.edge == last.edge && now.provider == last.provider)) continue;
    Event push = event(Event::Kind::push, g);
    push.provider = now.provider;
    push.edge = now.edge;
    push.condition = now.condition;
    tell(push);
  }
  for (const Index e : t_.list(row.edges)) {
    const Queued &now = s_.next_queued[e], &last = s_.queued[e];
    if (now.why == Why::none || now == last) continue;
    Event queue = event(Event::Kind::queue, t_.edges[e].target);
    queue.edge = e;
    queue.why = now.why;
    queue.condition = now.condition;
    tell(queue);
  }
  for (const Index g : t_.list(row.groups)) {
    const Index now = s_.now.holder[g], last = s_.last.holder[g];
    if (now == last) continue;
    Event control = event(now == nil ? Event::Kind::lose : Event::Kind::grant, g);
    control.edge = now;
    control.other = last;
    control.provider = s_.now.active[g];
    tell(control);
  }
}

} // namespace director
