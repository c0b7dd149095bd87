// SPDX-License-Identifier: MIT
// Which changes of meaning are reported, with which text. Planted defects and changes without meaning:
// tests/defects/meaning.
#include "tests/compiler/diff/told.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using tests::Files;
using tests::told;

/// A robot that walks and kicks, softly.
std::string walker(const std::string& kick, const std::string& within, const std::string& priorities) {
  return "states: {Pose: {values: [moving, standing], initial: standing}}\n"
         "roots: {" +
         priorities +
         "}\n"
         "groups:\n"
         "  Walk:\n"
         "    providers:\n"
         "      - {name: walking, when: [Pose == moving|standing], needs: [Legs], sets: [Pose == moving], tasks: "
         "[Legs]}\n"
         "      - {name: halting, needs: [Legs], causing: [Pose == standing" +
         within +
         "], tasks: [Legs]}\n"
         "  Kick: {" +
         kick +
         "needs: [Legs], tasks: [Legs]}\n"
         "  Legs: {}\n";
}

const char* const ranks = "Walk: {priority: 10}, Kick: {priority: 20}";
const char* const waits = "when: [Pose == standing], ";

TEST_CASE("states of a hundred thousand values are compared") {
  std::string values = "v0";
  for (std::size_t i = 1; i < 100'000; ++i) values += ", v" + std::to_string(i);
  const auto with = [](const std::string& listed) {
    return "states: {Mood: {values: [" + listed + "], external: true}}\nroots: [Walk]\ngroups: {Walk: {}}\n";
  };
  CHECK(told(with(values), with(values + ", more")) == "state_values: `Mood` may now be `more`\n");
}

} // namespace

TEST_CASE("the kinds of changes are in order, each once, with a sentence") {
  std::size_t at = 0;
  for (const compiler::ChangeKindPage& page : compiler::change_kinds()) {
    CHECK(static_cast<std::size_t>(page.kind) == at++);
    CHECK(page.meaning.ends_with("."));
  }
}

TEST_CASE("a condition that made a transition soft is gone: it is hard, and that comes first") {
  CHECK(
      told(walker(waits, "", ranks), walker("", "", ranks)) ==
      "hardened: from `Walk` to `Kick`: hard now, before soft\n"
      "became_dead: `Walk.halting` can never run any more\n"
      "became_dead: warning is new: `Walk.halting` never runs: `Walk.walking` comes before it and can run whenever it "
      "can\n"
      "condition_loosened: `Kick` no longer requires `Pose == standing` to run\n"
      "push_lost: `Kick` can no longer push `Walk.halting`\n");
}

TEST_CASE("the other way round it is soft now") {
  CHECK(told(walker("", "", ranks), walker(waits, "", ranks)) ==
        "became_reachable: `Walk.halting` may run now\n"
        "became_reachable: warning is gone: `Walk.halting` never runs: `Walk.walking` comes before it and can run "
        "whenever it can\n"
        "condition_tightened: `Kick` now requires `Pose == standing` to run\n"
        "push_gained: `Kick` may now push `Walk.halting`\n"
        "softened: from `Walk` to `Kick`: soft now, before hard\n");
}

TEST_CASE("the groups of one change of transitions are in alphabetical order") {
  const auto robot = [](const std::string& when) {
    return "states: {Pose: {values: [moving, standing], initial: standing}}\n"
           "roots: {Walk: {priority: 10}, Shoot: {priority: 20}, Kick: {priority: 20}}\ngroups:\n"
           "  Walk: {providers: [{name: walking, when: [Pose == moving|standing], needs: [Legs], sets: [Pose == "
           "moving],"
           " tasks: [Legs]}, {name: halting, needs: [Legs], causing: [Pose == standing], tasks: [Legs]}]}\n"
           "  Shoot: {" +
           when + "needs: [Legs], tasks: [Legs]}\n  Kick: {" + when + "needs: [Legs], tasks: [Legs]}\n  Legs: {}\n";
  };
  CHECK(told(robot(waits), robot(""))
            .starts_with("hardened: from `Walk` to `Kick` and `Shoot`: hard now, before soft\n"));
}

TEST_CASE("a finding of a check that may over-report does not prove that something never happens") {
  const auto beeping = [](const std::string& tasks) {
    return R"(states:
  Air: {values: [flying, hover], initial: flying, external: true}
  Battery: {values: [empty, low, fine], initial: fine, external: true}
roots: [Safety]
groups:
  Safety:
    providers:
      - {name: empty, when: [Battery == empty], tasks: [)" +
           tasks + R"(]}
      - {name: low, when: [Battery == low], packs: {down: {Land: {priority: 5}, Fly: {apart: true}}}}
      - {name: ok, tasks: [Fly]}
  Fly:
    providers:
      - {name: cruise, needs: [Rotors], sets: [Air == flying], tasks: [Rotors]}
      - {name: brake, needs: [Rotors], causing: [Air == hover], tasks: [Rotors]}
  Land: {when: [Air == hover], stay: [Air == flying|hover], needs: [Rotors], tasks: [Rotors]}
  Rotors: {}
  Beep: {}
)";
  };
  const std::string finding = "`Land` may wait here for `Air == hover`, and `Fly`, which could cause it, need not be "
                              "requested\n";
  CHECK(told(beeping("Beep"), beeping("Beep, Land")) ==
        "request_added: `Safety.empty` may now request `Land`\n"
        "transition_changed: from `Fly` to `Land`: condition lost now, before soft\n"
        "finding_new: warning is new: " +
            finding);
  CHECK(told(beeping("Beep, Land"), beeping("Beep")) ==
        "request_removed: `Safety.empty` no longer requests `Land`\n"
        "transition_changed: from `Fly` to `Land`: soft now, before condition lost\n"
        "finding_gone: warning is gone: " +
            finding);
}

TEST_CASE("a transition becomes hard that the outside begins, as one requester then requests both") {
  const auto keeper = [](const std::string& conditions) {
    return R"(states:
  Ball: {values: [far, near], initial: far, external: true}
  Hold: {values: [free, held], initial: free, of: Walk}
roots: [Keep]
groups:
  Keep:
    providers:
      - {name: clearing, when: [Ball == near], packs: {go: {Clear: {priority: 20}, Walk: {apart: true}}}}
      - {name: placing, tasks: [Walk]}
  Clear: {)" +
           conditions + R"(needs: [Legs], tasks: [Legs]}
  Walk:
    providers:
      - {name: walking, when: [Hold == free], needs: [Legs], tasks: [Legs]}
      - {name: halting, needs: [Legs], sets: [Hold == free], causing: [Hold == held], tasks: [Legs]}
  Legs: {}
)";
  };
  CHECK(
      told(keeper("when: [Hold == held], stay: [Hold == free|held], "), keeper("")) ==
      "hardened: from `Walk` to `Clear`: hard now, before soft\n"
      "became_dead: `Walk.halting` can never run any more\n"
      "became_dead: warning is new: `Walk.halting` never runs: `Walk.walking` comes before it and can run whenever it "
      "can\n"
      "condition_loosened: `Clear` no longer requires `Hold == held` to run\n"
      "push_lost: `Clear` can no longer push `Walk.halting`\n");
}

TEST_CASE("a promise takes longer, and so does the transition that waits for it") {
  CHECK(told(walker(waits, " within 2 s", ranks), walker(waits, " within 500 ms", ranks)) ==
        "bound_shrank: `Walk.halting` promises `Pose == standing` within 500 ms; before within 2 s\n"
        "bound_shrank: from `Walk` to `Kick`: soft, and may take at most 500 ms, before at most 2 s\n");
  CHECK(told(walker(waits, " within 2 s", ranks), walker(waits, "", ranks)) ==
        "bound_grew: `Walk.halting` promises `Pose == standing` at no time in particular; before within 2 s\n"
        "bound_grew: from `Walk` to `Kick`: soft, and may take any time, before at most 2 s\n");
}

TEST_CASE("two tasks change ranks: the one gains what the other loses") {
  const char* const plain = "groups: {Walk: {needs: [Legs]}, Kick: {needs: [Legs]}, Legs: {}}\n";
  CHECK(
      told(std::string("roots: {Walk: {priority: 10}, Kick: {priority: 20}}\n") + plain,
           std::string("roots: {Walk: {priority: 30}, Kick: {priority: 20}}\n") + plain) ==
      "takeover_gained: `Walk` can now take `Legs` from `Kick`: the program requests it with priority 30, before with "
      "priority 10\n"
      "takeover_lost: `Kick` can no longer take `Legs` from `Walk`: the program requests `Walk` with priority 30, "
      "before with priority 10\n"
      "transition_changed: from `Kick` to `Walk`: hard now, before waits\n"
      "transition_changed: from `Walk` to `Kick`: waits now, before hard\n");
}

TEST_CASE("of two warnings of one check that one is allowed now is reported") {
  const auto robot = [](const std::string& of_a, const std::string& of_b) {
    return "states: {Mode: {values: [a, b], initial: a, external: true}}\nroots: [A, B]\ngroups:\n"
           "  A: {providers: [{name: p}, {name: q, when: [Mode == a]" +
           of_a + "}]}\n  B: {providers: [{name: p}, {name: q, when: [Mode == a]" + of_b + "}]}\n";
  };
  const std::string allowed = ", allow: [shadowed_provider], because: known";
  CHECK(told(robot("", ""), robot(allowed, "")).find("warning is allowed now: `A.q` never runs") != std::string::npos);
  CHECK(told(robot(allowed, ""), robot("", "")).find("warning is no longer allowed: `A.q` never runs") !=
        std::string::npos);
  CHECK(told(robot("", ""), robot("", allowed)).find("warning is allowed now: `B.q` never runs") != std::string::npos);
  CHECK(told(robot("", allowed), robot("", "")).find("warning is no longer allowed: `B.q` never runs") !=
        std::string::npos);
}

TEST_CASE("what never runs on either side is not reported, whatever keeps it from running") {
  const auto robot = [](const std::string& door) {
    return "states: {Door: {values: [shut, open], initial: shut" + door +
           "}}\nroots: [Pass]\ngroups:\n  Pass: {when: [Door == shut], packs: {go: [Walk]}}\n"
           "  Walk: {providers: [{name: through, when: [Door == open], sets: [Door]}, {name: around}]}\n";
  };
  for (const std::string& text :
       {told(robot(""), robot(", external: true")), told(robot(", external: true"), robot(""))}) {
    CHECK(text.find("became_") == std::string::npos);
    CHECK(text.find("never run") == std::string::npos);
  }
  const auto providers = [](const std::string& light) {
    return "states: {Light: {values: [dark, bright], initial: dark" + light +
           "}}\nroots: [Look]\ngroups:\n  Look: {providers: [{name: a, when: [Light == bright]}, "
           "{name: b, when: [Light == bright]}, {name: c}]}\n";
  };
  const std::string text = told(providers(", external: true"), providers(""));
  INFO(text);
  CHECK(text.find("became_dead: `Look.a` can never run any more\n") != std::string::npos);
  CHECK(text.find("became_reachable") == std::string::npos);
}

TEST_CASE("transitions of a group that is no longer made to run, and of which that is not proven") {
  const auto robot = [](const std::string& walk, const std::string& kick) {
    return "roots: [Play, Rest, Wave]\ngroups:\n  Play: {packs: {go: {Walk: {priority: " + walk +
           "}, Kick: {priority: " + kick +
           ", apart: true}}}}\n"
           "  Rest: {needs: [Head], tasks: [Head]}\n"
           "  Wave: {needs: [Arm], tasks: [Arm]}\n"
           "  Walk: {needs: [Legs], tasks: [Legs]}\n"
           "  Kick: {needs: [Legs], tasks: [Legs]}\n"
           "  Legs: {}\n  Head: {}\n  Arm: {}\n";
  };
  CHECK(
      told(robot("10", "20"), robot("20", "10")) ==
      "takeover_gained: `Walk` can now take `Legs` from `Kick`: `Play` requests it with priority 20, before with "
      "priority 10\n"
      "takeover_lost: `Kick` can no longer take `Legs` from `Walk`: `Play` requests it with priority 10 (apart), "
      "before "
      "with priority 20 (apart)\n"
      "transition_changed: from `Kick` to `Rest` and `Wave`: unreachable now, as `Kick` is not made to run; before "
      "both\n"
      "transition_changed: from `Rest` and `Wave` to `Kick`: unreachable now, as `Kick` is not made to run; before "
      "both\n"
      "transition_changed: from `Walk` to `Rest` and `Wave`: both now; before unreachable, as `Walk` was not made to "
      "run\n"
      "transition_changed: from `Rest` and `Wave` to `Walk`: both now; before unreachable, as `Walk` was not made to "
      "run\n"
      "finding_new: warning is new: `Kick` never runs for `Play`: `Walk`, which goes before it and never has to wait, "
      "is always requested with it and takes `Legs`\n"
      "finding_gone: warning is gone: `Walk` never runs for `Play`: `Kick`, which goes before it and never has to "
      "wait, "
      "is always requested with it and takes `Legs`\n");
}

TEST_CASE("of a group that is proven never to run the transitions are not reported besides") {
  const auto robot = [](const std::string& tasks) {
    return "roots: [Play, Rest]\ngroups:\n  Play: {tasks: [" + tasks +
           "]}\n"
           "  Rest: {needs: [Head], tasks: [Head]}\n"
           "  Walk: {needs: [Legs], tasks: [Legs]}\n"
           "  Kick: {needs: [Legs], tasks: [Legs]}\n"
           "  Legs: {}\n  Head: {}\n";
  };
  CHECK(told(robot("Walk, Kick"), robot("Walk")) ==
        "became_dead: `Kick` is never requested any more\n"
        "request_removed: `Play` no longer requests `Kick`\n"
        "finding_gone: warning is gone: `Walk` and `Kick` can never be granted together: both come down to `Legs`\n");
}

TEST_CASE("another number that changes no rank is reported as that: what could take a group still can") {
  const char* const plain = "groups: {Walk: {needs: [Legs]}, Kick: {needs: [Legs]}, Legs: {}}\n";
  CHECK(told(std::string("roots: {Walk: {priority: 10}, Kick: {priority: 20}}\n") + plain,
             std::string("roots: {Walk: {priority: 10}, Kick: {priority: 30}}\n") + plain) ==
        "priority: the program requests `Kick` with priority 30, before with priority 20; what each can take from the "
        "others is as before, but their bodies run by priority where they are granted at once\n");
}

TEST_CASE("a task that leads to one more group can take that group too") {
  const char* const roots = "roots: {Walk: {priority: 10}, Kick: {priority: 20}}\n";
  CHECK(
      told(std::string(roots) + "groups: {Walk: {needs: [Legs, Arms]}, Kick: {needs: [Legs]}, Legs: {}, Arms: {}}\n",
           std::string(roots) +
               "groups: {Walk: {needs: [Legs, Arms]}, Kick: {needs: [Legs, Arms]}, Legs: {}, Arms: {}}\n") ==
      "takeover_gained: `Kick` can now take `Arms` from `Walk`: below the program the one goes before the other as it "
      "did; what they lead to has changed\n"
      "needs_added: `Kick` now needs `Arms`\n");
}

TEST_CASE("at one of several levels a task can take what it could not") {
  const auto robot = [](const char* drive) {
    return std::string("roots: {Search: {priority: {lazy: 5, calm: 10, eager: 20}}, Drive: {priority: ") + drive +
           "}}\ngroups: {Search: {needs: [Legs]}, Drive: {needs: [Legs]}, Legs: {}}\n";
  };
  CHECK(told(robot("10"), robot("15"))
            .starts_with("takeover_gained: `Drive` can take `Legs` from `Search` in more cases now: the program "
                         "requests it with priority 15, before with priority 10\n"));
  CHECK(told(robot("15"), robot("10"))
            .starts_with("takeover_lost: `Drive` can take `Legs` from `Search` in fewer cases now: the program "
                         "requests it with priority 10, before with priority 15\n"));
  CHECK(told(robot("12"), robot("15")) == "priority: the program requests `Drive` with priority 15, before with "
                                          "priority 12; what each can take from the others is as before, but their "
                                          "bodies run by priority where they are granted at once\n");
}

TEST_CASE("levels that changed places are named, and so is a group that can never run any more") {
  const auto robot = [](const char* walk) {
    return std::string("states: {P: {values: [m, s], initial: m}}\nroots: {Walk: {priority: ") + walk +
           R"(}, Kick: {priority: 5}}
groups:
  Walk:
    providers:
      - {name: go, needs: [Legs], sets: [P == m], tasks: [Legs]}
      - {name: halt, needs: [Legs], causing: [P == s], tasks: [Legs]}
  Kick: {when: [P == s], needs: [Legs], tasks: [Legs]}
  Legs: {}
)";
  };
  const std::string why = ": the program at `calm` requests `Walk` with priority 9, before with 1 and the program at "
                          "`hot` requests `Walk` with priority 1, before with 9\n";
  const std::string walk = "`Walk` can take `Legs` from `Kick` in ", kick = "`Kick` can take `Legs` from `Walk` in ";
  CHECK(told(robot("{calm: 1, hot: 9}"), robot("{calm: 9, hot: 1}"))
            .starts_with("takeover_gained: " + walk + "more cases now" + why + "takeover_gained: " + kick +
                         "more cases now" + why + "takeover_lost: " + walk + "fewer cases now" + why +
                         "takeover_lost: " + kick + "fewer cases now" + why));
  CHECK(told(robot("{calm: 1, hot: 9}"), robot("{calm: 6, hot: 9}"))
            .starts_with("takeover_lost: `Walk` can no longer take `Legs` from `Kick`: `Kick` can never run any more; "
                         "the program requests `Walk` with priority 6 and 9, before with priority 1 and 9\n"
                         "takeover_lost: `Kick` can no longer take `Legs` from `Walk`: `Kick` can never run any more; "
                         "the program requests `Walk` with priority 6 and 9, before with priority 1 and 9\n"
                         "became_dead: `Kick` can never run any more\n"));
  CHECK(told(robot("{calm: 6, hot: 9}"), robot("{calm: 1, hot: 9}"))
            .starts_with("takeover_gained: `Walk` can now take `Legs` from `Kick`: `Kick` could never run before; the "
                         "program requests `Walk` with priority 1 and 9, before with priority 6 and 9\n"
                         "takeover_gained: `Kick` can now take `Legs` from `Walk`: `Kick` could never run before; the "
                         "program requests `Walk` with priority 1 and 9, before with priority 6 and 9\n"
                         "became_reachable: `Kick` may run now\n"));
}

TEST_CASE("levels with other numbers in the order of before are not why a task can take one more group") {
  const auto robot = [](const std::string& priorities, const std::string& arms) {
    return "roots: {Walk: {priority: " + priorities + "}, Kick: {priority: 5}}\ngroups: {Walk: {needs: [Legs" + arms +
           "]}, Kick: {needs: [Legs, Arms]}, Legs: {}, Arms: {}}\n";
  };
  CHECK(told(robot("{calm: 9, hot: 1}", ""), robot("{calm: 8, hot: 2}", ", Arms"))
            .starts_with("takeover_gained: `Walk` can now take `Arms` from `Kick`: below the program the one goes "
                         "before the other as it did; what they lead to has changed\n"));
}

TEST_CASE("a way that became mandatory is compared with the one that was optional, at each level") {
  const auto robot = [](const char* head) {
    return std::string(R"(states: {S: {values: [a, b], initial: a, external: true}}
roots: {Walk: {priority: 1}, Look: {levels: {firm: {priority: 5}, spare: {priority: 2, optional: true}}}}
groups:
  Walk:
    providers:
      - {name: w1, when: [S == a], tasks: )") +
           head + R"(}
      - {name: w2, tasks: {Head: {apart: true}}}
  Look: {tasks: [Head]}
  Head: {}
)";
  };
  CHECK(told(robot("{Head: {optional: true}}"), robot("[Head]")) ==
        "takeover_gained: `Walk` can take `Head` from `Look` in more cases now: below the program the one goes before "
        "the other as it did; when they lead there, or how, has changed\n"
        "takeover_lost: `Look` can take `Head` from `Walk` in fewer cases now: below the program the one goes before "
        "the other as it did; when they lead there, or how, has changed\n"
        "unit: `Walk.w1` requests `Head` as mandatory, before as optional\n");
}

TEST_CASE("an optional task and one below which something is optional are compared by priority") {
  const auto robot = [](const char* look) {
    return std::string("roots: {Play: {priority: 20}, Look: {optional: true, priority: ") + look +
           "}}\ngroups: {Play: {tasks: {Head: {optional: true}}}, Look: {tasks: [Head]}, Head: {}}\n";
  };
  CHECK(told(robot("20"), robot("30"))
            .starts_with("takeover_gained: `Look` can now take `Head` from `Play`: the program requests it with "
                         "priority 30 (optional), before with priority 20 (optional)\n"));
}

TEST_CASE("tasks that request each other take from each other") {
  const auto robot = [](const char* track) {
    return std::string("roots: {Search: {priority: 20}, Track: {priority: ") + track +
           "}}\ngroups: {Search: {tasks: [Track]}, Track: {tasks: {Search: {optional: true}}}}\n";
  };
  CHECK(told(robot("10"), robot("30")) == "takeover_gained: `Track` can now take `Search` itself: the program "
                                          "requests it with priority 30, before with priority 10\n"
                                          "takeover_gained: `Track` can take the place of `Search` in more cases "
                                          "now: the program requests it with priority 30, before with priority 10\n"
                                          "takeover_lost: `Search` can no longer always take the place of `Track`: "
                                          "the program requests `Track` with priority 30, before with priority 10\n"
                                          "takeover_lost: `Search` can take `Track` itself in fewer cases now: "
                                          "the program requests `Track` with priority 30, before with priority 10\n");
}

TEST_CASE("a member of a unit goes forward with it") {
  const auto robot = [](const char* lift) {
    return std::string("roots: [Play]\ngroups: {Play: {packs: {go: {Lift: {priority: ") + lift +
           "}, Grip: {priority: 10}, Look: {priority: 30, apart: true}}}}, Lift: {}, Grip: {needs: [Hand]}, "
           "Look: {needs: [Hand]}, Hand: {}}\n";
  };
  const std::string never =
      ", which goes before it and never has to wait, is always requested with it and takes `Hand`\n";
  const std::string findings = "finding_new: warning is new: `Grip` never runs for `Play`: `Look`" + never +
                               "finding_gone: warning is gone: `Look` never runs for `Play`: `Grip`" + never;
  CHECK(told(robot("50"), robot("20")) ==
        "takeover_gained: `Look` can now always take `Hand` from `Grip`: `Play` requests `Lift`, "
        "which may be granted together with `Grip`, with priority 20, before with priority 50\n"
        "takeover_lost: `Grip` can no longer take `Hand` from `Look`: `Play` requests `Lift`, which "
        "may be granted together with `Grip`, with priority 20, before with priority 50\n" +
            findings);
  CHECK(told(robot("50"), robot("40")) == "priority: `Play` requests `Lift` with priority 40, before with priority 50; "
                                          "what each can take from the others is as before, but their bodies run by "
                                          "priority where they are granted at once\n");
  // The same request in another pack.
  CHECK(told(robot("50"),
             "roots: [Play]\ngroups: {Play: {packs: {go: {Grip: {priority: 10}, Look: {priority: 30, apart: "
             "true}}, lift: {Lift: {priority: 50}}}}, Lift: {}, Grip: {needs: [Hand]}, "
             "Look: {needs: [Hand]}, Hand: {}}\n") ==
        "takeover_gained: `Look` can now always take `Hand` from `Grip`: what may be granted together with `Grip` has "
        "changed\n"
        "takeover_lost: `Grip` can no longer take `Hand` from `Look`: what may be granted together with `Grip` has "
        "changed\n"
        "request_added: `Play` has a new pack `lift` with `Lift`\n"
        "request_removed: `Play`, pack `go`, no longer requests `Lift`\n" +
            findings);
}

TEST_CASE("tasks that are never requested at once are compared while control passes") {
  const auto robot = [](const char* kick) {
    return std::string("roots: [Play]\ngroups: {Play: {packs: {go: {Walk: {priority: 20}}, shoot: {Kick: {priority: ") +
           kick + "}}}}, Walk: {needs: [Legs]}, Kick: {needs: [Legs]}, Legs: {}}\n";
  };
  CHECK(told(robot("10"), robot("30")) ==
        "takeover_gained: `Kick` can take `Legs` from `Walk` in more cases now, while control passes: `Play` requests "
        "it with priority 30, before with priority 10\n"
        "takeover_lost: `Walk` can take `Legs` from `Kick` in fewer cases now, while control passes: `Play` requests "
        "`Kick` with priority 30, before with priority 10\n");
  CHECK(told(robot("30"), robot("40")) == "priority: `Play` requests `Kick` with priority 40, before with priority 30; "
                                          "what each can take from the others is as before, but their bodies run by "
                                          "priority where they are granted at once\n");
}

TEST_CASE("what a task can take in passing has the place of the task with another priority") {
  const auto robot = [](const char* kick) {
    return std::string("roots: [Play]\ngroups: {Play: {packs: {go: {Walk: {priority: 20}}, shoot: {Kick: {priority: ") +
           kick + "}}}}, Walk: {needs: [Legs]}, Kick: {needs: [Legs]}, Legs: {}}\n";
  };
  const std::string head = "behaviour: robot\nlanguage: 1\n", before = head + robot("10"), after = head + robot("30");
  const std::vector<compiler::BehaviourChange> all = tests::changes({robot("10"), {}}, {robot("30"), {}});
  REQUIRE(all.size() == 2);
  for (const compiler::BehaviourChange& change : all) {
    CHECK(before.substr(change.before->begin, 4) == "Kick");
    CHECK(after.substr(change.after->begin, 4) == "Kick");
  }
}

TEST_CASE("what a request marked keep keeps is reported") {
  const auto robot = [](const char* far) {
    return std::string(
               "roots: [Watch]\ngroups: {Watch: {packs: {near: {Look: {priority: 10}}, far: {Look: {priority: ") +
           far + "}}}}, Look: {}}\n";
  };
  CHECK(told(robot("10"), robot("20")) ==
        "levels: `Look` is requested with priority 10 and 20, before with priority 10: marked *keep*, a request by "
        "`Watch` in pack `near` no longer keeps what was requested by `Watch` in pack `far`, as their levels differ\n"
        "priority: `Watch` requests `Look` with priority 10 and 20, before with priority 10; what each can take from "
        "the others is as before, but their bodies run by priority where they are granted at once\n");
  CHECK(told(robot("20"), robot("10")) ==
        "levels: `Look` is requested with priority 10, before with priority 10 and 20: marked *keep*, a request by "
        "`Watch` in pack `near` now keeps what was requested by `Watch` in pack `far`, as their levels are the same\n"
        "priority: `Watch` requests `Look` with priority 10, before with priority 10 and 20; what each can take from "
        "the others is as before, but their bodies run by priority where they are granted at once\n");
  CHECK(told(robot("20"), robot("30")) == "priority: `Watch` requests `Look` with priority 10 and 30, before with "
                                          "priority 10 and 20; what each can take from the others is as before, but "
                                          "their bodies run by priority where they are granted at once\n");
}

TEST_CASE("one more pack or level changes no priority") {
  const auto robot = [](const std::string& packs) {
    return "roots: [D]\ngroups: {D: {packs: {" + packs + "}}, M: {}, L: {}}\n";
  };
  CHECK(told(robot("go: {M: {}, L: {}}"), robot("go: {M: {}, L: {}}, stay: {M: {}, L: {apart: true}}")) ==
        "request_added: `D` has a new pack `stay` with `M` and `L`\n");
  CHECK(told(robot("go: {M: {priority: {low: 1, high: 2}}, L: {}}"),
             robot("go: {M: {priority: {low: 1, high: 2, top: 3}}, L: {}}")) ==
        "levels: `D`, pack `go`, may now request `M` at `top`\n");
}

TEST_CASE("for a task of the program apart changes nothing") {
  const std::string groups = "groups: {Walk: {}, Look: {}}\n";
  CHECK(told("roots: {Walk: {priority: 10}, Look: {}}\n" + groups,
             "roots: {Walk: {priority: 10}, Look: {apart: true}}\n" + groups)
            .empty());
}

TEST_CASE("of equal rank the order decides, of different ranks it does not") {
  const char* const plain = "groups: {Walk: {needs: [Legs]}, Kick: {needs: [Legs]}, Legs: {}}\n";
  CHECK(
      told(std::string("roots: [Walk, Kick]\n") + plain, std::string("roots: [Kick, Walk]\n") + plain)
          .starts_with(
              "tie_order: of what the program requests at one priority, the order is `Kick` and `Walk`, before `Walk` "
              "and `Kick`: of those that were requested at once, the first one that wants `Legs` gets it\n"));
  CHECK(told(std::string("roots: {Walk: {priority: 1}, Kick: {}}\n") + plain,
             std::string("roots: {Kick: {}, Walk: {priority: 1}}\n") + plain)
            .empty());
}

TEST_CASE("another order has the place of what is the first now") {
  const std::string plain = "groups: {Walk: {needs: [Legs]}, Kick: {needs: [Legs]}, Legs: {}}\n",
                    head = "behaviour: robot\nlanguage: 1\n";
  const std::string before = "roots: [Walk, Kick]\n" + plain, after = "roots: [Kick, Walk]\n" + plain;
  const std::vector<compiler::BehaviourChange> all = tests::changes({before, {}}, {after, {}});
  REQUIRE(all.front().kind == compiler::ChangeKind::tie_order);
  CHECK((head + before).substr(all.front().before->begin, 4) == "Kick");
  CHECK((head + after).substr(all.front().after->begin, 4) == "Kick");
}

TEST_CASE("what a priority changes is compared only in a behaviour with roots, and in a module this is said") {
  const auto module = [](const std::string& priority) {
    return "groups: {Play: {packs: {go: {Walk: {priority: " + priority +
           "}, Kick: {priority: 2, apart: true}}}}, Walk: {needs: [Legs]}, Kick: {needs: [Legs]}, Legs: {}}\n";
  };
  CHECK(told(module("3"), module("1")) ==
        "priority: `Play` requests `Walk` with priority 1, before with priority 3; what each can take from the others "
        "is compared only in a behaviour with `roots`\n");
}

TEST_CASE("the order of providers, and of needs between whose providers there is a choice, is reported") {
  const auto robot = [](const std::string& providers) {
    return "states: {Charge: {range: [0, 100], external: true}}\nroots: [Walk]\ngroups:\n  Walk: {providers: [" +
           providers +
           "]}\n  One: {providers: [{name: left, when: [Charge > 5]}, {name: right}]}\n"
           "  Two: {providers: [{name: up, when: [Charge > 5]}, {name: down}]}\n  Three: {}\n";
  };
  CHECK(told(robot("{name: fast, when: [Charge > 50]}, {name: slow}"),
             robot("{name: slow}, {name: fast, when: [Charge > 50]}"))
            .find("preference: the providers of `Walk` are tried in the order `slow` and `fast`, before `fast` and "
                  "`slow`\n") != std::string::npos);
  CHECK(told(robot("{name: only, needs: [One, Three, Two]}"), robot("{name: only, needs: [Three, Two, One]}")) ==
        "preference: for the needs of `Walk.only` providers are chosen in the order `Two` and `One`, before `One` and "
        "`Two`\n");
  CHECK(told(robot("{name: only, needs: [One, Three]}"), robot("{name: only, needs: [Three, One]}")).empty());
}

TEST_CASE("conditions are compared by what they accept") {
  const auto robot = [](const std::string& when) {
    return "states:\n  Phase: {values: [off, ready, set], initial: off, external: true}\n"
           "  Charge: {range: [0, 100], external: true}\n"
           "roots: [Walk]\ngroups: {Walk: {when: [" +
           when + "], allow: [uncovered_state], because: it waits}}\n";
  };
  CHECK(told(robot("Phase == ready|set"), robot("Phase != off")).empty());
  CHECK(told(robot("Phase >= ready"), robot("Phase == set|ready, Phase != off")).empty());
  CHECK(told(robot("Charge > 30, Charge < 60"), robot("Charge <= 59, Charge >= 31")).empty());
  CHECK(told(robot("Phase == ready"), robot("Phase == set")) ==
        "condition_loosened: `Walk` may now run also while `Phase == set`\n"
        "condition_tightened: `Walk` may no longer run while `Phase == ready`\n");
  CHECK(told(robot("Charge > 30"), robot("Charge > 20, Charge < 90")) ==
        "condition_loosened: `Walk` may now run also while `Charge == 21..30`\n"
        "condition_tightened: `Walk` may no longer run while `Charge == 90..100`\n");
}

TEST_CASE("moves between files, comments, docs and other spellings are silent") {
  CHECK(told(Files{"imports: [parts.yaml]\nroots: [Walk]\ngroups: {Walk: {needs: [Legs], tasks: [Legs]}}\n",
                   "groups: {Legs: {}}\n"},
             Files{"# moved\nimports: [parts.yaml]\nroots: {Walk: {priority: 0}}\n"
                   "groups: {Legs: {doc: Two of them}, Walk: {tasks: {Legs: {}}, needs: [Legs]}}\n",
                   "groups: {}\n"})
            .empty());
}

TEST_CASE("a module that is declared is reported") {
  CHECK(told("roots: [Walk]\ngroups: {Walk: {module: legs}}\n", "roots: [Walk]\ngroups: {Walk: {module: feet}}\n") ==
        "api: `Walk` is in the module `feet`, before in `legs`\n");
}

TEST_CASE("a group that is renamed is gone and new, with a hint") {
  CHECK(told("roots: [Walk]\ngroups: {Walk: {tasks: [Legs]}, Legs: {}}\n",
             "roots: [Walk]\ngroups: {Walk: {tasks: [Feet]}, Feet: {}}\n") ==
        "request_added: `Walk` may now request `Feet`\n"
        "request_removed: `Walk` no longer requests `Legs`\n"
        "group_removed: the group `Legs` is gone\n"
        "hint: it may be called `Feet` now: all else is equal\n"
        "group_added: the group `Feet` is new\n");
}

TEST_CASE("a group that is gone has no hint if the new one differs, or if several new ones are equal") {
  const auto robot = [](const std::string& tasks, const std::string& groups) {
    return "roots: [Walk]\ngroups: {Walk: {tasks: [" + tasks + "]}, " + groups + "}\n";
  };
  CHECK(told(robot("Legs", "Legs: {realtime: true}"), robot("Feet", "Feet: {}")) ==
        "request_added: `Walk` may now request `Feet`\n"
        "request_removed: `Walk` no longer requests `Legs`\n"
        "group_removed: the group `Legs` is gone\n"
        "group_added: the group `Feet` is new\n");
  CHECK(told(robot("Legs", "Legs: {}"), robot("Feet, Paws", "Feet: {}, Paws: {}")) ==
        "request_added: `Walk` may now request `Feet`\n"
        "request_added: `Walk` may now request `Paws`\n"
        "request_removed: `Walk` no longer requests `Legs`\n"
        "group_removed: the group `Legs` is gone\n"
        "group_added: the group `Feet` is new\n"
        "group_added: the group `Paws` is new\n");
}

TEST_CASE("what a pack requests, how, and at which levels") {
  const auto robot = [](const std::string& packs) {
    return "roots: [Play]\ngroups: {Play: {packs: {" + packs + "}}, Walk: {}, Look: {}}\n";
  };
  CHECK(told(robot("go: {Walk: {priority: 10}, Look: {}}"),
             robot("go: {Walk: {priority: 10}, Look: {optional: true}}")) ==
        "unit: `Play`, pack `go`, requests `Look` as optional, before as mandatory\n");
  CHECK(told(robot("go: {Walk: {}, Look: {}}"), robot("go: {Walk: {}}, stay: {Look: {}}")) ==
        "request_added: `Play` has a new pack `stay` with `Look`\n"
        "request_removed: `Play`, pack `go`, no longer requests `Look`\n");
  CHECK(told(robot("go: {Walk: {priority: {calm: 10, urgent: 80}}, Look: {}}"),
             robot("go: {Walk: {priority: {urgent: 80, calm: 10}}, Look: {}}")) ==
        "levels: `Play`, pack `go`, requests `Walk` at `urgent` where it names no level, before at `calm`\n");
}

TEST_CASE("a request that gets names for its levels, or loses them, is compared where it names none") {
  const auto robot = [](const std::string& look) {
    return "roots: [Play]\ngroups: {Play: {packs: {go: {Walk: {}, Look: {" + look + "}}}}, Walk: {}, Look: {}}\n";
  };
  const std::string plain = robot("priority: 5"),
                    optional = robot("levels: {spare: {priority: 5, optional: true}, firm: {priority: 5}}"),
                    urgent = robot("priority: {urgent: 50, calm: 5}");
  CHECK(told(plain, optional) == "unit: `Play`, pack `go`, requests `Look` as optional where it names no level, before "
                                 "as mandatory\n"
                                 "levels: `Play`, pack `go`, may now request `Look` at `spare` and `firm`\n");
  CHECK(told(plain, robot("levels: {firm: {priority: 5}, spare: {priority: 5, optional: true}}")) ==
        "levels: `Play`, pack `go`, may now request `Look` at `firm` and `spare`\n");
  CHECK(told(plain, urgent) == "levels: `Play`, pack `go`, may now request `Look` at `urgent` and `calm`\n"
                               "levels: `Play`, pack `go`, requests `Look` with priority 50 where it names no level, "
                               "before with 5\n");
  CHECK(told(urgent, plain) == "levels: `Play`, pack `go`, can no longer request `Look` at `urgent` and `calm`\n"
                               "levels: `Play`, pack `go`, requests `Look` with priority 5 where it names no level, "
                               "before with 50\n");
}

TEST_CASE("what a provider may stay for beyond its `when` is compared, not what its `when` accepts anyway") {
  const auto robot = [](const std::string& keys) {
    return "states: {S: {values: [a, b, c], initial: a, external: true}, R: {values: [x, y], external: true}}\n"
           "roots: [G]\ngroups: {G: {" +
           keys + "}}\nallow: [uncovered_state, stay_adds_nothing]\nbecause: it waits\n";
  };
  const std::string at_a = "when: [S == a], ", at_b = "when: [S == b], ";
  CHECK(told(robot(at_a + "stay: [S == b]"), robot(at_a + "stay: [S == a|b]")).empty());
  CHECK(told(robot(at_a + "stay: [S == a|b]"), robot(at_a + "stay: [S == b]")).empty());
  CHECK(told(robot(at_a + "stay: [S == a|b, R == x]"), robot(at_a + "stay: [S == b, R == x]")).empty());
  CHECK(told(robot("when: [S == a|b], stay: [S == c, R == x]"), robot("when: [S == a|b], stay: [R == x]")).empty());
  CHECK(told(robot("when: [S == a|b], stay: [R == x]"), robot("when: [S == a|b], stay: [S == c, R == x]")).empty());
  CHECK(told(robot(at_a + "stay: [S == c, R == x]"), robot(at_a + "stay: [R == x]")) ==
        "condition_loosened: `G` no longer requires `S == c` to stay\n");
  CHECK(told(robot("when: [S == a, R == y], stay: [S == b]"), robot("when: [S == a, R == y], stay: [S == a|b]")) ==
        "condition_loosened: `G` may now stay also while `S == a`\n");
  CHECK(told(robot(at_a + "stay: [S == b]"), robot(at_a + "stay: [S == a|c]")) ==
        "condition_loosened: `G` may now stay also while `S == c`\n"
        "condition_tightened: `G` may no longer stay while `S == b`\n");
  CHECK(told(robot(at_a + "stay: [S == b]"), robot(at_b + "stay: [S == a]")) ==
        "condition_loosened: `G` may now run also while `S == b`\n"
        "condition_tightened: `G` may no longer run while `S == a`\n");
  CHECK(told(robot("when: [S == a|b]"), robot("when: [S == a|b], stay: [S == a, R == x]")).empty());
  CHECK(told(robot("when: [S == a|b], stay: [S == a]"), robot("when: [S == a|b]")).empty());
  // `R` may be unset, which neither accepts.
  CHECK(told(robot("when: [R == y], stay: [R == x, S == a]"), robot("when: [R == y], stay: [S == a]")) ==
        "condition_loosened: `G` no longer requires `R == x` to stay\n");
  CHECK(told(robot(at_a), robot(at_a + "stay: [S == a|b]")) ==
        "condition_loosened: `G` may now stay also while `S == b`\n");
  CHECK(told(robot("when: [S == a|b]"), robot("when: [S == a], stay: [S == a|b]")) ==
        "condition_tightened: `G` may no longer run while `S == b`\n");
  CHECK(told(robot("when: [S == a], stay: [S == a|b]"), robot("when: [S == a|b]")) ==
        "condition_loosened: `G` may now run also while `S == b`\n");
  CHECK(told(robot("when: [S == a], stay: [S == a|b]"), robot("when: [S == a]")) ==
        "condition_tightened: `G` may no longer stay while `S == b`\n");
  // A `stay` that every value of `S` fulfils has no condition left, which is not the same as no `stay`.
  CHECK(told(robot(at_a + "stay: [S == a|b|c]"), robot(at_a + "stay: [S == a|b]")) ==
        "condition_tightened: `G` now requires `S == a|b` to stay\n");
  CHECK(told(robot(at_a + "stay: [S == a|b|c]"), robot(at_a)) ==
        "condition_tightened: `G` now requires `S == a` to stay\n");
  CHECK(told(robot(at_a), robot(at_a + "stay: [S == a|b|c]")) ==
        "condition_loosened: `G` no longer requires `S == a` to stay\n");
  CHECK(told(robot("when: [S == a, R == y]"), robot("when: [S == a, R == y], stay: [S == a]")) ==
        "condition_loosened: `G` no longer requires `R == y` to stay\n");
  CHECK(told(robot("when: [S == a]"), robot("when: [S == a], stay: [R == x]")) ==
        "condition_loosened: `G` may now stay active where its `when` does not hold\n");
  CHECK(told(robot("when: [S == a], stay: [R == x]"), robot("when: [S == a]")) ==
        "condition_tightened: `G` no longer stays active where its `when` does not hold\n");
}

TEST_CASE("states: values, their order, the first one, what sets them, when they expire") {
  const auto robot = [](const std::string& state) {
    return "states: {Pose: {" + state +
           "}}\nroots: [Walk]\ngroups: {Walk: {when: [Pose == up], allow: [uncovered_state], because: it waits}}\n";
  };
  CHECK(
      told(
          robot("values: [down, up], initial: up, external: true, expires: {after: 1 s, to: up}"),
          robot("values: [up, down, flat], unordered: [flat], initial: down, external: true, expires: {after: 2 s, to: "
                "down}")) ==
      "bound_grew: `Pose` expires after 2 s, before after 1 s\n"
      "state_values: `Pose` may now be `flat`\n"
      "state_values: the values of `Pose` ascend as `up`, `down` and `flat`, before as `down` and `up`\n"
      "state_values: of the values of `Pose` are `unordered` `flat`, before none\n"
      "state_initial: `Pose` begins as `down`, before as `up`\n"
      "state_source: `Pose` is `down` when it has expired, before `up`\n");
}

TEST_CASE("what the generated C++ is called, includes and carries") {
  CHECK(told("cpp: {namespace: one, headers: [a.hpp]}\nroots: [Walk]\ngroups: {Walk: {data: one::Speed}}\n",
             "cpp: {namespace: two, headers: [b.hpp]}\nroots: [Walk]\ngroups: {Walk: {stop: true}}\n") ==
        "handler: `Walk` now has a stop handler\n"
        "api: the namespace is `two`, before `one`\n"
        "api: the generated code now includes `b.hpp`\n"
        "api: the generated code no longer includes `a.hpp`\n"
        "api: the data of a task for `Walk` is none, before `one::Speed`\n");
}

TEST_CASE("limits, triggers, assertions and layers") {
  CHECK(told("layers: [low, high]\ntriggers: [Tick]\nroots: [Walk]\ngroups: {Walk: {triggers: [Tick]}}\n"
             "assertions: [{can_run: Walk}]\n",
             "layers: [low]\ntriggers: [Tick]\nroots: [Walk]\ngroups: {Walk: {every: 10 ms}}\nlimits: {trials: "
             "20000}\n") == "bound_grew: the limit of `trials` is 20000, before 10000\n"
                            "triggers: `Tick` no longer calls `Walk` again\n"
                            "triggers: `Walk` is now called again every 10 ms\n"
                            "assertion: no longer asserted: `Walk` can run\n"
                            "api: something in it uses time now, so each `step` is given the time\n"
                            "layers: the layers are `low`, before `low` and `high`\n");
}

TEST_CASE("what cannot be read or named is refused, and accepted when it is mended") {
  const char* const good = "roots: [Walk]\ngroups: {Walk: {}}\n";
  const char* const bad = "roots: [Wlak]\ngroups: {Walk: {}}\n";
  CHECK(told(good, bad) == "refused: there is no group called `Wlak`\n");
  CHECK(told(bad, good) == "accepted: there is no group called `Wlak`\n");
}
