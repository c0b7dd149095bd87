#pragma once
// SPDX-License-Identifier: MIT
// The reports of the engine. An observer is a function and a pointer. It is called during a micro-step, and is as
// restricted as a body in what it may call. An exception from it is kept by generated code until the micro-step is
// over, like one from a body; it never passes through the engine. A program without an observer may define
// DIRECTOR_NO_OBSERVER, in every file: then the engine is compiled without reports, and a Behaviour takes no observer.

#include "runtime/core/base/tables.hpp"
#include "runtime/core/base/words.hpp"

namespace director {

#ifdef DIRECTOR_NO_OBSERVER
inline constexpr bool observable = false;
#else
inline constexpr bool observable = true;
#endif

/// One decision or input of the engine. The members that count depend on `kind`; the others are `nil`.
struct Event {
  /// What happened.
  enum class Kind : std::uint8_t {
    input,  ///< an input was taken: `input`, and its subject; a cancel of all tasks: without an edge, then one for each
    run,    ///< `provider` of `group` is called for `reasons`
    start,  ///< the start handler of `group` is called, if it has one
    stop,   ///< the stop handler of `group` is called, if it has one
    done,   ///< `group` answered done
    failed, ///< `group` answered fail
    grant,  ///< `group` goes to `edge`, in `provider`; `other` is the edge that controlled it before, or nil
    lose,   ///< `group`, controlled by `other` before, has no holder any more
    queue,  ///< the request on `edge` is queued: `why`, and for waiting the first false `condition`
    push,   ///< `group` is pushed to `provider` for the request on `edge`, to make `condition` true
    release,   ///< the push on `group` is over
    set,       ///< `state` becomes `value` (director::unset: none), by a body, handler, owner or expiry
    refused,   ///< a body tried to set `state` to `value`, which its provider does not declare
    broken,    ///< a promise of `provider` of `group` is broken
    fault,     ///< the body of `provider`, or a handler of `group`, threw
    exhausted, ///< the budget of one step ran out
    ask,       ///< the run requested `edge`, which leads to `group`, at `level`: a new task
    keep,      ///< likewise, but it keeps the request, which has that level
    withdraw,  ///< the run withdrew the request on `edge`, which leads to `group`
    wait,      ///< the run requested another run of `group` at the time `due`; `never`: none
    lost,      ///< `count` inputs were lost since the step before: refused, as the inbox was full, or replaced
    answer,    ///< the run answered `outcome`; its requests follow, and take effect together
    assign,    ///< a run of `provider` of `group`, or a handler (no provider), sets `state` to a declared `value`
    begin,     ///< the first step begins
    given,     ///< `state` was set to `value` before the first step
  };
  /// The kind of the input or timer of an `input`.
  enum class Input : std::uint8_t { none, request, cancel, set, fire, enable, disable, expire, wait, within, every };

  Kind kind = Kind::input;                     ///< the other members that count depend on it
  Input input = Input::none;                   ///< of an `input`
  Reasons reasons{};                           ///< of a run
  Why why = Why::none;                         ///< of a request that is queued
  Index group = nil;                           ///< the group of the event
  Index provider = nil;                        ///< the provider of the event
  Index edge = nil;                            ///< the edge of the request
  Index other = nil;                           ///< of a grant or loss: the edge that controlled it before
  Index state = nil;                           ///< the state that is set
  Index condition = nil;                       ///< the condition that is waited for
  Index trigger = nil;                         ///< the trigger that was fired
  Index level = nil;                           ///< of a request, or a keep: of Tables::levels
  Outcome::Kind outcome = Outcome::Kind::keep; ///< of an answer
  std::uint16_t pack = 0;                      ///< of an answer that is a pack: its place among those of `provider`
  std::int32_t value = unset;                  ///< of `state`
  std::uint32_t count = 0;                     ///< of lost inputs
  Time time = 0;                               ///< the engine's time, in microseconds
  Time until = 0;               ///< the time given to the step: later than `time` while overdue timers are served
  Time due = never;             ///< when a wait ends
  std::uint64_t micro_step = 0; ///< counts from 1
};

/// An observer given directly to an Engine must not throw; one given to a generated Behaviour may.
struct Observer {
  void (*tell)(void* self, const Event& event) = nullptr; ///< null: no observer
  void* self = nullptr;                                   ///< the first argument of `tell`
};

} // namespace director
