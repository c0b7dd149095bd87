// SPDX-License-Identifier: MIT
#include "compiler/reference/explain_key.hpp"
#include "tests/compiler/cli/world.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace {

using director::tests::World;

World lamp(const std::string& expect) {
  World world;
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups:\n  Lamp: {}\n");
  world.files.add("bulb.yaml", "behaviour: bulb\nlanguage: 1\ngroups:\n  Bulb: {}\n");
  world.files.add("s.yaml",
                  "scenario: it shines\nbehaviour: lamp.yaml\nsteps:\n  - request: Lamp\n    expect: " + expect + "\n");
  return world;
}

TEST_CASE("a scenario is played as text and as JSON") {
  World world = lamp("run Lamp new_task");
  CHECK(world.directorc({"simulate", "s.yaml"}) == 0);
  CHECK(world.out == "> request Lamp\nrun Lamp new_task\n");
  CHECK(world.directorc({"simulate", "--format=json", "s.yaml"}) == 0);
  CHECK(world.out == "{\"step\":1,\"event\":\"input\",\"input\":\"request Lamp\"}\n"
                     "{\"step\":1,\"event\":\"run\",\"group\":\"Lamp\",\"provider\":\"default\","
                     "\"reasons\":[\"new_task\"]}\n");
}

TEST_CASE("scenarios that hold and that do not") {
  World world = lamp("run Lamp new_task");
  CHECK(world.directorc({"test", "s.yaml", "s.yaml"}) == 0);
  CHECK(world.out == "holds s.yaml: it shines\nholds s.yaml: it shines\n2 of 2 hold\n");
  World other = lamp("run Lamp pushed");
  CHECK(other.directorc({"test", "s.yaml"}) == 1);
  CHECK(other.out.substr(0, 24) == "fails s.yaml: it shines\n");
}

TEST_CASE("on a terminal what runs is blue, what waits red, and what differs red and green") {
  World world = lamp("run Lamp pushed");
  world.colours = true;
  world.files.add("lamp.yaml", R"(behaviour: lamp
language: 1
states: {Power: {values: [gone, there], initial: gone, external: true}}
roots: [Lamp]
groups: {Lamp: {when: [Power == there]}}
)");
  world.files.add("waits.yaml", "behaviour: lamp.yaml\nsteps: [{request: Lamp}, {set: {Power: there}}]\n");
  CHECK(world.directorc({"simulate", "--decisions", "waits.yaml"}) == 0);
  CHECK(world.out == "\033[1m> request Lamp\033[0m\n"
                     "\033[31mqueue root>Lamp: waiting for Power == there\033[0m\n"
                     "\033[1m> set {Power: there}\033[0m\n"
                     "\033[34mrun Lamp new_task\033[0m\n");
  CHECK(world.directorc({"test", "s.yaml"}) == 1);
  CHECK(world.out == "\033[1;31mfails\033[0m s.yaml: it shines\n"
                     "\033[1ms.yaml:5:13: step 1: request Lamp\033[0m\n"
                     "    \033[1m--- expected\033[0m\n"
                     "    \033[1m+++ happened\033[0m\n"
                     "    \033[36m@@ -1 +0,0 @@\033[0m\n"
                     "    \033[31m-run Lamp pushed\033[0m\n");
}

TEST_CASE("unreadable: a scenario, one with an unreadable behaviour, and one of a module") {
  World world = lamp("''");
  CHECK(world.directorc({"test", "none.yaml"}) == 2);
  CHECK(world.err == "directorc: cannot read `none.yaml`: No such file or directory\n");
  world.files.add("s.yaml", "behaviour: dark.yaml\nsteps: []\n");
  CHECK(world.directorc({"simulate", "s.yaml"}) == 1);
  CHECK(world.err == "s.yaml:1:12: error: cannot read `dark.yaml`: No such file or directory [import_not_found]\n"
                     "    1 | behaviour: dark.yaml\n      |            ^~~~~~~~~\n"
                     "  help: a path is relative to the file that it stands in\n1 error\n");
  world.files.add("s.yaml", "behaviour: bulb.yaml\nsteps: []\n");
  CHECK(world.directorc({"simulate", "s.yaml"}) == 1);
  CHECK(world.err.find("s.yaml:1:12: error: `bulb.yaml` has no `roots`") == 0);
}

TEST_CASE("an error of a file that several scenarios share is reported once") {
  World world;
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nroots: [Lamp, Bulb]\ngroups: {Lamp: {}}\n");
  for (const char* name : {"a.yaml", "b.yaml", "c.yaml"})
    world.files.add(name, "behaviour: lamp.yaml\nsteps: [{request: Lamp}]\n");
  CHECK(world.directorc({"test", "a.yaml"}) == 1);
  const std::string once = world.err;
  CHECK(once.starts_with("lamp.yaml:3:15: error: "));
  CHECK(world.directorc({"test", "a.yaml", "b.yaml", "c.yaml"}) == 1);
  CHECK(world.err == once + "directorc: `b.yaml` cannot be played either: 1 error is printed above\n"
                            "directorc: `c.yaml` cannot be played either: 1 error is printed above\n");
  CHECK(world.out == "0 of 3 hold\n");
  // One of its own, and two tests one after another.
  world.files.add("b.yaml", "behaviour: lamp.yaml\nsteps: [{reqest: Lamp}]\n");
  CHECK(world.directorc({"test", "a.yaml", "b.yaml", "c.yaml"}) == 1);
  CHECK(world.err.find("b.yaml:2:") != std::string::npos);
  CHECK(world.err.ends_with("directorc: `c.yaml` cannot be played either: 1 error is printed above\n"));
}

TEST_CASE("every stage can be printed") {
  World world = lamp("''");
  for (const std::string stage : {"spec", "model", "graph", "tables"}) {
    CHECK(world.directorc({"dump", "--stage=" + stage, "lamp.yaml"}) == 0);
    CHECK(world.out.find("Lamp") != std::string::npos);
  }
  CHECK(world.directorc({"dump", "--stage=tables", "bulb.yaml"}) == 2);
  CHECK(world.err == "directorc: `bulb.yaml` has no `roots`: a module alone has no tables\n");
}

TEST_CASE("a step that is not played, because the engine does not come to rest before, has no moment") {
  World world;
  world.files.add("busy.yaml",
                  "behaviour: busy\nlanguage: 1\nroots: [Busy]\ngroups:\n  Busy: {tasks: [Part], every: 1 us}\n"
                  "  Part: {}\n");
  world.files.add("b.scenario.yaml", "behaviour: busy.yaml\nscript: {Part: {done: true}}\n"
                                     "steps: [request: Busy, cancel: Busy]\n");
  const std::string ends =
      "directorc: `b.scenario.yaml` ends in step 1: the engine does not come to rest: Busy, Part run again and again; "
      "a case with `reason: subtask_done` in the script says what Busy answers when one of its tasks is done\n";
  CHECK(world.directorc({"simulate", "b.scenario.yaml"}) == 1);
  CHECK(world.out.ends_with("\nbudget_exhausted\n"));
  CHECK(world.err == ends);
  world.files.add("c.scenario.yaml", "behaviour: busy.yaml\nsteps: [request: Busy]\nscript:\n  Part: {done: true}\n"
                                     "  Busy: [{reason: subtask_done, tasks: [Part]}, {tasks: [Part]}]\n");
  CHECK(world.directorc({"simulate", "c.scenario.yaml"}) == 1);
  CHECK(world.err == "directorc: `c.scenario.yaml` ends in step 1: the engine does not come to rest: Busy, Part run "
                     "again and again\n");
  CHECK(world.directorc({"why", "b.scenario.yaml", "Busy", "--step", "2"}) == 1);
  CHECK(world.out.empty());
  CHECK(world.err == ends);
  CHECK(world.directorc({"why", "b.scenario.yaml", "Busy", "--step", "1"}) == 1);
  CHECK(world.out.starts_with("Busy runs (root>Busy)\n"));
  CHECK(world.err == ends);
  CHECK(world.directorc({"graph", "b.scenario.yaml", "--step", "2"}) == 1);
  CHECK(world.out.empty());
  CHECK(world.err == ends);
  CHECK(world.directorc({"graph", "b.scenario.yaml", "--step", "1"}) == 1);
  CHECK(world.out.find("after step 1 (request Busy), at 0 s") != std::string::npos);
  CHECK(world.err == ends);
  CHECK(world.directorc({"graph", "b.scenario.yaml", "--frames", "-o", "frames"}) == 1);
  CHECK(world.outputs.files.count("frames/step_1.dot") == 1);
  CHECK(world.outputs.files.count("frames/step_2.dot") == 0);
  CHECK(world.err == ends);
}

TEST_CASE("the spec of a file with errors is printed, and the exit status says that there are errors") {
  World world;
  world.files.add("twice.yaml", "behaviour: twice\nlanguage: 1\nroots: [Lamp]\ngroups: {Lamp: {need: []}}\n");
  CHECK(world.directorc({"dump", "--stage=spec", "twice.yaml"}) == 1);
  CHECK(world.out.find("Lamp") != std::string::npos);
  CHECK(world.err.ends_with("1 error\n"));
}

TEST_CASE("a check is explained, and all are listed") {
  World world;
  CHECK(world.directorc({"explain", "needs_cycle"}) == 0);
  CHECK(world.out.find("Level: error") != std::string::npos);
  CHECK(world.directorc({"explain", "need_cycle"}) == 2);
  CHECK(world.err == "directorc: there is no check and no key `need_cycle`; did you mean `needs_cycle`?\n");
  CHECK(world.directorc({"explain", "neds"}) == 2);
  CHECK(world.err == "directorc: there is no check and no key `neds`; did you mean `needs`?\n");
  CHECK(world.directorc({"explain", "xylophone"}) == 2);
  CHECK(world.err == fmt::format("directorc: there is no check and no key `xylophone`; `directorc checks` lists all "
                                 "checks; the keys are {}\n",
                                 fmt::join(director::compiler::keys_of(director::compiler::reference()), ", ")));
  CHECK(world.directorc({"explain", "unless"}) == 2);
  CHECK(world.err ==
        "directorc: there is no check and no key `unless`: `when` says what must hold: write the opposite, "
        "such as `when: [Motion != rolling]`\n");
  CHECK(world.directorc({"checks"}) == 0);
  CHECK(world.out.find("needs_cycle ") != std::string::npos);
}

TEST_CASE("a key of the language is explained in the words of its reference") {
  World world;
  CHECK(world.directorc({"explain", "of"}) == 0);
  CHECK(world.out.starts_with("# of\n\n- `of`: the state belongs to that group: nobody else sets it, and it returns to "
                              "`initial` (required) when the group stops (key, under \"States\")\n"));
}

TEST_CASE("times are printed where they are requested, as text and as JSON") {
  World world = lamp("''");
  world.files.add("s.yaml", "behaviour: lamp.yaml\nsteps:\n  - advance: 1500 ms\n  - request: Lamp\n");
  CHECK(world.directorc({"simulate", "--times", "s.yaml"}) == 0);
  CHECK(world.out ==
        "[    0.000000] > advance 1500 ms\n[    1.500000] > request Lamp\n[    1.500000] run Lamp new_task\n");
  CHECK(world.directorc({"simulate", "--times", "--format=json", "s.yaml"}) == 0);
  CHECK(world.out == "{\"step\":1,\"time_us\":0,\"event\":\"input\",\"input\":\"advance 1500 ms\"}\n"
                     "{\"step\":2,\"time_us\":1500000,\"event\":\"input\",\"input\":\"request Lamp\"}\n"
                     "{\"step\":2,\"time_us\":1500000,\"event\":\"run\",\"group\":\"Lamp\",\"provider\":\"default\","
                     "\"reasons\":[\"new_task\"]}\n");
}

TEST_CASE("a scenario that expects nothing holds, and it is reported that nothing is compared") {
  World world = lamp("''");
  world.files.add("s.yaml", "behaviour: lamp.yaml\nsteps:\n  - request: Lamp\n");
  CHECK(world.directorc({"test", "s.yaml"}) == 0);
  CHECK(world.out == "holds s.yaml\n");
  CHECK(world.err ==
        "directorc: `s.yaml` expects nothing, so nothing is compared; `directorc test --update s.yaml` writes "
        "what happens\n");
  world.files.add("a $lamp.yaml", "behaviour: lamp.yaml\nsteps:\n  - request: Lamp\n");
  CHECK(world.directorc({"test", "a $lamp.yaml"}) == 0);
  CHECK(world.err.find("`directorc test --update 'a $lamp.yaml'` writes") != std::string::npos);
}

TEST_CASE("of a scenario that expects nothing and fails only that is reported") {
  World world;
  world.files.add("busy.yaml",
                  "behaviour: busy\nlanguage: 1\nroots: [Busy]\ngroups:\n  Busy: {tasks: [Part], every: 1 us}\n"
                  "  Part: {}\n");
  world.files.add("s.yaml", "behaviour: busy.yaml\nscript: {Part: {done: true}}\nsteps: [request: Busy]\n");
  CHECK(world.directorc({"test", "s.yaml"}) == 1);
  CHECK(world.out.starts_with("fails s.yaml\n"));
  CHECK(world.err == "");
}

TEST_CASE("a scenario without steps tests nothing, and there is nothing to write into it") {
  World world = lamp("''");
  world.files.add("s.yaml", "behaviour: lamp.yaml\nsteps: []\n");
  CHECK(world.directorc({"test", "--update", "s.yaml"}) == 0);
  CHECK(world.err == "directorc: `s.yaml` has no steps, so nothing is tested\n");
  CHECK(world.outputs.written.empty());
}

TEST_CASE("what happens is written into a scenario that is to be updated, and one that holds stays as it is") {
  World world = lamp("run Lamp pushed");
  const std::string text = "scenario: it shines\nbehaviour: lamp.yaml\nsteps:\n  - request: Lamp\n    expect: ";
  world.outputs.files["s.yaml"] = text + "run Lamp pushed\n";
  CHECK(world.directorc({"test", "--update", "s.yaml"}) == 0);
  CHECK(world.out == "wrote s.yaml: it shines\n    what happens in step 1\n");
  CHECK(world.outputs.files["s.yaml"] == text + "|\n      run Lamp new_task\n");
  world.files.add("s.yaml", world.outputs.files["s.yaml"]);
  world.outputs.written.clear();
  CHECK(world.directorc({"test", "--update", "s.yaml"}) == 0);
  CHECK(world.out == "holds s.yaml: it shines\n");
  CHECK(world.outputs.written.empty());
}

TEST_CASE("of many steps that are to be updated, the ranges are named, or the first ones") {
  World world = lamp("''");
  std::string all = "behaviour: lamp.yaml\nsteps:\n", every_second = all;
  for (int i = 1; i <= 50; ++i) {
    all += "  - advance: 1 ms\n";
    every_second += fmt::format("  - {{advance: 1 ms, expect: {}}}\n", i % 2 == 1 ? "run Lamp pushed" : "''");
  }
  world.files.add("s.yaml", all);
  world.outputs.files["s.yaml"] = all;
  CHECK(world.directorc({"test", "--update", "s.yaml"}) == 0);
  CHECK(world.out == "wrote s.yaml\n    what happens in step 1 to 50\n");
  world.files.add("s.yaml", every_second);
  world.outputs.files["s.yaml"] = every_second;
  CHECK(world.directorc({"test", "--update", "s.yaml"}) == 0);
  CHECK(world.out ==
        "wrote s.yaml\n    what happens in step 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31, "
        "33, 35, 37, 39, and 5 more\n");
  const std::string some = "behaviour: lamp.yaml\nsteps:\n  - {advance: 1 ms, expect: x}\n  - {advance: 1 ms, expect: "
                           "x}\n  - {advance: 1 ms, expect: ''}\n  - {advance: 1 ms, expect: x}\n";
  world.files.add("s.yaml", some);
  world.outputs.files["s.yaml"] = some;
  CHECK(world.directorc({"test", "--update", "s.yaml"}) == 0);
  CHECK(world.out == "wrote s.yaml\n    what happens in step 1, 2, 4\n");
}

TEST_CASE("a scenario that cannot be written is reported, and so is one that a body ends") {
  World world = lamp("run Lamp pushed"); // the file on the disk has changed meanwhile
  world.outputs.files["s.yaml"] = "something else\n";
  CHECK(world.directorc({"test", "--update", "s.yaml"}) == 2);
  CHECK(world.err == "directorc: cannot write `s.yaml`: it has changed meanwhile; run this again\n");
}

TEST_CASE("text of a scenario cannot control a terminal") {
  World world = lamp("\"run \\e[31mLamp\"");
  const std::string name = "s\x1B[1m.yaml";
  world.files.add(name, "scenario: \"it \\e[31mshines\\nfails\"\nbehaviour: lamp.yaml\n"
                        "steps:\n  - {request: {Lamp: {data: \"\\e[2J\"}}, expect: \"run \\e[31mLamp\"}\n");
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups:\n  Lamp: {data: int}\n");
  CHECK(world.directorc({"test", name}) == 1);
  CHECK(world.out == R"(fails s\x1B[1m.yaml: it \x1B[31mshines\x0Afails
s\x1B[1m.yaml:4:48: step 1: request {Lamp: {data: "\x1b[2J"}}
    --- expected
    +++ happened
    @@ -1 +1 @@
    -run \x1B[31mLamp
    +run Lamp new_task
)");
  CHECK(world.directorc({"simulate", name}) == 0);
  CHECK(world.out == "> request {Lamp: {data: \"\\x1b[2J\"}}\nrun Lamp new_task\n");
  CHECK(world.directorc({"test", "no\x1B[1m.yaml"}) == 2);
  CHECK(world.err == "directorc: cannot read `no\\x1B[1m.yaml`: No such file or directory\n");
}

TEST_CASE("a folder stands for the scenarios below it") {
  World world = lamp("run Lamp new_task");
  for (const char* path : {"a/s.scenario.yaml", "a/b/t.scenario.yaml"}) {
    world.files.add(path, "behaviour: " + std::string(path[2] == 'b' ? "../../" : "../") +
                              "lamp.yaml\nsteps:\n  - {request: Lamp, expect: run Lamp new_task}\n");
    world.outputs.files[path] = "";
  }
  world.files.add("a/u.scenario.yml",
                  "behaviour: ../lamp.yaml\nsteps:\n  - {request: Lamp, expect: run Lamp new_task}\n");
  world.outputs.files["a/u.scenario.yml"] = "";
  world.outputs.files["a/lamp.yaml"] = "";
  world.outputs.files["c/lamp.yaml"] = "";
  CHECK(world.directorc({"test", "a/", "s.yaml"}) == 0);
  CHECK(world.out == "holds a/b/t.scenario.yaml\nholds a/s.scenario.yaml\nholds a/u.scenario.yml\nholds s.yaml: it "
                     "shines\n4 of 4 hold\n");
  world.outputs.files["a/secret/"] = ""; // as for a folder without permission
  CHECK(world.directorc({"test", "a"}) == 2);
  CHECK(world.out == "holds a/b/t.scenario.yaml\nholds a/s.scenario.yaml\nholds a/u.scenario.yml\n3 of 3 hold\n");
  CHECK(world.err == "directorc: cannot look into `a/secret/`, where scenarios may be\n");
  CHECK(world.directorc({"test", "c"}) == 2);
  CHECK(world.err == "directorc: there is no *.scenario.yaml or *.scenario.yml in `c` or below it\n");
}

} // namespace
