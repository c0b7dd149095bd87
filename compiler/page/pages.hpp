#pragma once
// SPDX-License-Identifier: MIT
// A behaviour as a page for people. What a page tells stands in the JSON that `directorc graph --format=json --page`
// prints; nothing else is looked at but the pictures.

#include "compiler/base/json.hpp"

#include <string>
#include <vector>

namespace director::compiler {

struct PagePicture {
  std::string name; ///< `Whole`, `By module`
  std::string text; ///< SVG; for Markdown Mermaid
};

struct PageInput {
  const Json& data;
  std::vector<PagePicture> pictures; ///< the first one is shown first
  std::string link;                  ///< address of a line, with {file} and {line} in it; empty: nothing is a link
  std::string file;                  ///< the behaviour's name of a file, for the notice
};

/// One file that needs no other, and nothing of the network.
std::string html_page(const PageInput& input);

/// For GitHub, GitLab, MkDocs and Sphinx.
std::string markdown_page(const PageInput& input);

namespace page {

/// Script and style of the page: compiler/page/bundle, compiled in.
std::string_view page_script();
std::string_view page_style();

} // namespace page

} // namespace director::compiler
