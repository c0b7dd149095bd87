#pragma once
// SPDX-License-Identifier: MIT
// Converts a Model to the tables of the engine. The Model must be complete: no error of "Reading" or "Names and
// domains", every provider has a valid plan for its needs, and no group requests itself.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"

namespace director::compiler {

Lowered lower(const Model& model);

} // namespace director::compiler
