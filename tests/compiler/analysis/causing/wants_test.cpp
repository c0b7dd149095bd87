// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/wants.hpp"
#include "compiler/analysis/words/words.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

/// "task: waiter condition <- causers" for each want.
std::string wants_in(const std::string& text) {
  const tests::Analysed test(text);
  const Model& model = test.model;
  std::string out;
  for (const Wanting& wanting : find_wants(model, test.facts, test.chains, find_causers(model))) {
    for (const Want& want : wanting.wants) {
      out += name_of(model, wanting.task) + ": " + name_of(model, want.waiter) + " " +
             name_of(model, want.condition.id) + " <-";
      for (const ProviderId causer : want.causers) out += " " + name_of(model, causer);
      out += "\n";
    }
  }
  return out;
}

const std::string walker = "states: {Pose: {values: [moving, standing], initial: moving}}\n";
const std::string walk = "  Walk: {providers: [{name: walking}, {name: halting, causing: [Pose == standing]}]}\n";

TEST_CASE("a task wants what it may push for, by itself or by what it needs") {
  CHECK(wants_in(walker + "roots: {Kick: {priority: 2}, Walk: {priority: 1}}\ngroups:\n" + walk +
                 "  Kick: {needs: [Leg]}\n  Leg: {when: [Pose == standing]}\n") ==
        "`Kick`: `Leg` `Pose == standing` <- `Walk.halting`\n");
}

TEST_CASE("a task wants nothing that it may not push for, or that never is lacking") {
  CHECK(wants_in(walker + "roots: {Kick: {priority: 1}, Walk: {priority: 2}}\ngroups:\n" + walk +
                 "  Kick: {when: [Pose == standing]}\n") == "");
  CHECK(wants_in(walker + "roots: {Kick: {priority: 2}, Walk: {priority: 1}}\ngroups:\n" + walk +
                 "  Kick: {when: [Pose == standing|moving]}\n") == "");
}

TEST_CASE("a task wants nothing of what its own conditions exclude, or those of the provider that needs it") {
  const std::string states = "states:\n  Pose: {values: [moving, standing], initial: moving}\n"
                             "  Estop: {values: [pressed, clear], initial: clear, external: true}\n"
                             "roots: {Kick: {priority: 2}, Walk: {priority: 1}}\ngroups:\n";
  const std::string halt = "  Walk: {providers: [{name: halting, when: [Estop == clear], causing: [Pose == standing]}, "
                           "{name: walking, sets: [Pose == moving]}]}\n";
  CHECK(wants_in(states + halt + "  Kick: {when: [Pose == standing, Estop == pressed]}\n") == "");
  CHECK(wants_in(states + halt +
                 "  Kick: {when: [Estop == pressed], needs: [Leg]}\n  Leg: {when: [Pose == standing]}\n") == "");
  CHECK(wants_in(states + halt + "  Kick: {when: [Pose == standing, Estop == clear]}\n") ==
        "`Kick`: `Kick` `Pose == standing` <- `Walk.halting`\n");
}

TEST_CASE("what is pushed wants what has to be caused before it runs, unless what runs instead keeps that off") {
  const auto wants_of_pushed_in = [](const std::string& resting, const std::string& needs) {
    const tests::Analysed test("states:\n  Pose: {values: [stale, fresh], initial: stale}\n"
                               "  Arm: {values: [out, ready], initial: out}\n"
                               "roots: {Grasp: {priority: 3}, Reach: {priority: 2}, Look: {priority: 1}}\ngroups:\n"
                               "  Grasp: {when: [Arm == ready]}\n  Camera: {}\n  Reach: {providers: [{name: resting" +
                               resting + "}, {name: reaching, when: [Pose == fresh], causing: [Arm == ready]}]}\n" +
                               "  Look: {causing: [Pose == fresh]" + needs + "}\n");
    const Causers causers = find_causers(test.model);
    const std::vector<Wanting> wants = find_wants(test.model, test.facts, test.chains, causers);
    std::string out;
    for (const Wanting& wanting :
         find_wants_of_pushed(test.model, test.facts, test.chains, causers, Indispensable(test.model), wants)) {
      for (const Want& want : wanting.wants) {
        out += name_of(test.model, want.waiter) + " " + name_of(test.model, want.condition.id) + " <-";
        for (const ProviderId causer : want.causers) out += " " + name_of(test.model, causer);
        out += ", for " + name_of(test.model, want.pushed->by) + " " + name_of(test.model, want.pushed->wanted);
      }
    }
    return out;
  };
  CHECK(wants_of_pushed_in("", ", needs: [Camera]") ==
        "`Reach.reaching` `Pose == fresh` <- `Look`, for `Grasp` `Arm == ready`");
  CHECK(wants_of_pushed_in(", needs: [Camera]", ", needs: [Camera]") == "");
}

} // namespace
