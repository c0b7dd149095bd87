#pragma once
// SPDX-License-Identifier: MIT
// The expected content of the blocks of a page. A comment directly before a block names the source of its text:
//
//   <!-- file: PATH -->                      the file, without the indentation that all its lines have
//   <!-- file, from "A", to "B": PATH -->    the lines of the file from the first that has A to the next that has B;
//                                            either may be missing, and `before "B"` excludes the last line
//   <!-- run: COMMAND -->                    the output of the command in the source tree; `run, exit 1:` if it fails
//   <!-- session -->                         the commands behind `$ ` in the block and their output;
//                                            `session, exit 1` if they fail; `in "FOLDER"` is where they run
//   <!-- output: ./start -->                 the output of the script and of the programs at its end
//   <!-- check -->                           a behaviour that is clean; its first two lines may be missing. Further
//                                            lines of the comment are a file beside it, which it imports
//   <!-- findings -->                        the output of `directorc check` for the block before, which is not clean
//   <!-- not run: REASON -->                 anything
//
// A line `…` in a block stands for any lines.

#include "tests/docs/markdown.hpp"

#include <string>
#include <vector>

namespace director::tests {

struct ExpectedPage {
  std::string text;                ///< the page as it should be
  std::vector<std::string> faults; ///< what cannot be decided, each as `PAGE:LINE: what is wrong`
};

ExpectedPage expected_page(const std::string& path, const Markdown& page);

} // namespace director::tests
