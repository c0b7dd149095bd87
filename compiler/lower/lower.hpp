#pragma once
// SPDX-License-Identifier: MIT
// From a Model to the tables that the engine runs on. The Model must be whole: no error of "Reading" or "Names and
// domains", every provider has a valid plan for its needs, and no group requests itself.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"

namespace director::compiler {

Lowered lower(const Model& model);

} // namespace director::compiler
