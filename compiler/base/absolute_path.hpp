#pragma once
// SPDX-License-Identifier: MIT

#include <filesystem>

namespace director::compiler {

/// The path from the root, `.` for an empty one; unchanged if the working directory is gone.
std::filesystem::path absolute_path(const std::filesystem::path& path);

} // namespace director::compiler
