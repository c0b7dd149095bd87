// Door: compiler/emit/graph/formats.hpp. Test: tests/compiler/cli/graph_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/artefact/code.hpp"
#include "compiler/emit/graph/formats.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char letter : text) {
    switch (letter) {
    case '"': out += "#quot;"; break;
    case '<': out += "#lt;"; break;
    case '>': out += "#gt;"; break;
    case '|': out += "#124;"; break;
    default: out += letter;
    }
  }
  return out;
}

bool direct(const PictureBox& box) { return box.rows.size() == 1 && box.rows.front().name.empty(); }

std::string words_of(const PictureRow& row) {
  std::string out;
  if (!row.when.empty()) out += "<br/>when " + escaped(row.when);
  if (!row.stay.empty()) out += "<br/>stay " + escaped(row.stay);
  if (!row.causing.empty()) out += "<br/>causing " + escaped(row.causing);
  return out;
}

std::string end_of(const Picture& picture, GroupId group, const std::optional<ProviderId>& provider) {
  const bool row = provider && !direct(picture.boxes[group.value]);
  return row ? fmt::format("p{}", provider->value) : fmt::format("g{}", group.value);
}

std::string_view line_of(const PictureArrow& arrow) {
  if (arrow.task && arrow.need) return "==>";
  if (arrow.need) return "--o";
  return arrow.optional ? "-.->" : "-->";
}

} // namespace

std::string mermaid(const Picture& picture) {
  Code code;
  code.open("flowchart TB");
  code.line("%% --> task, -.-> optional task, --o need, ==> task that is needed, -. condition .-> causing");
  for (const PictureBox& box : picture.boxes) {
    const std::string name = escaped(box.name);
    if (direct(box)) {
      code.line(fmt::format("g{}[\"{}{}\"]", box.group.value, name, words_of(box.rows.front())));
      continue;
    }
    code.open(fmt::format("subgraph g{}[\"{}\"]", box.group.value, name));
    for (const PictureRow& row : box.rows) {
      code.line(fmt::format("p{}[\"{}{}\"]", row.provider.value, escaped(row.name.empty() ? "default" : row.name),
                            words_of(row)));
    }
    code.close("end");
  }
  for (const PictureArrow& arrow : picture.arrows) {
    code.line(fmt::format("{} {} g{}", end_of(picture, arrow.from, arrow.provider), line_of(arrow), arrow.to.value));
  }
  for (const PictureCause& cause : picture.causes) {
    code.line(fmt::format("{} -. \"{}\" .-> {}", end_of(picture, cause.causer_group, cause.causer),
                          escaped(cause.condition), end_of(picture, cause.waiter_group, cause.waiter)));
  }
  code.close("");
  return code.text();
}

} // namespace director::compiler
