#pragma once
// SPDX-License-Identifier: MIT
// The engine: takes micro-steps as semantics.md, section 3, orders them, arbitrates after each (arbitration/pass.hpp)
// and acts on the difference (section 5). It owns nothing: tables, memory, bodies and inbox are the caller's.

#include "runtime/core/arbitration/pass.hpp"
#include "runtime/core/arbitration/trail.hpp"
#include "runtime/core/base/duration.hpp"
#include "runtime/core/base/observer.hpp"
#include "runtime/core/engine/inbox.hpp"
#include "runtime/core/engine/run.hpp"
#include "runtime/core/engine/timers.hpp"

namespace director {

/// Decides for one behaviour. A program reads it, as `Program::engine()`, and changes it by the functions of Program.
class Engine {
public:
  static constexpr std::uint32_t default_budget = 10'000; ///< micro-steps in one step

  /// `memory`: State::bytes(Shape::of(tables)) bytes, aligned to 8, better to State::alignment. Begins as after
  /// reset(). Links all parts (base/parts.hpp), for any tables.
  Engine(const Tables& tables, std::byte* memory, const Bodies& bodies, Inbox& inbox, Observer observer = {});
  /// The same for generated code, which names the parts that its tables use.
  Engine(const Tables& tables, const State& memory, const Bodies& bodies, Inbox& inbox);
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Resets: initial values, every provider enabled, nothing requested. What waits in the inbox stays.
  void reset();

  /// Sets a state before the first step; this is no input, and is not reported.
  void preset(Index state, std::int32_t value);

  /// Sets the observer. If a program does not call this, reports are not linked.
  void observe(Observer observer);

  /// Limits the micro-steps of one step. 0: no limit.
  void set_budget(std::uint32_t micro_steps) { budget_ = micro_steps != 0 ? micro_steps : ~std::uint32_t{0}; }
  /// Limits the work() of one step; tested between micro-steps, so that the last one may exceed it. 0: no limit.
  void set_work_budget(std::uint64_t work) { work_budget_ = work; }

  /// Ends the running step with this micro-step, with StepResult::fault, for callers of an observer that throws.
  void end_with_fault() {
    faulted_ = true;
    left_ = 1;
  }

  /// Takes micro-steps until nothing is left to do: the inputs in the inbox (at time `now`), then due timers, each time
  /// up to rest before the next. An earlier `now` counts as the last one, `never` as last_time.
  StepResult step(Time now) {
    Counters& c = *x_.s.counters;
    if (now >= c.quiet_until || !inbox_.empty()) return take_step(now);
    if (now > c.until) c.until = c.now = now;
    return StepResult::quiescent;
  }
  /// The same without advancing the time.
  StepResult step() {
    const Counters& c = *x_.s.counters; // timers due later than `now` stay pending
    return c.quiet_until == first_time || !inbox_.empty() ? take_step(c.now) : StepResult::quiescent;
  }

  // For the thread that calls step().

  /// Sets a state at once, if the next step would take that input first and only its value would change. Else: post.
  bool take_at_once(Index state, std::int32_t value) {
    Counters& c = *x_.s.counters;
    if (c.quiet_until == first_time || observed() || inside_ || !x_.s.values[state].unchanged.has(value) ||
        x_.t.states[state].expires != 0 || !inbox_.empty())
      return false;
    ++c.micro_step;
    x_.s.values[state].value = value;
    return true;
  }

  /// Adds an input of one record, to be taken before all later ones. False: another waits already, so post it.
  bool take_first(const Input& input) {
    if (inside_ || !inbox_.put_first(input)) return false;
    x_.s.counters->quiet_until = first_time;
    return true;
  }

  /// Posts an input for the next step, by the shortest way. False: the inbox is full.
  bool post(std::span<const Input> records) {
    return (records.size() == 1 && take_first(records[0])) || inbox_.post(records);
  }

  /// The next time at which a step has something to do without an input; `never` if there is none.
  Time next_due() const { return x_.s.counters->next_due; }

  // The state between steps. A row is that of the generated names.
  std::int32_t value(Index state) const { return x_.s.values[state].value; } ///< or `unset`
  RunState state(Index edge) const;                                          ///< of a request: running, queued or none
  Index holder(Index group) const { return x_.s.last[group].holder; }        ///< edge; >= edges.size(): limbo; nil
  Index active(Index group) const { return x_.s.last[group].active; }        ///< provider, or nil
  bool granted(Index group) const { return x_.s.last[group].granted(); }     ///< to its holder, by a request
  bool in_force(Index group) const { return x_.s.last[group].in_force(); }   ///< its provider runs because of a push
  Queued queued(Index edge) const { return x_.s.queued[edge]; }              ///< why it is queued
  Time now() const { return x_.s.counters->now; }                            ///< the time of the last step
  std::uint64_t micro_steps() const { return x_.s.counters->micro_step; }    ///< micro-steps so far
  std::uint64_t passes() const { return passes_; } ///< passes over a component, and loads, so far
  bool inside() const { return inside_; }          ///< a step is being taken; for the thread that calls step()
  bool inputs_wait() const { return !inbox_.empty() || inbox_.due(); } ///< for that thread as well
  std::uint32_t lost() const { return inbox_.lost(); }                 ///< inputs lost so far; from any thread
  /// The work done so far, including searches for pushes; docs/bounds.md says what is counted.
  std::uint64_t work() const { return x_.work; }
  /// Makes the next pass over each component begin from nothing: the memory was changed from outside.
  void forget_trail() { arbitration::forget_trail(x_); }
  /// The same, for tests; sets up to how many groups a component is decided whole.
  void set_most_decided_whole(Index groups) {
    x_.most_decided_whole = groups;
    forget_trail();
  }
  const Tables& tables() const { return x_.t; } ///< of the behaviour
  const State& memory() const { return x_.s; }  ///< all that changes

private:
  friend class Call;
  friend class Run;
  friend class Handling;
  friend class LoadedState; // saved/saved_state.cpp

  /// What a micro-step took, and whether that may change the assignment.
  enum class Taken : std::uint8_t { nothing, no_change, change };

  // step.cpp: section 3
  StepResult take_step(Time now);
  bool micro_step();
  Taken take_next(Index& ran);
  Index run_next();
  void commit(Index group, Index provider, Time wait, Outcome::Kind kind);
  void answer(Index group, bool failed);
  StepResult come_to_rest();

  // inputs.cpp: true if the input changes anything
  bool take_input(const Input& record);
  bool take_requests(const Input& first);
  bool take_cancel(Index edge);
  bool take_enabled(Index provider, std::uint8_t wanted);

  // data.cpp
  DIRECTOR_PART bool take_request_with_data(const Input& record);
  DIRECTOR_PART void settle_data(Index edge);

  // timers.cpp
  DIRECTOR_PART bool take_timer();
  DIRECTOR_PART void begin_wait(Index group, Time wait);

  // states.cpp
  DIRECTOR_PART void begin_to_expire();
  DIRECTOR_PART bool take_states(const Input& first);
  DIRECTOR_PART bool expire(Index state);
  DIRECTOR_PART void update_conditions(Index state);
  DIRECTOR_PART bool commit_states(bool fault);

  // promises.cpp: section 7
  DIRECTOR_PART void take_promises(Index group);
  DIRECTOR_PART bool fire(Index trigger);
  DIRECTOR_PART bool break_promise(Index promise);
  DIRECTOR_PART void keep_promises(Index group);
  DIRECTOR_PART void keep_promises_in(Index component);

  // handlers.cpp
  DIRECTOR_PART void begin_lifecycle(Index group);
  DIRECTOR_PART void end_lifecycle(Index group);
  DIRECTOR_PART void end_period(Index group, Time when);
  DIRECTOR_PART bool take_handlers_input();
  void handle(Index group, Reason reason);

  // notes.hpp
  void mark(Index component, std::uint8_t bits);
  void mark_stale(Index group);
  void forget_work();
  void touch(Index group);
  void untouch(Index group);
  bool note_reasons(Index group, std::uint8_t bits);
  void use_data_of(Index group, Index edge);
  void add_reason(Index group, Reason reason);
  void queue_run(Index group, bool anew);
  void enter_queue(Index group);
  Index take_from_queue();
  void leave_queue(Index group);
  void forget_triggers(Index group);
  void end_wait(Index group);
  void mark_request(Index edge);
  void request(Index edge, Index level);
  bool withdraw(Index edge);
  const Input* take_more(const Input& record);
  void stage(Index state, std::int32_t value);
  bool set_value(Index state, std::int32_t value);
  bool assign(Index state, std::int32_t value);
  bool repeats_request(Index edge, Index level) const;
  void run_for_repeated_request(Index edge);

  // several.cpp
  DIRECTOR_PART void commit_pack(Range edges);
  DIRECTOR_PART bool other_plan(Index group) const;
  DIRECTOR_PART void act_on_all_touched();
  DIRECTOR_PART void remember_request(Index edge);
  DIRECTOR_PART void swap_altered();
  DIRECTOR_PART void forget_altered();
  DIRECTOR_PART void sort_work();
  DIRECTOR_PART std::span<const Index> held_in_all(Index passes);

  // act.cpp: after every micro-step, section 5
  void arbitrate();
  bool changed(bool& stops);
  void act(Index passes, bool stops);
  void act_on_touched();
  std::span<const Index> held_in(Index component) const {
    return {x_.s.order + x_.t.components[component].order, x_.s.order_count[component]};
  }
  std::span<const Index> with_reasons();
  void stop_group(Index group);
  void give_reasons(Index group);
  void adopt_order(Index component);

  bool answered(Index edge, std::uint8_t answer) const;

  // reports.cpp: docs/programs.md, Observers. All but the first only if observed().
  void report(Event::Kind kind, Index group = nil, Index provider = nil, Reasons reasons = {}) const {
    if (observed()) report_run(kind, group, provider, reasons);
  }
  DIRECTOR_PART void report_run(Event::Kind kind, Index group, Index provider, Reasons reasons) const;
  DIRECTOR_PART void report_begin() const;
  DIRECTOR_PART void report_input(const Input& record) const;
  DIRECTOR_PART void report_timer(Timers::Timer timer) const;
  DIRECTOR_PART void report_lost();
  DIRECTOR_PART void report_set(Index state) const;
  DIRECTOR_PART void report_request(Event::Kind kind, Index edge, Index level = nil) const;
  DIRECTOR_PART void report_wait(Index group, Time due) const;
  DIRECTOR_PART void report_answer(Index group, Index provider, Outcome::Kind outcome, std::uint16_t pack) const;
  DIRECTOR_PART void report_value(Event::Kind kind, Index group, Index provider, Index state, std::int32_t value) const;
  DIRECTOR_PART void remember_queued(Index component);
  DIRECTOR_PART void report_decisions(Index component) const;
  void notify(Event&& event) const; ///< adds the time
  bool observed() const { return observable && observer_.tell != nullptr; }

  arbitration::Context x_; ///< the tables, the memory, and the state of arbitration
  Timers timers_;
  Bodies bodies_;
  Inbox& inbox_;
  Observer observer_;
  std::uint64_t passes_ = 0;
  std::uint32_t budget_ = default_budget;
  std::uint64_t work_budget_ = 0;
  std::uint32_t left_ = 0;          ///< micro-steps that may still be taken
  Index differing_ = 0;             ///< rows of State::differing in use
  Index starting_ = nil;            ///< the group whose start handler runs; its data may still be staged
  std::uint32_t reported_lost_ = 0; ///< lost inputs that were reported
  bool inside_ = false;             ///< a step is being taken
  bool faulted_ = false;
};

} // namespace director
