#pragma once
// SPDX-License-Identifier: MIT
// The text of a user's file with insertions that are not on the disk.

#include "compiler/base/json.hpp"
#include "compiler/stubs/insertion.hpp"

#include <string>
#include <vector>

namespace director::scanning {

using compiler::Json;

/// Joined.
std::vector<compiler::stubs::Insertion> insertions_in(const Json& list);

/// Throws if the file cannot be read.
compiler::stubs::Applied user_text(const std::string& path, const std::vector<compiler::stubs::Insertion>& insertions);

} // namespace director::scanning
