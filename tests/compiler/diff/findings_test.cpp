// SPDX-License-Identifier: MIT
// Which findings count as the same on both sides.
#include "tests/compiler/diff/told.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using tests::told;

} // namespace

TEST_CASE("a finding that says never for another reason than before is the same one") {
  const auto unreachable = [](const std::string& expires) {
    return "states: {S: {values: [a, b, c], initial: a" + expires + "}}\nroots: [G]\ngroups: {G: {when: [S == b]}}\n";
  };
  CHECK(told(unreachable(""), unreachable(", expires: {after: 1 s, to: c}")) ==
        "state_source: `S` now expires after 1 s, and is `c` then\n"
        "api: something in it uses time now, so each `step` is given the time\n");
  const auto shadowed = [](const std::string& first) {
    return "roots: [G]\ngroups: {G: {providers: [{name: " + first + "}, {name: spare}]}}\n";
  };
  CHECK(told(shadowed("first"), shadowed("primary")) ==
        "provider_removed: the provider `first` of `G` is gone\n"
        "provider_added: the provider `primary` of `G` is new, tried first\n");
}

TEST_CASE("a finding that an allow covers on one side is not what can never run any more") {
  const auto robot = [](const std::string& allow) {
    return "roots: [G]\ngroups: {G: {providers: [{name: first}, {name: spare" + allow + "}]}}\n";
  };
  const std::string allow = ", allow: [shadowed_provider], because: the program disables the first one";
  const std::string finding = "`G.spare` never runs: `G.first` comes before it and can run whenever it can\n";
  CHECK(told(robot(allow), robot("")) == "finding_new: warning is no longer allowed: " + finding);
  CHECK(told(robot(""), robot(allow)) == "finding_gone: warning is allowed now: " + finding);
}

TEST_CASE("a condition in another form makes no other finding of it, whatever else has changed") {
  const auto robot = [](const std::string& triggers, const std::string& when) {
    return triggers + R"(roots: {Walk: {priority: 1}, Kick: {priority: 2}}
states: {Pose: {values: [moving, still], initial: moving}}
groups:
  Walk:
    stop: {sets: [Pose == moving]}
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Pose == still], tasks: [Legs]}
  Kick: {when: [)" +
           when + R"(], needs: [Legs], tasks: [Legs]}
  Legs: {}
)";
  };
  CHECK(told(robot("", "Pose == still"), robot("triggers: [New]\n", "Pose > moving")) ==
        "triggers: the trigger `New` is new\n");
}

TEST_CASE("a condition of a provider that never runs on either side is not what can never hold any more") {
  const auto robot = [](const std::string& s, const std::string& t) {
    return "states: {S: {values: [a, b], initial: a" + s + "}, T: {values: [x, y], initial: y" + t +
           "}}\nroots: [G]\ngroups: {G: {providers: [{name: first, when: [S == b, T == x]}, {name: rest}]}}\n";
  };
  const std::string external = ", external: true";
  CHECK(told(robot(external, ""), robot("", external)) ==
        "state_source: `S` may no longer be set from outside\n"
        "state_source: `T` may now be set from outside\n"
        "finding_new: error is new: `S == b` never holds: `S` is only ever a\n"
        "finding_gone: error is gone: `T == x` never holds: `T` is only ever y\n");
}

TEST_CASE("a group that nothing requests on either side is not what can never run any more") {
  const auto robot = [](const std::string& when) {
    return "states: {Door: {values: [shut, open], initial: shut}}\nroots: [Work]\ngroups: {Work: {" + when +
           "}, Crew: {causing: [Door == open]}}\n";
  };
  CHECK(told(robot(""), robot("when: [Door == open]")) ==
        "became_dead: `Work` can never run any more\n"
        "condition_tightened: `Work` now requires `Door == open` to run\n"
        "finding_new: error is new: `Crew` can never run, so nothing ever causes `Door == open`\n");
}
