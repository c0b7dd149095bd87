// SPDX-License-Identifier: MIT
#include "tests/compiler/support/checked.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using tests::check_text;

const std::string kick_and_walk = "roots: {Kick: {priority: 10}, Walk: {priority: 10}}\n"
                                  "groups:\n  Kick: {needs: [Legs]}\n  Walk: {needs: [Legs]}\n  Legs: {}\n";

compiler::CheckOptions asked(checks::Selection selection) { return {std::move(selection)}; }

TEST_CASE("a warning is no error unless that is requested") {
  checks::Selection selection;
  CHECK(check_text(kick_and_walk).checked.findings.at(0).level == dsl::Level::warning);
  selection.warnings_as_errors = {"shadowed_provider"};
  CHECK(check_text(kick_and_walk, asked(selection)).checked.findings.at(0).level == dsl::Level::warning);
  selection.warnings_as_errors = {"equal_priority"};
  CHECK(check_text(kick_and_walk, asked(selection)).checked.findings.at(0).level == dsl::Level::error);
  selection = {};
  selection.every_warning_is_error = true;
  CHECK(check_text(kick_and_walk, asked(selection)).checked.findings.at(0).level == dsl::Level::error);
}

TEST_CASE("what two tasks want at once is reported before what only one of them can want at a time") {
  const auto reported = [](const std::string& first, const std::string& second) {
    const std::string text =
        "states:\n  S: {values: [a, b], initial: a}\n  E: {values: [x, z], initial: x, external: true}\n"
        "roots: {T1: {priority: 2}, T2: {priority: 2}, C: {priority: 1}}\ngroups:\n" +
        first + second +
        "  C:\n    providers:\n      - {name: one, when: [E == x], causing: [S == a]}\n"
        "      - {name: two, sets: [S == b]}\n  Z: {}\n  G: {}\n  X: {}\n  M: {needs: [X]}\n";
    const std::string all = check_text(text).findings();
    const std::size_t end = all.find(" [equal_priority]");
    REQUIRE(end != std::string::npos);
    const std::size_t begin = all.rfind(": ", all.rfind("`T1` and", end)) + 2;
    return all.substr(begin, end - begin);
  };
  CHECK(reported("  T1: {when: [S == a], needs: [X, Z], tasks: [G]}\n",
                 "  T2:\n    providers:\n      - {name: p, when: [S == b], needs: [Z, G]}\n"
                 "      - {name: q, when: [E == x], needs: [G], tasks: [X]}\n") ==
        "`T1` and `T2` have equal rank: `T1` may hold `X` and want `G` while `T2` holds `G` and wants `X`, and then "
        "each waits for the other");
  CHECK(reported("  T1: {when: [S == a], needs: [X], tasks: [G]}\n",
                 "  T2:\n    providers:\n      - {name: p, when: [S == b], needs: [G], tasks: [M]}\n"
                 "      - {name: q, when: [E == x], needs: [G]}\n") ==
        "`T1` and `T2` have equal rank and may both want `G`: whichever takes it first keeps it, and if both want it "
        "at once `T1` takes it");
}

TEST_CASE("lints are reported on request") {
  const std::string text = "roots: [Walk]\ngroups:\n  Walk: {}\n  Kick: {}\n";
  checks::Selection selection;
  CHECK(check_text(text).findings().empty());
  selection.lints = {"unused_declaration"};
  CHECK(check_text(text, asked(selection)).findings() ==
        "main.yaml:6: nothing requests or needs `Kick` [unused_declaration]\n");
  selection.lints = {"equal_priority"};
  CHECK(check_text(text, asked(selection)).findings().empty());
  selection = {};
  selection.every_lint = true;
  CHECK(check_text(text, asked(selection)).checked.findings.at(0).level == dsl::Level::lint);
}

TEST_CASE("an allowance covers what is inside its thing, and nothing beside it") {
  const std::string allow = "allow: [equal_priority], because: first come first served";
  const auto roots = [&](const std::string& kick, const std::string& walk) {
    return check_text("roots: {Kick: {priority: 10" + kick + "}, Walk: {priority: 10" + walk + "}}\n" +
                      kick_and_walk.substr(52))
        .findings();
  };
  CHECK(roots("", ", " + allow).empty());
  CHECK(roots(", " + allow, "").find("[unused_allow]") != std::string::npos);
  CHECK(check_text(kick_and_walk + "allow: [equal_priority]\nbecause: first come first served\n").findings().empty());
}

TEST_CASE("an allowance is not called unused beside a warning that may be the reason why nothing else was found") {
  const auto deliver = [](const std::string& needs) {
    return check_text(
               "states: {Badge: {values: [none, nurse], initial: none, external: true}, "
               "Speed: {values: [zero, slow], initial: zero}}\n"
               "roots: [Deliver]\n"
               "groups:\n"
               "  Deliver: {" +
               needs +
               "packs: {hand: {HandOut: {priority: 10, apart: true}, Move: {priority: 5}}}}\n"
               "  Move:\n"
               "    providers:\n"
               "      - {name: rolling, needs: [Wheels], sets: [Speed == slow], tasks: [Wheels]}\n"
               "      - {name: parking, needs: [Wheels], causing: [Speed == zero], tasks: [Wheels]}\n"
               "  HandOut: {when: [Badge == nurse, Speed == zero], allow: [uncovered_state], because: a nurse comes}\n"
               "  Wheels: {}\n")
        .findings();
  };
  CHECK(deliver("").empty());
  const std::string found = deliver("needs: [Wheels], ");
  CHECK(found.find("[push_in_vain]") != std::string::npos);
  CHECK(found.find("[unused_allow]") == std::string::npos);
}

TEST_CASE("an allowance of a lint is in use although the lint is not requested") {
  CHECK(check_text(
            "roots: [Walk]\ngroups:\n  Walk: {}\n  Kick: {allow: [unused_declaration], because: for the workshop}\n")
            .findings()
            .empty());
}

TEST_CASE("an allowed warning is not made an error") {
  checks::Selection selection;
  selection.every_warning_is_error = true;
  CHECK(check_text(kick_and_walk + "allow: [equal_priority]\nbecause: first come first served\n", asked(selection))
            .findings()
            .empty());
}

TEST_CASE("the lint that is named as an error is one, others are not") {
  const std::string text = "roots: [Walk]\ngroups: {Walk: {}, Kick: {}}\n";
  checks::Selection selection;
  selection.every_warning_is_error = true;
  selection.every_lint = true;
  const auto level = [&] { return check_text(text, asked(selection)).checked.findings.at(0).level; };
  CHECK(level() == dsl::Level::lint);
  selection.warnings_as_errors = {"unused_declaration"};
  CHECK(level() == dsl::Level::error);
}

TEST_CASE("an unused allowance may be allowed itself") {
  CHECK(check_text("roots: [Walk]\ngroups: {Walk: {allow: [equal_priority], because: it varies}}\n"
                   "allow: [unused_allow]\nbecause: some deployments need them\n")
            .findings()
            .empty());
  CHECK(check_text("roots: [Walk]\ngroups: {Walk: {}}\nallow: [unused_allow]\nbecause: nothing\n").findings() ==
        "main.yaml:5: `unused_allow` finds nothing here that could be allowed [unused_allow]\n");
}

TEST_CASE("every check has a level and a certainty, and is found by its id") {
  for (const checks::Registered& check : checks::registered()) {
    CHECK(checks::find_registered(check.id) == &check);
    CHECK_NOTHROW(checks::level_of(check));
    CHECK_NOTHROW(checks::certainty_of(check));
    CHECK_NOTHROW(checks::consequence_of(check));
  }
  CHECK(checks::find_registered("no_such_check") == nullptr);
}

} // namespace

TEST_CASE(
    "the consequence of an error, and whether it reports that something never happens, are in the head of the page") {
  const auto consequence = [](std::string_view id) { return checks::consequence_of(*checks::find_registered(id)); };
  CHECK(consequence("needs_cycle") == checks::Consequence::nothing_runs);
  CHECK(consequence("unbounded_choice") == checks::Consequence::nothing_is_explored);
  CHECK(consequence("unprovided_task") == checks::Consequence::stand_in);
  CHECK(consequence("starved_task") == checks::Consequence::none);
  CHECK(checks::reports_never(*checks::find_registered("unreachable_when")));
  CHECK_FALSE(checks::reports_never(*checks::find_registered("needs_cycle")));
}

TEST_CASE("whether a check may over-report is in the head of the page") {
  CHECK(checks::may_over_report(*checks::find_registered("uncovered_state")));
  CHECK(checks::may_over_report(*checks::find_registered("causer_not_running")));
  CHECK_FALSE(checks::may_over_report(*checks::find_registered("unreachable_when")));
  CHECK_FALSE(checks::may_over_report(*checks::find_registered("state_without_source")));
}
