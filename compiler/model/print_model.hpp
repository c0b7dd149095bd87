#pragma once
// SPDX-License-Identifier: MIT
// A Model as text (`directorc dump --stage=model`): one line for each thing, in the order of ids.

#include "compiler/model/model.hpp"

#include <string>

namespace director::compiler {

std::string print_model(const Model& model);

} // namespace director::compiler
