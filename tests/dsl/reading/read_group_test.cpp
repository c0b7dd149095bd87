// SPDX-License-Identifier: MIT
// Tests dsl/reading/read_group.hpp.
#include "dsl/reading/read_condition.hpp"
#include "dsl/reading/read_group.hpp"
#include "tests/dsl/reading/reading.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

namespace {

Read with_group(const std::string& words) { return read_body("groups:\n  Walk: " + words + "\n"); }

std::vector<std::string> values(const std::vector<Word>& words) {
  std::vector<std::string> out;
  for (const Word& word : words) out.push_back(word.value);
  return out;
}

using Names = std::vector<std::string>;

} // namespace

TEST_CASE("A group's words are read, and what a provider has") {
  const Read read = read_body(R"(groups:
  Walk:
    doc: Steps.
    layer: skill
    module: locomotion
    data: soccer::WalkCommand
    realtime: true
    start: true
    stop: {sets: [Stability == unknown]}
    uses: [LeftLeg]
    sets: [Step]
    triggers: [Tick]
    allow: [unused_use]
    because: It is so.
    providers:
      - name: walking
        doc: On and on.
        when: [Charge > 3]
        stay: [Charge > 1]
        needs: [LeftLeg, RightLeg]
        sets: [Stability == unstable]
        triggers: [Sensors, Walk.halting.broken]
        every: 10 ms
        uses: [RightLeg]
        tasks: [LeftLeg]
        allow: [unused_need]
        because: It is kept still.
      - name: halting
        causing: [Stability == standing within 2 s]
        packs: {all: [LeftLeg]}
)");
  REQUIRE(read.findings() == "");
  const GroupSpec& walk = read.file().groups.at(0);
  CHECK(read.text(walk.name.span) == "Walk");
  CHECK(read.text(walk.span).starts_with("Walk:\n    doc: Steps."));
  CHECK(read.text(walk.span).ends_with("packs: {all: [LeftLeg]}"));
  CHECK(walk.doc->value == "Steps.");
  CHECK(walk.layer->value == "skill");
  CHECK(walk.module->value == "locomotion");
  CHECK(walk.data->value == "soccer::WalkCommand");
  CHECK(walk.realtime.value);
  REQUIRE(walk.start);
  CHECK(walk.start->sets.empty());
  CHECK(read.text(walk.start->span) == "true");
  REQUIRE(walk.stop);
  CHECK(to_text(walk.stop->sets.at(0)) == "Stability == unknown");
  CHECK(values(walk.uses) == Names{"LeftLeg"});
  CHECK(to_text(walk.sets.at(0)) == "Step");
  CHECK(values(walk.triggers) == Names{"Tick"});
  CHECK(walk.allow.at(0).id.value == "unused_use");
  REQUIRE(walk.providers.size() == 2);
  const ProviderSpec &walking = walk.providers[0], &halting = walk.providers[1];
  CHECK(walking.name.value == "walking");
  CHECK_FALSE(walking.direct);
  CHECK(read.text(walking.span).starts_with("name: walking"));
  CHECK(read.text(walking.span).ends_with("because: It is kept still."));
  CHECK(walking.doc->value == "On and on.");
  CHECK(to_text(walking.when.at(0)) == "Charge > 3");
  CHECK(to_text(walking.stay.at(0)) == "Charge > 1");
  CHECK(values(walking.needs) == Names{"LeftLeg", "RightLeg"});
  CHECK(to_text(walking.sets.at(0)) == "Stability == unstable");
  CHECK(values(walking.triggers) == Names{"Sensors", "Walk.halting.broken"});
  CHECK(walking.every->value.microseconds() == 10'000);
  CHECK(values(walking.uses) == Names{"RightLeg"});
  CHECK(walking.tasks->at(0).name.value == "LeftLeg");
  CHECK(walking.allow.at(0).because->value == "It is kept still.");
  CHECK(to_text(halting.causing.at(0)) == "Stability == standing within 2 s");
  CHECK(halting.packs->at(0).name.value == "all");
}

TEST_CASE("A group with one provider writes its words directly") {
  const Read read = with_group("{when: [A == b], uses: [Legs], sets: [A], triggers: [T], doc: Text.}");
  REQUIRE(read.findings() == "");
  const GroupSpec& walk = read.file().groups.at(0);
  CHECK(walk.doc->value == "Text.");
  CHECK(walk.uses.empty());
  CHECK(walk.sets.empty());
  CHECK(walk.triggers.empty());
  REQUIRE(walk.providers.size() == 1);
  const ProviderSpec& only = walk.providers[0];
  CHECK(only.direct);
  CHECK(only.name.value == "default");
  CHECK(read.text(only.name.span) == "Walk");
  CHECK(only.when.size() + only.uses.size() + only.sets.size() + only.triggers.size() == 4);
  CHECK_FALSE(only.doc);
}

TEST_CASE("A group without any words has a provider without any") {
  const Read read = with_group("{}");
  CHECK(read.findings() == "");
  CHECK(read.file().groups.at(0).providers.at(0).direct);
  CHECK(with_group("{providers: []}").file().groups.at(0).providers.empty());
}

TEST_CASE("What is wrong in a group is reported at its place") {
  for (const Case& c : {
           Case{"", "4:3 `Walk` wrong_node_kind: `Walk`: expected a mapping, found nothing (an empty one is `{}`)\n"},
           Case{"null",
                "4:9 `null` wrong_node_kind: `Walk`: expected a mapping, found nothing (an empty one is `{}`)\n"},
           Case{"[walking]", "4:9 `[walking]` wrong_node_kind: `Walk`: expected a mapping, found a list (what it "
                             "requests stands in `tasks`, what it must control in `needs`: `Walk: {tasks: [...]}`)\n"},
           Case{
               "{need: [Legs], nme: x}",
               "4:10 `need` unknown_key: group `Walk` has no key `need` (did you mean `needs`?)\n"
               "4:24 `nme` unknown_key: group `Walk` has no key `nme` (it may have doc, layer, module, data, realtime, "
               "start, stop, providers, when, stay, causing, sets, needs, uses, triggers, every, tasks, packs, allow, "
               "because)\n"},
           Case{"{needs: Legs}",
                "4:17 `Legs` wrong_node_kind: `needs`: expected a list, found `Legs` (write `[Legs]`)\n"},
           Case{"{needs: [[Legs], {a: b}, ~, \"\"]}",
                "4:18 `[Legs]` wrong_node_kind: `needs`: expected the name of a group, found a list\n"
                "4:26 `{a: b}` wrong_node_kind: `needs`: expected the name of a group, found a mapping\n"
                "4:34 `~` wrong_node_kind: `needs`: expected the name of a group, found nothing\n"
                "4:37 `\"\"` wrong_node_kind: `needs`: expected the name of a group, found the text ``\n"},
           Case{"{doc: [a], realtime: 1, data: {}}",
                "4:15 `[a]` wrong_node_kind: `doc`: expected a text, found a list\n"
                "4:30 `1` wrong_node_kind: `realtime`: expected true or false, found `1` (write `true`, without "
                "quotes)\n"
                "4:39 `{}` wrong_node_kind: `data`: expected a C++ type, found a mapping\n"},
           Case{"{tasks: [A], packs: {b: [B]}}", "4:22 `packs` exclusive_keys: `tasks` and `packs` exclude each other "
                                                 "(make one of the packs of the tasks)\n"
                                                 "  4:10 `tasks` `tasks` stands here\n"},
           Case{"{when: [A == b], providers: [{name: x}], every: 1 s}",
                "4:26 `providers` exclusive_keys: `when` and `providers` exclude each other (move `when` into the "
                "providers that it is meant for)\n"
                "  4:10 `when` `when` stands here\n"
                "4:50 `every` exclusive_keys: `providers` and `every` exclude each other (move `every` into the "
                "providers that it is meant for)\n"
                "  4:26 `providers` `providers` stands here\n"},
           Case{"{providers: {walking: {}}}",
                "4:21 `{walking: {}}` wrong_node_kind: `providers`: expected a list of providers, found a mapping "
                "(their order "
                "is that of preference: write `- name: walking`, and its other words below)\n"},
           Case{"{providers: [walking, {needs: [Legs]}, {}]}",
                "4:22 `walking` wrong_node_kind: `providers`: expected "
                "a mapping such as {name: walking}, found `walking` (write `{name: walking}`)\n"
                "4:32 `needs` missing_key: a provider needs `name` (for example `name: walking`)\n"
                "4:48 `{}` missing_key: a provider needs `name` (for example `name: walking`)\n"},
           Case{"{providers: [{nmae: walking}, {name: halting, layer: skill}]}",
                "4:23 `nmae` unknown_key: a provider has no key `nmae` (did you mean `name`?)\n"
                "4:55 `layer` unknown_key: provider `halting` has no key `layer` (it may have name, when, stay, "
                "causing, "
                "sets, needs, uses, triggers, every, tasks, packs, doc, allow, because)\n"},
           Case{"{every: 10}",
                "4:17 `10` wrong_node_kind: `every`: expected a duration such as 10 ms, found `10` (a whole "
                "number and one of us, ms, s, min)\n"},
           Case{"{every: [1 s]}", "4:17 `[1 s]` wrong_node_kind: `every`: expected a duration such as 10 ms, found a "
                                  "list (a whole number and one of us, ms, s, min)\n"},
           Case{"{every: 0 ms}", "4:17 `0 ms` wrong_node_kind: `every`: expected a duration above 0, found `0 ms`\n"},
           Case{"{needs: [yes, \"no\", On]}",
                "4:18 `yes` warning yaml_word_trap: older YAML tools read a bare `yes` as a boolean (write \"yes\", or "
                "choose another word)\n"
                "4:29 `On` warning yaml_word_trap: older YAML tools read a bare `On` as a boolean (write \"On\", or "
                "choose "
                "another word)\n"},
       }) {
    CAPTURE(c.text);
    CHECK(with_group(c.text).findings() == c.findings);
  }
}

TEST_CASE("A handler is true, or a mapping with its sets alone") {
  for (const Case& c : {
           Case{"{start: false}",
                "4:17 `false` start_stop_shape: `start`: expected true or a mapping with `sets` alone, "
                "found `false` (a group without one leaves it out)\n"},
           Case{"{stop: no}", "4:16 `no` start_stop_shape: `stop`: expected true or a mapping with `sets` alone, "
                              "found `no` (a group without one leaves it out)\n"},
           Case{"{stop: \"true\"}",
                "4:16 `\"true\"` start_stop_shape: `stop`: expected true or a mapping with `sets` alone, "
                "found the text `true` (write `stop: true`, or what it may set: `stop: {sets: [Pose == standing]}`)\n"},
           Case{"{start: {set: [A]}}",
                "4:18 `set` start_stop_shape: `start`: expected true or a mapping with `sets` alone, found `set` "
                "(a handler requests nothing and promises nothing: what it may set stands in its `sets`)\n"},
           Case{"{start: {}}",
                "4:17 `{}` start_stop_shape: `start`: expected true or a mapping with `sets` alone, found a "
                "mapping (write `start: true`, or what it may set: `start: {sets: [Pose == standing]}`)\n"},
           Case{"{stop: {sets: [A], needs: [B]}}",
                "4:28 `needs` start_stop_shape: `stop`: expected true or a mapping with `sets` alone, found `needs` "
                "(a handler requests nothing and promises nothing: what it may set stands in its `sets`)\n"},
           Case{"{stop: }", "4:10 `stop` start_stop_shape: `stop`: expected true or a mapping with `sets` alone, found "
                            "nothing (write `stop: true`, or what it may set: `stop: {sets: [Pose == standing]}`)\n"},
           Case{"{stop: {sets: [A =]}}",
                "4:26 `=` bad_condition: expected one of ==, !=, <, <=, >, >= behind `A`, found "
                "`=` (write `==`)\n"},
       }) {
    CAPTURE(c.text);
    CHECK(with_group(c.text).findings() == c.findings);
  }
}

TEST_CASE("A group of another file gets more providers") {
  const Read read =
      read_body("extend:\n  GetUp:\n    doc: Faster.\n    before: slowly\n    providers: [{name: quickly}]\n");
  REQUIRE(read.findings() == "");
  const ExtendSpec& extend = read.file().extend.at(0);
  CHECK(extend.group.value == "GetUp");
  CHECK(extend.before->value == "slowly");
  CHECK(extend.doc->value == "Faster.");
  CHECK(extend.providers.at(0).name.value == "quickly");
  CHECK(read.text(extend.span).starts_with("GetUp:\n    doc"));
  CHECK(read_body("extend: {GetUp: {after: slowly}, Kick: 3}\n").findings() ==
        "3:10 `GetUp` missing_key: extend of `GetUp` needs `providers` (for example `providers: [{name: quickly}]`)\n"
        "3:18 `after` unknown_key: extend of `GetUp` has no key `after` (it may have before, providers, doc)\n"
        "3:40 `3` wrong_node_kind: `Kick`: expected a mapping, found `3`\n");
}
