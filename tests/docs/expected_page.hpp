#pragma once
// SPDX-License-Identifier: MIT
// What the blocks of a page should say. A comment directly before a block tells where its text comes from:
//
//   <!-- file: PATH -->                      the file, without indentation that all its lines have
//   <!-- file, from "A", to "B": PATH -->    of the file the lines from the first that holds A to the next that holds
//   B;
//                                            either may be missing, and `before "B"` leaves the last of them out
//   <!-- run: COMMAND -->                    what the command prints in the source tree; `run, exit 1:` if it fails
//   <!-- session -->                         the commands behind `$ ` in the block and what they print; `session, exit
//   1`
//                                            if they fail; `in "FOLDER"` is where in the source tree they run
//   <!-- output: ./start -->                 what the script prints of its own and through the programs that it ends
//   with
//   <!-- check -->                           a behaviour that is clean; its first two lines may be missing. Further
//   lines
//                                            of the comment are a file beside it, which it imports
//   <!-- findings -->                        what `directorc check` prints of the block before, which is then not clean
//   <!-- not run: REASON -->                 anything
//
// A line `…` in a block stands for any lines.

#include "tests/docs/markdown.hpp"

#include <string>
#include <vector>

namespace director::tests {

struct ExpectedPage {
  std::string text;                ///< the page as it should be
  std::vector<std::string> faults; ///< what cannot be found out, each as `PAGE:LINE: what is wrong`
};

ExpectedPage expected_page(const std::string& path, const Markdown& page);

} // namespace director::tests
