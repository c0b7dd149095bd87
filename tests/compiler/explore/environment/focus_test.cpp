// SPDX-License-Identifier: MIT
#include "compiler/explore/environment/focus.hpp"
#include "compiler/explore/search/search.hpp"
#include "tests/compiler/explore/environment/ground_words.hpp"
#include "tests/compiler/explore/explored.hpp"

using namespace director::compiler;
using director::tests::explore_all;
using director::tests::packs;
using director::tests::puts;

namespace {

/// Tidying, which the cup takes, is far away; a lamp, a door and a radio are not, and are independent of it.
const std::string household = R"(behaviour: b
language: 1
states:
  Cup: {values: [away, seen, gripped, washed], initial: away}
  Lamp: {values: [off, dim, on], initial: off, external: true}
  Door: {values: [shut, ajar, open], initial: shut, external: true}
  Radio: {values: [silent, music, talk], initial: silent, external: true}
  Battery: {range: [0, 100], initial: 0, external: true}
roots: {Tidy: {priority: 10}, Light: {priority: 5}, Listen: {priority: 5}, Greet: {priority: 5}}
groups:
  Tidy:
    when: [Battery > 20]
    packs: {rest: {}, look: {Search: {}}, take: {Grip: {}}, wash: {Wash: {}}, stow: {Stow: {}}}
  Search: {sets: [Cup == seen]}
  Grip: {when: [Cup == seen], sets: [Cup == gripped]}
  Wash: {when: [Cup == gripped], sets: [Cup == washed]}
  Stow: {when: [Cup == washed]}
  Light: {providers: [{name: bright, when: [Lamp == on]}, {name: dim, when: [Lamp == dim]}, {name: dark}]}
  Listen: {providers: [{name: music, when: [Radio == music]}, {name: talk, when: [Radio == talk]}]}
  Greet: {providers: [{name: guest, when: [Door == open]}, {name: knock, when: [Door == ajar]}]}
)";

GroupId group(const Model& model, const char* name) { return *model.find_group(name); }

} // namespace

TEST_CASE("a focus leaves the inputs and answers that a plan takes") {
  const auto compiled = director::tests::compile(household);
  Ground ground(compiled.model);
  focus_on(ground, {{group(compiled.model, "Grip")}, {}});
  CHECK(packs(ground, 0) == "|Grip |Search |");
  CHECK(puts(ground, ground.bodies[1].puts) == "|Cup=seen |");
  CHECK(puts(ground, ground.bodies[2].puts) == "|"); // no provider waits for what it sets
  CHECK(puts(ground, ground.sets) == "Battery=0 |Battery=21 |");
  CHECK(ground.requests.size() == 1);
  CHECK(ground.triggers.empty());
  CHECK(ground.expiries.empty());
}

TEST_CASE("a focus leaves the largest and the smallest pack that requests what a plan takes") {
  const auto compiled = director::tests::compile(
      "behaviour: b\nlanguage: 1\nroots: [Tidy]\ngroups:\n"
      "  Tidy: {packs: {rest: {}, some: {Grip: {}, Look: {}}, all: {Grip: {}, Look: {}, Walk: {}}, one: {Grip: {}}}}\n"
      "  Grip: {}\n  Look: {}\n  Walk: {}\n");
  Ground ground(compiled.model);
  focus_on(ground, {{group(compiled.model, "Grip")}, {}});
  CHECK(packs(ground, 0) == "|Grip Look Walk |Grip |");
}

TEST_CASE("a focus leaves the inputs that keep a provider from running which comes before the one of the plan") {
  const auto compiled = director::tests::compile(
      "behaviour: b\nlanguage: 1\nstates:\n  Lamp: {values: [off, on], initial: on, external: true}\n"
      "  Door: {values: [shut, open], initial: shut, external: true}\n"
      "  Radio: {values: [silent, music], initial: silent, external: true}\nroots: [Greet, Listen]\ngroups:\n"
      "  Greet: {providers: [{name: wave, when: [Lamp == on]}, {name: call, when: [Door == open]}]}\n"
      "  Listen: {when: [Radio == music]}\n");
  Ground ground(compiled.model);
  focus_on(ground, {{}, {compiled.provider("Greet.call")}});
  CHECK(puts(ground, ground.sets) == "Lamp=off |Lamp=on |Door=shut |Door=open |");
}

TEST_CASE("a goal that cannot be reached has no plan") {
  const auto compiled = director::tests::compile("behaviour: b\nlanguage: 1\n"
                                                 "states: {S: {values: [x, y], initial: x}}\n"
                                                 "roots: [A]\ngroups: {A: {when: [S == y], tasks: [B]}, B: {}}\n");
  Ground ground(compiled.model);
  focus_on(ground, {{group(compiled.model, "B")}, {}});
  CHECK(ground.requests.empty());
  CHECK(search(ground, {}).states == 1);
}

TEST_CASE("what runs after a long way is found, whatever else may happen") {
  const auto compiled = director::tests::compile(household + "assertions: [{can_run: Stow}]\n");
  const Ground ground(compiled.model);
  CHECK(explore_all(ground, 2'000).verdicts.front().why == "it runs after: request Tidy; set {Battery: 21}");

  SearchOptions lean;
  lean.assertions = {0};
  lean.breadth = Breadth::lean;
  lean.bound = 2'000;
  CHECK_FALSE(search(ground, lean).seen[0].has_value());
}

TEST_CASE("a provider that runs only when it is pushed is found beside the task that waits for it") {
  std::string text = household;
  text.replace(text.find("roots: {"), 8, "roots: {Play: {priority: 2}, Stroll: {priority: 1}, ");
  text.replace(text.find("  Lamp:"), 0, "  Pose: {values: [moving, still], initial: moving}\n");
  const auto compiled = director::tests::compile(text + R"(
  Play: {packs: {rest: {}, kick: {Kick: {}}}}
  Stroll: {packs: {rest: {}, go: {Walk: {}}}}
  Kick: {when: [Pose == still], needs: [Legs], tasks: [Legs]}
  Walk:
    providers:
      - {name: walking, needs: [Legs], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Pose == still], tasks: [Legs]}
  Legs: {}
)");
  const Ground ground(compiled.model);
  const Exploration cut = explore_all(ground, 2'000);
  CHECK_FALSE(cut.searched.complete);
  for (const ProviderId id : cut.never_ran) CHECK(compiled.model.full_name(id) == "");
}
