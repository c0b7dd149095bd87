#pragma once
// SPDX-License-Identifier: MIT
// Makes the page of one behaviour, which `docs` writes as it is, and `trace` with the recorded events.

#include "compiler/cli/system/console.hpp"
#include "compiler/page/pages.hpp"
#include "compiler/pipeline.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler::cli {

struct PageWish {
  bool markdown = false;                ///< else HTML
  std::string link;                     ///< address of a line, with {file} and {line}; empty: nothing is a link
  std::vector<std::string> transitions; ///< groups of the matrix; empty: all
  std::string requested = "--format=html", instead = "--format=markdown"; ///< the option that needs Graphviz, and one
                                                                          ///< that does not
  const PageRecording* recording = nullptr;                               ///< null: none
};

/// Empty, and prints why, if it cannot be made. `checked`: resolved. `file`: its path.
std::optional<std::string> make_page(const std::string& file, const Checked& checked, const dsl::Sources& sources,
                                     const PageWish& wish, Console& console);

} // namespace director::compiler::cli
