#pragma once
// SPDX-License-Identifier: MIT
// Whether lines of a trace are missing or in another order, where that is certain. The numbers of micro-steps do not
// decide it: a program that loads a saved state goes on with the micro-step of that state, a lower or a higher one, and
// there are micro-steps without an event. But the events of a run follow each other, in the same micro-step.

#include "runtime/core/base/observer.hpp"

#include <optional>
#include <string>

namespace director::compiler {

class TraceOrder {
public:
  /// Why the event cannot follow those before it; empty: it can, or it is not known.
  std::string problem_of(const Event& event);
  /// Events are missing here, and the trace says so.
  void gap() { micro_step_.reset(); }

private:
  std::optional<std::uint64_t> micro_step_; ///< of the event before; nothing: not known
  bool is_begun_ = false;                   ///< the first event of that micro-step is known
  bool has_run_ = false, has_answer_ = false;
};

} // namespace director::compiler
