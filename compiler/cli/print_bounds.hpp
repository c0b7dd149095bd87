#pragma once
// SPDX-License-Identifier: MIT
// What `directorc check --verbose` says of memory and of what the engine may cost at most.

#include "compiler/analysis/plans/bounds.hpp"
#include "compiler/base/json.hpp"
#include "compiler/model/model.hpp"

#include <string>

namespace director::compiler::cli {

/// `work_ns`: what a unit of work costs.
std::string bounds_text(const analysis::Bounds& bounds, const Model& model, const std::string& file, double work_ns);
Json bounds_json(const analysis::Bounds& bounds, double work_ns);

} // namespace director::compiler::cli
