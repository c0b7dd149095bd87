#pragma once
// SPDX-License-Identifier: MIT
// A box in the input of Graphviz: a node whose label is an HTML table.

#include "compiler/emit/artefact/code.hpp"
#include "compiler/emit/graph/formats.hpp"

namespace director::compiler {

std::string_view colour_of(Moment::Mark mark, std::string_view inactive);

/// Adds the node. Its rows are ports for the arrows of single providers and packs.
void draw_box(const PictureBox& box, const PictureLinks& links, Code& code);

} // namespace director::compiler
