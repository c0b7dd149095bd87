#pragma once
// SPDX-License-Identifier: MIT
// The static priority table as text.

#include "compiler/model/model.hpp"

#include <string>

namespace director::analysis {

using namespace director::compiler;

/// The last part of `directorc dump --stage=tables`: for each requester its edge levels, ranked; for each group with
/// several edges every pair of them, with the common requester that decides between them.
std::string print_priorities(const Model& model);

} // namespace director::analysis
