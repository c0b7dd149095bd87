#pragma once
// SPDX-License-Identifier: MIT
// Makes pages about a behaviour. Their content is in the JSON that `directorc graph --format=json --page` prints; only
// the pictures, and a recording if there is one, are further input.

#include "compiler/base/json.hpp"

#include <string>
#include <vector>

namespace director::compiler {

struct PagePicture {
  std::string name; ///< `Whole`, `By module`
  std::string text; ///< SVG; for Markdown Mermaid
};

/// A recording for the timeline of an HTML page.
struct PageRecording {
  std::string about; ///< `59 events in 2 s, from run.jsonl`
  std::string data;  ///< bytes of compiler/trace/recording.hpp, packed, in base64
  struct Line {
    std::string time, words;
  };
  std::vector<Line> first; ///< for display without a script
  std::size_t more = 0;    ///< the number of further ones
};

struct PageInput {
  const Json& data;
  std::vector<PagePicture> pictures; ///< the first one is shown first
  std::string link;                  ///< address of a line, with {file} and {line} in it; empty: nothing is a link
  std::string file;                  ///< the behaviour's file name in the notice
  const PageRecording* recording = nullptr; ///< null: none, and the page has no timeline
  std::string fingerprint = {};             ///< of the behaviour, as in traces; empty: it cannot be lowered
};

/// One file that needs no other file and no network.
std::string html_page(const PageInput& input);

/// For GitHub, GitLab, MkDocs and Sphinx.
std::string markdown_page(const PageInput& input);

namespace page {

/// Script and style of the page: compiler/page/bundle, compiled in.
std::string_view page_script();
std::string_view page_style();

} // namespace page

} // namespace director::compiler
