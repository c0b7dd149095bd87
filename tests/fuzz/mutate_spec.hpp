#pragma once
// SPDX-License-Identifier: MIT
// Behaviour files that can be read, changed in a few places into others that can be read: references go to what is
// declared, conditions ask for values that there are. What is asked for may make no sense, which is for the checks.

#include "tests/property/random.hpp"

#include <string>
#include <string_view>

namespace director::fuzz {

/// Empty where the bytes cannot be read as behaviour files.
std::string mutate_files(std::string_view bytes, const std::string& first, property::Random& random);

/// The first ones, with some of what the second ones declare. Empty likewise.
std::string cross_files(std::string_view first_bytes, std::string_view second_bytes, const std::string& first,
                        property::Random& random);

} // namespace director::fuzz
