// Header: compiler/lower/steps.hpp. Test: tests/compiler/lower/lower_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/lower/steps.hpp"

namespace director::compiler {

namespace {

/// Every declared value fits, and none is director::unset: the stage before refuses other domains.
std::int32_t number(const std::optional<std::int64_t>& value) {
  return value ? static_cast<std::int32_t>(*value) : unset;
}

} // namespace

void lower_states(const Model& model, Lowered& out) {
  for (const State& state : model.states) {
    director::StateVariable variable;
    variable.initial = number(state.initial);
    if (state.expires) {
      variable.expires = state.expires->after;
      variable.expires_to = number(state.expires->to);
    }
    if (state.of) variable.owner = row(state.of->id);
    variable.external = state.external;
    out.states.push_back(variable);
  }
}

} // namespace director::compiler
