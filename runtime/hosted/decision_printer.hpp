#pragma once
// SPDX-License-Identifier: MIT
// An observer that prints what a behaviour decides, a line for each event, in the words of `directorc simulate
// --decisions`, so that what a robot does can be compared with what a scenario does:
//
//   director::DecisionPrinter printer{rover::names::all()};
//   rover::Behaviour behaviour{mission, chassis, printer.observer()};
//
// No heap, no exceptions. It writes where the step is called: into a buffered stream, what a line takes is some
// microseconds, and a disk or a terminal that is slow makes the step slow.

#include "runtime/core/base/observer.hpp"
#include "runtime/core/inspect/why.hpp"

#include <cstdio>
#include <span>

namespace director {

/// One event as a line, without an end of line; empty where `simulate` has none: what tasks are granted and asked for,
/// and timers. Written into `buffer`, which it returns; cut off where that is too small (at least one byte).
const char* to_text(const Event& event, const Names& names, std::span<char> buffer);

/// Prints what is decided as it is decided.
class DecisionPrinter {
public:
  /// `yes`: the time before each line, as `simulate --times` has it.
  enum class Times : bool { no, yes };

  /// `names`: `all()` of the behaviour's `names`. `out` must be open for as long as the behaviour lives, and so must
  /// the printer be there.
  explicit DecisionPrinter(const Names& names, std::FILE* out = stdout, Times times = Times::no)
      : names_(names),
        out_(out),
        times_(times) {}
  DecisionPrinter(const DecisionPrinter&) = delete;
  DecisionPrinter& operator=(const DecisionPrinter&) = delete;

  /// For the constructor of a Behaviour.
  Observer observer();
  /// Prints the event; what an observer of your own may do besides.
  void tell(const Event& event);

private:
  Names names_;
  std::FILE* out_;
  Times times_;
};

/// How the line of something that happened at this time begins: `[    1.500000] `, in seconds. Written into `buffer`,
/// which it returns.
const char* time_text(Time time, std::span<char> buffer);

} // namespace director
