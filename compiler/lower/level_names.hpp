#pragma once
// SPDX-License-Identifier: MIT
// The names of the rows of Tables::levels, and who requests them.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "runtime/core/inspect/why.hpp"

#include <string>
#include <vector>

namespace director::compiler {

/// For the rows of all edges, one after another; empty for the first of a task in a pack. The first of a root task has
/// its name, as a program may be asked for it by name. Packs may name one level differently: the first name is used.
std::vector<std::string> level_names(const Model& model, const Lowered& lowered);

/// Who requests which level by which name, in the order in which it is written: roots first. The texts are the model's.
std::vector<LevelUse> level_uses(const Model& model, const Lowered& lowered);

} // namespace director::compiler
