// Header: tests/defects/planter.hpp. Test: itself.
// SPDX-License-Identifier: MIT
//
// What is met when a file is read.
#include "tests/defects/gadgets.hpp"
#include "tests/defects/planter.hpp"

#include <algorithm>

namespace director::defects {

namespace {

std::string any_skill(Robot& robot) {
  std::string out;
  do { out = robot.r.one_of(robot.skills[robot.part()]); } while (robot.group(out).find("providers") != nullptr);
  return out;
}

Node& any_provider(Robot& robot) { return *robot.r.one_of(robot.providers(robot.r.one_of(robot.choosing))); }

// yaml_syntax

/// A new root whose words are, with the defect, what stands in `with`: text, not a document any more.
void edit_new(Robot& robot, const std::string& with, bool defect) {
  const std::string name = robot.verb();
  robot.add_group(name, "{needs: [$0], tasks: [$0]}", {robot.parts[robot.part()]});
  robot.add_root(name, robot.above());
  robot.edits.push_back([=](Texts& texts) {
    for (auto& [path, text] : texts) {
      const std::size_t groups = text.find("\ngroups:");
      const std::size_t at = groups == std::string::npos ? groups : text.find("\n  " + name + ":", groups);
      if (at == std::string::npos) continue;
      if (defect) {
        const std::size_t words = text.find(':', at) + 1;
        std::size_t end = text.find('\n', words); // its words are the lines with a deeper indentation
        while (text.compare(end, 4, "\n   ") == 0) end = text.find('\n', end + 1);
        text.replace(words, end - words, " " + with);
      }
      if (with.find('@') == std::string::npos) text.insert(at + 3, "@");
    }
  });
}

void alias(Robot& robot, bool defect) { edit_new(robot, "*shared", defect); }
void anchor(Robot& robot, bool defect) { edit_new(robot, "&shared {}", defect); }
void tag(Robot& robot, bool defect) { edit_new(robot, "!!map {}", defect); }
void merge(Robot& robot, bool defect) { edit_new(robot, "{<<: {}}", defect); }
void wrong_bracket(Robot& robot, bool defect) { edit_new(robot, "{needs: [}", defect); }
void open_quote(Robot& robot, bool defect) { edit_new(robot, "{doc: \"It goes}", defect); }
void bad_colon(Robot& robot, bool defect) { edit_new(robot, "\n    doc@: Before: after", defect); }
void odd_indent(Robot& robot, bool defect) { edit_new(robot, "{}\n   @Another: {}", defect); }
void tab(Robot& robot, bool defect) { edit_new(robot, "\n@\tneeds: []", defect); }
void second_document(Robot& robot, bool defect) {
  robot.edits.push_back([=, file = robot.files[robot.r.below(robot.files.size())].path](Texts& texts) {
    texts[file] += defect ? "@---\nstates: {}\n" : "@";
  });
}

// duplicate_key

void group_twice(Robot& robot, bool defect) {
  const std::size_t file = robot.r.below(robot.files.size());
  const std::string name = robot.verb();
  Node& groups = robot.section(file, "groups");
  groups.add(name, {});
  groups.add(defect ? "@" + name : "@" + robot.verb(), {});
  robot.add_root(name, robot.above());
}
void word_twice(Robot& robot, bool defect) {
  Node& skill = robot.group(any_skill(robot));
  if (defect) skill.add("@needs", flow("[$0]", {robot.parts[robot.part()]}));
}
void state_word_twice(Robot& robot, bool defect) {
  Node& state = robot.state(robot.sense(SenseKind::plain).name);
  if (defect) state.add("@initial", *state.find("initial"));
}
void section_twice(Robot& robot, bool defect) {
  robot.edits.push_back([=, file = robot.files[robot.r.below(robot.files.size())].path](Texts& texts) {
    texts[file] += defect ? "@groups: {}\n" : "@";
  });
}

// unknown_key

void misspelt_word(Robot& robot, bool defect) {
  Node& skill = robot.group(any_skill(robot));
  const std::string right = robot.r.one_of({"needs", "tasks"});
  for (std::string& key : skill.keys) {
    if (key == right) key = !defect ? "@" + key : right == "needs" ? "@neds" : "@taks";
  }
}
void misspelt_in_provider(Robot& robot, bool defect) {
  Node& provider = any_provider(robot);
  for (std::string& key : provider.keys) {
    if (key == "tasks") key = defect ? "@task" : "@tasks";
  }
}
void word_of_a_group(Robot& robot, bool defect) {
  if (defect) any_provider(robot).add("@layer", "skill");
}
void misspelt_of_state(Robot& robot, bool defect) {
  Node& state = robot.state(robot.sense(SenseKind::plain).name);
  for (std::string& key : state.keys) {
    if (key == "external") key = defect ? "@extrenal" : "@external";
  }
}
void misspelt_of_task(Robot& robot, bool defect) {
  Node& pack = robot.add_pack(robot.r.one_of(robot.planners).name, robot.name("look_about"));
  const std::string member = any_skill(robot);
  pack.add(member, flow(defect ? "{@optionl: true}" : "{@optional: true}"));
}
void misspelt_section(Robot& robot, bool defect) {
  if (defect) robot.files[robot.r.below(robot.files.size())].node.add("@stats", flow("{Mood: {values: [good, bad]}}"));
}

// wrong_node_kind

void word_for_list(Robot& robot, bool defect) {
  const std::string part = robot.parts[robot.part()], name = robot.verb();
  Node& group = robot.add_group(name, "{}");
  group.add("@needs", defect ? Node(part) : flow("[$0]", {part}));
  robot.add_root(name, robot.above());
}
void word_for_number(Robot& robot, bool defect) {
  const std::string name = robot.verb();
  robot.add_group(name, "{}");
  robot.section(0, "roots").add(name, flow("{@priority: $0}", {defect ? "high" : std::to_string(robot.above())}));
}
void word_for_truth(Robot& robot, bool defect) {
  robot.group(robot.add_skill(robot.parts[robot.part()])).add("@realtime", defect ? "1" : "false");
}
void number_for_duration(Robot& robot, bool defect) { any_provider(robot).add("@every", defect ? "10" : "10 ms"); }
void list_for_mapping(Robot& robot, bool defect) {
  robot.section(robot.r.below(robot.files.size()), "groups")
      .add(robot.verb(), flow(defect ? "[@a, b]" : "{@layer: skill}"));
}
void range_upside_down(Robot& robot, bool defect) {
  const std::string name = robot.name("Level");
  make_root(robot, "{when: [$0 > 3], allow: [uncovered_state], because: it waits}", {name});
  robot.add_state(name, defect ? "{range: [@100, 0], external: true}" : "{range: [@0, 100], external: true}");
}
void nothing_at_all(Robot& robot, bool defect) { edit_new(robot, defect ? "" : "{}", true); }

// missing_key

void nameless_provider(Robot& robot, bool defect) {
  const std::string name = robot.verb();
  robot.add_group(name,
                  defect ? "{providers: [{@needs: [$0], tasks: [$0]}]}"
                         : "{providers: [{@name: only, needs: [$0], tasks: [$0]}]}",
                  {robot.parts[robot.part()]});
}
void no_domain(Robot& robot, bool defect) {
  const std::string name = robot.name("Humidity");
  robot.add_state("@" + name, defect ? "{external: true}" : "{range: [0, 9], external: true}");
  make_root(robot, "{when: [$0 > 3], allow: [uncovered_state], because: it waits}", {name});
}
void owned_without_initial(Robot& robot, bool defect) {
  robot.add_state("@" + robot.name("Lap"),
                  defect ? "{values: [one, two], of: $0}" : "{values: [one, two], initial: one, of: $0}",
                  {robot.owner});
}
void no_reason(Robot& robot, bool defect) {
  const std::string name = robot.verb();
  Node& group = robot.add_group(name, "{when: [$0], @allow: [uncovered_state]}",
                                {condition(robot.r, robot.sense(SenseKind::plain))});
  if (!defect) group.add("because", "it waits for that");
  robot.add_root(name, robot.above());
}
void no_language(Robot& robot, bool defect) {
  Node& node = robot.files[robot.r.below(robot.files.size())].node;
  node.keys[0] = "@behaviour";
  if (defect) node.keys.erase(node.keys.begin() + 1), node.items.erase(node.items.begin() + 1);
}

// exclusive_keys

void tasks_and_packs(Robot& robot, bool defect) {
  const std::string name = robot.verb();
  Node& group = robot.add_group(name, "{tasks: [$0]}", {any_skill(robot)});
  if (defect) group.add("@packs", flow("{all: [$0]}", {any_skill(robot)}));
  robot.add_root(name, robot.above());
}
void range_and_values(Robot& robot, bool defect) {
  Node& state = robot.state(robot.sense(SenseKind::number).name);
  if (defect) state.add("@values", flow("[few, many]"));
}
void own_words_and_providers(Robot& robot, bool defect) {
  Node& group = robot.group(robot.r.one_of(robot.choosing));
  if (defect) group.add("@needs", flow("[$0]", {robot.parts[robot.part()]}));
}
void optional_and_apart(Robot& robot, bool defect) {
  Node& pack = robot.add_pack(robot.r.one_of(robot.planners).name, robot.name("look_about"));
  pack.add(any_skill(robot), flow(defect ? "{optional: true, @apart: true}" : "{@apart: true}"));
}
void owned_and_external(Robot& robot, bool defect) {
  Node& state = robot.state(robot.owned);
  if (defect) state.add("@external", "true");
}
void levels_and_priority(Robot& robot, bool defect) {
  const std::string skill = any_skill(robot), name = robot.verb();
  robot.add_group(name, "{packs: {go: {$0: {}}}}", {skill});
  Node& pack = robot.providers(name).front()->find("packs")->items.front();
  pack.items.front() =
      flow(defect ? "{priority: 5, @levels: {firm: {priority: 10}}}" : "{@levels: {firm: {priority: 10}}}");
  robot.add_root(name, robot.above());
}

// bad_condition

void spoilt(Robot& robot, const std::string& bad, const std::string& good, bool defect, SenseKind kind) {
  const Sense& sense = robot.sense(kind);
  const std::string name = robot.verb();
  const std::vector<std::string> words{sense.name, sense.values.empty() ? "20" : sense.values[1],
                                       sense.values.empty() ? "30" : sense.values[2]};
  Node& group = robot.add_group(name, "{allow: [uncovered_state], because: it waits}");
  Node& list = group.add("when", Node::list());
  list.add("@" + fill(defect ? bad : good, words));
  robot.add_root(name, robot.above());
}
void one_equals(Robot& robot, bool d) { spoilt(robot, "$0 = $1", "$0 == $1", d, SenseKind::plain); }
void two_in_one(Robot& robot, bool d) { spoilt(robot, "$0 > $1 && $0 < $2", "$0 > $1", d, SenseKind::number); }
void order_of_several(Robot& robot, bool d) { spoilt(robot, "$0 > $1|$2", "$0 > $1", d, SenseKind::number); }
void no_value(Robot& robot, bool d) { spoilt(robot, "$0 ==", "$0 == $1", d, SenseKind::plain); }
void promise_in_when(Robot& robot, bool d) { spoilt(robot, "$0 == $1 within 2 s", "$0 == $1", d, SenseKind::plain); }

// bad_type, bad_header

void no_type(Robot& robot, bool defect) {
  const std::string bad = robot.r.one_of({"robot::Pose&", "void", "robot Pose", "robot::Pose; int x", "std::vector<int",
                                          "struct Pose", "const robot::Pose"});
  const std::string name = robot.verb();
  robot.add_group(name, "{@data: $0}", {defect ? bad : "robot::Pose"});
  robot.add_root(name, robot.above());
}
void no_enum(Robot& robot, bool defect) {
  robot.add_state(robot.name("Gear"), "{@type: $0, values: [a, b], initial: a, external: true}",
                  {defect ? robot.r.one_of({"signed char", "robot Gear", "robot::Gear*"}) : "robot::Gear"});
}
void no_header(Robot& robot, bool defect) {
  robot.files.back().node.add(
      "cpp", flow("{headers: [@$0]}", {defect ? robot.r.one_of({"<vector", "a>b.hpp", "a\\b.hpp"}) : "robot/a.hpp"}));
}

// language_version, import_cycle, import_not_found, input_limit

void later_language(Robot& robot, bool defect) {
  Node& node = robot.files[robot.r.below(robot.files.size())].node;
  node.keys[1] = "@language";
  if (defect) node.items[1] = robot.r.one_of({"2", "3", "0"});
}
void imports_its_importer(Robot& robot, bool defect) {
  Node& imports = robot.section(robot.r.below(robot.files.size() - 1) + 1, "imports");
  if (defect) imports.add("@" + robot.files[0].path);
}
void imports_itself(Robot& robot, bool defect) {
  const std::size_t file = robot.r.below(robot.files.size());
  if (defect) robot.section(file, "imports").add("@" + robot.files[file].path);
}
void misspelt_import(Robot& robot, bool defect) {
  Node& imports = robot.section(robot.r.below(robot.files.size()), "imports");
  if (defect) imports.add(std::string("@") + robot.r.one_of({"limb.yaml", "motion/limbs.yaml", "senses.yml"}));
}
void too_deep(Robot& robot, bool defect) {
  std::string brackets = "[";
  for (int i = 0; i < 70; ++i) brackets.insert(0, "["), brackets += "]";
  edit_new(robot, "{needs: " + brackets + "]}", defect);
}
void too_many_files(Robot& robot, bool defect) {
  if (!defect) return;
  robot.section(0, "imports").add("chain_1.yaml");
  robot.edits.push_back([](Texts& texts) {
    for (int i = 1; i <= 230; ++i) {
      const std::string next = "chain_" + std::to_string(i + 1) + ".yaml";
      texts["chain_" + std::to_string(i) + ".yaml"] =
          "behaviour: chain_" + std::to_string(i) + "\nlanguage: 1\n" +
          (i < 230 ? "imports: [" + std::string(i == 199 ? "@" : "") + next + "]\n" : "");
    }
  });
}

// yaml_word_trap

void trap_in_values(Robot& robot, bool defect) {
  const std::string name = robot.name("Switch"), word = robot.r.one_of({"on", "Off", "yes", "n"});
  robot.add_state(name, "{values: [@$0, other], initial: other, external: true}", {defect ? word : "lit"});
}
void trap_as_group(Robot& robot, bool defect) {
  const std::string name = defect ? robot.r.one_of({"N", "Y", "Yes", "No"}) : robot.noun();
  robot.add_group("@" + name, "{}");
}
void trap_as_provider(Robot& robot, bool defect) {
  Node& provider = *robot.providers(robot.r.one_of(robot.choosing)).front();
  provider.keys.front() = "@name";
  if (defect) provider.items.front() = Node("off");
}

constexpr Planter of_reading[]{
    {"yaml_syntax", "an alias", alias},
    {"yaml_syntax", "an anchor", anchor},
    {"yaml_syntax", "a tag", tag},
    {"yaml_syntax", "a merge key", merge},
    {"yaml_syntax", "a wrong bracket", wrong_bracket},
    {"yaml_syntax", "an open quote", open_quote},
    {"yaml_syntax", "a colon too much", bad_colon},
    {"yaml_syntax", "one blank too much", odd_indent},
    {"yaml_syntax", "a tab", tab},
    {"yaml_syntax", "a second document", second_document},
    {"duplicate_key", "a group", group_twice},
    {"duplicate_key", "a word of a group", word_twice},
    {"duplicate_key", "a word of a state", state_word_twice},
    {"duplicate_key", "a section", section_twice},
    {"unknown_key", "of a group", misspelt_word},
    {"unknown_key", "of a provider", misspelt_in_provider},
    {"unknown_key", "of a group in a provider", word_of_a_group},
    {"unknown_key", "of a state", misspelt_of_state},
    {"unknown_key", "of a task", misspelt_of_task},
    {"unknown_key", "of a file", misspelt_section},
    {"wrong_node_kind", "a word for a list", word_for_list},
    {"wrong_node_kind", "a word for a number", word_for_number},
    {"wrong_node_kind", "a number for true", word_for_truth},
    {"wrong_node_kind", "a number for a duration", number_for_duration},
    {"wrong_node_kind", "a list for a mapping", list_for_mapping},
    {"wrong_node_kind", "a range upside down", range_upside_down},
    {"wrong_node_kind", "nothing", nothing_at_all},
    {"missing_key", "the name of a provider", nameless_provider},
    {"missing_key", "the values of a state", no_domain},
    {"missing_key", "the first value of a group's state", owned_without_initial},
    {"missing_key", "the reason", no_reason},
    {"missing_key", "the language", no_language},
    {"exclusive_keys", "tasks and packs", tasks_and_packs},
    {"exclusive_keys", "range and values", range_and_values},
    {"exclusive_keys", "needs and providers", own_words_and_providers},
    {"exclusive_keys", "optional and apart", optional_and_apart},
    {"exclusive_keys", "of and external", owned_and_external},
    {"exclusive_keys", "levels and priority", levels_and_priority},
    {"bad_condition", "one =", one_equals},
    {"bad_condition", "two in one", two_in_one},
    {"bad_condition", "alternatives of an order", order_of_several},
    {"bad_condition", "no value", no_value},
    {"bad_condition", "within in a when", promise_in_when},
    {"bad_type", "data", no_type},
    {"bad_type", "type", no_enum},
    {"bad_header", "a path", no_header},
    {"language_version", "of a file", later_language},
    {"import_cycle", "the importer", imports_its_importer},
    {"import_cycle", "itself", imports_itself},
    {"import_not_found", "misspelt", misspelt_import},
    {"input_limit", "too deep", too_deep},
    {"input_limit", "too many files in a row", too_many_files},
    {"yaml_word_trap", "a value", trap_in_values},
    {"yaml_word_trap", "a group", trap_as_group},
    {"yaml_word_trap", "a provider", trap_as_provider},
};

} // namespace

std::span<const Planter> reading_planters() { return of_reading; }

} // namespace director::defects
