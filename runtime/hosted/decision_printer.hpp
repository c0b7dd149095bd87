#pragma once
// SPDX-License-Identifier: MIT
// An observer that prints what a behaviour decides, a line for each event, in the format of `directorc simulate
// --decisions`, so that a robot can be compared with a scenario:
//
//   director::DecisionPrinter printer{rover::names::all()};
//   rover::Behaviour behaviour{mission, chassis, printer.observer()};
//
// No heap, no exceptions. It writes in the thread that steps: a line takes some microseconds in a buffered stream, but
// a slow disk or terminal makes the step slow.

#include "runtime/core/base/observer.hpp"
#include "runtime/core/inspect/why.hpp"

#include <cstdio>
#include <span>

namespace director {

/// Writes one event as a line, without an end of line, into `buffer`, which it returns; cut off if that is too small
/// (at least one byte). Empty for events that `simulate` does not print: grants, requests of runs, and timers.
const char* to_text(const Event& event, const Names& names, std::span<char> buffer);

/// Prints decisions while they are made.
class DecisionPrinter {
public:
  /// `yes`: the time before each line, as in `simulate --times`.
  enum class Times : bool { no, yes };

  /// `names`: `all()` of the behaviour's `names`. `out` must be open, and the printer exist, as long as the behaviour.
  explicit DecisionPrinter(const Names& names, std::FILE* out = stdout, Times times = Times::no)
      : names_(names),
        out_(out),
        times_(times) {}
  DecisionPrinter(const DecisionPrinter&) = delete;
  DecisionPrinter& operator=(const DecisionPrinter&) = delete;

  /// For the constructor of a Behaviour.
  Observer observer();
  /// Prints the event; to be called by an observer of your own.
  void tell(const Event& event);

private:
  Names names_;
  std::FILE* out_;
  Times times_;
};

/// Writes the beginning of a line for an event at this time, `[    1.500000] `, in seconds, into `buffer`, which it
/// returns.
const char* time_text(Time time, std::span<char> buffer);

} // namespace director
