// Header: compiler/trace/trace_order.hpp. Test: tests/compiler/trace/trace_order_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/trace/trace_order.hpp"

#include "runtime/core/api/event_names.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

using Kind = Event::Kind;

/// Whether the event is the effect of an answer, and of nothing else.
bool follows_an_answer(const Event& event) {
  switch (event.kind) {
  case Kind::ask:
  case Kind::keep:
  case Kind::withdraw:
  case Kind::wait: return true;
  case Kind::assign: return event.provider != nil;
  default: return false;
  }
}

} // namespace

std::string TraceOrder::problem_of(const Event& event) {
  if (event.kind == Kind::lost || event.kind == Kind::exhausted) return {}; // between two steps
  if (micro_step_ != event.micro_step) {
    is_begun_ = micro_step_.has_value();
    has_run_ = has_answer_ = false;
  }
  micro_step_ = event.micro_step;
  if (event.kind == Kind::run) {
    is_begun_ = has_run_ = true;
    has_answer_ = false;
    return {};
  }
  const auto without = [&](Kind before) {
    return fmt::format("`{}` without `{}` before it in micro-step {}: lines are missing here, or are in another order",
                       name_of(event.kind), name_of(before), event.micro_step);
  };
  if (event.kind == Kind::answer) {
    has_answer_ = true;
    return is_begun_ && !has_run_ ? without(Kind::run) : "";
  }
  return is_begun_ && !has_answer_ && follows_an_answer(event) ? without(Kind::answer) : "";
}

} // namespace director::compiler
