// Header: compiler/emit/cpp/parts.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
//
// A state with values becomes an enum class, one with a range a struct with a number, one with a type the user's own
// enum.
#include "compiler/emit/cpp/parts.hpp"
#include "dsl/lexical/cpp_type.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

namespace {

void declare_state(Code& code, const CppEmission& e, StateId id) {
  const State& state = e.model.states[id];
  const std::string name = state_type(e.model, id);
  if (state.type) {
    if (dsl::plain_type(*state.type) == fmt::format("{}::{}", e.model.name_space, name)) return; // it has that name
    document(code, e, state.doc, state.name.span);
    code.line(fmt::format("using {} = {};", name, *state.type), state.name.span);
  } else if (state.is_range) {
    document(code, e, state.doc, state.name.span);
    code.comment(fmt::format("{} to {}.", state.low, state.high));
    code.open(fmt::format("struct {} {{", name), state.name.span);
    code.line("std::int32_t value = 0;");
    code.close("};");
  } else {
    document(code, e, state.doc, state.name.span);
    for (const std::int64_t value : state.unordered)
      code.comment(
          fmt::format("`{}` is unordered: no condition with <, <=, > or >= accepts it.", state.value_text(value)));
    code.list(fmt::format("enum class {} : std::int32_t {{ ", name), state.values.words(), " };", state.name.span);
  }
  code.blank();
}

} // namespace

Code states_part(const CppEmission& e) {
  Code code;
  if (e.model.states.empty()) return code;
  code.comment("States", "//");
  code.blank();
  for (const StateId id : e.model.states.ids()) declare_state(code, e, id);
  return code;
}

Code triggers_part(const CppEmission& e) {
  Code code;
  const auto& triggers = e.model.triggers;
  if (std::all_of(triggers.begin(), triggers.end(), [](const Trigger& t) { return t.promise.has_value(); }))
    return code;
  code.comment("Triggers", "//");
  code.blank();
  for (const TriggerId id : e.model.triggers.ids()) {
    const Trigger& trigger = e.model.triggers[id];
    if (trigger.promise) continue;
    document(code, e, trigger.doc, trigger.span);
    code.line(fmt::format("struct {} {{}};", trigger_type(e.model, id)), trigger.span);
    code.blank();
  }
  return code;
}

} // namespace director::compiler
