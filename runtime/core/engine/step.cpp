// docs/semantics.md, section 3: micro-steps, and runs.
// SPDX-License-Identifier: MIT
//
// Most micro-steps are runs, so a run is inlined in the loop.

#include "runtime/core/engine/notes.hpp"

namespace director {

/// Carries out all results of a run together.
DIRECTOR_INLINE void Engine::commit(Index group, Index provider, Time wait, Outcome::Kind kind) {
  RunQueueEntry& entry = x_.s.run_queue[group];
  forget_triggers(group);
  if (x_.s.counters->staged_count != 0) commit_states(kind == Outcome::Kind::fault);
  if (kind == Outcome::Kind::pack) {
    if (const Range edges = x_.t.groups[group].edges; !edges.empty()) commit_pack(edges);
    entry.done = 0;
    if (wait <= 0) end_wait(group);
  } else {
    for (Index i = 0; i < x_.t.groups[group].edges.size(); ++i) x_.s.staged_request[i].level = nil;
    if ((kind == Outcome::Kind::done || kind == Outcome::Kind::failed) && entry.done == 0)
      answer(group, kind == Outcome::Kind::failed);
    if (kind == Outcome::Kind::fault) {
      report(Event::Kind::fault, group, provider);
      end_with_fault();
      return;
    }
  }
  if (wait > 0) begin_wait(group, wait);
}

/// Runs the first group of the queue, and carries out its results together. Returns the group; nil: none ran.
DIRECTOR_INLINE Index Engine::run_next() {
  Counters& c = *x_.s.counters;
  ++c.micro_step;
  const Index group = take_from_queue();
  std::uint8_t reasons = x_.s.run_queue[group].pending;
  x_.s.run_queue[group].pending = 0;
  mark_stale(group);
  const bool pushed = in_force(group);
  const Index provider = x_.s.last[group].active;
  if (!pushed) reasons &= static_cast<std::uint8_t>(~reason::pushed);
  if (reasons == 0) return nil; // it is not pushed any more

  if (pushed && !x_.t.promises.empty()) take_promises(group);
  Run run(*this, x_.s, x_.t.groups[group].edges.begin, group, provider, Reasons{reasons});
  report(Event::Kind::run, group, provider, run.reasons());
  const Outcome outcome = bodies_.run(bodies_.self, run);
  if (observed()) report_answer(group, provider, outcome.kind(), run.pack_);
  commit(group, provider, run.wait_, outcome.kind());
  return group;
}

/// Takes the first of what there is to do, without its consequences. `ran`: the group that ran, or nil.
DIRECTOR_INLINE Engine::Taken Engine::take_next(Index& ran) {
  Counters& c = *x_.s.counters;
  const auto taken = [](bool changes) { return changes ? Taken::change : Taken::no_change; };
  for (;;) {
    if (c.staged_count != 0) return taken(take_handlers_input());
    if (inbox_.is_open()) {
      if (const Input* const record = inbox_.take(); record != nullptr) return taken(take_input(*record));
    }
    if (c.serving && c.next_due <= c.now) return taken(take_timer());
    c.serving = false;
    if (c.queue_first != nil) {
      ran = run_next();
      return Taken::change;
    }
    if (c.unsettled) {
      ++c.micro_step;
      return Taken::change;
    }
    if (c.next_due > c.until) return Taken::nothing;
    c.now = c.next_due;
    c.serving = true;
  }
}

/// Takes a micro-step. False: nothing is left to do up to the time given to `step`.
DIRECTOR_INLINE bool Engine::micro_step() {
  Index ran = nil;
  const Taken taken = take_next(ran);
  if (taken != Taken::change) return taken != Taken::nothing;
  Counters& c = *x_.s.counters;
  c.unsettled = false;
  if (c.work_count != 0) {
    arbitrate();
  } else if (c.touched_count != 0) { // requests repeat what is granted
    act_on_touched();
  }
  if (bodies_.data != nullptr) {
    for (Index i = 0; i < c.anew_count; ++i) settle_data(x_.s.renewed[i]);
  }
  for (Index i = 0; i < c.anew_count; ++i) x_.s.anew[x_.s.renewed[i]] = 0; // new for one micro-step
  c.anew_count = 0;
  if (!x_.t.promises.empty() && ran != nil) keep_promises(ran);
  return true;
}

[[gnu::aligned(64)]] StepResult Engine::take_step(Time now) {
  if (inside_) return StepResult::refused;
  inside_ = true;
  const struct Inside { // whatever the engine calls meanwhile, also a destructor of data, is inside
    bool& flag;
    ~Inside() { flag = false; }
  } until_it_returns{inside_};
  if (now > last_time) now = last_time;
  Counters& c = *x_.s.counters;
  if (!c.begun) {
    c.begun = true;
    c.until = c.now = now;
    if (observed()) report_begin();
    if (!x_.t.states.empty()) begin_to_expire();
  }
  c.quiet_until = first_time;
  inbox_.open();
  if (now > c.until) c.until = now;
  // After a step that ended early, what it left is done at the time that it reached, unless there are inputs.
  const bool goes_on = c.serving || c.staged_count != 0 || c.queue_first != nil || c.unsettled;
  if (c.now != c.until && (!goes_on || inbox_.is_open())) {
    c.now = c.until;
    c.serving = false;
  }
  if (observed()) {
    if (inbox_.lost() != reported_lost_) report_lost();
    if (std::exchange(faulted_, false)) return StepResult::fault; // the observer threw
  }
  const std::uint64_t before = work();
  for (left_ = budget_; left_ != 0; --left_) {
    if (!micro_step()) return come_to_rest();
    if (work_budget_ != 0 && work() - before >= work_budget_) break;
  }
  if (!faulted_) {
    const bool left =
        c.staged_count != 0 || c.queue_first != nil || c.unsettled || inbox_.due() || c.next_due <= c.until;
    if (!left) return come_to_rest(); // the budget was used up by the last micro-step that was due
    report(Event::Kind::exhausted);
  }
  return std::exchange(faulted_, false) ? StepResult::fault : StepResult::budget_exhausted;
}

StepResult Engine::come_to_rest() {
  Counters& c = *x_.s.counters;
  c.serving = false;
  c.now = c.until;
  c.quiet_until = c.next_due;
  return StepResult::quiescent;
}

void Engine::answer(Index group, bool failed) {
  x_.s.run_queue[group].done = failed ? result::done | result::failed : result::done;
  report(failed ? Event::Kind::failed : Event::Kind::done, group);
  const Index holder = x_.s.last[group].holder;
  if (holder < x_.t.root_edges) {
    withdraw(holder);
  } else {
    add_reason(x_.t.edges[holder].requester, Reason::subtask_done);
  }
}

} // namespace director
