// Header: dsl/reading/slips.hpp. Test: tests/dsl/reading/slips_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/reading/slips.hpp"

#include <algorithm>

namespace director::dsl {

const std::string* help_for(const Slips& slips, std::string_view key) {
  for (const Slip& slip : slips)
    if (std::find(slip.keys.begin(), slip.keys.end(), key) != slip.keys.end()) return &slip.help;
  return nullptr;
}

const Slips& slips_of_file() {
  static const Slips slips{
      {{"scenario", "given", "script", "steps"},
       "this belongs to a scenario, which `directorc test` and `directorc simulate` play"},
      {{"name"}, "the name stands in `behaviour`: `behaviour: soccer`"},
      {{"version"}, "the version of the language stands in `language`: `language: 1`"},
      {{"include", "includes", "modules"}, "other files stand in `imports`: `imports: [legs.yaml]`"},
      {{"tasks", "actions", "nodes", "behaviours", "skills", "providers"},
       "tasks and their providers stand in `groups`: `groups: {Walk: {needs: [Legs]}}`"},
      {{"resources", "actuators", "locks"}, "a resource is a group that others need: `groups: {Legs: {}}`"},
      {{"goals", "missions", "root"}, "what the program requests stands in `roots`: `roots: {Play: {priority: 10}}`"},
      {{"variables", "conditions", "blackboard", "inputs", "sensors"},
       "what is known stands in `states`: `states: {Ball: {values: [lost, seen], external: true}}`"},
      {{"events", "signals"}, "events without a value stand in `triggers`, others are `states` that are `external`"},
      {{"priorities", "priority"}, "a priority stands where a task is requested: `roots: {Play: {priority: 10}}`"},
      {{"sequence", "sequences", "transitions"},
       "there are no sequences: a provider runs as soon as its `when` holds, and promises in `causing` what others "
       "wait "
       "for"},
      {{"description", "comment"}, "a text for people stands in `doc`"},
  };
  return slips;
}

const Slips& slips_of_scenario_file() {
  static const Slips slips{
      {{"language", "imports", "cpp", "layers", "states", "triggers", "extern", "roots", "groups", "extend",
        "assertions", "limits"},
       "this belongs to a behaviour file, which `directorc check` reads"},
      {{"name", "title"}, "a sentence that says what is shown stands in `scenario`"},
      {{"expect"}, "it stands beside an input, in `steps`: `- {request: Walk, expect: \"run Walk new_task\"}`"},
      {{"request", "cancel", "set", "trigger", "enable", "disable", "advance", "inputs"},
       "it stands in `steps`: `- request: Walk`"},
      {{"bodies", "mocks"}, "what bodies do stands in `script`"},
      {{"initial"}, "values at the start stand in `given`"},
      {{"description", "comment"}, "a text for people stands in `doc`"},
  };
  return slips;
}

const Slips& slips_of_cpp() {
  static const Slips slips{
      {{"include", "includes", "imports", "types"}, "what is included stands in `headers`: `headers: [types.hpp]`"},
      {{"package", "module"}, "the namespace of what is generated stands in `namespace`"},
  };
  return slips;
}

const Slips& slips_of_state() {
  static const Slips slips{
      {{"default"}, "the value at the start stands in `initial`"},
      {{"enum"}, "the values stand in `values`, a C++ enum in `type`"},
      {{"min", "max", "minimum", "maximum"}, "lowest and highest number stand in `range`: `range: [0, 100]`"},
      {{"timeout", "ttl", "lifetime"}, "a state that is not set again for so long `expires`: `expires: 500 ms`"},
      {{"input", "sensor"}, "a state that the program sets says `external: true`"},
      {{"owner", "group"}, "the group to which it belongs stands in `of`"},
      {{"description", "comment"}, "a text for people stands in `doc`"},
  };
  return slips;
}

const Slips& slips_of_group() {
  static const Slips slips{
      {{"sequence", "sequences"},
       "there is no sequence: give each step a provider, with a `when` on a state that tells how far it is, and have "
       "it set the next value"},
      {{"fallback", "selector", "alternatives"}, "list the ways in `providers`: the first one that can run is chosen"},
      {{"parallel"}, "list them in `tasks`: what a run requests goes on at once"},
      {{"children", "subtasks", "request", "requests", "actions"}, "what it may request stands in `tasks` or `packs`"},
      {{"timeout", "deadline"},
       "a promise may have a time, `causing: [Motion == still within 3 s]`; a body that waits calls `run.wait(3s)`"},
      {{"unless", "except"}, "`when` says what must hold: write the opposite, such as `when: [Motion != rolling]`"},
      {{"if", "condition", "conditions", "precondition", "preconditions", "guard"},
       "conditions stand in `when`: `when: [Motion == still]`"},
      {{"while", "until", "hold"}, "conditions that are enough once it runs stand in `stay`: `stay: [Battery < 90]`"},
      {{"priority", "weight", "rank", "optional", "apart", "levels"},
       "it stands where the task is requested: `roots: {Walk: {priority: 10}}`, or in `tasks` of the group that "
       "requests it"},
      {{"requires", "resources", "locks", "uses_resource"}, "groups that it must control stand in `needs`"},
      {{"cause", "causes", "effects", "effect", "postconditions", "achieves"},
       "what it promises to make true stands in `causing`: `causing: [Motion == still]`"},
      {{"set", "writes"}, "what it may set stands in `sets`: `sets: [Motion == rolling]`"},
      {{"rate", "period", "interval", "frequency", "hz"}, "it runs again after a period with `every: 10 ms`"},
      {{"trigger", "events", "on"}, "what runs it again stands in `triggers`: `triggers: [Picture]`"},
      {{"on_start", "on_enter", "enter", "entry", "init"}, "a handler for when it begins to run: `start: true`"},
      {{"on_stop", "on_exit", "exit", "cleanup"}, "a handler for when it ceases to run: `stop: true`"},
      {{"type", "message", "params", "parameters", "args"},
       "the C++ type that the task carries stands in `data` of the group"},
      {{"description", "comment"}, "a text for people stands in `doc`"},
  };
  return slips;
}

const Slips& slips_of_task() {
  static const Slips slips{
      {{"prio", "weight", "rank", "importance"}, "it is called `priority`, a whole number; the higher one goes first"},
      {{"when", "if", "unless", "condition", "conditions", "stay"},
       "a condition belongs to a provider: to that of the task, or to the one that requests it"},
      {{"mandatory", "required"}, "every task is, unless it says `optional: true`"},
      {{"data", "params", "parameters", "args", "with"}, "the body that requests a task gives it its data, in C++"},
      {{"parallel"}, "a task that waits for itself alone says `apart: true`"},
      {{"needs", "uses", "causing", "sets", "every", "providers"}, "this belongs to the group, in `groups`"},
      {{"description", "comment"}, "a text for people stands in `doc`"},
  };
  return slips;
}

const Slips& slips_of_step() {
  static const Slips slips{
      {{"wait", "sleep", "after", "time", "delay"}, "time passes with `advance: 100 ms`"},
      {{"check", "assert", "then", "expected", "output"}, "what should happen stands in `expect`"},
      {{"fire", "triggers"}, "one trigger is fired with `trigger: Picture`"},
      {{"requests", "tasks"}, "several tasks are one input: `request: [Walk, Look]`"},
      {{"states"}, "states are set with `set: {Ball: near}`"},
      {{"name", "description", "comment"}, "a text for people stands in `doc`"},
  };
  return slips;
}

const Slips& slips_of_input() {
  static const Slips slips{
      {{"advance", "wait", "sleep", "after", "time", "delay"}, "time passes in a step of its own: `- advance: 100 ms`"},
      {{"expect", "check", "assert", "then", "expected", "output"},
       "what should happen stands in `expect`, beside `inputs`"},
      {{"fire", "triggers"}, "one trigger is fired with `trigger: Picture`"},
      {{"requests", "tasks"}, "several tasks are one input: `request: [Walk, Look]`"},
      {{"states"}, "states are set with `set: {Ball: near}`"},
      {{"doc", "name", "description", "comment"}, "a text for people stands in `doc`, beside `inputs`"},
  };
  return slips;
}

const Slips& slips_of_case() {
  static const Slips slips{
      {{"keep", "nothing"}, "that everything goes on is said by `continue: true`"},
      {{"fail", "failure"}, "that a task failed is said by `failed: true`"},
      {{"success", "succeeded", "finished"}, "that a task is finished is said by `done: true`"},
      {{"request", "requests"}, "what is requested stands in `tasks` or `pack`: `tasks: [Legs]`"},
      {{"packs"}, "one of them is requested with `pack: attack`"},
      {{"sets"}, "states are set with `set: {Ball: near}`"},
      {{"when", "if"}, "a case may look at `reason`, `trigger`, `data`, `run` and `uses`"},
      {{"name", "doc", "description", "comment"}, "a text for people stands in a comment, behind `#`"},
  };
  return slips;
}

const Slips& slips_of_assertion() {
  static const Slips slips{
      {{"never", "always", "forbidden", "invariant", "not"},
       "assertions are about groups, `never_together: [Walk, Kick]`; a group that runs only with some values of "
       "states, "
       "`Rolls: {when: [Base == rolling]}`, stands for these"},
      {{"reachable", "possible", "eventually"}, "that a group runs at some time is said by `can_run: Kick`"},
      {{"doc", "name", "description", "comment"}, "a text for people stands in a comment, behind `#`"},
  };
  return slips;
}

const std::string* help_for_type(std::string_view type) {
  static const Slips slips{
      {{"bool", "boolean"},
       "leave it out and name the two values: `values: [closed, open]`; an enum is generated for them"},
      {{"integer",       "int8",         "int16",        "int32",        "int64",        "uint8",
        "uint16",        "uint32",       "uint64",       "int",          "unsigned",     "unsigned int",
        "short",         "long",         "size_t",       "int8_t",       "int16_t",      "int32_t",
        "int64_t",       "uint8_t",      "uint16_t",     "uint32_t",     "uint64_t",     "std::size_t",
        "std::int8_t",   "std::int16_t", "std::int32_t", "std::int64_t", "std::uint8_t", "std::uint16_t",
        "std::uint32_t", "std::uint64_t"},
       "leave it out and say which whole numbers: `range: [0, 100]`"},
      {{"float", "double"},
       "leave it out: a state has whole numbers, `range: [0, 1000]`, in a unit that is small enough"},
      {{"char", "string", "std::string", "std::string_view", "enum"},
       "leave it out and list the words: `values: [lost, seen]`; an enum is generated for them"},
  };
  return help_for(slips, type);
}

} // namespace director::dsl
