// Header: compiler/cli/system/draw_svg.hpp. Test: tests/compiler/cli/commands/graph_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/system/draw_svg.hpp"

#include <fmt/format.h>

#include <set>

namespace director::compiler::cli {

std::optional<std::string> draw_svg(const Picture& picture, const PictureLinks& links, std::string_view wish,
                                    std::string_view instead, Console& console) {
  const auto drawn = [&](const std::set<std::size_t>& beside) { // the warnings of `dot` name no file
    return console.programs.run({"dot", "-q", "-Tsvg"}, dot(picture, links, beside));
  };
  Answer answer = drawn({});
  if (answer.started && answer.status == 0) {
    if (const std::set<std::size_t> lost = lost_labels(picture, answer.output); !lost.empty()) answer = drawn(lost);
  }
  if (!answer.started) {
    print_message(console,
                  fmt::format("directorc: {} needs the program `dot` of Graphviz, which is not installed (on Debian: "
                              "apt-get install graphviz); {} needs nothing\n",
                              wish, instead));
    return {};
  }
  if (answer.status != 0) {
    print_message(
        console,
        fmt::format("directorc: `dot` failed with exit status {}: the graph is not drawn; {} needs no Graphviz\n",
                    answer.status, instead));
    return {};
  }
  return finish_svg(picture, answer.output);
}

} // namespace director::compiler::cli
