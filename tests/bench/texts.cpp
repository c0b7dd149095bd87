// Header: tests/bench/texts.hpp. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "tests/bench/texts.hpp"

#include <fmt/format.h>

#include <string_view>

namespace bench {

namespace {

const std::string head = "behaviour: grown\nlanguage: 1\nlimits: {pass: 1000000000}\n"; // one component

constexpr const char* tree = R"(  Robot_{0}:
    tasks:
      Walk_{0}: {{apart: true}}
      Head_{0}: {{apart: true}}
      Neck_{0}: {{apart: true}}
      LeftArm_{0}: {{apart: true}}
      LeftHand_{0}: {{apart: true}}
      RightArm_{0}: {{apart: true}}
      RightHand_{0}: {{apart: true}}
  Walk_{0}:
    providers:
      - {{name: walking, needs: [Legs_{0}], sets: [Pose_{0} == moving], tasks: [Legs_{0}]}}
      - {{name: halting, needs: [Legs_{0}], causing: [Pose_{0} == standing], tasks: [Legs_{0}]}}
  Kick_{0}: {{when: [Pose_{0} == standing], needs: [Legs_{0}]}}
  Legs_{0}: {{}}
  Head_{0}: {{}}
  Neck_{0}: {{}}
  LeftArm_{0}: {{}}
  LeftHand_{0}: {{}}
  RightArm_{0}: {{}}
  RightHand_{0}: {{}}
)";

/// The names are numbered from 1.
std::string rows(std::size_t count, fmt::format_string<std::size_t&> row) {
  std::string out;
  for (std::size_t i = 1; i <= count; ++i) out += fmt::format(row, i);
  return out;
}

} // namespace

std::string trees(std::size_t groups) {
  const std::size_t count = groups / 10;
  return head + ("states:\n" + rows(count, "  Pose_{}: {{values: [moving, standing]}}\n")) + "roots:\n" +
         rows(count, "  Robot_{0}: {{priority: 10}}\n  Kick_{0}: {{priority: 20}}\n") + "groups:\n" + rows(count, tree);
}

std::string waiting(std::size_t tasks) {
  return head +
         ("roots:\n  Left: {priority: {low: 1, high: 3}}\n  Right: {priority: 2}\n" +
          rows(tasks, "  Waiting_{0}: {{priority: -{0}}}\n")) +
         "groups:\n  Left: {tasks: [Shared]}\n  Right: {tasks: [Shared]}\n  Shared: {}\n" +
         rows(tasks, "  Waiting_{}: {{tasks: [Shared]}}\n");
}

std::string apart(std::size_t groups) {
  return head + ("roots:\n" + rows(groups, "  Task_{}: {{}}\n")) + "groups:\n" + rows(groups, "  Task_{}: {{}}\n");
}

std::string together(std::size_t groups) {
  return head + ("roots: [All]\ngroups:\n  All:\n    tasks:\n" + rows(groups, "      Task_{}: {{}}\n")) +
         rows(groups, "  Task_{}: {{}}\n");
}

std::string wide_units(std::size_t units) {
  std::string out = head + ("roots:\n  Holder: {priority: 1000}\n" + rows(units, "  Unit_{0}: {{priority: {0}}}\n")) +
                    "groups:\n  Holder: {tasks: [Key]}\n  Key: {}\n" +
                    rows(units, "  Unit_{0}: {{tasks: [Member1_{0}, Member2_{0}, Member3_{0}, Member4_{0}]}}\n");
  for (const char* member : {"Member1", "Member2", "Member3", "Member4"}) {
    const bool last = std::string_view(member) == "Member4";
    std::string providers;
    for (int i = 1; i <= 10; ++i) providers += fmt::format("{{name: way{}{}}}, ", i, last ? ", needs: [Key]" : "");
    for (std::size_t i = 1; i <= units; ++i) out += fmt::format("  {}_{}: {{providers: [{}]}}\n", member, i, providers);
  }
  return out;
}

} // namespace bench
