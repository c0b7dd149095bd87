// SPDX-License-Identifier: MIT
// Tests dsl/reading/read_condition.hpp.
#include "dsl/reading/read_condition.hpp"
#include "tests/dsl/reading/reading.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

namespace {

Read with_conditions(const std::string& key, const std::string& list) {
  return read_body("groups:\n  G:\n    " + key + ": " + list + "\n");
}

} // namespace

TEST_CASE("A condition is a state, an operator and values, blanks as one likes") {
  struct Row {
    const char* written;
    const char* normal;
  };
  for (const Row& row : {Row{"Phase == playing", "Phase == playing"}, Row{"Phase==playing", "Phase == playing"},
                         Row{"Phase  !=  ready | set", "Phase != ready|set"}, Row{"Charge < 5", "Charge < 5"},
                         Row{"Charge<=-5", "Charge <= -5"}, Row{"Charge > 0", "Charge > 0"},
                         Row{"Charge >= 10", "Charge >= 10"}, Row{"Phase == within", "Phase == within"}}) {
    CAPTURE(row.written);
    const Read read = with_conditions("when", "[" + std::string(row.written) + "]");
    CHECK(read.findings() == "");
    REQUIRE(read.file().groups[0].providers[0].when.size() == 1);
    CHECK(to_text(read.file().groups[0].providers[0].when[0]) == row.normal);
  }
}

TEST_CASE("Each part of a condition has its place, in quotes and over lines too") {
  for (const char* written : {"Phase == ready|set within 2 s", "\"Phase == ready|set within 2 s\"",
                              "'Phase == ready|set within 2 s'", "Phase\n      == ready|set\n\n      within 2 s"}) {
    CAPTURE(written);
    const Read read = with_conditions("causing", "[" + std::string(written) + "]");
    REQUIRE(read.findings() == "");
    const ConditionSpec& condition = read.file().groups[0].providers[0].causing.at(0);
    CHECK(read.text(condition.span) == written);
    CHECK(read.text(condition.state.span) == "Phase");
    CHECK(read.text(condition.op.span) == "==");
    REQUIRE(condition.values.size() == 2);
    CHECK(read.text(condition.values[0].span) == "ready");
    CHECK(read.text(condition.values[1].span) == "set");
    REQUIRE(condition.within);
    CHECK(read.text(condition.within->span) == "2 s");
    CHECK(condition.within->value.microseconds() == 2'000'000);
  }
}

TEST_CASE("A part behind an escape has the place of the whole") {
  const Read read = with_conditions("when", R"(["Ph\u0061se == ready"])");
  REQUIRE(read.findings() == "");
  const ConditionSpec& condition = read.file().groups[0].providers[0].when.at(0);
  CHECK(condition.state.value == "Phase");
  CHECK(read.text(condition.values.at(0).span) == R"("Ph\u0061se == ready")");
}

TEST_CASE("A state alone may be set to any value, but not compared") {
  const Read read = with_conditions("sets", "[Phase, Charge > 3]");
  CHECK(read.findings() == "");
  const auto& sets = read.file().groups[0].providers[0].sets;
  CHECK(sets.at(0).any);
  CHECK(to_text(sets.at(0)) == "Phase");
  CHECK_FALSE(sets.at(1).any);
  CHECK(with_conditions("when", "[Phase]").findings() ==
        "5:17 `` bad_condition: expected one of ==, !=, <, <=, >, >= behind `Phase`, found nothing (compare it with "
        "one of its values, as in `Phase == ready` or `Charge >= 10`)\n");
  CHECK(with_conditions("when", "[Height]").findings() ==
        "5:18 `` bad_condition: expected one of ==, !=, <, <=, >, >= behind `Height`, found nothing (compare it with "
        "one of its values, as in `Phase == ready` or `Charge >= 10`)\n");
}

TEST_CASE("A mistake inside a condition is shown where it is") {
  for (const Case& c : {
           Case{"[Phase = ready]",
                "5:18 `=` bad_condition: expected one of ==, !=, <, <=, >, >= behind `Phase`, found `=` "
                "(write `==`)\n"},
           Case{"[Charge => 3]", "5:19 `=>` bad_condition: expected one of ==, !=, <, <=, >, >= behind `Charge`, found "
                                 "`=>` (write `>=`)\n"},
           Case{"[Charge <> 3]", "5:19 `<>` bad_condition: expected one of ==, !=, <, <=, >, >= behind `Charge`, found "
                                 "`<>` (write `!=`)\n"},
           Case{"[Phase is ready]",
                "5:18 `is` bad_condition: expected one of ==, !=, <, <=, >, >= behind `Phase`, found "
                "`is` (write `==`)\n"},
           Case{"[Phase is not ready]",
                "5:18 `is` bad_condition: expected one of ==, !=, <, <=, >, >= behind `Phase`, found `is` (write `!=` "
                "between state and value: `Phase != ready`)\n"},
           Case{"[3 == 3]", "5:12 `3` bad_condition: expected the name of a state, found `3` (a condition compares a "
                            "state with a value: `Phase == ready`)\n"},
           Case{"[\"-|\"]", "5:13 `-|` bad_condition: expected the name of a state, found `-|`\n"},
           Case{"[\"-= == b\"]", "5:13 `-=` bad_condition: expected the name of a state, found `-=`\n"},
           Case{"[Phase ==]", "5:20 `` bad_condition: expected a value behind `==`, found nothing\n"},
           Case{"[Phase == ready|]", "5:27 `` bad_condition: expected a value behind `|`, found nothing\n"},
           Case{"[Phase == |set]", "5:21 `|` bad_condition: expected a value behind `==`, found `|`\n"},
           Case{"[== ready]", "5:12 `==` bad_condition: expected the name of a state, found `==`\n"},
           Case{"[\"\"]", "5:13 `` bad_condition: expected the name of a state, found nothing\n"},
           Case{"[Phase == ready && Charge > 3]", "5:27 `&&` bad_condition: expected the end of the condition, found "
                                                  "`&&` (each condition is an entry of its "
                                                  "own in the list; all must hold)\n"},
           Case{
               "[Phase == ready || Phase == set]",
               "5:27 `||` bad_condition: expected the end of the condition, found `||` (alternatives are values of one "
               "state: `Phase == ready|set`)\n"},
           Case{"[Phase == a::b]", "5:22 `::` bad_condition: expected the end of the condition, found `::` (a value "
                                   "stands by itself: `Phase == ready`)\n"},
           Case{"[Phase == Game.ready]",
                "5:25 `.` bad_condition: expected the end of the condition, found `.` (a value "
                "stands by itself: `Phase == ready`)\n"},
           Case{"[Walk.halting]",
                "5:16 `.` bad_condition: expected one of ==, !=, <, <=, >, >= behind `Walk`, found `.` "
                "(a condition compares a state with a value: `Phase == ready`)\n"},
           Case{"[Charge > 1.5]", "5:22 `.` bad_condition: expected the end of the condition, found `.` (a number is a "
                                  "whole one)\n"},
           Case{"[Charge == 1..3]",
                "5:23 `..` bad_condition: expected the end of the condition, found `..` (for numbers "
                "from one to another write two conditions, with >= and <=)\n"},
           Case{"[1 < Charge < 3]", "5:23 `<` bad_condition: expected the end of the condition, found `<` (each "
                                    "condition is an entry of its own in the list; all must hold)\n"},
           Case{"[\"Phase == 'ready'\"]", "5:22 `'` bad_condition: expected a value behind `==`, found `'` (write it "
                                          "without quotes)\n"},
           Case{"[Charge < 3|4]", "5:21 `3|4` bad_condition: `<` compares with one value, found alternatives "
                                  "(alternatives go with == and !=)\n"},
           Case{"[Phase == ready within 2 s]", "5:27 `within 2 s` bad_condition: `within` belongs to a promise: it "
                                               "stands in `causing` only (leave it out)\n"},
           Case{"['Phase = ready']",
                "5:19 `=` bad_condition: expected one of ==, !=, <, <=, >, >= behind `Phase`, found "
                "`=` (write `==`)\n"},
           Case{"[3 < Charge]",
                "5:12 `3` bad_condition: expected the name of a state, found `3` (the state comes first: "
                "`Charge > 3`)\n"},
           Case{"[-3 >= Charge]", "5:12 `-3` bad_condition: expected the name of a state, found `-3` (the state comes "
                                  "first: `Charge <= -3`)\n"},
           Case{"[3 != Charge]", "5:12 `3` bad_condition: expected the name of a state, found `3` (the state comes "
                                 "first: `Charge != 3`)\n"},
           Case{"[Charge - 3]",
                "5:19 `-` bad_condition: expected one of ==, !=, <, <=, >, >= behind `Charge`, found `-`\n"},
           Case{"[Größe == 3, Phase ==\n      rüh!]",
                "6:11 `!` bad_condition: expected the end of the condition, found `!`\n"},
       }) {
    CAPTURE(c.text);
    CHECK(with_conditions("when", c.text).findings() == c.findings);
  }
}

TEST_CASE("A promise's time is a duration above 0") {
  for (const Case& c :
       {Case{"[Phase within 2 s]", "5:21 `within` bad_condition: expected one of ==, !=, <, <=, >, >= behind `Phase`, "
                                   "found `within` (say which value it promises: `Phase == ready within 2 s`)\n"},
        Case{"[Phase == ready within]", "5:36 `` bad_condition: expected a duration such as 2 s behind `within`, found "
                                        "nothing (a whole number above 0 and one of us, ms, s, min)\n"},
        Case{"[Phase == ready within 2]",
             "5:37 `2` bad_condition: expected a duration such as 2 s behind `within`, found "
             "`2` (a whole number above 0 and one of us, ms, s, min)\n"},
        Case{"[Phase == ready within 1000000000000000 ms]",
             "5:37 `1000000000000000 ms` bad_condition: expected a duration of at most 999999999999999 ms behind "
             "`within`, found `1000000000000000 ms`\n"},
        Case{"[Phase == ready within 0 s]",
             "5:37 `0 s` bad_condition: expected a duration such as 2 s behind `within`, "
             "found `0 s` (a whole number above 0 and one of us, ms, s, min)\n"}}) {
    CAPTURE(c.text);
    CHECK(with_conditions("causing", c.text).findings() == c.findings);
  }
}

TEST_CASE("A time stands where nothing is promised") {
  const std::string begin = "bad_condition: expected one of ==, !=, <, <=, >, >= behind `Phase`, found `within` ";
  CHECK(with_conditions("sets", "[Phase within 2 s]").findings() ==
        "5:18 `within` " + begin + "(leave out `within`: it belongs to a promise, in `causing`)\n");
  CHECK(with_conditions("when", "[Phase within 2 s]").findings() ==
        "5:18 `within` " + begin + "(a condition compares a state with a value: `Phase == ready`)\n");
}

TEST_CASE("A promise's time stands behind another word") {
  CHECK(with_conditions("causing", "[Phase == ready in 3 s]").findings() ==
        "5:30 `in` bad_condition: expected the end of the condition, found `in` (the time of a promise stands behind "
        "`within`: `within 3 s`)\n");
  CHECK(with_conditions("causing", "[Phase == ready 3 s]").findings() ==
        "5:30 `3` bad_condition: expected the end of the condition, found `3` (the time of a promise stands behind "
        "`within`: `within 3 s`)\n");
  CHECK(with_conditions("when", "[Phase == ready in 3 s]").findings() ==
        "5:27 `in` bad_condition: expected the end of the condition, found `in` (alternatives are values of one state: "
        "`Phase == ready|set`)\n");
}

TEST_CASE("What is no text is no condition, and the others are read all the same") {
  const Read read = with_conditions("when", "[{Phase: ready}, Phase == set, [], ~]");
  CHECK(
      read.findings() ==
      "5:12 `{Phase: ready}` wrong_node_kind: `when`: expected a condition such as Phase == playing, found a mapping\n"
      "5:42 `[]` wrong_node_kind: `when`: expected a condition such as Phase == playing, found a list\n"
      "5:46 `~` wrong_node_kind: `when`: expected a condition such as Phase == playing, found nothing\n");
  CHECK(read.file().groups[0].providers[0].when.size() == 1);
  CHECK(
      with_conditions("when", "Phase == set").findings() ==
      "5:11 `Phase == set` wrong_node_kind: `when`: expected a list, found `Phase == set` (write `[Phase == set]`)\n");
}

TEST_CASE("A condition of very many alternatives takes time in proportion, on one line or on several") {
  for (const char* separator : {"|", "|\n        "}) {
    std::string text = "[Phase == ready";
    for (int i = 0; i < 100'000; ++i) text += std::string(separator) + "set";
    const Read read = with_conditions("when", text + "]");
    CHECK(read.findings() == "");
    CHECK(read.file().groups[0].providers[0].when.at(0).values.size() == 100'001);
  }
}
