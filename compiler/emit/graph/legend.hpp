#pragma once
// SPDX-License-Identifier: MIT
// The text below a picture: its title, and a legend of everything that is drawn in it, and of nothing else.

#include "compiler/emit/graph/picture/picture.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

struct LegendEntry {
  enum class Sample { task, optional, apart, need, both, push, take, text };
  Sample sample = Sample::text;
  std::string sign; ///< of a text: how it looks
  std::string words;
  bool is_grey = false; ///< a line whose colour means something else: the status at a moment
  bool operator==(const LegendEntry&) const = default;
};

/// Signs of lines at a moment.
inline constexpr std::string_view blue_line = "blue line", red_line = "dashed red line, bar", grey_line = "grey line";

std::vector<LegendEntry> legend_of(const Picture& picture);

/// For Graphviz: a table that takes no part in the layout. A line is the border of a cell.
std::vector<std::string> legend_table(const Picture& picture);

} // namespace director::compiler
