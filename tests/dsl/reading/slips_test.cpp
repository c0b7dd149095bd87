// SPDX-License-Identifier: MIT
// Tests dsl/reading/slips.hpp.
#include "dsl/reading/slips.hpp"
#include "tests/dsl/reading/reading.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

namespace {

void check_body(const std::string& body, const std::string& findings) {
  CAPTURE(body);
  CHECK(read_body(body).findings() == findings);
}

} // namespace

TEST_CASE("a priority is written as the task itself") {
  check_body("roots: {A: 10}\n",
             "3:12 `10` wrong_node_kind: `A`: expected a mapping, found `10` (write `A: {priority: 10}`)\n");
  check_body(
      "groups: {A: {tasks: {B: optional, C: true, D: -3}}}\n",
      "3:25 `optional` wrong_node_kind: `B`: expected a mapping, found `optional` (write `B: {optional: true}`)\n"
      "3:38 `true` wrong_node_kind: `C`: expected a mapping, found `true` (write `C: {}`)\n"
      "3:47 `-3` wrong_node_kind: `D`: expected a mapping, found `-3` (write `D: {priority: -3}`)\n");
  check_body("roots: {A: {levels: {firm: 50}}}\n",
             "3:28 `50` wrong_node_kind: `firm`: expected a mapping, found `50` (write `firm: {priority: 50}`)\n");
}

TEST_CASE("providers are written as a mapping") {
  check_body("groups: {A: {providers: {fast: {}, slow: {}}}}\n",
             "3:25 `{fast: {}, slow: {}}` wrong_node_kind: `providers`: expected a list of providers, found a mapping "
             "(their order is that of preference: write `- name: fast`, and its other words below)\n");
  check_body("groups: {A: {providers: {name: fast}}}\n",
             "3:25 `{name: fast}` wrong_node_kind: `providers`: expected a list of providers, found a mapping "
             "(each is an entry of a list: write `- ` before its `name`)\n");
}

TEST_CASE("a state has a type of C++ itself: that is reported once") {
  check_body("states: {X: {type: bool, initial: false}}\n",
             "3:20 `bool` wrong_node_kind: `type`: expected a C++ enum, found `bool` (leave it out and name the two "
             "values: `values: [closed, open]`; an enum is generated for them)\n");
  check_body("states: {X: {type: bool, values: [closed, open]}}\n",
             "3:20 `bool` wrong_node_kind: `type`: expected a C++ enum, found `bool` (leave it out: what the state can "
             "be is said beside it)\n");
  check_body(
      "states: {X: {type: int, range: [0, 9]}}\n",
      "3:20 `int` wrong_node_kind: `type`: expected a C++ enum, found `int` (leave it out: what the state can be "
      "is said beside it)\n");
  check_body("states: {X: bool}\n",
             "3:13 `bool` wrong_node_kind: `X`: expected a mapping, found `bool` (leave it out and name the two "
             "values: `values: [closed, open]`; an enum is generated for them)\n");
  check_body("states: {X: [a, b]}\n",
             "3:13 `[a, b]` wrong_node_kind: `X`: expected a mapping, found a list (its values "
             "stand in `values`: `X: {values: [...]}`)\n");
}

TEST_CASE("keys of other tools are reported with the right ones") {
  check_body(
      "groups: {A: {sequence: [B], timeout: 3 s, unless: [X == a], priority: 3}}\n",
      "3:14 `sequence` unknown_key: group `A` has no key `sequence` (there is no sequence: give each step a "
      "provider, with a `when` on a state that tells how far it is, and have it set the next value)\n"
      "3:29 `timeout` unknown_key: group `A` has no key `timeout` (a promise may have a time, `causing: [Motion "
      "== still within 3 s]`; a body that waits calls `run.wait(3s)`)\n"
      "3:43 `unless` unknown_key: group `A` has no key `unless` (`when` says what must hold: write the opposite, "
      "such as `when: [Motion != rolling]`)\n"
      "3:61 `priority` unknown_key: group `A` has no key `priority` (it stands where the task is requested: "
      "`roots: {Walk: {priority: 10}}`, or in `tasks` of the group that requests it)\n");
  check_body("groups: {A: {providers: [{name: a, priority: 3}]}}\n",
             "3:36 `priority` unknown_key: provider `a` has no key `priority` (it stands where the task is requested: "
             "`roots: {Walk: {priority: 10}}`, or in `tasks` of the group that requests it)\n");
  check_body("roots: {A: {when: [X == a]}}\n",
             "3:13 `when` unknown_key: task `A` has no key `when` (a condition belongs to a provider: to that of the "
             "task, or to the one that requests it)\n");
  check_body("states: {X: {values: [a], default: a}}\n", "3:27 `default` unknown_key: state `X` has no key `default` "
                                                         "(the value at the start stands in `initial`)\n");
  check_body("states: {X: {values: [a], value: a}}\n", "3:27 `value` unknown_key: state `X` has no key `value` "
                                                       "(the value at the start stands in `initial`)\n");
  check_body("states: {X: {value: [a, b]}}\n",
             "3:14 `value` unknown_key: state `X` has no key `value` (did you mean `values`?)\n");
  check_body("states: {X: {value: 5}}\n",
             "3:10 `X` missing_key: state `X` needs `values`, `range` or `type` (for example `values: [low, high]`, or "
             "`range: [0, 100]`)\n"
             "3:14 `value` unknown_key: state `X` has no key `value` (the value at the start stands in `initial`)\n");
  check_body("groups: {A: {cause: [X == a], request: [B]}}\n",
             "3:14 `cause` unknown_key: group `A` has no key `cause` (what it promises to make true stands in "
             "`causing`: `causing: [Motion == still]`)\n"
             "3:31 `request` unknown_key: group `A` has no key `request` (what it may request stands in `tasks` or "
             "`packs`)\n");
  check_body(
      "groups: {A: {description: x}}\nroots: {A: {comment: x}}\nstates: {X: {description: x, values: [a]}}\n",
      "3:14 `description` unknown_key: group `A` has no key `description` (a text for people stands in `doc`)\n"
      "4:13 `comment` unknown_key: task `A` has no key `comment` (a text for people stands in `doc`)\n"
      "5:14 `description` unknown_key: state `X` has no key `description` (a text for people stands in `doc`)\n");
  CHECK(read_text("behaviour: b\nlanguage: 1\ndescription: x\n").findings() ==
        "3:1 `description` unknown_key: a behaviour file has no key `description` (a text for people stands in "
        "`doc`)\n");
  CHECK(read_scenario_body("steps: [{wait: 3 s}]\n").findings() ==
        "2:10 `wait` unknown_key: a step has no key `wait` (time passes with `advance: 100 ms`)\n");
}

TEST_CASE("a list in place of a mapping, and a mapping in place of a list") {
  check_body("groups: [A]\n",
             "3:9 `[A]` wrong_node_kind: `groups`: expected a mapping, found a list (each with its name "
             "and a `:`, such as `Legs: {}`)\n");
  check_body(
      "groups: {A: [B]}\n",
      "3:13 `[B]` wrong_node_kind: `A`: expected a mapping, found a list (what it requests stands in `tasks`, what "
      "it must control in `needs`: `A: {tasks: [...]}`)\n");
  check_body("groups: {A: {needs: {B: {}, C: {}}}}\n",
             "3:21 `{B: {}, C: {}}` wrong_node_kind: `needs`: expected a list, found a mapping (write `[B, C]`)\n");
  check_body("groups: {A: {when: {X: a}}}\n",
             "3:20 `{X: a}` wrong_node_kind: `when`: expected a list, found a mapping (write `[X == a]`)\n");
  check_body("groups: {A: {causing: {X == a: 2 s}}}\n",
             "3:23 `{X == a: 2 s}` wrong_node_kind: `causing`: expected a list, found a mapping (write `[X == a within "
             "2 s]`)\n");
  check_body("groups: {A: {when: {X == a: true}}}\n",
             "3:20 `{X == a: true}` wrong_node_kind: `when`: expected a list, found a mapping (write `[X == a]`)\n");
  check_body(
      "groups: {A: {packs: [B]}}\n",
      "3:21 `[B]` wrong_node_kind: `packs`: expected a mapping of names to tasks, found a list (give each pack a "
      "name: `packs: {attack: [Kick, Walk]}`)\n");
  check_body("groups: {A: {tasks: {go: [B]}}}\n",
             "3:26 `[B]` wrong_node_kind: `go`: expected a mapping, found a list (tasks that belong together stand in "
             "`packs`: `packs: {go: [Walk]}`)\n");
}

TEST_CASE("an entry of a list lacks the blank behind its dash") {
  check_body(
      "groups:\n  A:\n    tasks:\n      -B\n",
      "6:7 `-B` wrong_node_kind: `tasks`: expected a list of groups or a mapping, found `-B` (an entry of a list "
      "needs a blank behind its dash: `- B`)\n");
  check_body("groups:\n  A:\n    needs:\n      -B\n      -C\n",
             "6:7 `-B…` wrong_node_kind: `needs`: expected a list, found `-B -C` (an entry of a list needs a blank "
             "behind its dash: `- B`)\n");
  check_body(
      "groups:\n  A:\n    needs:\n      -_B\n",
      "6:7 `-_B` wrong_node_kind: `needs`: expected a list, found `-_B` (an entry of a list needs a blank behind "
      "its dash: `- _B`)\n");
  check_body("groups:\n  A:\n    providers:\n      -name: walking\n",
             "6:7 `-name: walking` wrong_node_kind: `providers`: expected a list of providers, found a mapping (an "
             "entry of a list needs a blank behind its dash: `- name`)\n");
  check_body("states: {X: {range: -5}}\n",
             "3:21 `-5` wrong_node_kind: `range`: expected a list of the lowest and the highest number, found `-5` "
             "(for example `[0, 100]`)\n");
}

TEST_CASE("a key of a group stands beside the group") {
  check_body("groups:\n  A: {}\n  tasks: [B]\n  realtime: true\n  stop: here and there\n",
             "5:10 `[B]` wrong_node_kind: `tasks`: expected a mapping, found a list (`tasks` is a key of a group: is "
             "the line indented as it should be?)\n"
             "6:13 `true` wrong_node_kind: `realtime`: expected a mapping, found `true` (`realtime` is a key of a "
             "group: is the line indented as it should be?)\n"
             "7:9 `here and there` wrong_node_kind: `stop`: expected a mapping, found `here and there` (`stop` is a "
             "key of a group: is the line indented as it should be?)\n");
  check_body("groups:\n  A: {}\n  tasks: {B: {priority: 1}, C: {}}\n  needs:\n    D:\n  data: {task: [B]}\n",
             "5:11 `B` unknown_key: group `tasks` has no key `B` (`tasks` is a key of a group: is the line indented as "
             "it should be?)\n"
             "7:5 `D` unknown_key: group `needs` has no key `D` (`needs` is a key of a group: is the line indented as "
             "it should be?)\n"
             "8:10 `task` unknown_key: group `data` has no key `task` (did you mean `tasks`?)\n");
  check_body("groups: {needs: {condition: [A == b]}}\n",
             "3:18 `condition` unknown_key: group `needs` has no key `condition` (conditions stand in `when`: `when: "
             "[Motion == still]`)\n");
}

TEST_CASE("a condition is written as a sentence") {
  check_body("groups: {A: {when: [not X == a]}}\n",
             "3:25 `X` bad_condition: expected one of ==, !=, <, <=, >, >= behind `not`, found `X` (write `!=` between "
             "state and value: `Phase != ready`)\n");
  check_body("groups: {A: {when: [X is a]}}\n",
             "3:23 `is` bad_condition: expected one of ==, !=, <, <=, >, >= behind `X`, found `is` (write `==`)\n");
}

TEST_CASE("no word of the language is taken for a mistake where it belongs") {
  for (const char* key :
       {"name", "when",  "stay",    "causing", "sets",   "needs", "uses",     "triggers", "every", "tasks",    "packs",
        "doc",  "allow", "because", "layer",   "module", "data",  "realtime", "start",    "stop",  "providers"}) {
    CAPTURE(key);
    CHECK(help_for(slips_of_group(), key) == nullptr);
  }
  for (const char* key : {"priority", "optional", "apart", "levels", "doc", "allow", "because"}) {
    CAPTURE(key);
    CHECK(help_for(slips_of_task(), key) == nullptr);
  }
}

TEST_CASE("what is no list is reported as one, whatever separates its parts") {
  check_body("states: {X: {values: open|shut}}\n",
             "3:22 `open|shut` wrong_node_kind: `values`: expected a list, found `open|shut` (write `[open, shut]`)\n");
  check_body("groups: {A: {needs: 'Left , Right'}}\n",
             "3:21 `'Left , Right'` wrong_node_kind: `needs`: expected a list, found the text `Left , Right` (write "
             "`[Left, Right]`)\n");
  for (const std::string range : {"0..100", "100", "{min: 0, max: 100}", "[0, 50, 100]"})
    check_body("states: {X: {range: " + range + "}}\n",
               "3:21 `" + range +
                   "` wrong_node_kind: `range`: expected a list of the lowest and the highest number, found " +
                   (range[0] == '{'   ? "a mapping"
                    : range[0] == '[' ? "a list of 3"
                                      : "`" + range + "`") +
                   " (for example `[0, 100]`)\n");
}

TEST_CASE("providers are written without the key `name`") {
  check_body(
      "groups: {A: {providers: [fast]}}\n",
      "3:26 `fast` wrong_node_kind: `providers`: expected a mapping such as {name: walking}, found `fast` (write "
      "`{name: fast}`)\n");
  check_body("groups:\n  A:\n    providers:\n      - fast: {needs: [B]}\n      - slow:\n",
             "6:9 `fast` missing_key: a provider needs `name` (write `- name: fast`, and its other words below)\n"
             "7:9 `slow` missing_key: a provider needs `name` (write `- name: slow`, and its other words below)\n");
  check_body("groups: {A: {providers: [{needs: [B]}]}}\n",
             "3:27 `needs` missing_key: a provider needs `name` (for example `name: walking`)\n");
}

TEST_CASE("what should be a mapping is a word") {
  check_body("groups: {A: Legs}\n",
             "3:13 `Legs` wrong_node_kind: `A`: expected a mapping, found `Legs` (what it requests "
             "stands in `tasks`, what it must control in `needs`: `A: {tasks: [Legs]}`)\n");
  check_body("roots: {A: high}\n",
             "3:12 `high` wrong_node_kind: `A`: expected a mapping, found `high` (a priority is a "
             "whole number: `A: {priority: 10}`)\n");
  check_body("cpp: types.hpp\n",
             "3:6 `types.hpp` wrong_node_kind: `cpp`: expected a mapping, found `types.hpp` (headers are "
             "a list: `cpp: {headers: [robot/messages.hpp]}`)\n");
  check_body("cpp: {include: [types.hpp]}\n", "3:7 `include` unknown_key: `cpp` has no key `include` (what is included "
                                              "stands in `headers`: `headers: [types.hpp]`)\n");
}

TEST_CASE("the members of a task's data, and types of other languages, are reported where they belong") {
  check_body(
      "groups: {A: {data: {x: int}}}\n",
      "3:20 `{x: int}` wrong_node_kind: `data`: expected a C++ type, found a mapping (what has members is a struct "
      "in a header of yours: `data: robot::Course`, and under `cpp` `headers: [robot/course.hpp]`)\n");
  check_body(
      "states: {X: {type: boolean}}\n",
      "3:20 `boolean` wrong_node_kind: `type`: expected a C++ enum, found `boolean` (leave it out and name the two "
      "values: `values: [closed, open]`; an enum is generated for them)\n");
  check_body(
      "states: {X: {type: uint8}}\n",
      "3:20 `uint8` wrong_node_kind: `type`: expected a C++ enum, found `uint8` (leave it out and say which whole "
      "numbers: `range: [0, 100]`)\n");
  check_body(
      "states: {X: {type: string}}\n",
      "3:20 `string` wrong_node_kind: `type`: expected a C++ enum, found `string` (leave it out and list the words: "
      "`values: [lost, seen]`; an enum is generated for them)\n");
}
