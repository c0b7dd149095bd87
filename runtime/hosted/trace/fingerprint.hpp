#pragma once
// SPDX-License-Identifier: MIT
// A number that tells two behaviours apart: of all rows of the tables, and of what they are called.

#include "runtime/core/inspect/why.hpp"

#include <cstdint>
#include <string>

namespace director {

/// FNV-1a over 64 bits. The same for a program and for `directorc` where both were made from the same behaviour.
/// `names` must have tables.
std::uint64_t fingerprint(const Names& names);

/// As a trace has it: 16 hexadecimal digits.
std::string fingerprint_text(const Names& names);

} // namespace director
