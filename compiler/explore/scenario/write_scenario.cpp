// Header: compiler/explore/scenario/write_scenario.hpp. Test: tests/compiler/explore/verdict_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/explore/scenario/write_scenario.hpp"

#include "compiler/explore/scenario/scenario_draft.hpp"
#include "compiler/play/play.hpp"
#include "compiler/play/scenario/resolve_scenario.hpp"
#include "dsl/yaml/yaml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace director::compiler {

namespace {

std::string text_of(const ScenarioDraft& draft, const ScenarioHead& head,
                    const std::vector<std::vector<std::string>>& expected) {
  std::string out = fmt::format("scenario: {}\ndoc: |\n", dsl::yaml_word(head.title));
  for (std::size_t at = 0; at < head.doc.size();) {
    const std::size_t end = std::min(head.doc.find('\n', at), head.doc.size());
    out += fmt::format("  {}\n", head.doc.substr(at, end - at));
    at = end + 1;
  }
  out += fmt::format("behaviour: {}\n", dsl::yaml_word(head.behaviour));
  if (!draft.script().empty()) out += "script:\n";
  for (const auto& [name, cases] : draft.script()) {
    out += fmt::format("  {}:\n", name);
    for (const std::vector<std::string>& words : cases) out += fmt::format("    - {{{}}}\n", fmt::join(words, ", "));
  }
  out += "steps:\n";
  const std::vector<ScenarioDraft::Words>& steps = draft.steps();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    out += steps[i].size() == 1 ? fmt::format("  - {}\n", steps[i].front())
                                : fmt::format("  - inputs: [{{{}}}]\n", fmt::join(steps[i], "}, {"));
    if (i >= expected.size()) continue;
    out += "    expect: |\n";
    if (expected[i].empty()) out += "      # nothing\n";
    for (const std::string& line : expected[i]) out += fmt::format("      {}\n", line);
  }
  return out;
}

struct Play {
  bool good = false, exhausted = false;
  std::vector<std::vector<std::string>> steps; ///< in the form of `expect`
  std::vector<std::string> lines;              ///< as ScenarioDraft::lines
  std::vector<std::string> providers;          ///< that ran
};

Play play_text(const std::string& text, const Model& model, const Lowered& lowered) {
  Play out;
  const std::optional<Scenario> scenario = scenario_from(text, model);
  if (!scenario) return out;
  out.steps.resize(scenario->steps.size());
  const Sink sink = [&](const Happening& happening) {
    using Kind = Happening::Kind;
    if (happening.kind == Kind::input || happening.kind == Kind::budget_exhausted) return;
    out.steps[happening.step - 1].push_back(to_text(happening));
    switch (happening.kind) {
    case Kind::run:
      out.providers.push_back(happening.group + "." + happening.provider);
      out.lines.push_back("run " + out.providers.back());
      break;
    case Kind::start: out.lines.push_back("start " + happening.group); break;
    case Kind::stop: out.lines.push_back("stop " + happening.group); break;
    case Kind::done: out.lines.push_back("done " + happening.group); break;
    default: break;
    }
  };
  const Played played = play(*scenario, model, lowered, {}, sink);
  out.good = !played.refused;
  out.exhausted = played.budget_exhausted;
  return out;
}

} // namespace

std::optional<std::string> write_scenario(const Ground& ground, const std::vector<Taken>& way,
                                          const ScenarioHead& head) {
  ScenarioDraft draft(ground);
  if (!draft.fill(way)) return {};
  draft.repeat(head.round);
  const bool endless = !head.round.empty();
  for (;;) {
    const Play play = play_text(text_of(draft, head, {}), ground.model, ground.timed);
    const std::vector<std::string>& lines = draft.lines();
    if (!play.good || play.exhausted != endless || play.lines.size() < lines.size() ||
        !std::equal(lines.begin(), lines.end(), play.lines.begin()))
      return {};
    if (endless) return text_of(draft, head, {});
    bool quieter = false;
    for (const std::string& name : play.providers) quieter = draft.add_continuing(name) || quieter;
    if (!quieter) return text_of(draft, head, play.steps);
  }
}

std::string in_words(const Ground& ground, const std::vector<Taken>& way) {
  ScenarioDraft draft(ground);
  if (!draft.fill(way)) return {};
  std::vector<std::string> out;
  for (const auto& step : draft.steps()) {
    for (std::string words : step) {
      if (const std::size_t at = words.find(": "); at != std::string::npos) words.erase(at, 1);
      out.push_back(std::move(words));
    }
  }
  return fmt::format("{}", fmt::join(out, "; "));
}

} // namespace director::compiler
