// SPDX-License-Identifier: MIT
#include "compiler/checks/check.hpp"
#include "tests/compiler/checks/page.hpp"
#include "tests/compiler/support/checked.hpp"

#include <catch2/catch.hpp>

#include <set>
#include <utility>

namespace {

using namespace director;

struct RuledOut {
  std::set<std::string> ids; ///< of findings that rule something out
  std::string of_one;        ///< those of one id, as written; what never happens together in brackets
};

RuledOut ruled_out(const std::string& id, const tests::CheckedText& checked) {
  RuledOut out;
  const auto add = [&](const std::vector<dsl::Span>& spans, const std::string& begin, const std::string& end) {
    for (const dsl::Span& span : spans) {
      const std::string_view all = checked.sources[span.file].text();
      out.of_one +=
          (out.of_one.empty() ? "" : " ") + begin + std::string(all.substr(span.begin, span.end - span.begin)) + end;
    }
  };
  for (const dsl::Diagnostic& finding : checked.checked.findings) {
    if (!finding.rules_out.empty() || !finding.rules_out_together.empty()) out.ids.insert(finding.id);
    if (finding.id != id) continue;
    add(finding.rules_out, "", "");
    add(finding.rules_out_together, "[", "]");
  }
  return out;
}

compiler::CheckOptions with_every_lint() {
  compiler::CheckOptions options;
  options.selection.every_lint = true;
  return options;
}

std::string ruled_out(const std::string& id, const std::string& text) {
  return ruled_out(id, tests::check_text(text, with_every_lint())).of_one;
}

/// What the findings of the specimens on a check's page rule out.
RuledOut ruled_out(const std::string& id, const tests::Specimen& specimen) {
  dsl::MemoryFiles files;
  for (const auto& [path, text] : specimen.files) files.add(path, text);
  tests::CheckedText checked;
  checked.checked = compiler::check(std::string(tests::main_file), files, checked.sources, with_every_lint());
  return ruled_out(id, checked);
}

const std::string state = "states: {S: {values: [a, b, c], initial: a}}\n";
struct Row {
  std::string id, text, out;
};
const std::vector<Row> rows{
    {"contradictory_when", state + "roots: [A]\ngroups: {A: {when: [S == a, S == b]}}\n", "S == b S == a"},
    {"unreachable_when", state + "roots: [A]\ngroups: {A: {when: [S == b]}}\n", "S == b"},
    {"state_without_source",
     "states: {S: {values: [a, b]}}\nroots: [A, B]\ngroups: {A: {when: [S == a]}, B: {when: [S == b]}}\n",
     "S == a S == b"},
    {"shadowed_provider", "roots: [A]\ngroups: {A: {providers: [{name: x}, {name: y}]}}\n", "y"},
    {"unused_declaration", "roots: [A]\ngroups: {A: {}, B: {}}\n", "B"},
    {"task_cycle", "roots: [A]\ngroups: {A: {packs: {p: {B: {}}}}, B: {packs: {p: {A: {}}}}}\n", "A B"},
    {"pack_conflict",
     "roots: [A]\ngroups: {A: {packs: {p: {B: {}, C: {}}}}, B: {needs: [D]}, "
     "C: {needs: [D]}, D: {}}\n",
     "[B] [C]"},
    {"self_conflict",
     "roots: [P]\ngroups: {P: {needs: [W], packs: {go: {L: {}}}}, "
     "W: {needs: [L], tasks: [L]}, L: {}}\n",
     "L"},
    {"unreachable_causing", state + "roots: [A]\ngroups: {A: {when: [S == b]}, B: {causing: [S == b]}}\n",
     "S == b S == b"},
    {"uncovered_state",
     "states: {S: {values: [a, b], initial: a, external: true}}\nroots: [A]\n"
     "groups: {A: {when: [S == a], needs: [B], tasks: [B]}, B: {when: [S == b]}}\n",
     "A"},
};
/// What the first specimen of its page rules out.
const std::vector<std::pair<std::string, std::string>> rows_of_pages{
    {"causer_goes_first", "Stability == standing"},
    {"causer_not_running", "Stability == standing"},
    {"imprecise_causing", "Stability > moving Stability == standing"},
    {"incompatible_pushes", "Arm == stretched Head == high"},
    {"needs_conflict", "Stand"},
    {"needs_cycle", "Balance Legs"},
    {"optional_never_runs", "Dance"},
    {"possible_pack_conflict", "both_arms"},
    {"push_cycle", "Lamp == lit Battery == full"},
    {"push_in_vain", "A == 1 B == 1 A == 1 B == 1"},
    {"self_defeating_handler", "Gripper == open"},
    {"sibling_starvation", "Kick"},
    {"starved_task", "Balance"},
    {"undone_by_fallback", "Base == still"},
    {"undone_by_stop", "Stability == standing"},
    {"unpushable_causing", "Stability == standing Stability == standing"},
};

TEST_CASE("each finding rules out what it reports: nothing else reports that again") {
  for (const Row& row : rows) {
    INFO(row.id);
    CHECK(ruled_out(row.id, row.text) == row.out);
  }
  for (const auto& [id, out] : rows_of_pages) {
    INFO(id);
    const checks::Registered* check = checks::find_registered(id);
    REQUIRE(check != nullptr);
    CHECK(ruled_out(id, tests::read_page(check->page).reported.front()).of_one == out);
  }
}

TEST_CASE("of no other check a finding rules anything out, on any page") {
  std::set<std::string> listed, found;
  for (const Row& row : rows) listed.insert(row.id);
  for (const auto& [id, out] : rows_of_pages) listed.insert(id);
  for (const checks::Registered& check : checks::registered()) {
    const tests::Page page = tests::read_page(check.page);
    for (const auto* specimens : {&page.reported, &page.accepted}) {
      for (const tests::Specimen& specimen : *specimens) {
        if (!specimen.has_code) found.merge(ruled_out("", specimen).ids);
      }
    }
  }
  CHECK(found == listed);
}

TEST_CASE("a finding that does not report that something never happens rules nothing out") {
  CHECK(ruled_out("unused_need", "roots: [A]\ngroups: {A: {needs: [B]}, B: {}}\n").empty());
  CHECK(ruled_out("uncovered_state", "states: {S: {values: [a, b], external: true}}\nroots: [A]\n"
                                     "groups: {A: {when: [S == a]}}\n")
            .empty());
}

/// H alone makes S what G waits for, G takes what H needs, and without H its value of S is lost.
TEST_CASE("a group that is granted and never runs is reported, unless another finding says why") {
  const auto findings = [](const std::string& root, const std::string& group) {
    return tests::check_text("states: {S: {values: [a, b], initial: b, of: H}}\nroots: {" + root +
                             R"(: {priority: 2}, H: {priority: 1}}
groups:
  G: {when: [S == a], needs: [R]}
  H: {needs: [R], sets: [S == a]}
  R: {}
)" + group + "allow: [waiting_company]\nbecause: they belong together\n")
        .findings();
  };
  const std::string never = " never runs: wherever it is granted, a state that returns to its initial value takes that "
                            "away before it runs [shadowed_provider]\n";
  const std::string uncovered = "main.yaml:6: no provider of `G` can run while `S` is b [uncovered_state]\n";
  CHECK(findings("P", "  P: {packs: {both: {G: {}, Z: {}}}}\n  Z: {}\n") ==
        "main.yaml:6: `G`" + never + uncovered + "main.yaml:10: `Z`" + never);
  CHECK(findings("G", "") == "main.yaml:3: `S` is b again when `H` stops, and it is stopped when `G` is granted, which "
                             "waits for `S == a`: the two go round [undone_by_stop]\n" +
                                 uncovered);
}

/// G.one takes what P needs; so K ends, and with it the value of S that K sets.
TEST_CASE("what takes control away from a provider before each run is named") {
  const auto findings = [](const std::string& of, const std::string& handler) {
    return tests::check_text("states: {S: {values: [a, b], initial: b" + of + R"(}, T: {values: [p, q], external: true}}
roots: {G: {priority: 2}, P: {priority: 1}}
groups:
  G:
    providers:
      - {name: one, when: [S == a], needs: [R], tasks: [R]}
      - {name: two, when: [T == q]}
  P: {needs: [R], tasks: [K, R]}
  R: {}
  K: {)" + handler + R"(sets: [S == a]}
allow: [uncovered_state]
because: it waits for both
)")
        .findings();
  };
  const std::string begin = "main.yaml:8: `G.one` never runs: wherever it is granted, ";
  const std::string end = " takes that away before it runs [shadowed_provider]\n";
  CHECK(findings(", of: K", "") == begin + "a state that returns to its initial value" + end);
  CHECK(findings(", of: K", "stop: {sets: [S == b]}, ") ==
        begin + "what a handler sets or a state that returns to its initial value" + end);
}

} // namespace

/// C never runs beside W, so nothing but D.p0 is ever tried for D.
TEST_CASE("a provider that only a pack with a conflict would need is not reported: the conflict is") {
  const auto findings = [](const std::string& company) {
    return tests::check_text("roots: {P: {}, D: {priority: 1}}\ngroups:\n  P: {packs: {k: {" + company + R"(C: {}}}}
  W: {needs: [M], tasks: [M]}
  C: {needs: [L, M], packs: {k: {L: {}, M: {}, D: {}}}}
  D: {providers: [{name: p0, needs: [L, M], tasks: [L, M]}, {name: p2}]}
  L: {}
  M: {}
)")
        .findings();
  };
  const std::string need = "main.yaml:7: `C` needs `L` and not `D`, which it requests too: it can start and then be "
                           "refused [undeclared_need]\n";
  CHECK(findings("W: {}, ") ==
        "main.yaml:5: `W` and `C` can never be granted together: both come down to `M` [pack_conflict]\n" + need);
  CHECK(findings("") == need);
}
