// Header: tests/dsl/reading/reading.hpp.
// SPDX-License-Identifier: MIT
#include "tests/dsl/reading/reading.hpp"

#include <fmt/format.h>

namespace director::dsl {

std::string findings_text(const std::vector<Diagnostic>& diagnostics, const Sources& sources) {
  const auto place = [&](const Span& span) {
    const Place from = sources[span.file].place(span.begin);
    std::string_view text = sources.text(span);
    const bool cut = text.find('\n') != std::string_view::npos;
    text = text.substr(0, text.find('\n'));
    return fmt::format("{}{}:{} `{}{}`", span.file.value == 0 ? "" : sources[span.file].path() + ":", from.line,
                       from.column, text, cut ? "…" : "");
  };
  std::string out;
  for (const Diagnostic& d : diagnostics) {
    out += fmt::format("{} {}{}: {}", place(d.span), d.level == Level::error ? "" : "warning ", d.id, d.message);
    if (!d.help.empty()) out += fmt::format(" ({})", d.help);
    out += "\n";
    for (const Note& note : d.notes) out += fmt::format("  {} {}\n", place(note.span), note.message);
  }
  return out;
}

Read read_text(const std::string& text) {
  Read read;
  read.files.add("main.yaml", text);
  read.result = read_behaviour("main.yaml", read.files, read.sources);
  return read;
}

Read read_body(const std::string& body) { return read_text("behaviour: b\nlanguage: 1\n" + body); }

ScenarioRead read_scenario_body(const std::string& body) {
  ScenarioRead read;
  read.files.add("b.scenario.yaml", "behaviour: b.yaml\n" + body);
  read.result = read_scenario("b.scenario.yaml", read.files, read.sources);
  return read;
}

} // namespace director::dsl
