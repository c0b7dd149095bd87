// SPDX-License-Identifier: MIT
#include "compiler/model/print_model.hpp"
#include "tests/compiler/support/checked.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

namespace {

using namespace director;
using tests::beginning;
using tests::check_files;
using tests::check_text;

/// The lines of the printed model with this beginning.
std::string lines_with(const compiler::Model& model, const std::string& begin) {
  const std::string text = print_model(model);
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    if (text.compare(at, begin.size(), begin) == 0) out += text.substr(at, end - at + 1);
    at = end + 1;
  }
  return out;
}

TEST_CASE("edges are ordered by requester, in the order in which its providers first name them, needs last") {
  const auto text = check_text(R"(
roots: {B: {}, A: {}}
groups:
  A:
    providers:
      - {name: second, needs: [D, C], tasks: {C: {priority: 3}}}
  B:
    needs: [A]
    packs: {one: {D: {}, C: {}}, two: {E: {}, D: {priority: 1}}}
  C: {}
  D: {}
  E: {}
extend:
  A: {before: second, providers: [{name: first, tasks: [E, D]}]}
)");
  CHECK(lines_with(text.checked.model, "edge") == "edge root>B: 0\nedge root>A: 0\n"
                                                  "edge A>E: 0\nedge A>D: 0, needed\nedge A>C: 3, needed\n"
                                                  "edge B>D: 0, 1\nedge B>C: 0\nedge B>E: 0\n"
                                                  "edge B>A: never requested, needed\n");
}

TEST_CASE("equal levels of an edge are one, in order of first appearance") {
  const auto text = check_text(R"(
roots: {A: {priority: {calm: 1, brisk: 2}}}
groups:
  A:
    providers:
      - {name: one, tasks: {B: {priority: {soft: 5, hard: 9}}}}
      - name: two
        packs: {p: {B: {priority: 9}}, q: {B: {priority: 5, optional: true}}, r: {B: {priority: 5, apart: true}}}
  B: {}
)");
  CHECK(lines_with(text.checked.model, "edge") == "edge root>A: 1, 2\nedge A>B: 5, 9, 5 optional, 5 apart\n");
  const compiler::Provider& two = text.checked.model.providers[compiler::ProviderId{1}];
  CHECK(two.packs[0].tasks[0].levels[0].level == 1);
  CHECK(two.packs[2].tasks[0].levels[0].level == 3);
}

TEST_CASE("what is imported is declared before what imports it, and its roots do not count") {
  const auto text =
      check_files({{"main.yaml", beginning("robot") + "imports: [b.yaml, a.yaml]\nroots: [Main]\ngroups: {Main: {}}\n"},
                   {"a.yaml", beginning("a") + "imports: [b.yaml]\nroots: [A]\ngroups: {A: {}}\n"},
                   {"b.yaml", beginning("b") + "groups: {B: {}}\n"}});
  CHECK(text.findings().empty());
  CHECK(lines_with(text.checked.model, "group") ==
        "group B: module b_module\ngroup A: module a_module\ngroup Main: module main_module\n" + std::string());
  CHECK(lines_with(text.checked.model, "edge") == "edge root>Main: 0\n");
  CHECK(text.checked.model.name == "robot");
}

TEST_CASE("extensions take their place in the order of preference, one after the other") {
  const auto text = check_files({{"main.yaml", beginning("robot") + R"(
imports: [a.yaml]
roots: [Walk]
extend:
  Walk: {before: slow, providers: [{name: careful}, {name: brisk}]}
)"},
                                 {"a.yaml", beginning("a") + R"(
groups:
  Walk: {providers: [{name: fast}, {name: slow}]}
extend:
  Walk: {providers: [{name: last}]}
)"}});
  std::string names;
  for (const compiler::Provider& provider : text.checked.model.providers) names += provider.name + " ";
  CHECK(names == "fast careful brisk slow last ");
  CHECK(text.checked.model.modules.size() == 1);
}

TEST_CASE("words beside the providers come before their own, each once, for extensions too") {
  const auto text = check_text(R"(
states: {Pose: {values: [a, b], initial: a}}
triggers: [Tick, Tock]
roots: [Walk]
groups:
  Walk:
    sets: [Pose == a]
    uses: [Legs]
    triggers: [Tick]
    providers: [{name: one, sets: [Pose, Pose == a], uses: [Head, Legs], triggers: [Tock, Tick], tasks: [Legs, Head]}]
  Legs: {}
  Head: {}
extend:
  Walk: {providers: [{name: two, tasks: [Legs]}]}
)");
  CHECK(lines_with(text.checked.model, "    sets") == "    sets Pose == a, Pose\n    sets Pose == a\n");
  CHECK(lines_with(text.checked.model, "    uses") == "    uses Legs, Head\n    uses Legs\n");
  CHECK(lines_with(text.checked.model, "    trigger") == "    trigger Tick\n    trigger Tock\n    trigger Tick\n");
}

TEST_CASE("the same condition is one row, wherever it is written") {
  const auto text = check_text(R"(
states: {Pose: {values: [a, b, c], initial: a, external: true}}
roots: {A: {priority: 1}, B: {priority: 2}, C: {priority: 3}}
groups:
  A: {when: [Pose==a|b, "Pose  !=  c"]}
  B: {when: [Pose == a|b]}
  C: {when: [Pose == b|a]}
allow: [uncovered_state]
because: they wait for the rest
)");
  CHECK(text.findings().empty());
  CHECK(text.checked.model.conditions.size() == 3);
  CHECK(text.checked.model.conditions[compiler::ConditionId{0}].text == "Pose == a|b");
  CHECK(text.checked.model.conditions[compiler::ConditionId{2}].text == "Pose == b|a");
}

TEST_CASE("the main file's layers come first") {
  const auto text =
      check_files({{"main.yaml", beginning("robot") + "imports: [a.yaml]\nlayers: [top, low]\nroots: [A]\n"},
                   {"a.yaml", beginning("a") + "layers: [low, middle]\ngroups: {A: {layer: middle}}\n"}});
  CHECK(lines_with(text.checked.model, "layer") == "layer top\nlayer low\nlayer middle\n");
}

TEST_CASE("an imported assertion counts where all of its groups can be requested") {
  const std::string module = beginning("a") + R"(
groups:
  A: {tasks: [B]}
  B: {}
  C: {tasks: [B]}
assertions:
  - can_run: B
  - never_together: [B, C]
)";
  const auto text =
      check_files({{"main.yaml", beginning("robot") + "imports: [a.yaml]\nroots: [A]\n"}, {"a.yaml", module}});
  CHECK(lines_with(text.checked.model, "assert") == "assert can run B\n");
}

TEST_CASE("a task has at most 255 named levels, those of all its requesters together") {
  const auto levels = [](int first, int last) {
    std::string out;
    for (int i = first; i <= last; ++i)
      out += (out.empty() ? "" : ", ") + std::string("l") + std::to_string(i) + ": " + std::to_string(i);
    return "{priority: {" + out + "}}";
  };
  const auto findings = [&](int last) {
    return check_text("roots: {T: " + levels(0, 200) +
                      ", A: {priority: -1}}\ngroups:\n  A:\n    tasks:\n      T: " + levels(100, last) + "\n  T: {}\n")
        .findings();
  };
  CHECK(findings(254).empty());
  CHECK(findings(255) == "main.yaml:7: `T` has more than 255 named levels [input_limit]\n");
}

TEST_CASE("headers of all files are included, the namespace is the main file's") {
  const auto text = check_files(
      {{"main.yaml", beginning("robot") + "imports: [a.yaml]\ncpp: {headers: [m.hpp, a.hpp]}\nroots: [A]\n"},
       {"a.yaml", beginning("a") + "cpp: {namespace: other, headers: [a.hpp]}\ngroups: {A: {}}\n"}});
  CHECK(text.checked.model.headers == std::vector<std::string>{"a.hpp", "m.hpp"});
  CHECK(text.checked.model.name_space == "robot");
}

} // namespace
