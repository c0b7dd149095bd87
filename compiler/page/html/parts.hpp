#pragma once
// SPDX-License-Identifier: MIT
// The sections of the HTML page, each a text.

#include "compiler/page/relations.hpp"
#include "compiler/page/words.hpp"

#include <string>
#include <string_view>

namespace director::compiler::page {

/// The same for a finding's message, which has code between backquotes.
std::string message_html(std::string_view text);

/// The input of the sections.
struct HtmlInput {
  const PageInput& page;
  const Relations& relations;
};

/// The place of a declaration, as a link if links are wanted.
std::string place_html(const Json& thing, const HtmlInput& input);
/// A paragraph or a list for each block; empty if there is no text.
std::string doc_html(const Json& thing);
/// A group's name as a link to its section.
std::string group_link(const std::string& name);

/// Graphviz's SVG without what a page needs only once (file headers, ids of nodes, and the font, which is in page.css)
/// and without redundant parts: links within the same link, and hundredths of points.
std::string svg_part(std::string svg);
std::string pictures_html(const HtmlInput& input);
std::string timeline_html(const HtmlInput& input);
std::string groups_html(const HtmlInput& input);
std::string states_html(const HtmlInput& input);
std::string takes_html(const HtmlInput& input);
std::string transitions_html(const HtmlInput& input);
std::string assertions_html(const HtmlInput& input);
std::string findings_html(const HtmlInput& input);

} // namespace director::compiler::page
