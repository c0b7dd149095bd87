#pragma once
// SPDX-License-Identifier: MIT
// A picture, drawn by Graphviz.

#include "compiler/cli/system/console.hpp"
#include "compiler/emit/graph/formats.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace director::compiler::cli {

/// Empty, and prints why, if it cannot be drawn. `wish`: the option that needs it; `instead`: one that does not.
std::optional<std::string> draw_svg(const Picture& picture, const PictureLinks& links, std::string_view wish,
                                    std::string_view instead, Console& console);

} // namespace director::compiler::cli
