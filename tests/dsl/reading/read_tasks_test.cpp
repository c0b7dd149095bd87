// SPDX-License-Identifier: MIT
// Tests dsl/reading/read_tasks.hpp.
#include "dsl/reading/read_tasks.hpp"
#include "tests/dsl/reading/reading.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace director::dsl;

namespace {

/// `Legs 10 optional; Kick normal:10 urgent:80`.
std::string in_words(const std::vector<TaskSpec>& tasks) {
  std::string out;
  for (const TaskSpec& task : tasks) {
    out += (out.empty() ? "" : "; ") + task.name.value;
    for (const LevelSpec& level : task.levels)
      out += fmt::format(" {}{}{}{}{}", level.name.value, level.name.value.empty() ? "" : ":", level.priority.value,
                         level.optional.value ? " optional" : "", level.apart.value ? " apart" : "");
  }
  return out;
}

Read with_roots(const std::string& roots) { return read_body("roots: " + roots + "\n"); }

TEST_CASE("of a task that is called optional and apart, optional counts") {
  const Read read = with_roots("{Walk: {optional: true, apart: true}}");
  REQUIRE(read.file().roots);
  CHECK(in_words(*read.file().roots) == "Walk 0 optional");
}

} // namespace

TEST_CASE("Tasks are a list, or a mapping where defaults do not serve") {
  struct Row {
    const char* written;
    const char* words;
  };
  for (const Row& row :
       {Row{"[]", ""}, Row{"{}", ""}, Row{"[Legs, Kick]", "Legs 0; Kick 0"},
        Row{"{Legs: {}, Kick: {}}", "Legs 0; Kick 0"}, Row{"{Legs: {priority: -2147483648}}", "Legs -2147483648"},
        Row{"{Legs: {optional: true, priority: 2147483647}, Kick: {apart: true}}",
            "Legs 2147483647 optional; Kick 0 apart"},
        Row{"{Kick: {priority: {normal: 10, urgent: 80}}}", "Kick normal:10 urgent:80"},
        Row{"{Kick: {priority: {normal: 10, urgent: 80}, optional: true}}",
            "Kick normal:10 optional urgent:80 optional"},
        Row{"{Kick: {levels: {firm: {priority: 50}, spare: {priority: 5, optional: true}, beside: {apart: true}}}}",
            "Kick firm:50 spare:5 optional beside:0 apart"}}) {
    CAPTURE(row.written);
    const Read read = with_roots(row.written);
    CHECK(read.findings() == "");
    REQUIRE(read.file().roots);
    CHECK(in_words(*read.file().roots) == row.words);
  }
  CHECK_FALSE(read_body("").file().roots);
}

TEST_CASE("A task, its name and its words have their places") {
  const Read read = with_roots("{Kick: {doc: Hard, priority: 3}, Walk: {levels: {firm: {priority: 2}}}}");
  REQUIRE(read.findings() == "");
  const TaskSpec &kick = read.file().roots->at(0), &walk = read.file().roots->at(1);
  CHECK(read.text(kick.span) == "Kick: {doc: Hard, priority: 3}");
  CHECK(read.text(kick.name.span) == "Kick");
  CHECK(read.text(kick.levels[0].priority.span) == "3");
  CHECK(read.text(kick.levels[0].optional.span) == "Kick");
  CHECK(kick.doc->value == "Hard");
  CHECK(read.text(walk.levels[0].name.span) == "firm");
  CHECK(read.text(walk.levels[0].priority.span) == "2");
}

TEST_CASE("What is wrong in a task is reported at its place") {
  for (
      const Case& c : {
          Case{"Walk",
               "3:8 `Walk` wrong_node_kind: `roots`: expected a list of groups or a mapping, found `Walk` (write "
               "`[Walk]`)\n"},
          Case{"{Walk: }",
               "3:9 `Walk` wrong_node_kind: `Walk`: expected a mapping, found nothing (an empty one is `{}`)\n"},
          Case{"[Walk: {priority: 3}]",
               "3:9 `Walk: {priority: 3}` wrong_node_kind: `roots`: expected the name of a group, found a mapping "
               "(where a "
               "task has words of its own, all are a mapping: {Legs: {}, Head: {optional: true}})\n"},
          Case{"{Walk: 3}",
               "3:15 `3` wrong_node_kind: `Walk`: expected a mapping, found `3` (write `Walk: {priority: 3}`)\n"},
          Case{"{Walk: {speed: 3}}", "3:16 `speed` unknown_key: task `Walk` has no key `speed` (it may have priority, "
                                     "optional, apart, levels, "
                                     "doc, allow, because)\n"},
          Case{"{Walk: {priorty: 3}}",
               "3:16 `priorty` unknown_key: task `Walk` has no key `priorty` (did you mean `priority`?)\n"},
          Case{"{Walk: {priority: high}}",
               "3:26 `high` wrong_node_kind: `priority`: expected a whole number from -2147483648 to 2147483647, found "
               "`high`\n"},
          Case{"{Walk: {priority: 2147483648}}",
               "3:26 `2147483648` wrong_node_kind: `priority`: expected a whole number from -2147483648 to 2147483647, "
               "found `2147483648`\n"},
          Case{
              "{Walk: {priority: \"3\"}}",
              "3:26 `\"3\"` wrong_node_kind: `priority`: expected a whole number from -2147483648 to 2147483647, found "
              "the text `3` (write it without quotes)\n"},
          Case{"{Walk: {priority: 010}}",
               "3:26 `010` wrong_node_kind: `priority`: expected a whole number from -2147483648 to 2147483647, found "
               "`010` (write `10`, without leading zeros: older YAML tools read those as octal)\n"},
          Case{"{Walk: {priority: {}}}", "3:26 `{}` wrong_node_kind: `priority`: expected at least one level, found "
                                         "none (for example `{normal: 10, urgent: 80}`)\n"},
          Case{"{Walk: {optional: yes}}", "3:26 `yes` wrong_node_kind: `optional`: expected true or false, found `yes` "
                                          "(write `true`, without quotes)\n"},
          Case{"{Walk: {optional: \"true\"}}", "3:26 `\"true\"` wrong_node_kind: `optional`: expected true or false, "
                                               "found the text `true` (write `true`, without quotes)\n"},
          Case{"{Walk: {optional: true, apart: true}}",
               "3:32 `apart` exclusive_keys: `optional` and `apart` exclude each other (leave out `apart`: what is "
               "optional waits for itself alone anyway)\n"
               "  3:16 `optional` `optional` stands here\n"},
          Case{"{Walk: {priority: 3, levels: {a: {}}, optional: false}}",
               "3:29 `levels` exclusive_keys: `priority` and `levels` exclude each other (say `priority` in each of "
               "the levels)\n"
               "  3:16 `priority` `priority` stands here\n"
               "3:46 `optional` exclusive_keys: `levels` and `optional` exclude each other (say `optional` in each of "
               "the levels)\n"
               "  3:29 `levels` `levels` stands here\n"},
          Case{"{Walk: {levels: {firm: 3, spare: {optional: true, apart: true}}}}",
               "3:31 `3` wrong_node_kind: `firm`: expected a mapping, found `3` (write `firm: {priority: 3}`)\n"
               "3:58 `apart` exclusive_keys: `optional` and `apart` exclude each other (leave out `apart`: what is "
               "optional waits for itself alone anyway)\n"
               "  3:42 `optional` `optional` stands here\n"},
          Case{"[yes, \"no\", [Walk]]",
               "3:9 `yes` warning yaml_word_trap: older YAML tools read a bare `yes` as a boolean (write \"yes\", or "
               "choose "
               "another word)\n"
               "3:20 `[Walk]` wrong_node_kind: `roots`: expected the name of a group, found a list\n"},
      }) {
    CAPTURE(c.text);
    CHECK(with_roots(c.text).findings() == c.findings);
  }
}

TEST_CASE("`optional` and `apart` may be together if one of them is false") {
  CHECK(with_roots("{Walk: {optional: true, apart: false}}").findings() == "");
}

TEST_CASE("What is allowed needs a reason, and is allowed all the same") {
  const Read read = with_roots("{Walk: {allow: [equal_priority, starved_task], because: A tie is wanted.}}");
  CHECK(read.findings() == "");
  const auto& allow = read.file().roots->at(0).allow;
  REQUIRE(allow.size() == 2);
  CHECK(allow[1].id.value == "starved_task");
  CHECK(read.text(allow[1].id.span) == "starved_task");
  CHECK(allow[1].because->value == "A tie is wanted.");
  const Read silent = with_roots("{Walk: {allow: [equal_priority]}, Kick: {because: Of it.}}");
  CHECK(silent.findings() ==
        "3:16 `allow` missing_key: `allow` needs `because` (say why it is wanted: `because: ...`)\n"
        "3:49 `because` missing_key: `because` needs `allow` (say which check it is about, `allow: [...]`, or write it "
        "as `doc`)\n");
  CHECK(silent.file().roots->at(0).allow.size() == 1);
  for (const std::string empty : {"", " "})
    CHECK(with_roots("{Walk: {allow: [equal_priority], because: \"" + empty + "\"}}").findings() ==
          "3:50 `\"" + empty + "\"` wrong_node_kind: `because`: expected a reason, found the text `" + empty +
              "` (say why it is wanted: `because: ...`)\n");
}

TEST_CASE("Packs are lists or mappings of tasks by name") {
  const Read read = read_body("groups:\n  G:\n    packs:\n      attack: {Kick: {priority: 2}, Look: {optional: true}}\n"
                              "      search: [Turn]\n      rest: {}\n      none: []\n");
  REQUIRE(read.findings() == "");
  const auto& packs = *read.file().groups[0].providers[0].packs;
  REQUIRE(packs.size() == 4);
  CHECK(packs[0].name.value == "attack");
  CHECK(in_words(packs[0].tasks) == "Kick 2; Look 0 optional");
  CHECK(in_words(packs[1].tasks) == "Turn 0");
  CHECK(packs[2].tasks.empty());
  CHECK(packs[3].tasks.empty());
  CHECK(read.text(packs[1].span) == "search: [Turn]");
  CHECK(
      read_body("groups:\n  G: {packs: [a], when: []}\n").findings() ==
      "4:14 `[a]` wrong_node_kind: `packs`: expected a mapping of names to tasks, found a list (give each pack a name: "
      "`packs: {attack: [Kick, Walk]}`)\n");
  CHECK(read_body("groups:\n  G: {packs: {rest: }}\n").findings() ==
        "4:15 `rest` wrong_node_kind: `rest`: expected a list of groups or a mapping, found nothing (an empty one is "
        "`[]`)\n");
  CHECK(read_body("groups:\n  G: {packs: {}}\n").findings() ==
        "4:14 `{}` missing_key: `packs` needs a pack (each run requests one of them, whole: for example `{attack: [Kick, "
        "Walk]}`; or leave `packs` out)\n");
}
