// Header: compiler/diff/diff.hpp. Test: tests/compiler/cli/commands/diff_test.cpp.
// SPDX-License-Identifier: MIT
//
// Changes as text, as JSON and as SARIF.
#include "compiler/base/counted.hpp"
#include "compiler/diff/diff.hpp"
#include "compiler/emit/findings_json.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

std::string place_text(const dsl::Span& span, const dsl::Sources& sources) {
  const dsl::SourceFile& file = sources[span.file];
  const dsl::Place place = file.place(span.begin);
  return fmt::format("{}:{}:{}", file.path(), place.line, place.column);
}

} // namespace

std::string changes_text(const std::vector<BehaviourChange>& changes, const Breaking& breaking,
                         const dsl::Sources& sources) {
  std::string out;
  const BehaviourChange* last = nullptr;
  std::size_t broken = 0;
  for (const BehaviourChange& change : changes) {
    const ChangeKindPage& page = page_of(change.kind);
    if (last == nullptr || last->kind != change.kind)
      out += fmt::format("{}{}: {}\n", last == nullptr ? "" : "\n", page.id, page.meaning);
    last = &change;
    broken += breaking.has(change) ? 1 : 0;
    out += fmt::format("  {}{}{}\n", breaking.has(change) ? "breaking: " : "", change.message,
                       change.breaks_code ? " (C++ has to follow)" : "");
    if (change.after) out += fmt::format("    now    {}\n", place_text(*change.after, sources));
    if (change.before) out += fmt::format("    before {}\n", place_text(*change.before, sources));
    if (!change.hint.empty()) out += fmt::format("    hint: {}\n", change.hint);
  }
  if (last == nullptr) return out;
  out += fmt::format("\n{}", counted(changes.size(), "change"));
  if (broken > 0) out += fmt::format(", {} of them breaking", broken);
  return out + "\n";
}

Json changes_json(const std::vector<BehaviourChange>& changes, bool compared, const Breaking& breaking,
                  const dsl::Sources& sources) {
  Json list = Json::list({});
  bool any = false;
  for (const BehaviourChange& change : changes) {
    Json one = Json::object({{"kind", Json::text(page_of(change.kind).id)},
                             {"subject", Json::text(change.subject)},
                             {"message", Json::text(change.message)},
                             {"breaking", Json::boolean(breaking.has(change))},
                             {"breaks_code", Json::boolean(change.breaks_code)}});
    if (change.before) one.add("before", place_json(*change.before, sources));
    if (change.after) one.add("after", place_json(*change.after, sources));
    if (!change.hint.empty()) one.add("hint", Json::text(change.hint));
    any = any || breaking.has(change);
    list.add(std::move(one));
  }
  Json out = Json::object({{"breaking", Json::boolean(any)}, {"compared", Json::boolean(compared)}});
  out.add("changes", std::move(list));
  return out;
}

Json changes_sarif(const std::vector<BehaviourChange>& changes, const Breaking& breaking, const dsl::Sources& sources) {
  std::vector<SarifRule> rules;
  for (const ChangeKindPage& page : change_kinds())
    rules.push_back({std::string(page.id), dsl::Level::warning, std::string(page.meaning), std::string(page.meaning)});
  std::vector<dsl::Diagnostic> results;
  for (const BehaviourChange& change : changes) {
    dsl::Diagnostic one{std::string(page_of(change.kind).id),
                        breaking.has(change) ? dsl::Level::error : dsl::Level::warning,
                        change.after ? *change.after : *change.before,
                        change.message,
                        {},
                        change.hint};
    if (change.after && change.before) one.notes.push_back({*change.before, "before"});
    results.push_back(std::move(one));
  }
  return findings_sarif(results, {}, sources, rules);
}

} // namespace director::compiler
