// Header: compiler/play/expect/test_scenario.hpp. Test: tests/compiler/play/expect/test_scenario_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/expect/test_scenario.hpp"

#include "compiler/play/expect/line_diff.hpp"
#include "dsl/source/colours.hpp"
#include "dsl/source/harmless.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace director::compiler {

ScenarioResult test_scenario(const Scenario& scenario, const Model& model, const Lowered& lowered,
                             PlayOptions options) {
  ScenarioResult result;
  options.decisions = false;
  std::vector<std::vector<std::string>> happened(scenario.steps.size());
  result.played = play(scenario, model, lowered, options, [&](const Happening& happening) {
    if (happening.kind != Happening::Kind::input) happened[happening.step - 1].push_back(to_text(happening));
  });
  const std::size_t last = result.played.last_step;
  for (std::size_t i = 0; i < last; ++i) {
    const ScenarioStep& step = scenario.steps[i];
    if (step.expect) ++result.compared;
    if (i + 1 == last && result.played.refused) break; // it ended in the middle of this one
    const bool exhausted = i + 1 == last && result.played.budget_exhausted;
    if (!step.expect && !exhausted) continue;
    std::optional<std::vector<std::string>> expected;
    if (step.expect) {
      expected.emplace();
      for (const Word& line : step.expect->lines) expected->push_back(line.value);
    }
    if (!exhausted && expected == happened[i]) continue;
    const Span span = step.expect ? step.expect->span : step.span;
    result.mismatches.push_back({static_cast<std::uint32_t>(i + 1), exhausted,
                                 exhausted && result.played.too_many_stops, step.shown, span, std::move(expected),
                                 happened[i]});
  }
  happened.resize(last);
  result.happened = std::move(happened);
  return result;
}

namespace {

/// Of a line of a unified diff.
std::string_view colour_of(std::string_view line) {
  if (line.starts_with("---") || line.starts_with("+++")) return dsl::colours::bold;
  if (line.starts_with('-')) return dsl::colours::red;
  if (line.starts_with('+')) return dsl::colours::green;
  if (line.starts_with("@@")) return dsl::colours::cyan;
  return "";
}

/// For a step that expects nothing.
std::vector<std::string> first_of(std::vector<std::string> lines, std::size_t most) {
  if (lines.size() <= most) return lines;
  const std::size_t more = lines.size() - most;
  lines.resize(most);
  lines.push_back(fmt::format("... and {} more lines", more));
  return lines;
}

} // namespace

std::string render(const ScenarioResult& result, const dsl::Sources& sources, bool has_colours) {
  std::string out;
  for (const Mismatch& mismatch : result.mismatches) {
    const dsl::SourceFile& file = sources[mismatch.span.file];
    const dsl::Place place = file.place(mismatch.span.begin);
    const std::string head = fmt::format("{}:{}:{}: step {}: {}", file.path(), place.line, place.column, mismatch.step,
                                         fmt::join(mismatch.shown, "; "));
    out += dsl::painted(dsl::harmless(head), dsl::colours::bold, has_colours) + "\n";
    if (mismatch.too_many_stops)
      out += fmt::format("    something is due at more than {} times within it; advance by less\n", stops_of_advance);
    else if (mismatch.exhausted)
      out += fmt::format("    it did not come to rest within {} micro-steps{}\n", play_budget,
                         words_of_round(result.played));
    const std::size_t most_lines = mismatch.exhausted ? 30 : 200;
    const std::vector<std::string> lines = mismatch.expected
                                               ? unified_diff(*mismatch.expected, mismatch.happened, most_lines)
                                               : first_of(mismatch.happened, most_lines);
    for (const std::string& line : lines) {
      out += "    " + dsl::painted(dsl::harmless(line), colour_of(line), has_colours) + "\n";
    }
  }
  return out;
}

Json to_json(const ScenarioResult& result, const std::string& file, const std::string& title,
             const dsl::Sources& sources) {
  const auto texts = [](const std::vector<std::string>& lines) {
    std::vector<Json> out;
    for (const std::string& line : lines) out.push_back(Json::text(line));
    return Json::list(std::move(out));
  };
  Json out = Json::object({{"file", Json::text(file)}});
  if (!title.empty()) out.add("scenario", Json::text(title));
  out.add("holds", Json::boolean(result.holds())).add("compared", Json::number(result.compared));
  Json list = Json::list({});
  for (const Mismatch& mismatch : result.mismatches) {
    const dsl::Place place = sources[mismatch.span.file].place(mismatch.span.begin);
    Json row = Json::object({{"step", Json::number(mismatch.step)},
                             {"line", Json::number(place.line)},
                             {"column", Json::number(place.column)},
                             {"inputs", texts(mismatch.shown)},
                             {"exhausted", Json::boolean(mismatch.exhausted)}});
    if (mismatch.expected) row.add("expected", texts(*mismatch.expected));
    row.add("happened", texts(mismatch.happened));
    list.add(std::move(row));
  }
  out.add("mismatches", std::move(list));
  return out;
}

} // namespace director::compiler
