// SPDX-License-Identifier: MIT
#include "tests/compiler/support/checked.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;

/// What findings with this id rule out, as it is written; what never happens together stands in brackets.
std::string ruled_out(const std::string& id, const std::string& text) {
  compiler::CheckOptions options;
  options.selection.every_lint = true;
  const tests::CheckedText checked = tests::check_text(text, options);
  std::string out;
  const auto add = [&](const std::vector<dsl::Span>& spans, const std::string& begin, const std::string& end) {
    for (const dsl::Span& span : spans) {
      const std::string_view all = checked.sources[span.file].text();
      out += (out.empty() ? "" : " ") + begin + std::string(all.substr(span.begin, span.end - span.begin)) + end;
    }
  };
  for (const dsl::Diagnostic& finding : checked.checked.findings) {
    if (finding.id != id) continue;
    add(finding.rules_out, "", "");
    add(finding.rules_out_together, "[", "]");
  }
  return out;
}

TEST_CASE("each finding says what it rules out: nothing else needs to be told of that") {
  const std::string state = "states: {S: {values: [a, b, c], initial: a}}\n";
  CHECK(ruled_out("contradictory_when", state + "roots: [A]\ngroups: {A: {when: [S == a, S == b]}}\n") ==
        "S == b S == a");
  CHECK(ruled_out("unreachable_when", state + "roots: [A]\ngroups: {A: {when: [S == b]}}\n") == "S == b");
  CHECK(
      ruled_out("state_without_source",
                "states: {S: {values: [a, b]}}\nroots: [A, B]\ngroups: {A: {when: [S == a]}, B: {when: [S == b]}}\n") ==
      "S == a S == b");
  CHECK(ruled_out("shadowed_provider", "roots: [A]\ngroups: {A: {providers: [{name: x}, {name: y}]}}\n") == "y");
  CHECK(ruled_out("unused_declaration", "roots: [A]\ngroups: {A: {}, B: {}}\n") == "B");
  CHECK(ruled_out("task_cycle", "roots: [A]\ngroups: {A: {packs: {p: {B: {}}}}, B: {packs: {p: {A: {}}}}}\n") == "A B");
  CHECK(ruled_out("pack_conflict", "roots: [A]\ngroups: {A: {packs: {p: {B: {}, C: {}}}}, B: {needs: [D]}, "
                                   "C: {needs: [D]}, D: {}}\n") == "[B] [C]");
  CHECK(ruled_out("self_conflict", "roots: [P]\ngroups: {P: {needs: [W], packs: {go: {L: {}}}}, "
                                   "W: {needs: [L], tasks: [L]}, L: {}}\n") == "L");
  CHECK(ruled_out("unreachable_causing",
                  state + "roots: [A]\ngroups: {A: {when: [S == b]}, B: {causing: [S == b]}}\n") == "S == b S == b");
}

TEST_CASE("a finding that says of nothing that it never happens rules nothing out") {
  CHECK(ruled_out("unused_need", "roots: [A]\ngroups: {A: {needs: [B]}, B: {}}\n").empty());
  CHECK(ruled_out("uncovered_state", "states: {S: {values: [a, b], external: true}}\nroots: [A]\n"
                                     "groups: {A: {when: [S == a]}}\n")
            .empty());
}

/// H alone makes S what G waits for, G takes what H needs, and with H goes what it set.
TEST_CASE("a group that is granted and never runs is told of") {
  const tests::CheckedText checked = tests::check_text(R"(states: {S: {values: [a, b], initial: b, of: H}}
roots: {G: {priority: 2}, H: {priority: 1}}
groups:
  G: {when: [S == a], needs: [R]}
  H: {needs: [R], sets: [S == a]}
  R: {}
)");
  CHECK(checked.findings() ==
        "main.yaml:6: `G` never runs: wherever it is granted, what a handler sets takes that away before it runs "
        "[shadowed_provider]\n"
        "main.yaml:6: no provider of `G` can run while `S` is b [uncovered_state]\n");
}

} // namespace
