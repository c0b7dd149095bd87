// Door: compiler/cli/commands.hpp. Test: tests/cli/graph_test.cpp.
#include "compiler/cli/load.hpp"
#include "compiler/emit/graph/formats.hpp"

#include <fmt/format.h>

namespace director::compiler::cli {

namespace {

/// The picture drawn by Graphviz; nothing, and says why, where that cannot be.
std::optional<std::string> svg(const Picture& picture, Console& console) {
  const Answer answer = console.programs.run({"dot", "-Tsvg"}, dot(picture));
  if (!answer.started) {
    console.err << "directorc: --format=svg needs the program `dot` of Graphviz, which is not installed (on Debian: "
                   "apt-get install graphviz); --format=dot needs nothing\n";
    return {};
  }
  if (answer.status != 0) {
    console.err << fmt::format("directorc: `dot` could not draw the graph (exit status {})\n", answer.status);
    return {};
  }
  return answer.output;
}

std::optional<std::string> drawn(const Checked& checked, Format format, Console& console) {
  const Picture picture = make_picture(checked.model, checked.graph);
  switch (format) {
  case Format::json: return to_lines(graph_json(checked.model, checked.graph));
  case Format::svg: return svg(picture, console);
  case Format::mermaid: return mermaid(picture);
  case Format::dot:
  case Format::sarif:
  case Format::text: break;
  }
  return dot(picture);
}

} // namespace

int run(const DrawGraph& request, Console& console) {
  dsl::Sources sources;
  const std::optional<Checked> checked = load(request.file, {}, sources, console);
  if (!checked) return misused;
  if (!checked->resolved) {
    print_findings(errors_of(checked->findings), sources, console.err, console.err_colours);
    return found;
  }
  const std::optional<std::string> text = drawn(*checked, request.format, console);
  if (!text) return misused;
  if (request.output.empty()) {
    console.out << *text;
  } else if (const std::optional<std::string> fault = console.outputs.write(request.output, *text)) {
    console.err << fmt::format("directorc: cannot write `{}`: {}\n", request.output, *fault);
    return misused;
  }
  return clean;
}

} // namespace director::compiler::cli
