// Header: tests/defects/trial.hpp. Test: tests/defects/measure.cpp.
// SPDX-License-Identifier: MIT
#include "tests/defects/trial.hpp"

#include "compiler/explore/limits.hpp"
#include "compiler/pipeline.hpp"
#include "dsl/source/render.hpp"
#include "tests/compiler/support/scenario_findings.hpp"

#include <algorithm>
#include <string_view>

namespace director::defects {

namespace {

constexpr std::string_view scenario = "trial.scenario.yaml";

void without_signs(std::string& word) { word.erase(std::remove(word.begin(), word.end(), '@'), word.end()); }

void without_signs(Node& node) {
  without_signs(node.word);
  for (std::string& key : node.keys) without_signs(key);
  for (Node& item : node.items) without_signs(item);
}

/// Another robot for each check.
std::uint64_t mixed(std::string_view id, std::uint64_t seed) {
  for (const char c : id) seed = seed * 31 + static_cast<unsigned char>(c);
  return seed;
}

/// What is like a defect and is none makes it harder to be right.
void add_near_misses(Robot& robot, const Planter& planter) {
  std::vector<const Planter*> all;
  for (const auto& some :
       {resource_planters(), condition_planters(), push_planters(), undoing_planters(), priority_planters()}) {
    for (const Planter& each : some) {
      const std::string_view id = each.id;
      const bool in_scenario = id == "undeclared_state_write" || id == "unreachable_case"; // of which there is one
      if (id != planter.id && id != "assertion_failed" && !in_scenario) all.push_back(&each);
    }
  }
  for (const Planter* each : robot.r.some(all, 0, 3)) each->plant(robot, false);
  for (File& file : robot.files) without_signs(file.node);
}

} // namespace

Planted make_planted(const Case& one, bool defect, const std::function<void(Robot&)>& change) {
  const std::string id = one.planter->id;
  const bool asserted = id == "assertion_failed"; // decided by trying everything: of a small robot
  Random random(mixed(id, one.seed));
  Robot robot(random);
  grow(robot, asserted ? -1 : one.size);
  if (!asserted) add_near_misses(robot, *one.planter);
  one.planter->plant(robot, defect);
  if (change) {
    for (File& file : robot.files) without_signs(file.node);
    change(robot);
  }
  Planted out;
  std::vector<Mark> marks;
  out.texts = robot.render(marks);
  out.expected.insert(marks.begin(), marks.end());
  out.main = robot.files.front().path;
  out.edited = !robot.edits.empty();
  return out;
}

Outcome try_out(const Case& one, bool defect) {
  const std::string id = one.planter->id;
  Planted planted = make_planted(one, defect);
  Outcome out;
  out.texts = std::move(planted.texts);
  out.expected = std::move(planted.expected);

  dsl::MemoryFiles files;
  for (const auto& [path, text] : out.texts) files.add(path, text);
  dsl::Sources sources;
  compiler::CheckOptions options;
  options.decide = id == "assertion_failed" ? compiler::states_of_check : 0;
  options.selection.lints.insert(id);
  compiler::Checked checked = compiler::check(planted.main, files, sources, options);
  if (out.texts.count(std::string(scenario)) != 0 && checked.lowerable) {
    for (dsl::Diagnostic& each : tests::scenario_findings(std::string(scenario), checked.model, files, sources))
      checked.findings.push_back(std::move(each));
  }
  out.report = dsl::render(checked.findings, sources);
  for (const dsl::Diagnostic& finding : checked.findings) {
    const dsl::SourceFile& file = sources[finding.span.file];
    const bool expected = out.expected.count({file.path(), file.place(finding.span.begin).line}) != 0;
    const bool same = finding.id == id;
    out.found = out.found || (same && expected);
    out.elsewhere = out.elsewhere || (same && !expected && finding.level != dsl::Level::lint);
    out.others += !same;
    out.findings += finding.level != dsl::Level::lint;
  }
  out.elsewhere = out.elsewhere && !out.found;
  return out;
}

} // namespace director::defects
