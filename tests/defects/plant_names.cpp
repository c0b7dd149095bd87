// Header: tests/defects/planter.hpp. Test: itself.
// SPDX-License-Identifier: MIT
//
// What is met when names are resolved.
#include "tests/defects/planter.hpp"

namespace director::defects {

namespace {

/// As a slip of the fingers has it: two letters change places.
std::string misspelt(std::string word) {
  const std::size_t at = word.size() / 2;
  if (word[at] == word[at - 1]) return word + "x";
  std::swap(word[at], word[at - 1]);
  return word;
}

std::string new_root(Robot& robot, std::string_view text, const std::vector<std::string>& words) {
  const std::string name = robot.verb();
  robot.add_group(name, text, words);
  robot.add_root(name, robot.above());
  return name;
}

// undefined_name

void misspelt_task(Robot& robot, bool defect) {
  const std::string part = robot.parts[robot.part()];
  new_root(robot, "{tasks: [@$0]}", {defect ? misspelt(part) : part});
}
void misspelt_need(Robot& robot, bool defect) {
  const std::string part = robot.parts[robot.part()];
  new_root(robot, "{needs: [@$0]}", {defect ? misspelt(part) : part});
}
void misspelt_member(Robot& robot, bool defect) {
  const std::string skill = robot.skills[robot.part()].front();
  robot.add_pack(robot.r.one_of(robot.planners).name, robot.name("look_about"))
      .add("@" + (defect ? misspelt(skill) : skill), {});
}
void misspelt_use(Robot& robot, bool defect) {
  const std::string part = robot.parts[robot.part()];
  new_root(robot, "{tasks: [$0], uses: [@$1]}", {part, defect ? misspelt(part) : part});
}
void misspelt_state(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(SenseKind::plain);
  new_root(robot, "{when: [@$0 == $1], allow: [uncovered_state], because: it waits}",
           {defect ? misspelt(sense.name) : sense.name, sense.values[1]});
}
void misspelt_root(Robot& robot, bool defect) {
  const std::string name = robot.verb();
  robot.add_group(name, "{}");
  robot.add_root("@" + (defect ? misspelt(name) : name), robot.above());
}
void misspelt_trigger(Robot& robot, bool defect) {
  robot.group(robot.add_skill(robot.parts[robot.part()])).add("triggers", flow(defect ? "[@Sensor]" : "[@Sensors]"));
}
void misspelt_layer(Robot& robot, bool defect) {
  robot.group(robot.add_skill(robot.parts[robot.part()])).add("@layer", defect ? "skil" : "skill");
}
void no_such_promise(Robot& robot, bool defect) {
  if (defect) new_root(robot, "{triggers: [@$0.going.broken]}", {robot.pairs.front().resting});
}
void misspelt_check(Robot& robot, bool defect) {
  new_root(robot, "{when: [$0], allow: [uncovered_state, $1], because: it waits}",
           {condition(robot.r, robot.sense(SenseKind::plain)), defect ? "@uncovred_state" : "@uncovered_state"});
}
void misspelt_owner(Robot& robot, bool defect) {
  robot.add_state(robot.name("Lap"), "{values: [one, two], initial: one, @of: $0}",
                  {defect ? misspelt(robot.owner) : robot.owner});
}

// redefined_name

void group_in_two_files(Robot& robot, bool defect) {
  const std::string name = robot.verb();
  robot.section(robot.r.below(robot.files.size() - 1) + 1, "groups").add(name, {});
  robot.section(0, "groups").add("@" + (defect ? name : robot.verb()), {});
}
void small_letter(Robot& robot, bool defect) {
  std::string name = robot.name("Weather");
  robot.add_state(name, "{values: [fair, foul], initial: fair, external: true}");
  if (defect) name.front() = 'w';
  robot.section(0, "groups").add("@" + (defect ? name : robot.verb()), {});
}
void provider_twice(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(SenseKind::plain);
  new_root(robot, "{providers: [{name: gently, when: [$0 == $1]}, {@name: $2}]}",
           {sense.name, sense.values[1], defect ? "gently" : "firmly"});
}
void value_twice(Robot& robot, bool defect) {
  robot.add_state(robot.name("Taste"), "{values: [sweet, sour, @$0], initial: sour, external: true}",
                  {defect ? "sweet" : "salty"});
}
void one_type(Robot& robot, bool defect) {
  robot.section(robot.files.size() - 1, "states")
      .add(robot.name("Gear"), flow("{type: robot::Gear, values: [a, b], initial: a, external: true}"));
  robot.section(0, "states")
      .add(robot.name("Step"),
           flow("{@type: robot::$0, values: [a, b], initial: a, external: true}", {defect ? "Gear" : "Step"}));
}
void called_like_its_group(Robot& robot, bool defect) {
  const std::string name = robot.verb();
  std::string own = name;
  own.front() = static_cast<char>(own.front() | 0x20);
  robot.add_group(name, "{providers: [{@name: $0}]}", {defect ? own : "plainly"});
}

// reserved_name

void reserved_group(Robot& robot, bool defect) {
  robot.add_group("@" + (defect ? robot.r.one_of({"Stop", "Root", "Behaviour", "limbo"}) : robot.verb()), "{}");
}
void reserved_value(Robot& robot, bool defect) {
  robot.add_state(robot.name("Mode"), "{values: [@$0, manual], initial: manual, external: true}",
                  {defect ? robot.r.one_of({"auto", "default", "new"}) : "automatic"});
}
void reserved_provider(Robot& robot, bool defect) {
  new_root(robot, "{providers: [{@name: $0}]}", {defect ? robot.r.one_of({"default", "start", "while"}) : "plainly"});
}
void reserved_pack(Robot& robot, bool defect) {
  robot.add_pack(robot.r.one_of(robot.planners).name,
                 "@" + (defect ? robot.r.one_of({"done", "wait", "keep"}) : robot.name("pause")));
}
void name_of_cpp(Robot& robot, bool defect) {
  robot.add_group("@" + (defect ? robot.r.one_of({"eOF", "SIGINT", "__Walk", "_Complex", "left__hand"}) : robot.verb()),
                  "{}");
}
void no_name(Robot& robot, bool defect) { robot.add_group(defect ? "@left-hand" : "@left_hand", "{}"); }

// value_outside_domain

void misspelt_value(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(robot.r.one_of({SenseKind::plain, SenseKind::expiring, SenseKind::unset}));
  new_root(robot, "{when: [@$0 == $1], allow: [uncovered_state], because: it waits}",
           {sense.name, defect ? misspelt(sense.values[1]) : sense.values[1]});
}
void beyond_range(Robot& robot, bool defect) {
  new_root(robot, "{when: [@$0 > $1], allow: [uncovered_state], because: it waits}",
           {robot.sense(SenseKind::number).name, defect ? "120" : "20"});
}
void no_number(Robot& robot, bool defect) {
  new_root(robot, "{when: [@$0 == $1], allow: [uncovered_state], because: it waits}",
           {robot.sense(SenseKind::number).name, defect ? "full" : "99"});
}
void misspelt_initial(Robot& robot, bool defect) {
  robot.add_state(robot.name("Taste"), "{values: [sweet, sour], @initial: $0, external: true}",
                  {defect ? "swet" : "sweet"});
}
void expires_to_nothing(Robot& robot, bool defect) {
  robot.add_state(robot.name("Taste"), "{range: [0, 9], external: true, expires: {after: 1 s, @to: $0}}",
                  {defect ? "10" : "9"});
}
void order_of_a_sentinel(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(SenseKind::sentinel);
  new_root(robot, "{when: [@$0 > $1], allow: [uncovered_state], because: it waits}",
           {sense.name, defect ? "unknown" : sense.values[1]});
}
void sets_no_value(Robot& robot, bool defect) {
  new_root(robot, "{sets: [@$0 == $1]}", {robot.inner, defect ? "third" : "second"});
}

// The others

void below_a_sentinel(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(SenseKind::sentinel);
  new_root(robot, "{when: [@$0 $1 $2], allow: [uncovered_state], because: it waits}",
           {sense.name, defect ? robot.r.one_of({"<", "<="}) : ">=", sense.values[2]});
}
void sentinel_in_stay(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(SenseKind::sentinel);
  new_root(robot, "{when: [$0 == $2], stay: [@$0 $1 $2], allow: [uncovered_state], because: it waits}",
           {sense.name, defect ? "<=" : ">=", sense.values[2]});
}
void unused_state(Robot& robot, bool defect) {
  const std::string name = robot.name("Mood");
  robot.section(0, "states").add("@" + name, flow("{values: [good, bad], initial: good, external: true}"));
  if (!defect) new_root(robot, "{when: [$0 == good], allow: [uncovered_state], because: it waits}", {name});
}
void unused_trigger(Robot& robot, bool defect) {
  robot.section(0, "triggers").add("@Bumper");
  if (!defect) robot.group(robot.add_skill(robot.parts[0])).add("triggers", flow("[Bumper]"));
}
void unused_layer(Robot& robot, bool defect) {
  robot.section(0, "layers").add("@extra");
  if (!defect) robot.group(robot.add_skill(robot.parts[0])).add("layer", "extra");
}
void unused_group(Robot& robot, bool defect) {
  const std::string name = robot.verb();
  robot.section(0, "groups").add("@" + name, flow("{needs: [$0], tasks: [$0]}", {robot.parts[robot.part()]}));
  if (!defect) robot.add_root(name, robot.above());
}
void nobody_provides(Robot& robot, bool defect) {
  const std::string name = robot.verb();
  robot.section(robot.r.below(robot.files.size()), "extern").add("@" + name);
  new_root(robot, "{tasks: [$0]}", {name});
  if (!defect) robot.section(0, "groups").add(name, {});
}
void no_provider(Robot& robot, bool defect) {
  robot.add_group("@" + robot.verb(), defect ? "{providers: []}" : "{providers: [{name: only}]}");
}
void false_handler(Robot& robot, bool defect) {
  new_root(robot, "{@$0: $1}",
           {robot.r.one_of({"start", "stop"}), defect ? robot.r.one_of({"false", "always"}) : "true"});
}
void handler_with_tasks(Robot& robot, bool defect) {
  new_root(robot, defect ? "{stop: {@tasks: [$0]}}" : "{stop: {@sets: [$1]}}", {robot.parts[0], robot.inner});
}
void handler_list(Robot& robot, bool defect) {
  new_root(robot, defect ? "{start: [@$0 == second]}" : "{start: {@sets: [$0 == second]}}", {robot.inner});
}
void unread_enum(Robot& robot, bool defect) {
  robot.add_state(robot.name("Gear"), defect ? "{@type: robot::Gear, external: true}"
                                             : "{@type: robot::Gear, values: [a, b], external: true}");
}

constexpr Planter of_names[]{
    {"undefined_name", "a task", misspelt_task},
    {"undefined_name", "a need", misspelt_need},
    {"undefined_name", "a member of a pack", misspelt_member},
    {"undefined_name", "a use", misspelt_use},
    {"undefined_name", "a state", misspelt_state},
    {"undefined_name", "a root", misspelt_root},
    {"undefined_name", "a trigger", misspelt_trigger},
    {"undefined_name", "a layer", misspelt_layer},
    {"undefined_name", "a promise", no_such_promise},
    {"undefined_name", "a check", misspelt_check},
    {"undefined_name", "the owner of a state", misspelt_owner},
    {"redefined_name", "a group in two files", group_in_two_files},
    {"redefined_name", "a small letter", small_letter},
    {"redefined_name", "a provider", provider_twice},
    {"redefined_name", "a value", value_twice},
    {"redefined_name", "a C++ type", one_type},
    {"redefined_name", "a provider like its group", called_like_its_group},
    {"reserved_name", "a group", reserved_group},
    {"reserved_name", "a value", reserved_value},
    {"reserved_name", "a provider", reserved_provider},
    {"reserved_name", "a pack", reserved_pack},
    {"reserved_name", "a name of C++", name_of_cpp},
    {"reserved_name", "no name at all", no_name},
    {"value_outside_domain", "misspelt", misspelt_value},
    {"value_outside_domain", "beyond the range", beyond_range},
    {"value_outside_domain", "a word for a number", no_number},
    {"value_outside_domain", "at the start", misspelt_initial},
    {"value_outside_domain", "after it expires", expires_to_nothing},
    {"value_outside_domain", "the order of a sentinel", order_of_a_sentinel},
    {"value_outside_domain", "set", sets_no_value},
    {"ordering_on_sentinel", "in a when", below_a_sentinel},
    {"ordering_on_sentinel", "in a stay", sentinel_in_stay},
    {"unused_declaration", "a state", unused_state},
    {"unused_declaration", "a trigger", unused_trigger},
    {"unused_declaration", "a layer", unused_layer},
    {"unused_declaration", "a group", unused_group},
    {"unprovided_task", "extern", nobody_provides},
    {"unprovided_task", "no provider", no_provider},
    {"start_stop_shape", "false", false_handler},
    {"start_stop_shape", "it requests", handler_with_tasks},
    {"start_stop_shape", "a list", handler_list},
    {"type_needs_scanner", "a state", unread_enum},
};

} // namespace

std::span<const Planter> naming_planters() { return of_names; }

} // namespace director::defects
