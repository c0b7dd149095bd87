#pragma once
// SPDX-License-Identifier: MIT
// The finding for a value that a state cannot have.

#include "compiler/model/model.hpp"
#include "dsl/source/diagnostic.hpp"

#include <cstddef>

namespace director::compiler {

/// value_outside_domain, at the word. `findings`: earlier ones.
dsl::Diagnostic no_such_value(const State& state, const Word& value, std::size_t findings);

} // namespace director::compiler
