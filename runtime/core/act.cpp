// Door: runtime/core/engine.hpp. Test: tests/runtime/core/engine_test.cpp.
//
// Section 5: acting on the difference between the last assignment and the new one. First stops, in the old order, so
// that a group is cleaned up before others begin; then, in the new order, starts and reasons to run.

#include "runtime/core/engine.hpp"
#include "runtime/core/marks.hpp"

namespace director {

void Engine::act(std::span<const Index> order) {
  Counters& c = *s_.counters;
  c.unsettled = changed() ? 1 : 0;
  if (observed()) report_decisions();
  for (Index i = 0; i < c.order_count; ++i) {
    const Index group = s_.order[i];
    if (s_.last.active[group] != nil && s_.now.active[group] == nil) stop_group(group);
  }
  for (const Index group : order) {
    if ((s_.now.flags[group] & flag::granted) != 0) give_reasons(group);
  }
  Index left = 0; // runs of groups that are not granted leave the queue; what is pending stays
  for (Index i = 0; i < c.queue_count; ++i) {
    const Index group = s_.queue[i];
    s_.in_queue[group] = s_.now.flags[group] & flag::granted;
    if (s_.in_queue[group] != 0) s_.queue[left++] = group;
  }
  c.queue_count = left;
  keep_promises();
  adopt(order);
  settle_data(anew_);
  for (Index e = anew_.begin; e != anew_.end; ++e) s_.anew[e] = 0;
  anew_ = {};
}

/// Did this arbitration change anything (holders, providers, who is granted, pushes)? Then it is done once more at
/// rest.
bool Engine::changed() const {
  for (Index g = 0; g < t_.groups.size(); ++g) {
    if (s_.now.holder[g] != s_.last.holder[g] || s_.now.active[g] != s_.last.active[g] ||
        ((s_.now.flags[g] ^ s_.last.flags[g]) & flag::granted) != 0 || s_.now.push[g] != s_.last.push[g])
      return true;
  }
  return false;
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
  tell(event(starts ? Event::Kind::start : Event::Kind::stop, group));
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
    s_.every[group] = every == 0 ? never : s_.counters->now + every;
  }
  const Service& serves = s_.now.serves[group];
  if (serves.condition != nil && serves != s_.last.serves[group]) add_reason(group, Reason::pushed);
  if (s_.pending[group] == 0 || s_.in_queue[group] != 0) return;
  s_.in_queue[group] = 1;
  s_.queue[s_.counters->queue_count++] = group;
}

void Engine::add_reason(Index group, Reason reason) {
  s_.pending[group] |= static_cast<std::uint8_t>(reason);
  if (reason == Reason::new_task) s_.done[group] = 0;
}

/// Section 7: a promise ends with its push, and when its condition has come true.
void Engine::keep_promises() {
  for (Index g = 0; g < t_.groups.size(); ++g) {
    const Index provider = s_.promised_provider[g];
    if (provider == nil) continue;
    const bool stands = (s_.now.flags[g] & flag::in_force) != 0 && s_.now.push[g].edge == s_.promised_edge[g] &&
                        s_.now.push[g].provider == provider;
    const Range promises = t_.providers[provider].promises;
    for (Index i = promises.begin; i != promises.end; ++i) {
      if (!stands || holds(t_, s_, t_.promises[i].condition)) s_.promise_due[i] = never;
    }
    if (!stands) s_.promised_edge[g] = s_.promised_provider[g] = nil;
  }
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
void Engine::adopt(std::span<const Index> order) {
  for (Index g = 0; g < t_.groups.size(); ++g) {
    s_.last.holder[g] = s_.now.holder[g];
    s_.last.active[g] = s_.now.active[g];
    s_.last.planned[g] = s_.now.planned[g];
    s_.last.flags[g] = s_.now.flags[g];
    s_.last.push[g] = s_.now.push[g];
    s_.last.serves[g] = s_.now.serves[g];
  }
  for (Index slot = 0; slot < t_.plan_groups.size(); ++slot) s_.last.plan[slot] = s_.now.plan[slot];
  for (Index e = 0; e < t_.edges.size(); ++e) s_.queued[e] = s_.next_queued[e];
  s_.counters->order_count = static_cast<Index>(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) s_.order[i] = order[i];
}

void Engine::report_decisions() {
  for (Index g = 0; g < t_.groups.size(); ++g) {
    if (s_.last.push[g].edge != nil && s_.now.push[g].edge == nil) tell(event(Event::Kind::release, g));
  }
  for (Index g = 0; g < t_.groups.size(); ++g) {
    const Push &now = s_.now.push[g], &last = s_.last.push[g];
    if (now.edge == nil || (now.edge == last.edge && now.provider == last.provider)) continue;
    Event push = event(Event::Kind::push, g);
    push.provider = now.provider;
    push.edge = now.edge;
    push.condition = now.condition;
    tell(push);
  }
  for (Index e = 0; e < t_.edges.size(); ++e) {
    const Queued &now = s_.next_queued[e], &last = s_.queued[e];
    if (now.why == Why::none || now == last) continue;
    Event queue = event(Event::Kind::queue, t_.edges[e].target);
    queue.edge = e;
    queue.why = now.why;
    queue.condition = now.condition;
    tell(queue);
  }
  for (Index g = 0; g < t_.groups.size(); ++g) {
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
