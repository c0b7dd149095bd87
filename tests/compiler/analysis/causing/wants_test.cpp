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

} // namespace
