// Header: compiler/emit/findings_json.hpp. Test: tests/compiler/cli/commands/check_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/findings_json.hpp"

#include "dsl/source/shortened.hpp"

namespace director::compiler {

namespace {

void add_place(Json& to, const dsl::Span& span, const dsl::Sources& sources) {
  const dsl::SourceFile& file = sources[span.file];
  const dsl::Place begin = file.place(span.begin);
  to.add("file", Json::text(file.path()));
  to.add("line", Json::number(begin.line));
  to.add("column", Json::number(begin.column));
}

void add_range(Json& to, const dsl::Span& span, const dsl::Sources& sources) {
  const dsl::Place end = sources[span.file].place(span.end);
  add_place(to, span, sources);
  to.add("end_line", Json::number(end.line));
  to.add("end_column", Json::number(end.column));
}

} // namespace

Json place_json(const dsl::Span& span, const dsl::Sources& sources) {
  Json out = Json::object({});
  add_place(out, span, sources);
  return out;
}

Json note_json(const dsl::Note& note, const dsl::Sources& sources) {
  Json row = Json::object({});
  add_range(row, note.span, sources);
  row.add("message", Json::text(dsl::shortened(note.message)));
  return row;
}

Json finding_json(const dsl::Diagnostic& finding, const dsl::Sources& sources) {
  Json out = Json::object({});
  out.add("id", Json::text(finding.id));
  out.add("level", Json::text(dsl::name_of(finding.level)));
  add_range(out, finding.span, sources);
  out.add("message", Json::text(dsl::shortened(finding.message)));
  Json notes = Json::list({});
  for (const dsl::Note& note : finding.notes) notes.add(note_json(note, sources));
  out.add("notes", std::move(notes));
  if (!finding.help.empty()) out.add("help", Json::text(dsl::shortened(finding.help)));
  return out;
}

Json findings_json(const std::vector<dsl::Diagnostic>& findings, const dsl::Sources& sources) {
  Json list = Json::list({});
  for (const dsl::Diagnostic& finding : findings) list.add(finding_json(finding, sources));
  return Json::object({{"findings", std::move(list)}});
}

} // namespace director::compiler
