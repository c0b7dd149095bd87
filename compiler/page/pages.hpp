#pragma once
// SPDX-License-Identifier: MIT
// A behaviour as a page for people. What a page tells stands in the JSON that `directorc graph --format=json --page`
// prints; nothing else is looked at but the pictures, and a recording where there is one.

#include "compiler/base/json.hpp"

#include <string>
#include <vector>

namespace director::compiler {

struct PagePicture {
  std::string name; ///< `Whole`, `By module`
  std::string text; ///< SVG; for Markdown Mermaid
};

/// What happened, for the timeline of an HTML page.
struct PageRecording {
  std::string about; ///< `59 events in 2 s, from run.jsonl`
  std::string data;  ///< bytes of compiler/trace/recording.hpp, packed, in base64
  struct Line {
    std::string time, words;
  };
  std::vector<Line> first; ///< for who reads without a script
  std::size_t more = 0;    ///< so many there are behind those
};

struct PageInput {
  const Json& data;
  std::vector<PagePicture> pictures; ///< the first one is shown first
  std::string link;                  ///< address of a line, with {file} and {line} in it; empty: nothing is a link
  std::string file;                  ///< the behaviour's name of a file, for the notice
  const PageRecording* recording = nullptr; ///< null: none, and the page has no timeline
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
