#pragma once
// SPDX-License-Identifier: MIT
// Behaviours whose names are chosen to collide.

#include <cstdint>
#include <string>
#include <vector>

namespace director::tests {

/// Types for tasks and states, with names as generated code has them too.
extern const char* const adversary_types;

/// The number-th behaviour; the same for the same words. Its C++ stands in a name space that no other one uses.
std::string adversarial_behaviour(std::uint32_t number, const std::vector<std::string>& words);

} // namespace director::tests
