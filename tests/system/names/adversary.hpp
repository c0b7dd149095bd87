#pragma once
// SPDX-License-Identifier: MIT
// Behaviours whose names are chosen to collide.

#include <cstdint>
#include <string>
#include <vector>

namespace director::tests {

/// Types for tasks and states, with names that also occur in generated code.
extern const char* const adversary_types;

/// The number-th behaviour; deterministic for the same words. Its C++ is in a namespace that no other one uses.
std::string adversarial_behaviour(std::uint32_t number, const std::vector<std::string>& words);

} // namespace director::tests
