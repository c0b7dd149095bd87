// Header: tests/oracle/assignment.hpp. Test: tests/oracle/conformance_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/oracle/assignment.hpp"

#include <algorithm>

namespace director::oracle {

bool Assignment::same_decision(const Assignment& other) const {
  const auto same = [](const std::optional<Held>& a, const std::optional<Held>& b) {
    return a.has_value() == b.has_value() && (!a || (a->by == b->by && a->granted == b->granted));
  };
  return std::equal(held.begin(), held.end(), other.held.begin(), same) && active == other.active &&
         pushes == other.pushes;
}

Facts::Facts(const Model& model)
    : value(model.states.size()),
      request(model.edges.size()),
      pending(model.groups.size()) {
  for (const StateId s : model.states.ids()) value[s] = model.states[s].initial;
}

bool Facts::holds(const Model& model, ConditionId condition) const {
  const compiler::Condition& c = model.conditions[condition];
  return value[c.state] && c.accepts.contains(*value[c.state]);
}

} // namespace director::oracle
