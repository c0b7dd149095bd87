#pragma once
// SPDX-License-Identifier: MIT
// A number that differs between behaviours: a hash of all rows of the tables, of their names and of those of values.

#include "runtime/core/inspect/why.hpp"

#include <cstdint>
#include <string>

namespace director {

/// FNV-1a with 64 bits. The same for a program and for `directorc` if both use the same behaviour. `names` must have
/// tables.
std::uint64_t fingerprint(const Names& names);

/// The text in a trace: 16 hexadecimal digits.
std::string fingerprint_text(const Names& names);

} // namespace director
