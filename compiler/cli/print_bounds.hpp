#pragma once
// SPDX-License-Identifier: MIT
// What `directorc check --verbose` says of memory and of what the engine may cost at most.

#include "compiler/checks/analysis/plans/bounds.hpp"
#include "compiler/emit/json.hpp"

#include <string>

namespace director::compiler::cli {

std::string bounds_text(const checks::Bounds& bounds, std::int64_t limit, const std::string& file);
Json bounds_json(const checks::Bounds& bounds);

} // namespace director::compiler::cli
