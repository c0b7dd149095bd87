#pragma once
// SPDX-License-Identifier: MIT
// Reads what behaviours/robocup declares.

#include "tests/behaviours/robocup/graph.hpp"

#include <filesystem>

namespace director::tests {

/// Of the folder with the roles; its modules are in `modules` below it. What is in its folder `older` is left out.
TeamGraph read_declared(const std::filesystem::path& folder);

} // namespace director::tests
