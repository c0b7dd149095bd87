#pragma once
// SPDX-License-Identifier: MIT
// Resolves groups that are named on the command line.

#include "compiler/cli/system/console.hpp"
#include "compiler/model/model.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler::cli {

/// Empty, and prints why, if one does not exist. `option`: `--focus`.
std::optional<std::vector<GroupId>> named_groups(const std::vector<std::string>& names, std::string_view option,
                                                 const Model& model, Console& console);

/// Of `--transitions`. Likewise if one cannot be a row of the matrix.
std::optional<std::vector<GroupId>> named_rows(const std::vector<std::string>& names, const Model& model,
                                               Console& console);

} // namespace director::compiler::cli
