// Header: tests/bench/project.hpp. Test: tests/bench/project_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/bench/project.hpp"

#include <fmt/format.h>

namespace bench {

namespace {

constexpr std::size_t groups_of_robot = 24;

constexpr const char* common = R"(behaviour: common
language: 1
layers: [purpose, planning, skill, actuation]
states:
  Emergency: {values: [none, slow, stop], initial: none, external: true}
groups:
  Radio: {layer: actuation}
)";

constexpr const char* robot = R"(behaviour: robot_{0}
language: 1
imports: [common.yaml]
states:
  Pose_{0}: {{values: [moving, standing]}}
  Target_{0}: {{values: [unknown, far, near], unordered: [unknown], initial: unknown, external: true}}
  Charge_{0}: {{range: [0, 100], external: true, expires: 5 s}}
triggers: [Sensors_{0}]
groups:
  Mission_{0}:
    doc: Fetches what is requested.
    layer: purpose
    providers:
      - name: stopping
        when: [Emergency == stop]
        tasks: {{Stand_{0}: {{priority: 10}}}}
      - name: fetching
        when: [Emergency == none|slow, Charge_{0} > 20]
        packs:
          approach: {{Approach_{0}: {{priority: 20}}, Watch_{0}: {{optional: true, priority: 2}}, Report_{0}: {{apart: true}}}}
          grasp: {{Grasp_{0}: {{priority: 20}}, Walk_{0}: {{apart: true}}, Watch_{0}: {{optional: true, priority: 2}}}}
          rest: {{Stand_{0}: {{}}, Report_{0}: {{apart: true}}}}
      - name: waiting
        tasks: [Stand_{0}]
  Approach_{0}:
    layer: planning
    providers:
      - {{name: slowly, when: [Target_{0} == near], tasks: {{Walk_{0}: {{priority: 5}}, Look_{0}: {{optional: true}}}}}}
      - {{name: searching, tasks: {{Walk_{0}: {{priority: 5}}, Look_{0}: {{apart: true}}}}}}
  Grasp_{0}:
    layer: planning
    when: [Pose_{0} == standing]
    needs: [Arm_{0}]
    tasks: {{Arm_{0}: {{}}, Look_{0}: {{optional: true}}}}
  Watch_{0}:
    layer: planning
    triggers: [Sensors_{0}]
    tasks: [Head_{0}]
  Report_{0}:
    layer: planning
    every: 1 s
    needs: [Radio]
    tasks: [Radio]
  Walk_{0}:
    layer: skill
    stop: true
    providers:
      - {{name: walking, needs: [Legs_{0}], sets: [Pose_{0} == moving], tasks: [Legs_{0}]}}
      - {{name: halting, needs: [Legs_{0}], causing: [Pose_{0} == standing within 2 s], tasks: [Legs_{0}]}}
  Stand_{0}:
    layer: skill
    needs: [Legs_{0}]
    causing: [Pose_{0} == standing]
    tasks: [Legs_{0}]
  Look_{0}:
    layer: skill
    needs: [Head_{0}]
    tasks: [Head_{0}]
  Legs_{0}:
    layer: skill
    needs: [LeftLeg_{0}, RightLeg_{0}]
    tasks: [LeftLeg_{0}, RightLeg_{0}]
  LeftLeg_{0}:
    layer: skill
    needs: [LeftHip_{0}, LeftKnee_{0}, LeftAnkle_{0}]
    tasks: [LeftHip_{0}, LeftKnee_{0}, LeftAnkle_{0}]
  RightLeg_{0}:
    layer: skill
    needs: [RightHip_{0}, RightKnee_{0}, RightAnkle_{0}]
    tasks: [RightHip_{0}, RightKnee_{0}, RightAnkle_{0}]
  Arm_{0}:
    layer: skill
    needs: [Shoulder_{0}, Elbow_{0}, Gripper_{0}]
    tasks: [Shoulder_{0}, Elbow_{0}, Gripper_{0}]
  Head_{0}:
    layer: skill
    needs: [Pan_{0}, Tilt_{0}]
    tasks: [Pan_{0}, Tilt_{0}]
)";

constexpr const char* servos[] = {"LeftHip",  "LeftKnee", "LeftAnkle", "RightHip", "RightKnee", "RightAnkle",
                                  "Shoulder", "Elbow",    "Gripper",   "Pan",      "Tilt"};

const std::string head =
    "behaviour: grown\nlanguage: 1\nlimits: {trials: 1000000, pass: 1000000000}\n"; // one component

/// The names are numbered from 0.
std::string rows(std::size_t count, fmt::format_string<std::size_t&> row) {
  std::string out;
  for (std::size_t i = 0; i < count; ++i) out += fmt::format(row, i);
  return out;
}

std::string needed_by_all(std::size_t size) {
  return head + ("roots:\n" + rows(size, "  T{0}: {{priority: {0}}}\n")) + "groups:\n  Shared: {}\n" +
         rows(size, "  T{}: {{needs: [Shared], tasks: [Shared]}}\n");
}

std::string providers_of_one(std::size_t size) {
  return head + fmt::format("states:\n  S: {{range: [0, {}], external: true}}\n", size) +
         "roots: [A]\ngroups:\n  B: {}\n  A:\n    providers:\n" +
         rows(size, "      - {{name: p{0}, when: [S == {0}], needs: [B], tasks: [B]}}\n");
}

std::string chain(std::size_t size, const char* row) {
  std::string out = head + "roots: [T0]\ngroups:\n";
  for (std::size_t i = 0; i < size; ++i) out += fmt::format(fmt::runtime(row), i, i + 1);
  return out + fmt::format("  T{}: {{}}\n", size);
}

std::string chain_of_tasks(std::size_t size) { return chain(size, "  T{0}: {{tasks: [T{1}]}}\n"); }
std::string chain_of_needs(std::size_t size) { return chain(size, "  T{0}: {{needs: [T{1}], tasks: [T{1}]}}\n"); }

/// Each is a task that may push the one before it, in a chain.
std::string chain_of_causes(std::size_t size) {
  const std::string first = "  T0: {causing: [S0 == after]}\n";
  std::string groups;
  for (std::size_t i = 1; i < size; ++i)
    groups += fmt::format("  T{0}: {{when: [S{1} == after], causing: [S{0} == after]}}\n", i, i - 1);
  return head + ("states:\n" + rows(size, "  S{}: {{values: [before, after], initial: before}}\n")) + "roots:\n" +
         rows(size, "  T{0}: {{priority: {0}}}\n") + "groups:\n" + first + groups;
}

std::string wide_packs(std::size_t size) {
  std::string out = head + "roots: [A]\ngroups:\n" + rows(size, "  B{}: {{}}\n") + "  A:\n    packs:\n";
  for (std::size_t i = 0; i < size; ++i)
    out += fmt::format("      pack{}: {{", i) + rows(size, "B{0}: {{priority: {0}}}, ") + "}\n";
  return out;
}

std::string many_conditions(std::size_t size) {
  std::string out = head + ("states:\n" + rows(size, "  S{}: {{values: [a, b, c], external: true}}\n")) +
                    "roots: [A]\ngroups:\n  A:\n    providers:\n";
  for (std::size_t provider = 0; provider < 10; ++provider) {
    out += fmt::format("      - {{name: p{}, when: [", provider);
    for (std::size_t i = 0; i < size; ++i) out += fmt::format("S{} == {}, ", i, "abc"[(i + provider) % 3]);
    out += "]}\n";
  }
  return out;
}

std::string one_requests_all(std::size_t size) {
  return head + "roots: [All]\ngroups:\n  All:\n    tasks:\n" + rows(size, "      T{0}: {{priority: {0}}}\n") +
         rows(size, "  T{}: {{}}\n");
}

/// Every second one is requested, and every third one has no place in their order.
std::string many_values(std::size_t size) {
  std::string values, unordered, asked;
  for (std::size_t i = 0; i < size; ++i) {
    values += fmt::format("v{}, ", i);
    if (i % 3 == 0) unordered += fmt::format("v{}, ", i);
    if (i % 2 == 0) asked += fmt::format("{}v{}", i == 0 ? "" : "|", i);
  }
  return head + fmt::format("states:\n  S: {{values: [{}], unordered: [{}], external: true}}\n", values, unordered) +
         "roots: [A]\ngroups:\n  A:\n    providers:\n      - {name: most, when: [S > v1], allow: "
         "[ordering_on_sentinel], because: of them all}\n" +
         fmt::format("      - {{name: some, when: [S == {}]}}\n      - {{name: last}}\n", asked);
}

/// All need one group, and all are equal.
std::string rivals(std::size_t size) {
  return head + "roots: [All]\ngroups:\n  Shared: {}\n  All:\n    tasks:\n" + rows(size, "      T{0}: {{}}\n") +
         rows(size, "  T{}: {{needs: [Shared], tasks: [Shared]}}\n");
}

/// Each group requests all later ones, each at its own priority.
std::string dense(std::size_t size) {
  std::string out = head + "roots: [T0]\ngroups:\n";
  for (std::size_t i = 0; i < size; ++i) {
    out += fmt::format("  T{}: {{tasks: {{", i);
    for (std::size_t j = i + 1; j < size; ++j) out += fmt::format("T{0}: {{priority: {0}}}, ", j);
    out += "}}\n";
  }
  return out;
}

/// The values of each state are words that other readers of YAML take for booleans, and a provider of each group never
/// runs.
std::string warnings(std::size_t size) {
  return head + "states:\n" + rows(size, "  S{}: {{values: [off, on], initial: off, external: true}}\n") +
         "roots: [All]\ngroups:\n  All:\n    tasks:\n" + rows(size, "      T{0}: {{priority: {0}}}\n") +
         rows(size, "  T{}: {{providers: [{{name: first}}, {{name: second}}]}}\n");
}

} // namespace

Files project(std::size_t groups) {
  const std::size_t count = groups / groups_of_robot;
  Files out;
  out["common.yaml"] = common;
  std::string imports, roots;
  for (std::size_t i = 0; i < count; ++i) {
    std::string text = fmt::format(fmt::runtime(robot), i);
    for (const char* servo : servos) text += fmt::format("  {}_{}: {{layer: actuation, realtime: true}}\n", servo, i);
    out[fmt::format("robot_{}.yaml", i)] = std::move(text);
    imports += fmt::format("  - robot_{}.yaml\n", i);
    roots += fmt::format("  Mission_{0}: {{priority: {0}}}\n", i);
  }
  out["main.yaml"] = head + ("imports:\n" + imports) + "roots:\n" + roots;
  return out;
}

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{{"providers that need one group", 1'000, 10'000, needed_by_all},
                                      {"providers of one group", 100, 1'000, providers_of_one},
                                      {"a chain of tasks", 500, 5'000, chain_of_tasks},
                                      {"a chain of needs", 100, 900, chain_of_needs},
                                      {"a chain of causes", 100, 1'000, chain_of_causes},
                                      {"packs, each of as many tasks", 10, 100, wide_packs},
                                      {"conditions of each `when`", 100, 1'000, many_conditions},
                                      {"tasks of one provider", 1'000, 10'000, one_requests_all},
                                      {"groups, each requesting all behind it", 20, 100, dense},
                                      {"values of a state", 500, 5'000, many_values},
                                      {"tasks of equal rank that want one group", 200, 2'000, rivals},
                                      {"warnings, of reading and of checks", 500, 5'000, warnings}};
  return all;
}

} // namespace bench
