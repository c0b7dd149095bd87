#pragma once
// SPDX-License-Identifier: MIT
// What the engine tells about each of its decisions. An observer is a function and a pointer; it is called in the
// middle of a micro-step, and may call the behaviour as little as a body may. What it throws is kept by generated code
// until the micro-step is over, like what a body throws; it never passes through the engine. A program without an
// observer may define DIRECTOR_NO_OBSERVER, in every file: then the engine is compiled without what it would tell.

#include "runtime/core/base/tables.hpp"
#include "runtime/core/base/words.hpp"

namespace director {

#ifdef DIRECTOR_NO_OBSERVER
inline constexpr bool observable = false;
#else
inline constexpr bool observable = true;
#endif

/// One thing that the engine decided or was told. Which members count depends on `kind`; the others are `nil`.
struct Event {
  /// What happened.
  enum class Kind : std::uint8_t {
    input,  ///< an input was taken: `input`, and what it is about; of a cancel of all tasks, without an edge, then each
            ///< of them
    run,    ///< `provider` of `group` is called for `reasons`
    start,  ///< start handler of `group` (where it has one)
    stop,   ///< stop handler of `group` (where it has one)
    done,   ///< `group` said done
    failed, ///< `group` said failed
    grant,  ///< `group` goes to `edge`, in `provider`; `other` is the edge that controlled it before, or nil
    lose,   ///< `group`, controlled by `other` before, is controlled by nobody
    queue,  ///< the request on `edge` does not run: `why`, and for waiting the first false `condition`
    push,   ///< `group` is pushed to `provider` for the request on `edge`, to make `condition` true
    release,   ///< the push on `group` is over
    set,       ///< `state` becomes `value` (director::unset: it has none any more), by a body, handler, owner or expiry
    refused,   ///< a body tried to set `state` to `value`, which its provider does not declare
    broken,    ///< the promise of `provider` of `group` ran out
    fault,     ///< the body of `provider`, or a handler of `group`, threw
    exhausted, ///< the budget of one step ran out
    ask,       ///< the run asked for `edge`, which leads to `group`, at `level`: a new task
    keep,      ///< likewise, and a request of that level stays as it is
    withdraw,  ///< the run did not ask for `edge` any more, which leads to `group`
    wait,      ///< the run asked for another one of `group` at the time `due`; `never`: it asked for none
    lost,      ///< `count` inputs were lost since the step before: refused, as the inbox was full, or replaced
    answer,    ///< the run answered `outcome`; what it asked for follows, and takes effect together
    assign,    ///< the run of `provider` of `group`, or without a provider a handler, sets `state` to `value`, which it
               ///< may have
    begin,     ///< the first step begins
    given,     ///< ... and `state` had got `value` before it
  };
  /// What kind of input or timer an `input` was.
  enum class Input : std::uint8_t { none, request, cancel, set, fire, enable, disable, expire, wait, within, every };

  Kind kind = Kind::input;                     ///< says which of the others count
  Input input = Input::none;                   ///< of an `input`
  Reasons reasons{};                           ///< of a run
  Why why = Why::none;                         ///< of a request that is queued
  Index group = nil;                           ///< whom it is about
  Index provider = nil;                        ///< likewise
  Index edge = nil;                            ///< the request that it is about
  Index other = nil;                           ///< of a grant, and where control is lost: who controlled it before
  Index state = nil;                           ///< that is set
  Index condition = nil;                       ///< that is waited for
  Index trigger = nil;                         ///< that was fired
  Index level = nil;                           ///< of a request or what a run asks for: of Tables::levels
  Outcome::Kind outcome = Outcome::Kind::keep; ///< of an answer
  std::uint16_t pack = 0;                      ///< of an answer that is a pack: which of those of `provider`
  std::int32_t value = unset;                  ///< of `state`
  std::uint32_t count = 0;                     ///< of lost inputs
  Time time = 0;                               ///< the engine's time, in microseconds
  Time until = 0;               ///< what the step was given: later than `time` where it serves what was due before
  Time due = never;             ///< when a wait ends
  std::uint64_t micro_step = 0; ///< counts from 1
};

/// Given to an Engine as it is, it must not throw; given to a generated Behaviour it may.
struct Observer {
  void (*tell)(void* self, const Event& event) = nullptr; ///< null: nobody listens, and nothing is prepared for it
  void* self = nullptr;                                   ///< given to `tell`
};

} // namespace director
