// Header: tests/defects/planter.hpp. Test: itself.
// SPDX-License-Identifier: MIT
//
// Conditions and what can make them true.
#include "tests/defects/gadgets.hpp"
#include "tests/defects/planter.hpp"

namespace director::defects {

namespace {

const Sense& worded(Robot& robot) { return robot.sense(robot.r.one_of({SenseKind::plain, SenseKind::expiring})); }

/// A provider with conditions, of those that the robot has.
Node& conditional(Robot& robot) {
  const std::vector<std::string>& from = robot.r.chance(0.5) ? robot.purposes : robot.choosing;
  return *robot.providers(robot.r.one_of(from)).front();
}

/// One of the kind that the provider has no condition on.
const Sense& other_sense(Robot& robot, const Node& provider, SenseKind kind) {
  const std::string words = to_yaml(provider);
  for (const Sense& each : robot.senses) {
    if (each.kind == kind && words.find(each.name + " ") == std::string::npos) return each;
  }
  // Or a new one.
  Sense made = robot.sense(kind);
  const Node like = robot.state(made.name);
  made.name = robot.name("Humidity");
  robot.section(0, "states").add(made.name, like);
  robot.senses.push_back(made);
  return robot.senses.back();
}

/// A requested group that waits for the outside, and says so.
Node& waiting(Robot& robot, const std::string& name) {
  Node& out =
      robot.add_group(name, "{needs: [$0], allow: [uncovered_state], because: it waits}", {robot.parts[robot.part()]});
  robot.add_root(name, robot.above());
  return out;
}

/// The same; where it does not wait it says nothing.
Node& requested(Robot& robot, bool always) {
  const std::string name = robot.verb();
  Node& out =
      robot.add_group(name, always ? "{needs: [$0]}" : "{needs: [$0], allow: [uncovered_state], because: it waits}",
                      {robot.parts[robot.part()]});
  robot.add_root(name, robot.above());
  return out;
}

// contradictory_when

void two_values(Robot& robot, bool defect) {
  const Sense& sense = worded(robot);
  waiting(robot, robot.verb())
      .add("when", flow("[$0 == $1, @$0 $2 $3]", {sense.name, sense.values[1], defect ? "==" : "!=", sense.values[2]}));
}
void between_numbers(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(SenseKind::number);
  waiting(robot, robot.verb()).add("when", flow("[$0 < 30, @$0 $1]", {sense.name, defect ? ">= 30" : ">= 20"}));
}
void beyond_the_range(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(SenseKind::number);
  waiting(robot, robot.verb()).add("when", flow("[@$0 $1]", {sense.name, defect ? "< 0" : "< 1"}));
}
void in_a_stay(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(SenseKind::number);
  Node& group = waiting(robot, robot.verb());
  group.add("when", flow("[$0 > 50]", {sense.name}));
  group.add("stay", flow("[$0 > 30, @$0 < $1]", {sense.name, defect ? "30" : "99"}));
}
void in_a_purpose(Robot& robot, bool defect) {
  Node& provider = conditional(robot);
  const Sense sense = other_sense(robot, provider, SenseKind::plain);
  Node& when = *provider.find("when");
  when.add(sense.name + " == " + sense.values[1]);
  if (defect) when.add("@" + sense.name + " == " + sense.values[2]);
}

// always_true_when

void all_values(Robot& robot, bool defect) {
  const Sense& sense = worded(robot);
  std::string all = sense.name + " == ";
  for (std::size_t i = defect ? 0 : 1; i < sense.values.size(); ++i)
    all += (all.back() == ' ' ? "" : "|") + sense.values[i];
  requested(robot, defect).add("when", flow("[@$0]", {all}));
}
void from_the_first(Robot& robot, bool defect) {
  const Sense& sense = worded(robot);
  requested(robot, defect).add("when", flow("[@$0 >= $1]", {sense.name, sense.values[defect ? 0 : 1]}));
}
void any_number(Robot& robot, bool defect) {
  Node& provider = conditional(robot);
  const Sense sense = other_sense(robot, provider, SenseKind::number);
  provider.find("when")->add("@" + sense.name + (defect ? " <= 100" : " <= 99"));
}

// unset_is_false

void not_while_unset(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(SenseKind::unset);
  waiting(robot, robot.verb()).add("when", flow("[@$0 $1 $2]", {sense.name, defect ? "!=" : "==", sense.values[1]}));
}
void not_while_expired(Robot& robot, bool defect) {
  const std::string name = robot.name("Signal");
  robot.add_state(name, "{values: [weak, strong], initial: weak, external: true, expires: $0}",
                  {defect ? "1 s" : "{after: 1 s, to: weak}"});
  Node& provider = conditional(robot);
  provider.find("when")->add("@" + name + " != weak");
}
void unset_in_a_stay(Robot& robot, bool defect) {
  Node& provider = conditional(robot);
  const Sense sense = other_sense(robot, provider, SenseKind::unset);
  if (provider.find("stay") == nullptr) provider.add("stay", Node::list());
  provider.find("stay")->add("@" + sense.name + (defect ? " != " : " == ") + sense.values[1]);
}

// stay_adds_nothing

void as_strict(Robot& robot, bool defect) {
  const Sense& sense = worded(robot);
  Node& group = waiting(robot, robot.verb());
  group.add("when", flow("[$0 == $1]", {sense.name, sense.values[1]}));
  group.add("stay", flow(defect ? "[@$0 == $1]" : "[@$0 == $1|$2]", {sense.name, sense.values[1], sense.values[2]}));
}
void stricter(Robot& robot, bool defect) {
  const Sense& number = robot.sense(SenseKind::number);
  const Sense& sense = worded(robot);
  Node& group = waiting(robot, robot.verb());
  group.add("when", flow("[$0 > 40]", {number.name}));
  group.add("stay", flow("[@$0 > $1, $2 == $3]", {number.name, defect ? "60" : "20", sense.name, sense.values[1]}));
}

// foreign_set

void set_by_another(Robot& robot, bool defect) {
  const std::string name = make_root(robot, "{needs: [$0]}", {robot.parts[robot.part()]});
  robot.group(name).add("sets", flow("[@$0 == $1]", {defect ? robot.owned : robot.inner, defect ? "half" : "second"}));
}
void set_by_a_handler(Robot& robot, bool defect) {
  make_root(robot, "{$0: {sets: [@$1]}}", {robot.r.one_of({"start", "stop"}), defect ? robot.owned : robot.inner});
}
void caused_by_another(Robot& robot, bool defect) {
  const std::string own = make_state(robot, "bare", "whole");
  make_root(robot, "{causing: [@$0 == whole]}", {defect ? robot.owned : own});
}

// state_without_source

void nobody_sets(Robot& robot, bool defect) {
  const std::string name = robot.name("Smell");
  robot.add_state(name, defect ? "{values: [good, bad]}" : "{values: [good, bad], external: true}");
  waiting(robot, robot.verb()).add("when", flow("[@$0 == good]", {name}));
}
void no_number_comes(Robot& robot, bool defect) {
  const std::string name = robot.name("Depth");
  robot.add_state(name, defect ? "{range: [0, 9]}" : "{range: [0, 9], external: true}");
  conditional(robot).find("when")->add("@" + name + " > 3");
}

// unreachable_when

void no_such_source(Robot& robot, bool defect) {
  waiting(robot, robot.verb()).add("when", flow("[@$0 == $1]", {robot.inner, defect ? "never" : "second"}));
}
void never_that_high(Robot& robot, bool defect) {
  const std::string name = robot.name("Count");
  robot.add_state(name, "{range: [0, 9], initial: 0}");
  make_root(robot, "{sets: [$0 < 4]}", {name});
  conditional(robot).find("when")->add("@" + name + (defect ? " > 5" : " > 2"));
}
void never_stays(Robot& robot, bool defect) {
  Node& provider = conditional(robot);
  if (provider.find("stay") == nullptr) provider.add("stay", Node::list());
  provider.find("stay")->add("@" + robot.inner + " == " + (defect ? "never" : "second"));
}
void in_the_gap(Robot& robot, bool defect) {
  const std::string name = robot.name("Count");
  robot.add_state(name, "{range: [0, 100], initial: 0}");
  make_root(robot, "{sets: [$0 >= 90]}", {name});
  waiting(robot, robot.verb()).add("when", flow("[$0 > 10, @$0 < $1]", {name, defect ? "50" : "95"}));
}

// shadowed_provider, uncovered_state, overlapping_providers

void behind_the_last(Robot& robot, bool defect) {
  const std::string name = robot.r.one_of(robot.choosing);
  Node& list = *robot.group(name).find("providers");
  Node last = list.items.back();
  last.keys.front() = "@name", last.items.front() = Node("spare");
  if (defect) list.add(std::move(last));
  robot.add_root(name, robot.above());
}
void special_after_general(Robot& robot, bool defect) {
  const std::string number = robot.sense(SenseKind::number).name;
  make_root(robot,
            defect ? "{providers: [{name: any, when: [$0 > 10]}, {@name: fast, when: [$0 > 80]}, {name: rest}]}"
                   : "{providers: [{name: fast, when: [$0 > 80]}, {@name: any, when: [$0 > 10]}, {name: rest}]}",
            {number});
}
void nothing_left(Robot& robot, bool defect) {
  const Sense& sense = worded(robot);
  make_root(robot, "{providers: [{name: one, when: [$0 == $1]}, {name: other, when: [$0 $2]}, {@name: rest}]}",
            {sense.name, sense.values[1], defect ? "!= " + sense.values[1] : "== " + sense.values[0]});
}
void without_its_last(Robot& robot, bool defect) {
  const std::string name = robot.r.one_of(robot.choosing);
  Node& list = *robot.group(name).find("providers");
  for (std::size_t file = 0; file < robot.files.size(); ++file) {
    for (std::string& key : robot.section(file, "groups").keys) {
      if (key == name) key = "@" + name;
    }
  }
  robot.add_root(name, robot.above());
  if (!defect) return;
  list.items.pop_back();
  for (std::string& key : robot.section(0, "extend").keys) {
    if (key != name) continue;
    Node& more = *robot.section(0, "extend").find(name);
    more.keys.erase(more.keys.begin()), more.items.erase(more.items.begin());
  }
}
void unsaid_gate(Robot& robot, bool defect) {
  const std::string name = robot.verb();
  robot.add_group("@" + name, defect ? "{when: [$0]}" : "{when: [$0], allow: [uncovered_state], because: it waits}",
                  {condition(robot.r, robot.senses[robot.r.below(robot.senses.size())])});
  robot.add_root(name, robot.above());
}
void purpose_without_its_last(Robot& robot, bool defect) {
  const std::string sense = robot.sense(SenseKind::plain).name, value = robot.sense(SenseKind::plain).values[1];
  const std::string name = robot.verb();
  const std::string plan = robot.r.one_of(robot.planners).name;
  robot.add_group("@" + name,
                  defect ? "{providers: [{name: busy, when: [$0 == $1], packs: {go: {$2: {}}}}]}"
                         : "{providers: [{name: busy, when: [$0 == $1], packs: {go: {$2: {}}}}, {name: idle}]}",
                  {sense, robot.state(sense).find("values")->items[1].word, plan});
  robot.add_root(name, robot.above());
  (void)value;
}
void below_a_requester(Robot& robot, bool defect) {
  const std::string sense = robot.sense(SenseKind::expiring).name,
                    first = robot.state(sense).find("values")->items[0].word;
  const std::string name = robot.verb();
  robot.add_group("@" + name,
                  defect ? "{providers: [{name: one, when: [$0 != $1]}]}"
                         : "{providers: [{name: one, when: [$0 != $1]}, {name: other}]}",
                  {sense, first});
  make_root(robot, "{packs: {go: {$0: {}}}}", {name});
}
void overlap(Robot& robot, bool defect) {
  const std::string number = robot.sense(SenseKind::number).name;
  make_root(robot, "{providers: [{name: low, when: [$0 < 40]}, {@name: high, when: [$0 > $1, $0 < 90]}, {name: rest}]}",
            {number, defect ? "30" : "60"});
}

constexpr Planter of_conditions[]{
    {"contradictory_when", "two values", two_values},
    {"contradictory_when", "between numbers", between_numbers},
    {"contradictory_when", "beyond the range", beyond_the_range},
    {"contradictory_when", "in a stay", in_a_stay},
    {"contradictory_when", "in a purpose", in_a_purpose},
    {"always_true_when", "all values", all_values},
    {"always_true_when", "from the first", from_the_first},
    {"always_true_when", "any number", any_number},
    {"unset_is_false", "at the start", not_while_unset},
    {"unset_is_false", "expired", not_while_expired},
    {"unset_is_false", "in a stay", unset_in_a_stay},
    {"stay_adds_nothing", "as strict", as_strict},
    {"stay_adds_nothing", "stricter", stricter},
    {"foreign_set", "by a provider", set_by_another},
    {"foreign_set", "by a handler", set_by_a_handler},
    {"foreign_set", "promised", caused_by_another},
    {"state_without_source", "values", nobody_sets},
    {"state_without_source", "a number", no_number_comes},
    {"unreachable_when", "no source", no_such_source},
    {"unreachable_when", "never that high", never_that_high},
    {"unreachable_when", "in a stay", never_stays},
    {"unreachable_when", "in the gap", in_the_gap},
    {"shadowed_provider", "behind the last", behind_the_last},
    {"shadowed_provider", "special after general", special_after_general},
    {"shadowed_provider", "nothing left", nothing_left},
    {"uncovered_state", "without its last", without_its_last},
    {"uncovered_state", "a gate", unsaid_gate},
    {"uncovered_state", "a purpose", purpose_without_its_last},
    {"uncovered_state", "below", below_a_requester},
    {"overlapping_providers", "numbers", overlap},
};

} // namespace

std::span<const Planter> condition_planters() { return of_conditions; }

} // namespace director::defects
