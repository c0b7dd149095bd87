#pragma once
// SPDX-License-Identifier: MIT
// Behaviours for tests of stubs: from their YAML to the C++ that they want.

#include "compiler/stubs/wanted.hpp"

#include <string>

namespace director::tests {

/// Read and resolved; a fault in it fails the test.
compiler::stubs::Wanted wanted_of(const std::string& yaml, const std::string& file = "robot.yaml");

/// A walk with two providers and both handlers, and legs, in two modules.
extern const std::string walking_robot;

} // namespace director::tests
