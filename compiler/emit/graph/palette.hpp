#pragma once
// SPDX-License-Identifier: MIT
// The colours of pictures, and the HTML of Graphviz. They are distinguishable with red-green blindness and in print; on
// white and on a band each has a contrast of at least 4.5. Source: Okabe and Ito, "Color Universal Design", made
// darker.

#include <string>
#include <string_view>

namespace director::compiler::palette {

inline constexpr std::string_view ink = "#202428", task = "#404040", need = "#00629B", when = "#8A5100",
                                  push = "#00704F", take = "#A23B00", queued = "#A3171A", faint = "#8A919B",
                                  grey = "#5A616B", frame = "#6B727C", band = "#F1F3F5", paper = "#FFFFFF";

/// HTML on several lines, broken between words. `before`: the width of the text before it. `line_end`: the alignment of
/// each line, by default to the left.
std::string wrapped(std::string_view text, std::size_t before = 0,
                    std::string_view line_end = "<BR ALIGN=\"LEFT\"/>");
/// A string of the DOT language.
std::string in_quotes(std::string_view text);

} // namespace director::compiler::palette
