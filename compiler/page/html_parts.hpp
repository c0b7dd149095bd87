#pragma once
// SPDX-License-Identifier: MIT
// The sections of the HTML page, each a text.

#include "compiler/page/relations.hpp"
#include "compiler/page/words.hpp"

#include <string>
#include <string_view>

namespace director::compiler::page {

/// The same of a finding's words, which have code between backquotes.
std::string message_html(std::string_view text);

/// What the sections are made from.
struct HtmlInput {
  const PageInput& page;
  const Relations& relations;
};

/// Where something is declared, as a link if there are any.
std::string place_html(const Json& thing, const HtmlInput& input);
/// A paragraph for each that is parted by an empty line; empty where there is no text.
std::string doc_html(const Json& thing);
/// A group's name as a link to its section.
std::string group_link(const std::string& name);

/// What Graphviz wrote, without what a page has once: the heads of files, numbers of nodes as ids, and the font, which
/// is in page.css; without what is so anyway, links within the same link, and hundredths of points.
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
