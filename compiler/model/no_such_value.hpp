#pragma once
// SPDX-License-Identifier: MIT
// What is said of a value that a state cannot have.

#include "compiler/model/model.hpp"
#include "dsl/diagnostic.hpp"

namespace director::compiler {

/// value_outside_domain, at the word.
dsl::Diagnostic no_such_value(const State& state, const Word& value);

} // namespace director::compiler
