// Door: runtime/core/engine.hpp, run.hpp. Test: tests/runtime/core/engine_test.cpp.
//
// Section 3, A run: the oldest one calls its provider, and everything that it asked for takes effect together.

#include "runtime/core/notes.hpp"

namespace director {

DIRECTOR_INLINE void Engine::commit_pack(Range edges) {
  Staged* staged = s_.staged_request;
  for (Index e = edges.begin; e != edges.end; ++e, ++staged) {
    const Index level = staged->level;
    if (level == nil) {
      if (observed() && s_.request[e] != nil) report_request(Event::Kind::withdraw, e);
      withdraw(e);
      continue;
    }
    staged->level = nil;
    if (observed()) report_request(staged->keep ? Event::Kind::keep : Event::Kind::ask, e, level);
    if (staged->keep) continue;
    if (edges.size() != 1 || !ask_again(e, level)) {
      request(e, level);
    } else if (bodies_.data != nullptr) {
      settle_data(e);
    }
  }
}

/// Everything that a run asked for, together.
DIRECTOR_INLINE void Engine::commit(Index group, Index provider, Time wait, Outcome::Kind kind) {
  const Group& row = t_.groups[group];
  for (Index slot = row.listens.begin; slot != row.listens.end; ++slot) s_.fired[slot] = 0;
  if (s_.counters->staged_count != 0) commit_states(kind == Outcome::Kind::fault);
  if (kind == Outcome::Kind::pack) {
    commit_pack(row.edges);
    s_.done[group] = 0;
    if (wait <= 0) disarm(Due::wait, group);
  } else {
    for (Index i = 0; i < row.edges.size(); ++i) s_.staged_request[i].level = nil;
    if ((kind == Outcome::Kind::done || kind == Outcome::Kind::failed) && s_.done[group] == 0)
      answer(group, kind == Outcome::Kind::failed);
    if (kind == Outcome::Kind::fault) {
      if (observed()) {
        Event fault = event(Event::Kind::fault, group);
        fault.provider = provider;
        tell(fault);
      }
      faulted_ = true;
      return;
    }
  }
  if (wait <= 0) return;
  const Time due = s_.counters->now + wait;
  if (observed()) report_wait(group, due);
  arm(Due::wait, group, due);
}

void Engine::run_next() {
  Counters& c = *s_.counters;
  ++c.micro_step;
  const Index group = next_of_queue();
  std::uint8_t reasons = s_.pending[group];
  s_.pending[group] = 0;
  mark_stale(group);
  const bool pushed = in_force(group);
  if (!pushed) reasons &= static_cast<std::uint8_t>(~reason::pushed);
  if (reasons == 0) return end_micro_step(); // nobody pushes it any more

  const Index provider = s_.last[group].active;
  if (pushed && s_.turn[group].promised_provider == nil) { // section 7: its first run on that push
    s_.turn[group].promised_edge = s_.last[group].push.edge;
    s_.turn[group].promised_provider = provider;
    const Range promises = t_.providers[provider].promises;
    for (Index i = promises.begin; i != promises.end; ++i) arm(Due::promise, i, c.now + t_.promises[i].within);
  }
  Run run(*this, s_, t_.groups[group].edges.begin, group, provider, Reasons{reasons});
  if (observed()) {
    Event running = event(Event::Kind::run, group);
    running.provider = provider;
    running.reasons = run.reasons();
    tell(running);
  }
  inside_ = true;
  const Outcome outcome = bodies_.run[provider](bodies_.self, run);
  inside_ = false;
  commit(group, provider, run.wait_, outcome.kind());
  end_micro_step();
  if (s_.turn[group].promised_provider != nil) keep_promises(group);
}

void Engine::commit_states(bool fault) {
  Counters& c = *s_.counters;
  for (Index i = 0; i < c.staged_count; ++i) {
    const Index state = s_.staged[i];
    const std::int32_t value = s_.staged_value[state];
    s_.staged_value[state] = unset;
    if (!fault && set_value(state, value)) report_set(state);
  }
  c.staged_count = 0;
}

void Engine::answer(Index group, bool failed) {
  s_.done[group] = failed ? result::done | result::failed : result::done;
  report(failed ? Event::Kind::failed : Event::Kind::done, group);
  const Index holder = s_.last[group].holder, requester = t_.edges[holder].requester;
  if (requester == nil) {
    withdraw(holder);
  } else {
    add_reason(requester, Reason::subtask_done);
  }
}

void Engine::report_request(Event::Kind kind, Index edge, Index level) const {
  if (!observed()) return;
  Event request = event(kind, t_.edges[edge].target);
  request.edge = edge;
  request.level = level;
  tell(request);
}

void Engine::report_wait(Index group, Time due) const {
  if (!observed()) return;
  Event wait = event(Event::Kind::wait, group);
  wait.due = due;
  tell(wait);
}

} // namespace director
