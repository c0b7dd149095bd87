#pragma once
// SPDX-License-Identifier: MIT

#include <string>
#include <string_view>
#include <vector>

namespace director::tests {

// Says what is wrong with the include `name` (written in <> or "") in the file at `path` (from the root of the
// project); empty where nothing is. The rules: the allowed dependencies of each component, and the place of each
// library.
std::string include_fault(std::string_view path, std::string_view name, bool angled);

// All faults of a file, as "path:line: fault".
std::vector<std::string> include_faults(std::string_view path, const std::vector<std::string>& lines);

// The headers that a file includes by their path from the root of the project.
std::vector<std::string> project_includes(const std::vector<std::string>& lines);

} // namespace director::tests
