#pragma once
// SPDX-License-Identifier: MIT
// A check that reads the user's C++: its page has `Reads: C++`, and its function takes a CodeInput instead of an Input.

#include "compiler/analysis/code/code.hpp"
#include "compiler/checks/check.hpp"

#include <vector>

namespace director::checks {

/// Everything that checks of C++ find, sorted by place.
std::vector<dsl::Diagnostic> run_code_checks(const CodeInput& input);

} // namespace director::checks
