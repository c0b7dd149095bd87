// Header: compiler/page/markdown_transitions.hpp. Test: tests/compiler/page/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/page/markdown_transitions.hpp"

#include "compiler/page/markdown_text.hpp"
#include "compiler/page/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <map>
#include <string_view>
#include <vector>

namespace director::compiler::page {

namespace {

std::string row_in_markdown(const Json& rows, const Json& row) {
  std::string out =
      fmt::format("### From {}\n\n{}\n\n", escaped(row["group"].as_text()), escaped(row["words"].as_text()));
  const std::size_t before = out.size();
  std::map<std::string_view, std::vector<std::string>> others;
  for (std::size_t i = 0; i < rows.items().size(); ++i) {
    const Json& cell = row["cells"].items()[i];
    if (!needs_explanation(cell)) {
      others[cell_kind(cell).kind].push_back(escaped(rows.items()[i]["group"].as_text()));
      continue;
    }
    out += fmt::format("- to {}, {}: {}\n", escaped(rows.items()[i]["group"].as_text()), cell_kind(cell).kind,
                       escaped(cell["words"].as_text()));
  }
  if (out.size() != before) out += "\n";
  for (const auto& [kind, names] : others) out += fmt::format("To {}: {}.\n\n", fmt::join(names, ", "), kind);
  return out;
}

} // namespace

std::string transitions_in_markdown(const Json& transitions) {
  std::string out;
  const Json& rows = transitions["rows"];
  if (!transitions["left_out"].is_null())
    out += fmt::format("## Transitions\n\n{}\n\n", message(transitions["left_out"].as_text()));
  if (rows.items().empty()) return out;
  out +=
      fmt::format("## Transitions\n\nThe first group, a row, runs; then the second one, a column, is requested. {}\n\n",
                  one_course);
  if (transitions["limited"].as_boolean()) out += fmt::format("{}\n\n", limited_intro);
  for (const CellKind& kind : cell_kinds_in(rows))
    out += fmt::format("- **{}** {}: {}\n", kind.sign, kind.kind, kind.meaning);
  if (has_refuted(rows)) out += fmt::format("- **\u2716** refuted: {}\n", refuted_meaning);
  out += "\n| from \\ to |";
  for (const Json& row : rows.items()) out += fmt::format(" {} |", escaped(row["group"].as_text()));
  out += "\n| --- |";
  for (std::size_t i = 0; i < rows.items().size(); ++i) out += " --- |";
  out += "\n";
  for (const Json& row : rows.items()) {
    out += fmt::format("| **{}** |", escaped(row["group"].as_text()));
    for (const Json& cell : row["cells"].items()) out += fmt::format(" {} |", cell_sign(cell));
    out += "\n";
  }
  out += "\n";
  if (!transitions["not_requested"].items().empty()) {
    std::vector<std::string> names;
    for (const std::string& name : transitions["not_requested"].as_texts()) names.push_back(escaped(name));
    out += fmt::format("Not requested: {}.\n\n", fmt::join(names, ", "));
  }
  for (const Json& row : rows.items()) out += row_in_markdown(rows, row);
  return out;
}

} // namespace director::compiler::page
