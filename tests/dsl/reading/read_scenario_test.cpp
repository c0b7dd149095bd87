// SPDX-License-Identifier: MIT
// Tests dsl/reading/read_scenario.hpp, dsl/reading/read_script.hpp.
#include "dsl/reading/read_scenario.hpp"
#include "tests/dsl/reading/reading.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace director::dsl;

namespace {

std::string steps_findings(const std::string& steps) { return read_scenario_body("steps: " + steps + "\n").findings(); }
std::string script_findings(const std::string& script) {
  return read_scenario_body("script: " + script + "\n").findings();
}

} // namespace

TEST_CASE("The head of a scenario is read") {
  MemoryFiles files;
  files.add("play/kick.scenario.yaml",
            "scenario: a kick\nbehaviour: ../walker.yaml\ndoc: Softly.\ngiven: {Arm: folded, Charge: 3}\n");
  Sources sources;
  const ReadScenarioResult result = read_scenario("play/kick.scenario.yaml", files, sources);
  CHECK(findings_text(result.diagnostics, sources) == "");
  const ScenarioSpec& scenario = result.scenario;
  CHECK(scenario.title->value == "a kick");
  CHECK(scenario.behaviour.value == "../walker.yaml");
  CHECK(scenario.behaviour_path == "walker.yaml");
  CHECK(scenario.doc->value == "Softly.");
  REQUIRE(scenario.given.size() == 2);
  CHECK(scenario.given[0].state.value == "Arm");
  CHECK(scenario.given[1].value.value == "3");
  CHECK(scenario.steps.empty());
}

TEST_CASE("Where nothing is there, no empty step or input is proposed") {
  CHECK(steps_findings("[~]") ==
        "2:9 `~` wrong_node_kind: `steps`: expected a mapping such as {request: Walk}, found nothing\n");
  CHECK(steps_findings("[{inputs: [~]}]") ==
        "2:19 `~` wrong_node_kind: `inputs`: expected a mapping such as {request: Walk}, found nothing\n");
}

TEST_CASE("A script's entries have guards and effects") {
  const auto read = read_scenario_body(R"(script:
  Walk.walking:
    set: {Pose: moving}
    tasks: [Legs, Arms: {level: urgent, data: {at: [1, x]}, keep: true}]
    wait: 50 ms
  Kick:
    - {reason: subtask_done, trigger: Tick, data: 3, run: 2, uses: {Legs: done, Arms: queued}, done: true}
    - {pack: attack, with: [Legs: {data: 3}], without: [Arms, Head]}
    - {failed: true}
    - {continue: true}
    - {}
  Walk.stop: {data: 4, run: 1, set: {Pose: standing}}
)");
  REQUIRE(read.findings() == "");
  const auto& script = read.result.scenario.script;
  REQUIRE(script.size() == 3);
  CHECK(script[0].group.value == "Walk");
  REQUIRE(script[0].part);
  CHECK(script[0].part->value == "walking");
  CHECK(read.text(script[0].group.span) == "Walk");
  CHECK(read.text(script[0].part->span) == "walking");
  const CaseSpec& walking = script[0].cases.at(0);
  CHECK(walking.set.at(0).state.value == "Pose");
  CHECK(walking.set.at(0).value.value == "moving");
  CHECK(walking.answer.value == Answer::tasks);
  REQUIRE(walking.tasks.size() == 2);
  CHECK(walking.tasks[0].group.value == "Legs");
  CHECK_FALSE(walking.tasks[0].data);
  CHECK(walking.tasks[1].level->value == "urgent");
  CHECK(to_text(walking.tasks[1].data->value) == "{at: [1, x]}");
  CHECK(walking.tasks[1].keep.value);
  CHECK(walking.wait->value.microseconds() == 50'000);
  CHECK_FALSE(script[1].part);
  const auto& kick = script[1].cases;
  REQUIRE(kick.size() == 5);
  CHECK(kick[0].reason->value == Reason::subtask_done);
  CHECK(kick[0].trigger->value == "Tick");
  CHECK(to_text(kick[0].data->value) == "3");
  CHECK(kick[0].run->value == 2);
  REQUIRE(kick[0].uses.size() == 2);
  CHECK(kick[0].uses[0].group.value == "Legs");
  CHECK(kick[0].uses[0].state.value == UseState::done);
  CHECK(kick[0].uses[1].state.value == UseState::queued);
  CHECK(kick[0].answer.value == Answer::done);
  CHECK(kick[1].answer.value == Answer::pack);
  CHECK(kick[1].pack->value == "attack");
  CHECK(to_text(kick[1].tasks.at(0).data->value) == "3");
  REQUIRE(kick[1].without.size() == 2);
  CHECK(kick[1].without[1].value == "Head");
  CHECK(kick[2].answer.value == Answer::failed);
  CHECK(kick[3].answer.value == Answer::keep);
  CHECK(kick[4].answer.value == Answer::nothing);
  CHECK(script[2].part->value == "stop");
  CHECK(script[2].cases.at(0).set.at(0).value.value == "standing");
}

TEST_CASE("Steps are inputs that are printed as they are written, and time") {
  const auto read = read_scenario_body(R"(steps:
  - request: Walk
    doc: Off it goes.
  - request: [Walk, "Kick"]
  - request: {Kick: {level: urgent, data: 1}, Walk: {}}
  - cancel: Walk
  - set: {Pose: standing, Charge: -3}
  - trigger: Tick
  - enable: Walk.halting
  - disable: Kick.default
  - advance: 100 ms
  - inputs: [{request: A}, {set: {Pose: "moving"}}]
  - inputs: []
)");
  REQUIRE(read.findings() == "");
  std::vector<std::string> shown;
  const auto& steps = read.result.scenario.steps;
  for (const StepSpec& step : steps)
    for (const InputSpec& input : step.inputs) shown.push_back(input.shown);
  CHECK(shown == std::vector<std::string>{"request Walk", "request [Walk, Kick]",
                                          "request {Kick: {level: urgent, data: 1}, Walk: {}}", "cancel Walk",
                                          "set {Pose: standing, Charge: -3}", "trigger Tick", "enable Walk.halting",
                                          "disable Kick.default", "request A", "set {Pose: moving}"});
  REQUIRE(steps.size() == 11);
  CHECK(steps[0].doc->value == "Off it goes.");
  CHECK(steps[1].inputs[0].requests.at(1).group.value == "Kick");
  CHECK(steps[2].inputs[0].requests.at(0).level->value == "urgent");
  CHECK(to_text(steps[2].inputs[0].requests.at(0).data->value) == "1");
  CHECK(steps[3].inputs[0].name.value == "Walk");
  CHECK(steps[4].inputs[0].set.at(1).value.value == "-3");
  CHECK(steps[6].inputs[0].name.value == "Walk");
  CHECK(steps[6].inputs[0].provider.value == "halting");
  CHECK(read.text(steps[6].inputs[0].provider.span) == "halting");
  REQUIRE(steps[8].advance);
  CHECK(steps[8].advance->value.microseconds() == 100'000);
  CHECK(steps[9].inputs.size() == 2);
  CHECK(read.text(steps[9].inputs[1].span) == "{set: {Pose: \"moving\"}}");
  CHECK(steps[10].inputs.empty());
}

TEST_CASE("What is expected is a line for each event, each with its place") {
  const auto read =
      read_scenario_body("steps:\n  - request: Walk\n    expect: |\n      start Walk\n\n      # then\n"
                         "      run Walk new_task  \n  - {cancel: Walk, expect: \"\"}\n  - cancel: Walk\n");
  REQUIRE(read.findings() == "");
  const auto& steps = read.result.scenario.steps;
  REQUIRE(steps.at(0).expect);
  REQUIRE(steps[0].expect->lines.size() == 2);
  CHECK(steps[0].expect->lines[1].value == "run Walk new_task");
  CHECK(read.text(steps[0].expect->lines[1].span) == "run Walk new_task");
  REQUIRE(steps.at(1).expect);
  CHECK(steps[1].expect->lines.empty());
  CHECK_FALSE(steps.at(2).expect);
}

TEST_CASE("What is wrong in a scenario's head is reported at its place") {
  for (const Case& c : {
           Case{"senario: x\n",
                "2:1 `senario` unknown_key: a scenario file has no key `senario` (did you mean `scenario`?)\n"},
           Case{"language: 1\n", "2:1 `language` unknown_key: a scenario file has no key `language` (this belongs to a "
                                 "behaviour file, which `directorc check` reads)\n"},
           Case{"given: [A]\nsteps: {}\nscript: []\n",
                "2:8 `[A]` wrong_node_kind: `given`: expected a mapping of states to values, found a list\n"
                "3:8 `{}` wrong_node_kind: `steps`: expected a list of steps, found a mapping (write `- ` before "
                "each step: `- request: Walk`)\n"
                "4:9 `[]` wrong_node_kind: `script`: expected a mapping, found a list\n"},
           Case{"given: {A: , B: [c]}\n",
                "2:9 `A` wrong_node_kind: `A`: expected a value of the state, found nothing\n"
                "2:17 `[c]` wrong_node_kind: `B`: expected a value of the state, found a list\n"},
       }) {
    CAPTURE(c.text);
    CHECK(read_scenario_body(c.text).findings() == c.findings);
  }
  MemoryFiles files;
  files.add("a.yaml", "steps: []\n");
  files.add("b.yaml", "");
  Sources sources;
  CHECK(findings_text(read_scenario("a.yaml", files, sources).diagnostics, sources) ==
        "1:1 `steps` missing_key: a scenario file needs `behaviour` (for example `behaviour: walker.yaml`)\n");
  CHECK(findings_text(read_scenario("b.yaml", files, sources).diagnostics, sources) ==
        "b.yaml:1:1 `` wrong_node_kind: a scenario file is a mapping, found nothing (it begins with `behaviour: "
        "file.yaml`)\n");
  const ReadScenarioResult lost = read_scenario("c.yaml", files, sources);
  CHECK(findings_text(lost.diagnostics, sources) ==
        "c.yaml:1:1 `` import_not_found: cannot read `c.yaml`: No such file or directory (a path is relative to the "
        "folder in which the program runs)\n");
  CHECK_FALSE(lost.readable);
}

TEST_CASE("What is wrong in a script is reported at its place") {
  for (const Case& c : {
           Case{"{Kick: }",
                "2:10 `Kick` wrong_node_kind: `Kick`: expected a case or a list of cases, found nothing (an empty "
                "one is `[]`)\n"},
           Case{"{Kick: [done]}",
                "2:17 `done` wrong_node_kind: `Kick`: expected a case, found `done` (write `{done: true}`)\n"},
           Case{"{Kick: done}", "2:16 `done` wrong_node_kind: `Kick`: expected a case or a list of cases, found "
                                "`done` (write `{done: true}`)\n"},
           Case{"{Kick: [keep, wait, Legs, 3, ~]}",
                "2:17 `keep` wrong_node_kind: `Kick`: expected a case, found `keep` (that everything goes on is said "
                "by `continue: true`)\n"
                "2:23 `wait` wrong_node_kind: `Kick`: expected a case, found `wait` (write `{wait: 100 ms}`)\n"
                "2:29 `Legs` wrong_node_kind: `Kick`: expected a case, found `Legs` (write `{tasks: [Legs]}` if it is "
                "a task, `{pack: Legs}` if it is a pack)\n"
                "2:35 `3` wrong_node_kind: `Kick`: expected a case, found `3`\n"
                "2:38 `~` wrong_node_kind: `Kick`: expected a case, found nothing (an empty one is `{}`)\n"},
           Case{"{Kick: {keep: true}}", "2:17 `keep` unknown_key: a case of `Kick` has no key `keep` (that everything "
                                        "goes on is said by `continue: true`)\n"},
           Case{"{Kick.stop: done}", "2:21 `done` wrong_node_kind: `Kick.stop`: expected a case or a list of cases, "
                                     "found `done` (a handler gives no answer: it may set states, `{set: {Ball: "
                                     "near}}`)\n"},
           Case{"{Kick: {task: [A], reasn: x}}",
                "2:17 `task` unknown_key: a case of `Kick` has no key `task` (did you mean `tasks`?)\n"
                "2:28 `reasn` unknown_key: a case of `Kick` has no key `reasn` (did you mean `reason`?)\n"},
           Case{
               "{Kick: {reason: done, uses: {A: idle}}}",
               "2:25 `done` wrong_node_kind: `reason`: expected one of new_task, pushed, subtask_done, wait, trigger, "
               "found "
               "`done`\n"
               "2:41 `idle` wrong_node_kind: `A`: expected one of running, queued, none, done, failed, found `idle`\n"},
           Case{"{Kick: {done: true, failed: true}}", "2:29 `failed` exclusive_keys: `done` and `failed` exclude each "
                                                      "other (a case gives one answer: leave out the others)\n"
                                                      "  2:17 `done` `done` stands here\n"},
           Case{"{Kick: {tasks: [A], pack: b}}", "2:29 `pack` exclusive_keys: `tasks` and `pack` exclude each other (a "
                                                 "case gives one answer: leave out the others)\n"
                                                 "  2:17 `tasks` `tasks` stands here\n"},
           Case{"{Kick: {done: false}}",
                "2:23 `false` wrong_node_kind: `done`: expected true, found `false` (leave it out "
                "where it is not so)\n"},
           Case{"{Kick: {failed: no}}",
                "2:25 `no` wrong_node_kind: `failed`: expected true, found `no` (leave it out where it is not so)\n"},
           Case{"{Kick: {done: maybe}}", "2:23 `maybe` wrong_node_kind: `done`: expected true, found `maybe`\n"},
           Case{"{Kick: {with: [A]}}",
                "2:17 `with` missing_key: `with` needs `pack` (it says more about some tasks of a "
                "pack)\n"},
           Case{"{Kick: {tasks: [B], without: [A]}}",
                "2:29 `without` missing_key: `without` needs `pack` (it leaves out some tasks of a pack)\n"},
           Case{"{Kick: {pack: a, without: A}}",
                "2:35 `A` wrong_node_kind: `without`: expected a list, found `A` (write `[A]`)\n"},
           Case{"{Kick: {tasks: {A: {}}}}",
                "2:24 `{A: {}}` wrong_node_kind: `tasks`: expected a list, found a mapping (write `[A]`)\n"},
           Case{"{Kick: {tasks: {A: {data: 3}, B: {}}}}",
                "2:24 `{A: {data: 3}, B: {}}` wrong_node_kind: `tasks`: expected a list, found a mapping (write `[A: "
                "{data: 3}, B]`)\n"},
           Case{"{Kick: {tasks: [A: 3, B: urgent]}}",
                "2:28 `3` wrong_node_kind: `A`: expected a mapping, found `3` (write `A: {data: 3}`)\n"
                "2:34 `urgent` wrong_node_kind: `B`: expected a mapping, found `urgent` (write `B: {data: urgent}`, "
                "or, if it is a level, `B: {level: urgent}`)\n"},
           Case{"{Kick: {tasks: [[A], B: {dta: 3}]}}",
                "2:25 `[A]` wrong_node_kind: `tasks`: expected the name of a group, or {Group: {data: 1}}, found a "
                "list\n"
                "2:34 `dta` unknown_key: a request of `B` has no key `dta` (did you mean `data`?)\n"},
           Case{"{Kick: {run: 0, wait: 0 ms, data: [1, ~]}}",
                "2:22 `0` wrong_node_kind: `run`: expected a whole number from 1, found `0`\n"
                "2:31 `0 ms` wrong_node_kind: `wait`: expected a duration above 0, found `0 ms`\n"
                "2:47 `~` wrong_node_kind: `data`: expected a value, found nothing\n"},
           Case{"{Kick.start: {tasks: [A]}}",
                "2:23 `tasks` unknown_key: a case of `Kick.start` has no key `tasks` (it may have data, run, set)\n"},
       }) {
    CAPTURE(c.text);
    CHECK(script_findings(c.text) == c.findings);
  }
}

TEST_CASE("What is wrong in a step is reported at its place") {
  for (const Case& c : {
           Case{"[Walk]",
                "2:9 `Walk` wrong_node_kind: `steps`: expected a mapping such as {request: Walk}, found `Walk` (to "
                "request it, write `request: Walk`)\n"},
           Case{"[{}]",
                "2:9 `{}` missing_key: a step needs one of request, cancel, set, trigger, enable, disable, advance, "
                "inputs (for example `request: Walk`)\n"},
           Case{"[{expect: x}]",
                "2:10 `expect` missing_key: a step needs one of request, cancel, set, trigger, enable, "
                "disable, advance, inputs (for example `request: Walk`)\n"},
           Case{"[{requst: A}]", "2:10 `requst` unknown_key: a step has no key `requst` (did you mean `request`?)\n"},
           Case{"[{request: A, cancel: B}]", "2:22 `cancel` exclusive_keys: `request` and `cancel` exclude each other "
                                             "(make two steps of them, or `inputs: [...]` where they come at once)\n"
                                             "  2:10 `request` `request` stands here\n"},
           Case{"[{request: }]",
                "2:10 `request` wrong_node_kind: `request`: expected a root, a list or a mapping of roots, "
                "found nothing\n"},
           Case{"[{request: {A: {keep: true}}}]",
                "2:24 `keep` unknown_key: a request of `A` has no key `keep` (it may have level, data)\n"},
           Case{"[{request: {A: [1, x]}}]",
                "2:23 `[1, x]` wrong_node_kind: `A`: expected a mapping, found a list (write `A: {data: [1, x]}`)\n"},
           Case{"[{enable: Walk}]",
                "2:18 `Walk` wrong_node_kind: `enable`: expected a provider such as Walk.halting, found "
                "`Walk` (if it has no `providers`, the only one is called `Walk.default`)\n"},
           Case{"[{advance: soon}]",
                "2:19 `soon` wrong_node_kind: `advance`: expected a duration such as 10 ms, found `soon` "
                "(a whole number and one of us, ms, s, min)\n"},
           Case{"[{inputs: [{advance: 1 s}, {request: A, set: {B: c}}]}]",
                "2:20 `advance` unknown_key: an input has no key `advance` (time passes in a step of its own: "
                "`- advance: 100 ms`)\n"
                "2:48 `set` exclusive_keys: `request` and `set` exclude each other (make two entries of them)\n"
                "  2:36 `request` `request` stands here\n"},
           Case{"[{advance: 1 s, request: A}]",
                "2:24 `request` exclusive_keys: `advance` and `request` exclude each other (make two steps of them)\n"
                "  2:10 `advance` `advance` stands here\n"},
           Case{"[{advance: 1 s, inputs: [{cancel: A}]}]",
                "2:24 `inputs` exclusive_keys: `advance` and `inputs` exclude each other (make two steps of them)\n"
                "  2:10 `advance` `advance` stands here\n"},
           Case{"[{inputs: [{cancel: A}], request: A}]",
                "2:33 `request` exclusive_keys: `inputs` and `request` exclude each other (make two steps of them, or "
                "write `request` as an entry of `inputs`)\n"
                "  2:10 `inputs` `inputs` stands here\n"},
           Case{"[{inputs: [{request: A, expect: b}]}]",
                "2:32 `expect` unknown_key: an input has no key `expect` (what should happen stands in `expect`, "
                "beside `inputs`)\n"},
           Case{"[{cancel: A, expect: [b]}]",
                "2:29 `[b]` wrong_node_kind: `expect`: expected a text with one event a line, found a list "
                "(write `expect: |`, and below it each event in a line without a dash)\n"},
           Case{"[{set: B == 5}]", "2:15 `B == 5` wrong_node_kind: `set`: expected a mapping of states to values, "
                                   "found `B == 5` (write `{B: 5}`)\n"},
           Case{"[{set: [B = near]}]", "2:15 `[B = near]` wrong_node_kind: `set`: expected a mapping of states to "
                                       "values, found a list (write `{B: near}`)\n"},
           Case{"[{set: [B == 5, C = -1]}, {set: 'B == 5, C == near and D == far'}]",
                "2:15 `[B == 5, C = -1]` wrong_node_kind: `set`: expected a mapping of states to values, found a list "
                "(write `{B: 5, C: -1}`)\n"
                "2:40 `'B == 5, C == near and D == far'` wrong_node_kind: `set`: expected a mapping of states to "
                "values, found the text `B == 5, C == near and D == far` (write `{B: 5, C: near, D: far}`)\n"},
           Case{"[{set: 'B == '}, {set: B >= 5}, {set: B == 5 or C == 5}]",
                "2:15 `'B == '` wrong_node_kind: `set`: expected a mapping of states to values, found the text `B == ` "
                "(each state gets one value: `{Ball: near}`)\n"
                "2:31 `B >= 5` wrong_node_kind: `set`: expected a mapping of states to values, found `B >= 5` (each "
                "state gets one value: `{Ball: near}`)\n"
                "2:46 `B == 5 or C == 5` wrong_node_kind: `set`: expected a mapping of states to values, found `B == 5 "
                "or C == 5` (each state gets one value: `{Ball: near}`)\n"},
           Case{"[{disable: [A.default]}]",
                "2:19 `[A.default]` wrong_node_kind: `disable`: expected a provider such as Walk.halting, found a list "
                "(an input has one: write `disable: A.default`)\n"},
           Case{"[{trigger: [A, B]}]",
                "2:19 `[A, B]` wrong_node_kind: `trigger`: expected the name of a trigger, found "
                "a list (an input has one: for several at once write `inputs: [{trigger: A}, "
                "{trigger: ...}]`)\n"},
           Case{"[{set: A}]", "2:15 `A` wrong_node_kind: `set`: expected a mapping of states to values, found `A`\n"},
           Case{"[{cancel: [A]}]",
                "2:18 `[A]` wrong_node_kind: `cancel`: expected a root, found a list (an input has one: write `cancel: "
                "A`)\n"},
       }) {
    CAPTURE(c.text);
    CHECK(steps_findings(c.text) == c.findings);
  }
}

TEST_CASE("Every scenario of this project is read without a finding") {
  std::size_t count = 0;
  for (const char* folder : {"behaviours", "tests/conformance"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (!entry.path().string().ends_with(".scenario.yaml")) continue;
      DiskFiles disk;
      Sources sources;
      CHECK(findings_text(read_scenario(entry.path().string(), disk, sources).diagnostics, sources) == "");
      ++count;
    }
  }
  CHECK(count > 0);
}

TEST_CASE("A file of the other kind is recognised by its keys, and its other keys are not reported") {
  CHECK(read_scenario_body("language: 1\ngroups: {}\n").findings() ==
        "2:1 `language` unknown_key: a scenario file has no key `language` (this belongs to a behaviour file, which "
        "`directorc check` reads)\n");
  CHECK(read_text("scenario: it walks\nbehaviour: ../walker.yaml\ngiven: {}\nsteps: []\n").findings() ==
        "1:1 `scenario` unknown_key: a behaviour file has no key `scenario` (this belongs to a scenario, which "
        "`directorc test` and `directorc simulate` play)\n");
}

TEST_CASE("In a file that is of its own kind, each key of the other kind is reported") {
  CHECK(read_scenario_body("steps: []\nlanguage: 1\ngroups: {}\n").findings() ==
        "3:1 `language` unknown_key: a scenario file has no key `language` (this belongs to a behaviour file, which "
        "`directorc check` reads)\n"
        "4:1 `groups` unknown_key: a scenario file has no key `groups` (this belongs to a behaviour file, which "
        "`directorc check` reads)\n");
  CHECK(read_body("steps: []\n").findings() ==
        "3:1 `steps` unknown_key: a behaviour file has no key `steps` (this belongs to a scenario, which `directorc "
        "test` and `directorc simulate` play)\n");
}
