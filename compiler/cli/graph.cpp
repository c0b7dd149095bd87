// Door: compiler/cli/commands.hpp. Test: tests/compiler/cli/graph_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/load.hpp"
#include "compiler/emit/graph/formats.hpp"
#include "compiler/emit/artefact/notice.hpp"

#include <fmt/format.h>

#include <filesystem>

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

std::optional<std::string> drawn(const Checked& checked, const std::string& file, Format format, Console& console) {
  const Picture picture = make_picture(checked.model, checked.graph);
  const std::string name = std::filesystem::path(file).filename().string();
  switch (format) {
  case Format::json: return to_lines(graph_json(checked.model, checked.graph));
  case Format::svg: {
    const std::optional<std::string> text = svg(picture, console);
    return text ? std::optional(svg_with_notice(name, *text)) : text;
  }
  case Format::mermaid: return with_notice(name, "%% ", mermaid(picture));
  case Format::dot:
  case Format::sarif:
  case Format::text: break;
  }
  return with_notice(name, "// ", dot(picture));
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
  const std::optional<std::string> text = drawn(*checked, request.file, request.format, console);
  if (!text) return misused;
  if (request.output.empty()) {
    console.out << *text;
  } else if (const std::optional<std::string> fault = console.outputs.write({{request.output, *text, has_notice}})) {
    console.err << fmt::format("directorc: cannot write {}\n", *fault);
    return misused;
  }
  return clean;
}

} // namespace director::compiler::cli
