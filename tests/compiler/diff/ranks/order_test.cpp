// SPDX-License-Identifier: MIT
// Which orders of definitions are reported, with what they decide, and which are not as they decide nothing.
#include "tests/compiler/diff/told.hpp"

#include <catch2/catch.hpp>

namespace {

using director::tests::told;

/// The first line.
std::string first_of(const std::string& changes) { return changes.substr(0, changes.find('\n')); }

std::string roots(const std::string& listed, const std::string& groups) {
  return "roots: " + listed + "\ngroups: {" + groups + "}\n";
}

/// A task that waits for two states, and others that may cause them.
std::string waiting(const std::string& roots, const std::string& groups) {
  return "states: {Door: {values: [shut, open], initial: shut}, Arm: {values: [out, in], initial: out}}\nroots: {" +
         roots + "}\ngroups: {" + groups + "}\n";
}

const std::string three = "Work: {priority: 9}, Crew: {priority: 2}, Aide: {priority: 1}";
const std::string open = "{name: open, causing: [Door == open]}", fold = "{name: fold, causing: [Arm == in]}";

std::string group(const std::string& name, const std::string& causing) {
  return name + ": {providers: [{name: idle}, " + causing + "]}, ";
}

} // namespace

TEST_CASE("tasks of equal rank that share nothing have no order") {
  CHECK(told(roots("[Play]", "Play: {tasks: [Legs, Arm]}, Legs: {}, Arm: {}"),
             roots("[Play]", "Play: {tasks: [Arm, Legs]}, Legs: {}, Arm: {}"))
            .empty());
  const std::string groups = "Walk: {needs: [Legs]}, Wave: {needs: [Arm]}, Legs: {}, Arm: {}";
  CHECK(told(roots("[Walk, Wave]", groups), roots("[Wave, Walk]", groups)).empty());
}

TEST_CASE("tasks that are never requested at once have no order") {
  const std::string groups = "Walk: {needs: [Legs]}, Kick: {needs: [Legs]}, Legs: {}";
  CHECK(told(roots("[Play]", "Play: {packs: {go: [Walk], shoot: [Kick]}}, " + groups),
             roots("[Play]", "Play: {packs: {shoot: [Kick], go: [Walk]}}, " + groups))
            .empty());
}

TEST_CASE("an optional task and one with something optional below it have an order at equal priority") {
  const std::string groups = "A: {}, B: {tasks: {C: {optional: true}}}, C: {tasks: [A]}";
  CHECK(first_of(told(roots("{A: {optional: true}, B: {}}", groups), roots("{B: {}, A: {optional: true}}", groups))) ==
        "tie_order: of what the program requests at one priority, the order is `B` and `A`, before `A` and `B`: of "
        "those that were requested at once, the first one that wants `A` gets it");
  const std::string mandatory = "A: {}, B: {tasks: [C]}, C: {tasks: [A]}";
  CHECK(
      told(roots("{A: {optional: true}, B: {}}", mandatory), roots("{B: {}, A: {optional: true}}", mandatory)).empty());
  CHECK(told(roots("{A: {}, B: {}}", groups), roots("{B: {}, A: {}}", groups)).empty());
}

TEST_CASE("members of a unit have an order if they choose, or if they request the same below") {
  const auto play = [](const std::string& tasks, const std::string& groups) {
    return roots("[Play]", "Play: {packs: {go: [" + tasks + "]}}, " + groups);
  };
  const std::string choice =
      "First: {providers: [{name: left, needs: [Left]}, {name: right, needs: [Right]}]}, Second: "
      "{providers: [{name: left, needs: [Left]}, {name: right, needs: [Right]}]}, Left: {}, "
      "Right: {}";
  CHECK(first_of(told(play("First, Second", choice), play("Second, First", choice))) ==
        "tie_order: of what `Play` requests at one priority, the order is `Second` and `First`, before `First` and "
        "`Second`: of those that were requested at once, the first one that wants `Left` or `Right` gets it");
  const std::string below = "Walk: {tasks: [Legs]}, Kick: {tasks: [Legs]}, Legs: {}";
  CHECK(first_of(told(play("Walk, Kick", below), play("Kick, Walk", below))) ==
        "tie_order: of what `Play` requests at one priority, the order is `Kick` and `Walk`, before `Walk` and `Kick`: "
        "of those that were requested at once, the first one that wants `Legs` gets it");
  const std::string own = "Walk: {tasks: [Legs]}, Kick: {needs: [Legs]}, Legs: {}";
  CHECK(told(play("Walk, Kick", own), play("Kick, Walk", own)).empty());
}

TEST_CASE("a unit goes forward with its first member, before or after one that is apart") {
  const auto play = [](const std::string& tasks) {
    return roots("[Play]", "Play: {packs: {go: {" + tasks +
                               "}}}, Lift: {}, Grip: {needs: [Hand]}, Look: {needs: [Hand]}, Hand: {}");
  };
  const std::string lift = "Lift: {priority: 10}, ", look = "Look: {priority: 10, apart: true}, ";
  CHECK(first_of(told(play(lift + look + "Grip: {priority: 5}"), play(look + lift + "Grip: {priority: 5}"))) ==
        "tie_order: of what `Play` requests at one priority, the order is `Look` and `Lift`, before `Lift` and `Look`: "
        "of those that were requested at once, the first one that wants `Hand` gets it");
  CHECK(told(play(lift + look + "Grip: {priority: 15}"), play(look + lift + "Grip: {priority: 15}")).empty());
}

TEST_CASE("of tasks of equal rank that push different providers of one group, the first one pushes") {
  const std::string groups =
      "Enter: {when: [Door == open]}, Pass: {when: [Arm == in]}, " + group("Crew", open + ", " + fold);
  CHECK(told(waiting("Enter: {priority: 9}, Pass: {priority: 9}, Crew: {priority: 2}", groups),
             waiting("Pass: {priority: 9}, Enter: {priority: 9}, Crew: {priority: 2}", groups)) ==
        "tie_order: of what the program requests at one priority, the order is `Pass` and `Enter`, before `Enter` and "
        "`Pass`: of those that were requested at once, the first one that pushes a provider of `Crew` decides which\n");
}

TEST_CASE("an optional task that pushes another provider of one group has no order with a mandatory one") {
  const std::string groups =
      "Enter: {when: [Door == open]}, Pass: {when: [Arm == in]}, " + group("Crew", open + ", " + fold);
  const std::string enter = "Enter: {priority: 9}, ", crew = "Crew: {priority: 2, optional: true}";
  const auto turned = [&](const std::string& pass) {
    return told(waiting(enter + pass + crew, groups), waiting(pass + enter + crew, groups));
  };
  CHECK(turned("Pass: {priority: 9, optional: true}, ").empty());
  CHECK(turned("Pass: {priority: 9}, ").starts_with("tie_order: "));
}

TEST_CASE("many tasks in another order are one change, which names some of what they want") {
  std::string listed, reversed, groups;
  for (const char name : std::string("ABCDEFGH")) {
    const std::string task = std::string("Task") + name, part = std::string("Part") + name;
    listed += (listed.empty() ? "" : ", ") + task;
    reversed = task + (reversed.empty() ? "" : ", ") + reversed;
    groups += task + ": {tasks: [PartA, PartB, PartC, PartD, PartE, PartF, PartG, PartH]}, " + part + ": {}, ";
  }
  CHECK(
      first_of(told(roots("[" + listed + "]", groups), roots("[" + reversed + "]", groups))) ==
      "tie_order: of what the program requests at one priority, the order is `TaskH`, `TaskG`, `TaskF`, `TaskE`, "
      "`TaskD`, `TaskC`, `TaskB` and `TaskA`, before `TaskA`, `TaskB`, `TaskC`, `TaskD`, `TaskE`, `TaskF`, `TaskG` and "
      "`TaskH`: of those that were requested at once, the first one that wants `PartA`, `PartB`, `PartC`, `PartD` or 4 "
      "more gets it");
}

TEST_CASE("the order of conditions is reported if one group is pushed for both, with what it changes") {
  const auto robot = [](const std::string& when) {
    return waiting("Work: {priority: 9}, Crew: {priority: 2}",
                   "Work: {when: [" + when +
                       "], needs: [Legs], tasks: [Legs]}, Crew: {providers: [{name: idle, needs: [Legs], tasks: "
                       "[Legs]}, {name: open, when: [Arm == out], causing: [Door == open]}, " +
                       fold + "]}, Legs: {}");
  };
  const std::string why = ", and what causes the one cannot run while the other holds\n";
  CHECK(told(robot("Door == open, Arm == in"), robot("Arm == in, Door == open")) ==
        "preference: the conditions of `Work` are in the order `Arm == in` and `Door == open`, before `Door == open` "
        "and `Arm == in`: the first of them that it lacks decides how `Crew` is pushed\n"
        "transition_changed: from `Crew` to `Work`: never now, before soft\n"
        "finding_new: warning is new: `Work` waits for `Arm == in` and `Door == open`" +
            why + "finding_gone: warning is gone: `Work` waits for `Door == open` and `Arm == in`" + why);
}

TEST_CASE("the order of conditions for which different groups are pushed says nothing") {
  const auto robot = [](const std::string& when) {
    return waiting(three, "Work: {when: [" + when + "]}, " + group("Crew", open) + group("Aide", fold));
  };
  CHECK(told(robot("Door == open, Arm == in"), robot("Arm == in, Door == open")).empty());
}

TEST_CASE("of the conditions of a provider that is pushed itself, the first one is served first") {
  const auto robot = [](const std::string& when) {
    return "states: {Door: {values: [shut, open], initial: shut}, Arm: {values: [out, in], initial: out}, Box: "
           "{values: "
           "[empty, full], initial: empty}}\nroots: {Work: {priority: 9}, Load: {priority: 5}, Crew: {priority: 2}, "
           "Aide: "
           "{priority: 1}}\ngroups: {Work: {when: [Box == full]}, " +
           group("Load", "{name: fill, when: [" + when + "], causing: [Box == full]}") + group("Crew", open) +
           group("Aide", fold) + "}\n";
  };
  CHECK(told(robot("Door == open, Arm == in"), robot("Arm == in, Door == open")) ==
        "preference: the conditions of `Load.fill` are in the order `Arm == in` and `Door == open`, before `Door == "
        "open` "
        "and `Arm == in`: the first of them that it lacks decides how `Aide` or `Crew` is pushed\n");
}

TEST_CASE("the order of conditions of what nothing requests says nothing, though others push for the same") {
  const auto robot = [](const std::string& when) {
    return waiting("Pass: {priority: 9}, Crew: {priority: 2}", "Work: {when: [" + when +
                                                                   "]}, Pass: {when: [Door == open, Arm == in]}, " +
                                                                   group("Crew", open + ", " + fold));
  };
  CHECK(told(robot("Door == open, Arm == in"), robot("Arm == in, Door == open")).find("preference") ==
        std::string::npos);
}

TEST_CASE("the order of conditions is reported of what is needed by a provider that is pushed") {
  const auto robot = [](const std::string& when) {
    return "states: {Door: {values: [shut, open], initial: shut}, Arm: {values: [out, in], initial: out}, Box: "
           "{values: "
           "[empty, full], initial: empty}}\nroots: {Work: {priority: 9}, Load: {priority: 5}, Crew: {priority: 2}}\n"
           "groups: {Work: {when: [Box == full]}, " +
           group("Load", "{name: fill, needs: [Bench], causing: [Box == full]}") + "Bench: {when: [" + when + "]}, " +
           group("Crew", open + ", " + fold) + "}\n";
  };
  CHECK(told(robot("Door == open, Arm == in"), robot("Arm == in, Door == open"))
            .find("preference: the conditions of "
                  "`Bench` are in the order `Arm == in` and `Door == open`, before `Door == open` and `Arm == in`: the "
                  "first of "
                  "them that it lacks decides how `Crew` is pushed\n") != std::string::npos);
}

TEST_CASE("the order of needs is reported if one group is pushed for the conditions of both") {
  const auto robot = [](const std::string& needs) {
    return waiting(three, "Work: {needs: [" + needs + "]}, Hall: {when: [Door == open]}, Desk: {when: [Arm == in]}, " +
                              group("Crew", open + ", " + fold) + "Aide: {}");
  };
  CHECK(told(robot("Hall, Desk"), robot("Desk, Hall")) ==
        "preference: the needs of `Work` are in the order `Desk` and `Hall`, before `Hall` and `Desk`: the first "
        "condition of theirs that is lacking decides how `Crew` is pushed\n");
}

TEST_CASE("the order of groups is reported where a task may push either for one condition") {
  const std::string work = "Work: {when: [Door == open]}, ", crew = group("Crew", open), aide = group("Aide", open);
  CHECK(told(waiting(three, work + crew + aide), waiting(three, work + aide + crew)) ==
        "preference: the order of what causes `Door == open` is `Aide.open` and `Crew.open`, before `Crew.open` and "
        "`Aide.open`: where several of them serve `Work` in equally many steps, the first one is pushed\n");
  // Without a task that may push both.
  const std::string low = "Crew: {priority: 9}, Work: {priority: 2}, Aide: {priority: 1}";
  CHECK(told(waiting(low, work + crew + aide), waiting(low, work + aide + crew)).empty());
}

TEST_CASE("the order of two providers of one group that cause one condition is told with their group alone") {
  const auto crew = [](const std::string& causing) {
    return "states: {Door: {values: [shut, open], initial: shut}, Light: {values: [dark, lit], initial: dark, "
           "external: "
           "true}}\nroots: {Work: {priority: 9}, Crew: {priority: 2}}\ngroups: {Work: {when: [Door == open]}, " +
           group("Crew", causing) + "Hand: {}}\n";
  };
  const std::string left = "{name: left, when: [Light == dark], causing: [Door == open]}",
                    right = "{name: right, when: [Light == lit], needs: [Hand], causing: [Door == open]}";
  CHECK(told(crew(left + ", " + right), crew(right + ", " + left)) ==
        "preference: the providers of `Crew` are tried in the order `idle`, `right` and `left`, before `idle`, `left` "
        "and `right`\n");
}
