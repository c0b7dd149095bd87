#pragma once
// SPDX-License-Identifier: MIT
// An input of a scenario as the records that are posted to an engine.

#include "compiler/play/data_slots.hpp"
#include "compiler/play/scenario/scenario.hpp"
#include "runtime/core/engine/inbox.hpp"

#include <vector>

namespace director::compiler {

/// Linked, if there are several. The data of requests wait in `slots`.
std::vector<Input> input_records(const ScenarioInput& input, const Tables& tables, DataSlots& slots);

} // namespace director::compiler
