// docs/semantics.md, section 7: promises, and the triggers that they fire when they are broken.
// SPDX-License-Identifier: MIT

#include "runtime/core/engine/notes.hpp"

namespace director {

const char part::promises = 0;

/// Starts the promises of a provider with its first run because of a push.
void Engine::take_promises(Index group) {
  Promised& promised = x_.s.promised[group];
  if (promised.provider != nil) return;
  promised = {x_.s.last[group].push.edge, x_.s.last[group].active};
  for (const Index i : x_.t.providers[promised.provider].promises.rows())
    timers_.arm({Timers::Kind::promise, i}, later(x_.s.counters->now, x_.t.promises[i].within));
}

void Engine::keep_promises_in(Index component) {
  for (const Index group : x_.t.list(x_.t.components[component].groups)) keep_promises(group);
}

/// Ends promises whose push is over, or whose condition has become true.
void Engine::keep_promises(Index group) {
  Promised& promised = x_.s.promised[group];
  const Index provider = promised.provider;
  if (provider == nil) return;
  const Push& push = x_.s.last[group].push;
  const bool stands = in_force(group) && push.edge == promised.edge && push.provider == provider;
  for (const Index i : x_.t.providers[provider].promises.rows()) {
    if (!stands || arbitration::holds(x_, x_.t.promises[i].condition)) timers_.disarm({Timers::Kind::promise, i});
  }
  if (!stands) promised = {};
}

/// Fires a trigger. True if an active provider listens to it.
bool Engine::fire(Index trigger) {
  bool heard = false;
  for (const Index provider : x_.t.list(x_.t.triggers[trigger].listeners)) {
    const Index group = x_.t.providers[provider].group;
    if (x_.s.last[group].active != provider) continue;
    add_reason(group, Reason::trigger);
    for (const Index slot : x_.t.groups[group].listens.rows()) {
      if (x_.t.listened[slot] == trigger) x_.s.fired[slot] = 1;
    }
    heard = true;
  }
  return heard;
}

/// Breaks a promise, and ends all of its provider. True if an active provider listens to its trigger.
bool Engine::break_promise(Index promise) {
  const Index provider = x_.t.promises[promise].provider;
  for (const Index i : x_.t.providers[provider].promises.rows()) timers_.disarm({Timers::Kind::promise, i});
  report(Event::Kind::broken, x_.t.providers[provider].group, provider);
  const Index trigger = x_.t.promises[promise].trigger;
  return trigger != nil && fire(trigger);
}

} // namespace director
