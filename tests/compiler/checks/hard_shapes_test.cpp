// SPDX-License-Identifier: MIT
// Many mistakes of one kind: each has its place, and the output does not grow quadratically.
#include "tests/compiler/support/checked.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace {

using namespace director;

/// By id, their number and the number of their places.
std::map<std::string, std::pair<std::size_t, std::size_t>> count(const std::string& text) {
  const tests::CheckedText checked = tests::check_text(text);
  std::map<std::string, std::size_t> found;
  std::map<std::string, std::set<std::uint32_t>> places;
  for (const dsl::Diagnostic& finding : checked.checked.findings) {
    ++found[finding.id];
    places[finding.id].insert(finding.span.begin);
  }
  std::map<std::string, std::pair<std::size_t, std::size_t>> out;
  for (const auto& [id, number] : found) out[id] = {number, places[id].size()};
  return out;
}

std::string names(std::size_t from, std::size_t to) {
  std::string out;
  for (std::size_t i = from; i < to; ++i) out += fmt::format("T{}, ", i);
  return out;
}

/// So many tasks want one group.
std::string rivals(std::size_t size, const std::string& asked_for) {
  std::string out = "roots: [All]\ngroups:\n  Shared: {}\n  All: {" + asked_for + "}\n";
  for (std::size_t i = 0; i < size; ++i) out += fmt::format("  T{}: {{needs: [Shared], tasks: [Shared]}}\n", i);
  return out;
}

using Counts = std::map<std::string, std::pair<std::size_t, std::size_t>>;

TEST_CASE("of a hundred tasks of a list that want one group one finding is reported") {
  CHECK(count(rivals(100, "tasks: [" + names(0, 100) + "]")) == Counts{{"possible_pack_conflict", {1, 1}}});
}

TEST_CASE("of a hundred providers that each shadow another one it is told that some are not counted") {
  std::string text =
      "states: {A: {range: [0, 1], initial: 0, external: true}}\nroots: [G]\ngroups:\n  G:\n    providers:\n";
  for (std::size_t i = 0; i < 100; ++i) text += fmt::format("      - {{name: p{}, when: [A == 0]}}\n", i);
  text += "      - {name: late, when: [A == 0]}\n      - {name: rest}\n";
  const tests::CheckedText checked = tests::check_text(text);
  CHECK(std::any_of(checked.checked.findings.begin(), checked.checked.findings.end(), [](const dsl::Diagnostic& one) {
    return one.message ==
           "`G.late` never runs: `G.p0`, `G.p1`, `G.p2`, `G.p3` and at least 60 more come before it, and "
           "each of them can run whenever it can";
  }));
}

TEST_CASE("of a hundred members of a pack that exclude each other one finding is reported, with each of them") {
  CHECK(count(rivals(100, "packs: {a: [" + names(0, 100) + "], b: []}")) == Counts{{"pack_conflict", {1, 1}}});
  const tests::CheckedText checked = tests::check_text(rivals(25, "packs: {a: [" + names(0, 25) + "], b: []}"));
  const auto at = std::find_if(checked.checked.findings.begin(), checked.checked.findings.end(),
                               [](const dsl::Diagnostic& finding) { return finding.id == "pack_conflict"; });
  REQUIRE(at != checked.checked.findings.end());
  CHECK(at->message == "`T0` can never be granted together with `T1` and 23 others: all come down to `Shared`");
  REQUIRE(at->notes.size() == 26);
  CHECK(at->notes[0].message == "`T0` is requested in the same unit");
  CHECK(at->notes[2].message == "`T1` needs `Shared`");
  CHECK(at->notes[3].message == "nor with `T2`");
  CHECK(at->notes[25].message == "nor with `T24`");
  CHECK(at->help == "request them in packs of their own");
}

/// In a list of 24 every two want one group and have one priority.
std::string couples(const std::string& allow = "") {
  std::string out = "roots: [All]\ngroups:\n  All:\n    tasks:\n";
  for (std::size_t i = 0; i < 24; ++i)
    out += fmt::format("      T{}: {{priority: {}, apart: true{}}}\n", i, i / 2, i == 1 ? allow : "");
  for (std::size_t i = 0; i < 24; ++i) out += fmt::format("  T{}: {{needs: [R{}]}}\n", i, i / 2);
  for (std::size_t i = 0; i < 12; ++i) out += fmt::format("  R{}: {{}}\n", i);
  return out;
}

TEST_CASE("of a long list with many sets of equal rank one finding is reported, with each of the sets") {
  const tests::CheckedText checked = tests::check_text(couples());
  REQUIRE(checked.checked.findings.size() == 1);
  const dsl::Diagnostic& finding = checked.checked.findings.front();
  CHECK(finding.id == "equal_priority");
  CHECK(finding.message ==
        "of the tasks that `All` requests 24 have equal rank with others that may want the same, in "
        "12 sets: whichever takes it first keeps it, and of those that want it at once the one that is declared "
        "first takes it");
  REQUIRE(finding.notes.size() == 12);
  CHECK(finding.notes[0].message == "`T0` and `T1` have priority 0 and may want `R0`");
  CHECK(finding.notes[11].message == "`T22` and `T23` have priority 11 and may want `R11`");
  CHECK(finding.help == "give them priorities that say which goes first");
}

TEST_CASE("of a long list a set that is allowed is reported separately") {
  const tests::CheckedText checked = tests::check_text(couples(", allow: [equal_priority], because: it is meant"));
  REQUIRE(checked.checked.findings.size() == 1);
  CHECK(checked.checked.findings.front().notes.size() == 11);
}

TEST_CASE("of two hundred members whose conditions exclude each other one finding is reported") {
  std::string values, groups;
  for (std::size_t i = 0; i < 200; ++i) {
    values += fmt::format("v{}, ", i);
    groups += fmt::format("  T{0}: {{when: [S == v{0}]}}\n", i);
  }
  CHECK(count("states:\n  S: {values: [" + values +
              "], initial: v0, external: true}\nroots: [All]\ngroups:\n"
              "  All: {packs: {a: [" +
              names(0, 200) + "]}}\n" + groups)["pack_conflict"] == std::pair<std::size_t, std::size_t>{1, 1});
}

TEST_CASE("of sixty members of which every two want a group of their own each but the first is reported, once") {
  std::string groups;
  for (std::size_t i = 0; i < 60; ++i) {
    std::string needs;
    for (std::size_t j = 0; j < 60; ++j) {
      if (j != i) needs += fmt::format("R{}_{}, ", std::min(i, j), std::max(i, j));
      if (j > i) groups += fmt::format("  R{}_{}: {{}}\n", i, j);
    }
    groups += fmt::format("  T{}: {{needs: [{}]}}\n", i, needs);
  }
  CHECK(count("roots: [All]\ngroups:\n  All: {packs: {a: [" + names(0, 60) + "]}}\n" + groups)["pack_conflict"] ==
        std::pair<std::size_t, std::size_t>{59, 59});
}

TEST_CASE("of a chain of two hundred needs the first and the last steps are reported") {
  std::string groups = "  T199: {}\n";
  for (std::size_t i = 0; i < 199; ++i) groups += fmt::format("  T{}: {{needs: [T{}]}}\n", i, i + 1);
  const tests::CheckedText checked =
      tests::check_text("roots: [All]\ngroups:\n  All: {packs: {a: [T0, T199]}}\n" + groups);
  REQUIRE(checked.checked.findings.size() == 1);
  const std::vector<dsl::Note>& notes = checked.checked.findings[0].notes;
  REQUIRE(notes.size() == 14);
  CHECK(notes[6].message == "`T5` needs `T6`");
  CHECK(notes[7].message == "187 more steps lead from `T6` to `T193`");
  CHECK(notes[8].message == "`T193` needs `T194`");
}

/// Without findings about their equal rank: requested together, none of them is granted.
TEST_CASE("of twenty tasks of a list that want one group each is reported with every other, and nothing else") {
  CHECK(count(rivals(20, "tasks: [" + names(0, 20) + "]")) == Counts{{"possible_pack_conflict", {190, 19}}});
}

/// `Talk` leads to `Look`, and so to all that is optional below that; these are no contest between the two. `Legs` is,
/// and farther away than they are.
TEST_CASE("of two tasks with equal rank that have hundreds of groups in common by one of them a farther one is found") {
  std::string look, groups;
  for (std::size_t i = 0; i < 300; ++i) {
    look += fmt::format("N{}: {{optional: true}}, ", i);
    groups += fmt::format("  N{}: {{}}\n", i);
  }
  const tests::CheckedText checked =
      tests::check_text("roots: [Play]\ngroups:\n"
                        "  Play: {packs: {go: {Look: {}, Talk: {}}}}\n"
                        "  Talk: {packs: {a: {Look: {optional: true}, Step: {}}}}\n"
                        "  Step: {tasks: [Walk]}\n"
                        "  Walk: {tasks: [Legs]}\n"
                        "  Look: {packs: {a: {" +
                        look + "Turn: {}}}}\n  Turn: {tasks: [Legs]}\n  Legs: {}\n" + groups);
  const auto found = std::find_if(checked.checked.findings.begin(), checked.checked.findings.end(),
                                  [](const dsl::Diagnostic& finding) { return finding.id == "equal_priority"; });
  REQUIRE(found != checked.checked.findings.end());
  CHECK(found->message == "`Look` and `Talk` have equal rank and may both want `Legs`: whichever takes it first "
                          "keeps it, and if both want it at once `Look` takes it");
}

TEST_CASE("of forty groups, each needing all behind it, none is left out") {
  std::string text = "roots: [T0]\ngroups:\n";
  for (std::size_t i = 0; i < 40; ++i) text += fmt::format("  T{}: {{needs: [{}]}}\n", i, names(i + 1, 40));
  CHECK(count(text) == Counts{{"needs_conflict", {38, 38}}});
}

TEST_CASE("of three thousand unknown names each is reported, and the first ones with a suggestion") {
  std::string text = "roots: [T0]\ngroups:\n";
  for (std::size_t i = 0; i < 3'000; ++i) text += fmt::format("  T{0}: {{needs: [t{0}]}}\n", i);
  const tests::CheckedText checked = tests::check_text(text);
  REQUIRE(checked.checked.findings.size() == 3'000);
  CHECK(checked.checked.findings.front().help == "did you mean `T0`?");
  CHECK(checked.checked.findings.back().help == "declare it under `groups`, or import a file that does");
}

TEST_CASE("more conditions of one provider than fit into a message are all checked") {
  std::string text = "states:\n", when;
  for (std::size_t i = 0; i < 3'000; ++i) {
    text += fmt::format("  S{}: {{values: [low, high], initial: low, external: true}}\n", i);
    when += fmt::format("S{} == high, ", i);
  }
  CHECK(count(text + "roots: [T]\ngroups: {T: {when: [" + when + "]}}\n") == Counts{{"uncovered_state", {1, 1}}});
}

TEST_CASE("of two hundred providers that together leave nothing open the next one names a few") {
  std::string text = "states:\n  A: {range: [0, 199], initial: 0, external: true}\n"
                     "  B: {range: [0, 199], initial: 0, external: true}\nroots: [T]\ngroups:\n  T:\n    providers:\n";
  for (std::size_t i = 0; i < 200; ++i) text += fmt::format("      - {{name: p{0}, when: [A == {0}]}}\n", i);
  text += "      - {name: rest, when: [B > 10]}\n";
  const tests::CheckedText checked = tests::check_text(text);
  REQUIRE(checked.checked.findings.size() == 1);
  CHECK(checked.checked.findings[0].message == "`T.rest` never runs: `T.p0`, `T.p1`, `T.p2`, `T.p3` and 196 more come "
                                               "before it, and one of them can run whenever it can");
  CHECK(checked.checked.findings[0].notes.size() == 8);
}

/// Twenty groups of 255 providers with random conditions each, as hard as such ones are.
std::string random_conditions() {
  std::mt19937 random(1);
  const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
  std::string text = "states:\n", roots = "roots: [", groups = "groups:\n";
  for (std::size_t i = 0; i < 60; ++i)
    text += fmt::format("  S{}: {{values: [a, b, c, d], initial: a, external: true}}\n", i);
  for (std::size_t g = 0; g < 20; ++g) {
    roots += fmt::format("G{}, ", g);
    groups += fmt::format("  G{}:\n    providers:\n", g);
    for (std::size_t p = 0; p < 255; ++p) {
      std::string when;
      for (std::uint32_t k = 0; k < 4; ++k) when += fmt::format("S{} != {}, ", 15 * k + below(15), "abcd"[below(4)]);
      groups += fmt::format("      - {{name: p{}, when: [{}]}}\n", p, when);
    }
  }
  return text + roots + "]\n" + groups;
}

TEST_CASE("twenty groups of hundreds of providers with random conditions are checked within the budget of a run") {
  if (tests::is_sanitized) return; // it is all used up
  const std::string text = random_conditions();
  const tests::CheckedText checked = tests::check_text(text);
#ifdef NDEBUG
  CHECK(checked.checked.findings == tests::check_text(text).checked.findings);
#endif
  const auto open = std::count_if(checked.checked.findings.begin(), checked.checked.findings.end(),
                                  [](const dsl::Diagnostic& finding) { return finding.id == "not_decided"; });
  CHECK(open == 1);
  CHECK(dsl::render(checked.checked.findings, checked.sources).size() < 100'000);
}

/// One for each way in which notes may grow: a note for each condition, each member, each requester, each loser.
TEST_CASE("no finding has more notes or words than one reads, however many parties it has") {
  std::string many, members, conditions, losers, circle, asking;
  for (std::size_t i = 0; i < 400; ++i) {
    many += fmt::format("  T{0}: {{when: [S != v{1}], tasks: [Arm]}}\n", i, i % 3 + 1);
    members += fmt::format("T{}: {{optional: true}}, ", i);
    conditions += fmt::format("      - {{name: p{}, when: [S == v{}, R == v{}]}}\n", i % 200, i % 3 + 1, i % 2);
    if (i == 199) conditions += "  More:\n    providers:\n";
    losers += fmt::format("L{}, ", i);
    asking += fmt::format("  L{}: {{tasks: [Arm]}}\n", i);
    circle += fmt::format("  C{}: {{tasks: [C{}]}}\n", i, (i + 1) % 400);
  }
  const tests::CheckedText checked = tests::check_text(
      "states:\n  S: {values: [v0, v1, v2, v3], initial: v0, external: true}\n"
      "  R: {values: [v0, v1], initial: v0, external: true}\n"
      "roots: {Most: {priority: 1}, More: {priority: 2}, Keep: {priority: 3}, C0: {priority: 4}, All: {priority: 5}}\n"
      "groups:\n  Arm: {}\n  All: {packs: {go: {" +
      members + "}}}\n" + many + "  Most:\n    providers:\n" + conditions + "  Keep: {needs: [Arm], tasks: [" + losers +
      "]}\n" + asking + circle);
  REQUIRE_FALSE(checked.checked.findings.empty());
  for (const dsl::Diagnostic& finding : checked.checked.findings) {
    INFO(finding.id << ": " << finding.message);
    CHECK(finding.notes.size() <= 40);
    CHECK(finding.message.size() < 1'000);
  }
}

/// Keeping all groups below each group of a chain took 3 GB for this one.
TEST_CASE("of a chain of five thousand groups that each request the next one and a leaf nothing is in common") {
  constexpr std::size_t size = 5'000;
  std::string text = "roots: [T0]\ngroups:\n";
  for (std::size_t i = 0; i + 1 < size; ++i)
    text += fmt::format("  T{0}: {{tasks: [T{1}, L{0}]}}\n  L{0}: {{}}\n", i, i + 1);
  CHECK(count(text + "  T4999: {}\n") == Counts{{"unbounded_choice", {1, 1}}});
}

/// Only the two entries in which the chain ends have something in common.
TEST_CASE("of a chain of three thousand groups the two entries at its end that want one group are reported") {
  constexpr std::size_t size = 3'000;
  std::string text = "roots: [T0]\ngroups:\n";
  for (std::size_t i = 0; i + 1 < size; ++i)
    text += fmt::format("  T{0}: {{tasks: [T{1}, L{0}]}}\n  L{0}: {{}}\n", i, i + 1);
  text += "  T2999: {tasks: [Walk, Kick]}\n  Walk: {tasks: [Legs]}\n  Kick: {tasks: [Legs]}\n  Legs: {}\n";
  CHECK(count(text) == Counts{{"equal_priority", {1, 1}}, {"unbounded_choice", {1, 1}}});
}

/// The path down begins again at the group, and there with the requests of its other provider.
TEST_CASE("for a group that leads to itself no place is reported that the provider in question does not have") {
  CHECK(count(R"(
states: {Pose: {values: [standing]}}
roots: {Play: {}}
groups:
  Play: {needs: [Walk, Look], tasks: {Walk: {}, Look: {apart: true}}}
  Walk: {packs: {full: {Legs: {}, Help: {optional: true}}, none: {}}}
  Help:
    providers:
      - {name: alone, needs: [Legs], tasks: {Arm: {}, Legs: {}, Walk: {}, Look: {}}}
      - {name: together, tasks: {Turn: {}}}
  Turn: {causing: [Pose == standing], packs: {whole: {Arm: {priority: 10}, Play: {priority: 0}, Lean: {}}}}
  Lean: {needs: [Legs]}
  Look: {}
  Arm: {}
  Legs: {}
)")["self_conflict"] == std::pair<std::size_t, std::size_t>{2, 2});
}

/// So many tasks wait for one promise, which as many providers make, and all of them need one group.
std::string pushing(std::size_t waiting, std::size_t causing) {
  std::string roots, groups;
  for (std::size_t i = 0; i < waiting; ++i) {
    roots += fmt::format("  K{}: {{priority: {}}}\n", i, causing + i);
    groups += fmt::format("  K{}: {{when: [S == b], needs: [L], tasks: [L]}}\n", i);
  }
  for (std::size_t i = 0; i < causing; ++i) {
    roots += fmt::format("  W{}: {{priority: {}}}\n", i, i);
    groups += fmt::format("  W{}:\n    providers:\n      - {{name: p, needs: [L], tasks: [L], sets: [S == a]}}\n"
                          "      - {{name: q, needs: [L], tasks: [L], causing: [S == b]}}\n",
                          i);
  }
  return "states: {S: {values: [a, b], initial: a}}\nroots:\n" + roots + "groups:\n  L: {}\n" + groups;
}

TEST_CASE("of a hundred tasks that push a provider before one that holds what it needs one finding is reported") {
  const tests::CheckedText checked = tests::check_text(pushing(100, 2));
  std::vector<const dsl::Diagnostic*> found;
  for (const dsl::Diagnostic& finding : checked.checked.findings) {
    if (finding.id == "push_inversion") found.push_back(&finding);
  }
  REQUIRE(found.size() == 1); // nothing is between the tasks and `W1`
  CHECK(std::count_if(found.front()->notes.begin(), found.front()->notes.end(), [](const dsl::Note& note) {
          return note.message.find("and pushes it too, and ") != std::string::npos;
        }) == 8);
  CHECK(std::count_if(found.front()->notes.begin(), found.front()->notes.end(),
                      [](const dsl::Note& note) { return note.message == "further tasks push `W0.q` too"; }) == 1);
}

TEST_CASE("of as many waiting tasks as promises the findings grow only with the promises") {
  CHECK(count(pushing(150, 150)).at("push_inversion") == std::pair<std::size_t, std::size_t>{149, 149});
}

TEST_CASE("of more pairs of tasks that may end each other in turn than are looked at, the rest is left open") {
  std::string text = "states:\n  Base: {values: [rolling, still], initial: rolling}\n"
                     "  Arm: {values: [out, folded], initial: out}\n"
                     "  Mode: {values: [pick, drive], initial: pick, external: true}\n"
                     "roots: {Wheels: {priority: 2}, Joints: {priority: 1}";
  std::string groups = "groups:\n  Wheels: {providers: [{name: go}, {name: brake, causing: [Base == still]}]}\n"
                       "  Joints: {providers: [{name: go}, {name: fold, causing: [Arm == folded]}]}\n";
  for (std::size_t i = 0; i < 101; ++i) {
    text += fmt::format(", Pick{0}: {{priority: {1}}}, Drive{0}: {{priority: {2}}}", i, 10 + i, 200 + i);
    groups += fmt::format("  Pick{0}: {{when: [Base == still, Mode == pick], sets: [Arm == out]}}\n"
                          "  Drive{0}: {{when: [Arm == folded, Mode == drive], sets: [Base == rolling]}}\n",
                          i);
  }
  const tests::CheckedText checked = tests::check_text(text + "}\n" + groups);
  std::vector<std::string> open;
  for (const dsl::Diagnostic& finding : checked.checked.findings)
    if (finding.id == "not_decided") open.push_back(finding.message);
  CHECK(open == std::vector<std::string>{"whether two tasks end each other in turn, from `Drive80` and `Pick90` on was "
                                         "not decided"});
}

TEST_CASE("of a provider that promises five hundred states, and tasks that wait for them, the rest is left open") {
  std::string states = "states:\n", roots = "roots: {Base: {priority: -1}", groups = "groups:\n", promises;
  for (std::size_t i = 0; i < 500; ++i) {
    states += fmt::format("  S{}: {{values: [a, b], initial: a}}\n", i);
    roots += fmt::format(", T{}: {{priority: {}}}", i, i);
    groups += fmt::format("  T{0}: {{when: [S{0} == b]}}\n", i);
    promises += fmt::format("{}S{} == b", i == 0 ? "" : ", ", i);
  }
  groups += "  Base: {providers: [{name: go}, {name: all, causing: [" + promises + "]}]}\n";
  const tests::CheckedText checked = tests::check_text(states + roots + "}\n" + groups);
  std::vector<std::string> open;
  for (const dsl::Diagnostic& finding : checked.checked.findings)
    if (finding.id == "not_decided") open.push_back(finding.message);
  CHECK(open == std::vector<std::string>{"whether two tasks end each other in turn, from `T400` on was not decided"});
}

TEST_CASE("a task that eight hundred others request, and that requests each of them, is one cycle") {
  std::string text = "roots: [Hub]\ngroups:\n  Hub: {tasks: [" + names(0, 800) + "]}\n";
  for (std::size_t i = 0; i < 800; ++i) text += fmt::format("  T{}: {{tasks: [Hub]}}\n", i);
  CHECK(count(text) == Counts{{"task_cycle", {1, 1}}});
}

TEST_CASE("a staircase of one number has no finding, however many steps it has") {
  std::string text = "states: {S: {range: [0, 1000000], initial: 0, external: true}}\nroots: [G]\ngroups:\n  G:\n"
                     "    providers:\n";
  for (int i = 0; i < 2'000; ++i) text += fmt::format("      - {{name: p{}, when: [S > {}]}}\n", i, (2'000 - i) * 10);
  CHECK(count(text + "      - {name: last}\n").empty());
}

TEST_CASE(
    "of a task that conditions exclude for its requester, no other finding reports that something takes its group") {
  const auto findings = [](const std::string& play) {
    const tests::CheckedText checked =
        tests::check_text("states: {Ball: {values: [far, near], initial: far, external: true}}\nroots: {Turn: "
                          "{priority: 3}, Shoot: {priority: 2}, Play: {priority: 1}}\ngroups:\n  Play: {" +
                          play +
                          "}\n  Aim: {packs: {go: {Kick: {}, Turn: {}}}}\n  Kick: {when: [Ball == near]}\n"
                          "  Turn: {when: [Ball == far]}\n  Shoot: {tasks: [Kick]}\n");
    std::set<std::string> out;
    for (const dsl::Diagnostic& finding : checked.checked.findings) out.insert(finding.id + ": " + finding.message);
    return out;
  };
  std::set<std::string> expected{
      "pack_conflict: `Kick` and `Turn` can never be granted together: what they accept of `Ball` excludes each other",
      "uncovered_state: `Kick` never runs for `Aim`, which requests it only where it cannot",
      "uncovered_state: `Turn` never runs for `Aim`, which requests it only where it cannot",
      "uncovered_state: no provider of `Kick` can run while `Ball` is far",
      "uncovered_state: no provider of `Turn` can run while `Ball` is near"};
  CHECK(findings("packs: {go: {Aim: {priority: 20}, Kick: {}}}") == expected);
  expected.erase("uncovered_state: no provider of `Kick` can run while `Ball` is far");
  expected.insert("uncovered_state: no provider of `Play` or `Kick` can run while `Ball` is far");
  CHECK(findings("needs: [Kick], tasks: [Aim]") == expected);
}

} // namespace
