#pragma once
// SPDX-License-Identifier: MIT
// The part of `directorc check --verbose` about memory and the bounds on the engine's cost.

#include "compiler/analysis/plans/bounds.hpp"
#include "compiler/base/json.hpp"
#include "compiler/model/model.hpp"

#include <string>

namespace director::compiler::cli {

/// `work_ns`: the cost of a unit of work.
std::string bounds_text(const analysis::Bounds& bounds, const Model& model, const std::string& file, double work_ns);
Json bounds_json(const analysis::Bounds& bounds, double work_ns);

} // namespace director::compiler::cli
