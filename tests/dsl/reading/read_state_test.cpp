// SPDX-License-Identifier: MIT
// Tests dsl/reading/read_state.hpp.
#include "dsl/reading/read_state.hpp"
#include "tests/dsl/reading/reading.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

namespace {

Read with_state(const std::string& words) { return read_body("states:\n  S: " + words + "\n"); }

} // namespace

TEST_CASE("A state's words are read with their places") {
  const Read read = read_body(R"(states:
  Stability:
    doc: How it stands.
    type: soccer::Stability
    values: [unknown, fallen, standing]
    unordered: [unknown]
    initial: unknown
    external: true
    allow: [unused_declaration]
    because: Later.
  Charge: {range: [-5, 100], initial: 50, expires: 500 ms}
  Link: {values: [lost, up], expires: {after: 2 s, to: lost}}
  Approach: {values: [far, near], initial: far, of: Striker}
)");
  REQUIRE(read.findings() == "");
  const auto& states = read.file().states;
  REQUIRE(states.size() == 4);
  CHECK(states[0].name.value == "Stability");
  CHECK(states[0].doc->value == "How it stands.");
  CHECK(states[0].type->value == "soccer::Stability");
  REQUIRE(states[0].values);
  CHECK(states[0].values->at(2).value == "standing");
  CHECK(read.text(states[0].values->at(2).span) == "standing");
  CHECK(states[0].unordered.at(0).value == "unknown");
  CHECK(states[0].initial->value == "unknown");
  CHECK(states[0].external.value);
  CHECK(states[0].allow.at(0).id.value == "unused_declaration");
  CHECK_FALSE(states[0].range);
  CHECK(states[1].range->low.value == -5);
  CHECK(states[1].range->high.value == 100);
  CHECK(read.text(states[1].range->span) == "[-5, 100]");
  CHECK(states[1].initial->value == "50");
  CHECK(states[1].expires->after.value.microseconds() == 500'000);
  CHECK_FALSE(states[1].expires->to);
  CHECK_FALSE(states[1].values);
  CHECK_FALSE(states[1].external.value);
  CHECK(read.text(states[1].span) == "Charge: {range: [-5, 100], initial: 50, expires: 500 ms}");
  CHECK(states[2].expires->to->value == "lost");
  CHECK(states[3].of->value == "Striker");
}

TEST_CASE("What is wrong in a state is reported at its place") {
  for (const Case& c : {
           Case{"{}", "4:3 `S` missing_key: state `S` needs `values`, `range` or `type` (for example `values: [low, "
                      "high]`, or `range: [0, 100]`)\n"},
           Case{"{vales: [a]}", "4:7 `vales` unknown_key: state `S` has no key `vales` (did you mean `values`?)\n"},
           Case{"{values: []}", "4:15 `[]` wrong_node_kind: `values`: expected at least one value, found an empty list "
                                "(for example `[low, high]`)\n"},
           Case{"{values: a}", "4:15 `a` wrong_node_kind: `values`: expected a list, found `a` (write `[a]`)\n"},
           Case{"{values: [a], range: [0, 1]}", "4:20 `range` exclusive_keys: `values` and `range` exclude each other "
                                                "(leave out one: `range` is for whole numbers, `values` is for words)\n"
                                                "  4:7 `values` `values` stands here\n"},
           Case{"{range: [0, 1], type: T}", "4:22 `type` exclusive_keys: `range` and `type` exclude each other (leave "
                                            "out one: `range` is for whole numbers, `type` for an enum of C++)\n"
                                            "  4:7 `range` `range` stands here\n"},
           Case{"{values: [a], of: G}",
                "4:3 `S` missing_key: state `S` belongs to a group and needs `initial` (give it "
                "the value to which it returns when the group stops)\n"},
           Case{"{values: [a], of: G, initial: a, external: true}",
                "4:39 `external` exclusive_keys: `of` and `external` exclude each other (leave out `of` if the outside "
                "may set it, else `external`)\n"
                "  4:20 `of` `of` stands here\n"},
           Case{"{range: 3}",
                "4:14 `3` wrong_node_kind: `range`: expected a list of the lowest and the highest number, found "
                "`3` (for example `[0, 100]`)\n"},
           Case{"{range: [1, 2, 3]}",
                "4:14 `[1, 2, 3]` wrong_node_kind: `range`: expected a list of the lowest and the "
                "highest number, found a list of 3 (for example `[0, 100]`)\n"},
           Case{"{range: [a, 1.5]}", "4:15 `a` wrong_node_kind: `range`: expected a whole number, found `a`\n"
                                     "4:18 `1.5` wrong_node_kind: `range`: expected a whole number, found `1.5`\n"},
           Case{"{range: [5, 4]}", "4:14 `[5, 4]` wrong_node_kind: `range`: expected the lower number first, found 5 "
                                   "above 4 (write `[4, 5]`)\n"},
           Case{"{range: [0, 9223372036854775808]}",
                "4:18 `9223372036854775808` wrong_node_kind: `range`: expected a "
                "whole number from -9223372036854775808 to 9223372036854775807, found `9223372036854775808`\n"},
           Case{"{values: [a], initial: [a]}",
                "4:29 `[a]` wrong_node_kind: `initial`: expected a value of the state, found a list\n"},
           Case{"{values: [a], external: on}", "4:30 `on` wrong_node_kind: `external`: expected true or false, found "
                                               "`on` (write `true`, without quotes)\n"},
           Case{"{values: [a], expires: never}", "4:29 `never` wrong_node_kind: `expires`: expected a duration such as "
                                                 "10 ms, found `never` (a whole number "
                                                 "and one of us, ms, s, min)\n"},
           Case{"{values: [a], expires: {to: a}}",
                "4:20 `expires` missing_key: `expires` needs `after` (for example `after: 500 ms`)\n"},
           Case{"{values: [a], expires: {aftr: 1 s, in: 2}}",
                "4:30 `aftr` unknown_key: `expires` has no key `aftr` (did you mean `after`?)\n"
                "4:41 `in` unknown_key: `expires` has no key `in` (it may have after, to)\n"},
           Case{"{values: [off, \"on\"]}", "4:16 `off` warning yaml_word_trap: older YAML tools read a bare `off` as a "
                                           "boolean (write \"off\", or choose "
                                           "another word)\n"},
           Case{"[a, b]", "4:6 `[a, b]` wrong_node_kind: `S`: expected a mapping, found a list (its values stand in "
                          "`values`: `S: {values: [...]}`)\n"},
       }) {
    CAPTURE(c.text);
    CHECK(with_state(c.text).findings() == c.findings);
  }
}
