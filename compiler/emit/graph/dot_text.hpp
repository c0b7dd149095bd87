#pragma once
// SPDX-License-Identifier: MIT
// Texts, links and ports in the input of Graphviz.

#include "compiler/emit/graph/formats.hpp"

#include <string>
#include <string_view>

namespace director::compiler {

/// The tooltip of a node or an arrow, in quotes.
std::string quoted_tooltip(const PictureText& text);

/// The attributes of a cell or a table with its tooltip and its link.
std::string cell_words(const PictureText& text, const PictureLinks& links);

/// What Graphviz makes in SVG of a cell with a tooltip and without a link; not needed there.
inline constexpr std::string_view target_in_svg = " target=\"_top\"";

/// The port of a provider, and of a pack of it: `halting`, `ready.go`, `kick`. It is the name in the title.
std::string port(const PictureRow& row);
std::string port(const PictureRow& row, const PicturePack& pack);
/// Of an arrow's end; empty: it is at the whole box.
std::string port(const Picture& picture, const PictureEnd& end);

/// What an arrow says; empty: nothing.
std::string label_text(const PictureArrow& arrow);

} // namespace director::compiler
