#pragma once
// SPDX-License-Identifier: MIT

#include "dsl/source/source_file.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

/// The first path that Make or Ninja cannot read in any spelling.
std::optional<std::string> inexpressible_path(const std::vector<std::string>& outputs, const dsl::Sources& sources,
                                              const std::vector<std::string>& others = {});

/// What is said then. `result`: "nothing is written".
std::string no_depfile(const std::string& path, const std::string& depfile, const std::string& result);

/// A depfile for Make and Ninja: the outputs depend on every file that was read, also on `others`. Blanks and other
/// special characters are escaped.
std::string depfile(const std::vector<std::string>& outputs, const dsl::Sources& sources,
                    const std::vector<std::string>& others = {});

} // namespace director::compiler
