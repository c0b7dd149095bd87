#pragma once
// SPDX-License-Identifier: MIT

#include "dsl/source_file.hpp"

#include <string>
#include <vector>

namespace director::compiler {

/// What Make and Ninja read: the outputs depend on every file that was read, also on
/// `others`. Blanks and what else has a meaning there
/// are written so that it has none.
std::string depfile(const std::vector<std::string>& outputs, const dsl::Sources& sources,
                    const std::vector<std::string>& others = {});

} // namespace director::compiler
