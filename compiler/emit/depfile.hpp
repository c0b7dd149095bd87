#pragma once
// SPDX-License-Identifier: MIT

#include "dsl/source_file.hpp"

#include <string>
#include <vector>

namespace director::compiler {

/// A depfile for Make and Ninja: the outputs depend on every file that was read, also on `others`. Blanks and other
/// special characters are escaped.
std::string depfile(const std::vector<std::string>& outputs, const dsl::Sources& sources,
                    const std::vector<std::string>& others = {});

} // namespace director::compiler
