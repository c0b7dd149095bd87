#pragma once
// SPDX-License-Identifier: MIT

#include "tests/layout/source_tree.hpp"

#include <string>
#include <vector>

namespace director::tests {

// The components are compiled with several sources as one, so a compiler does not see whether each source includes what
// it uses. Here that is judged from the text: a type or a function that a header of the project defines, or a name of
// the standard library, must be declared in what the file includes, directly or by way of others. Faults, as
// "path:line: fault", each name once a file.
std::vector<std::string> missing_includes(const std::vector<ProjectFile>& files);

} // namespace director::tests
