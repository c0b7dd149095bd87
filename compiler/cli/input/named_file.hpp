#pragma once
// SPDX-License-Identifier: MIT
// Messages for a file on the command line that cannot be read; for a folder also which file may be meant.

#include "compiler/cli/system/console.hpp"

#include <string>
#include <string_view>

namespace director::compiler::cli {

// By their names.
bool is_called_behaviour(std::string_view path);
bool is_called_scenario(std::string_view path); ///< one that is played in its folder
bool is_called_trace(std::string_view path);

/// "; name a file in it, such as `soccer/soccer.yaml`", if the path is that of a folder, and the name of the standard
/// input if `-` is no file; otherwise empty. `is_wanted`: prefers the file in it with the name of the folder, then the
/// first of all.
std::string file_instead(const std::string& path, bool (*is_wanted)(std::string_view), Console& console);

} // namespace director::compiler::cli
