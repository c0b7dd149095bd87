#pragma once
// SPDX-License-Identifier: MIT
// What `directorc check --verbose` says of memory and of what the engine may cost at most.

#include "compiler/analysis/plans/bounds.hpp"
#include "compiler/base/json.hpp"
#include "compiler/model/model.hpp"

#include <string>

namespace director::compiler::cli {

std::string bounds_text(const analysis::Bounds& bounds, const Model& model, const std::string& file);
Json bounds_json(const analysis::Bounds& bounds);

} // namespace director::compiler::cli
