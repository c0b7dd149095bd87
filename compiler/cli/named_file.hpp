#pragma once
// SPDX-License-Identifier: MIT
// What is said where a file that the command line names cannot be read: of a folder also which file was meant, maybe.

#include "compiler/cli/console.hpp"

#include <string>
#include <string_view>

namespace director::compiler::cli {

// By their names.
bool is_called_behaviour(std::string_view path);
bool is_called_scenario(std::string_view path); ///< one that is played where its folder is
bool is_called_trace(std::string_view path);

/// "; name a file in it, such as `soccer/soccer.yaml`", if the path is that of a folder, and what stands for the
/// standard input where `-` is no file; else empty. `is_wanted`: of the files in it the one that is called like the
/// folder comes first, then the first of all.
std::string file_instead(const std::string& path, bool (*is_wanted)(std::string_view), Console& console);

} // namespace director::compiler::cli
