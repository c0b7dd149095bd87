// SPDX-License-Identifier: MIT
#include "compiler/play/coverage/coverage.hpp"
#include "compiler/play/coverage/coverage_watch.hpp"
#include "compiler/play/coverage/print_coverage.hpp"
#include "compiler/play/expect/test_scenario.hpp"
#include "tests/compiler/support/played.hpp"

#include <algorithm>

using namespace director::compiler;
using director::tests::load_scenario;
using director::tests::LoadedScenario;

namespace {

const char* const watched_walker = R"(behaviour: walker
language: 1
states:
  Pose: {values: [moving, standing]}
  Charge: {range: [0, 100], initial: 50, external: true}
roots:
  Walk: {priority: {calm: 10, hasty: 15}}
  Kick: {priority: 20}
groups:
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Pose == standing], tasks: [Legs]}
  Kick:
    when: [Pose == standing]
    stay: [Charge > 10]
    needs: [Legs]
    packs: {swing: [Legs], recover: {}}
  Legs: {}
  Forgotten: {when: [Pose == moving]}
)";

struct Watched {
  Coverage coverage;
  std::string text;
  std::string json;
  std::vector<std::string> happened;
};

Watched watch(const std::string& steps, const char* behaviour = watched_walker) {
  const LoadedScenario loaded = load_scenario(behaviour, steps);
  INFO(loaded.findings);
  REQUIRE(loaded.findings.empty());
  const Model& model = loaded.behaviour.model;
  Watched out;
  out.coverage = coverage_of(model, make_graph(model));
  CoverageReport report{"walker.yaml", 1, {}, {}};
  std::vector<CoverageReport::Missing> texts = coverage_texts(out.coverage, model, loaded.behaviour.sources);
  CoverageWatch watching(model, loaded.lowered, out.coverage);
  const Onlooker onlooker = watching.onlooker();
  play(loaded.scenario, model, loaded.lowered, {false, &onlooker},
       [&](const Happening& happening) { out.happened.push_back(to_text(happening)); });
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (!out.coverage.points[i].covered) report.missing.push_back(texts[i]);
  }
  report.coverage = out.coverage;
  out.text = to_text(report);
  out.json = to_line(to_json(report));
  return out;
}

const char* const soft_kick = R"(script:
  Walk.walking: {set: {Pose: moving}, tasks: [Legs]}
  Walk.halting: {set: {Pose: standing}, tasks: [Legs]}
  Kick: {pack: swing}
steps:
  - request: Walk
  - request: Kick
)";

} // namespace

TEST_CASE("what was not exercised is reported point by point, and what can never happen does not count") {
  CHECK(watch("steps: []\n").text == R"(coverage of walker.yaml by 1 scenario: 0 % (0 of 17)
  providers     0 of 4
    test.yaml:12:16: `Walk.walking` never ran
    test.yaml:13:16: `Walk.halting` never ran
    test.yaml:14:3: `Kick` never ran
    test.yaml:19:3: `Legs` never ran
  packs         0 of 2
    test.yaml:18:13: `Kick` never requested its pack `swing`
    test.yaml:18:28: `Kick` never requested its pack `recover`
  levels        0 of 5
    test.yaml:7:3: `Walk` was never requested at the level `calm`
    test.yaml:7:3: `Walk` was never requested at the level `hasty`
    test.yaml:8:3: `Kick` was never requested
    test.yaml:12:72: `Legs` was never requested by `Walk`
    test.yaml:18:21: `Legs` was never requested by `Kick`
  conditions    0 of 4
    test.yaml:15:12: `Pose == standing` in `when` of `Kick` was never true
    test.yaml:15:12: `Pose == standing` in `when` of `Kick` was never false
    test.yaml:16:12: `Charge > 10` in `stay` of `Kick` was never true
    test.yaml:16:12: `Charge > 10` in `stay` of `Kick` was never false
  pushes        0 of 1
    test.yaml:13:16: `Walk.halting` was never pushed for `Kick`
  take-overs    0 of 1
    test.yaml:8:3: among the roots, `Kick` never took anything from `Walk`
)");
}

TEST_CASE("a soft transition covers a push, a condition both ways, and a take-over") {
  const Watched watched = watch(soft_kick);
  CHECK(watched.text == R"(coverage of walker.yaml by 1 scenario: 82 % (14 of 17)
  providers     4 of 4
  packs         1 of 2
    test.yaml:18:28: `Kick` never requested its pack `recover`
  levels        4 of 5
    test.yaml:7:3: `Walk` was never requested at the level `hasty`
  conditions    3 of 4
    test.yaml:16:12: `Charge > 10` in `stay` of `Kick` was never false
  pushes        1 of 1
  take-overs    1 of 1
)");
  CHECK(watched.json ==
        R"({"behaviour":"walker.yaml","scenarios":1,"percent":82,"covered":14,"points":17,)"
        R"("providers":{"covered":4,"points":4},"packs":{"covered":1,"points":2},"levels":{"covered":4,"points":5},)"
        R"("conditions":{"covered":3,"points":4},"pushes":{"covered":1,"points":1},)"
        R"("take_overs":{"covered":1,"points":1},"missing":[)"
        R"({"class":"packs","file":"test.yaml","line":18,"column":28,)"
        R"("message":"`Kick` never requested its pack `recover`"},)"
        R"({"class":"levels","file":"test.yaml","line":7,"column":3,)"
        R"("message":"`Walk` was never requested at the level `hasty`"},)"
        R"({"class":"conditions","file":"test.yaml","line":16,"column":12,)"
        R"("message":"`Charge > 10` in `stay` of `Kick` was never false"}]})");
}

TEST_CASE("an onlooker changes nothing of what happens") {
  const LoadedScenario loaded = load_scenario(watched_walker, soft_kick);
  std::vector<std::string> alone;
  play(loaded.scenario, loaded.behaviour.model, loaded.lowered, {},
       [&](const Happening& happening) { alone.push_back(to_text(happening)); });
  CHECK(watch(soft_kick).happened == alone);
}

TEST_CASE("a `stay` that ends its provider was false") {
  Coverage coverage = watch(std::string(soft_kick) + "  - set: {Charge: 5}\n").coverage;
  CHECK(coverage.covered() == 15);
  CHECK(coverage.percent() == 88);
  coverage.merge(watch("steps: [request: {Walk: {level: hasty}}]\n").coverage);
  CHECK(coverage.covered() == 16);
}

TEST_CASE("a task that got what another one gave up took nothing") {
  const Watched watched = watch(R"(given: {Pose: standing}
script: {Walk: {tasks: [Legs]}, Kick: {pack: swing}}
steps: [request: Kick, request: Walk, cancel: Kick]
)");
  CHECK(watched.text.find("take-overs    0 of 1") != std::string::npos);
}

TEST_CASE("nothing was taken from a provider that gave up what it needs, though it requested it as optional too") {
  const char* const walker = R"(behaviour: walker
language: 1
states: {Phase: {values: [wait, play, dance], initial: wait, external: true}}
roots: {Walk: {priority: 10}, Look: {priority: 5}}
groups:
  Walk:
    providers:
      - {name: playing, when: [Phase == play], needs: [Head], tasks: {Head: {optional: true}}}
      - {name: dancing, when: [Phase == dance], tasks: {Head: {optional: true}}}
  Look: {tasks: [Head]}
  Head: {}
)";
  const std::string script = R"(script:
  Walk.playing: {tasks: [Head]}
  Walk.dancing: {tasks: [Head]}
  Look: {tasks: [Head]}
)";
  const auto covered = [&](const std::string& steps) {
    return watch(script + "steps: [" + steps + "]\n", walker).text.find("take-overs    1 of") != std::string::npos;
  };
  CHECK_FALSE(covered("set: {Phase: play}, request: Walk, request: Look, set: {Phase: wait}"));
  CHECK(covered("set: {Phase: dance}, request: Walk, request: Look"));
}

TEST_CASE("a task took something from a provider that could go on by its `when` or its `stay`") {
  const auto covered = [&](const std::string& steps) {
    const char* const walker = R"(behaviour: walker
language: 1
states: {Ball: {values: [lost, near, far], initial: far, external: true}}
roots: {Walk: {priority: 10}, Kick: {priority: 20}}
groups:
  Walk: {when: [Ball != lost], stay: [Ball != near], needs: [Legs], tasks: [Legs]}
  Kick: {needs: [Legs], tasks: [Legs]}
  Legs: {}
)";
    const std::string script = "script: {Walk: {tasks: [Legs]}, Kick: {tasks: [Legs]}}\nsteps: [";
    return watch(script + steps + "]\n", walker).text.find("take-overs    1 of 1") != std::string::npos;
  };
  CHECK(covered("set: {Ball: near}, request: Walk, request: Kick"));
  CHECK(covered("request: Walk, inputs: [set: {Ball: lost}, request: Kick]"));
}

TEST_CASE("a task took something from an optional one of the same priority") {
  const char* const player = R"(behaviour: player
language: 1
roots: {Play: {}, Look: {optional: true}}
groups:
  Play: {packs: {all: {Look: {}}}}
  Look: {}
)";
  CHECK(watch("steps: [request: Look, request: Play]\n", player).text.find("take-overs    1 of 1") !=
        std::string::npos);
}

TEST_CASE("a level without a name is told by its priority, and by what else it is") {
  const char* const player = R"(behaviour: player
language: 1
roots: [Play]
groups:
  Play:
    packs:
      first: {Look: {priority: 50}}
      second: {Look: {priority: 50, apart: true}}
      third: {Look: {priority: 50, optional: true}}
  Look: {}
)";
  const std::string text = watch("steps: []\n", player).text;
  const std::size_t begin = text.find("  levels"), end = text.find("  take-overs");
  CHECK(text.substr(begin, end == std::string::npos ? end : end - begin) == R"(  levels        0 of 4
    test.yaml:3:9: `Play` was never requested
    test.yaml:7:15: `Look` was never requested by `Play` with priority 50
    test.yaml:8:16: `Look` was never requested by `Play` with priority 50, apart
    test.yaml:9:15: `Look` was never requested by `Play` with priority 50, optional
)");
}

TEST_CASE("conditions of what is only needed count, and one of a state that may be unset can be false") {
  const char* const robot = R"(behaviour: robot
language: 1
states: {Door: {values: [shut, open], initial: shut, external: true}, Lamp: {values: [dark, lit], external: true}}
roots: [Pass]
groups:
  Pass: {needs: [Hall]}
  Hall: {when: [Door == open, Lamp == dark|lit]}
)";
  const std::string text = watch("steps: []\n", robot).text;
  INFO(text);
  for (const char* missing :
       {"`Door == open` in `when` of `Hall` was never true\n", "`Door == open` in `when` of `Hall` was never false\n",
        "`Lamp == dark|lit` in `when` of `Hall` was never true\n",
        "`Lamp == dark|lit` in `when` of `Hall` was never false\n"})
    CHECK(text.find(missing) != std::string::npos);
}

TEST_CASE("a level with several names is told by the first one") {
  const char* const player = R"(behaviour: player
language: 1
roots: [Play]
groups:
  Play:
    packs:
      first: {Look: {priority: {calm: 10, hot: 50}}}
      second: {Look: {priority: {slow: 10, fast: 50}}}
  Look: {}
)";
  const std::string text = watch("steps: []\n", player).text;
  CHECK(text.find("`Look` was never requested by `Play` at the level `calm`\n") != std::string::npos);
  CHECK(text.find("`Look` was never requested by `Play` at the level `hot`\n") != std::string::npos);
  CHECK(text.find("`fast`") == std::string::npos);
}

TEST_CASE("a task took something from one that became optional at that moment") {
  const char* const player = R"(behaviour: player
language: 1
roots: [Play]
triggers: [Go]
groups:
  Play:
    triggers: [Go]
    tasks:
      Kick: {priority: 40, apart: true}
      Look: {levels: {firm: {priority: 50, apart: true}, spare: {priority: 50, optional: true}}}
  Kick: {needs: [Head], tasks: [Head]}
  Look: {needs: [Head], tasks: [Head]}
  Head: {}
)";
  const std::string steps = R"(script:
  Play:
    - {reason: trigger, tasks: [Kick, {Look: {level: spare}}]}
    - {tasks: [{Look: {level: firm}}]}
  Kick: {tasks: [Head]}
  Look: {tasks: [Head]}
steps: [request: Play, trigger: Go]
)";
  const Coverage coverage = watch(steps, player).coverage;
  const auto is_taken = [](const CoveragePoint& point) {
    return point.key.kind == CoveragePoint::Kind::take_over && point.covered;
  };
  CHECK(std::count_if(coverage.points.begin(), coverage.points.end(), is_taken) == 1);
}

namespace {

/// The take-overs, `Kick from Walk`.
std::vector<std::string> take_overs(const std::string& groups) {
  const director::tests::Compiled compiled = director::tests::compile("behaviour: test\nlanguage: 1\n" + groups);
  const Model& model = compiled.model;
  std::vector<std::string> out;
  for (const PossibleTake& take : possible_takes(model, make_graph(model)))
    out.push_back(model.edge_name(take.taker) + " from " + model.edge_name(take.loser));
  return out;
}

} // namespace

TEST_CASE("nothing is taken from what its holder needs, by the optional request that the holder has for it too") {
  CHECK(take_overs(R"(roots: {Walk: {priority: 10}, Look: {priority: 20, optional: true}}
groups:
  Walk: {needs: [Head], tasks: {Head: {optional: true}}}
  Look: {needs: [Head], tasks: [Head]}
  Head: {}
)") == std::vector<std::string>{"root>Walk from root>Look"});
}

TEST_CASE("nothing is taken from a unit that another member always brings before what is apart") {
  const auto of_play = [](const std::string& tasks) {
    return take_overs("roots: [Play]\ngroups:\n  Play: {" + tasks +
                      "}\n  Lift: {}\n  Carry: {needs: [Arm]}\n  Grip: {needs: [Arm]}\n  Arm: {}\n");
  };
  const std::string list = "{Lift: {priority: 5}, Carry: {apart: true, priority: 2}, Grip: {}}";
  CHECK(of_play("packs: {go: " + list + "}") == std::vector<std::string>{"Play>Grip from Play>Carry"});
  CHECK(of_play("tasks: " + list) ==
        std::vector<std::string>{"Play>Carry from Play>Grip", "Play>Grip from Play>Carry"});
}

TEST_CASE("what is requested below it is optional there") {
  CHECK(take_overs(R"(roots: {Walk: {priority: 10}, Look: {priority: 20, optional: true}}
groups:
  Walk: {needs: [Head], tasks: {Head: {optional: true}}}
  Look: {tasks: [Neck]}
  Head: {tasks: [Neck]}
  Neck: {}
)") == std::vector<std::string>{"root>Walk from root>Look", "root>Look from root>Walk"});
}

TEST_CASE("what a provider requested may be taken once its group has changed to another one") {
  const auto walk = [](const std::string& looking, const std::string& waving, const std::string& look) {
    const director::tests::Compiled compiled = director::tests::compile(
        "behaviour: test\nlanguage: 1\nstates: {S: {values: [a, b], initial: a, external: true}}\n"
        "roots: {Walk: {priority: 10}, Look: {priority: " +
        look + "}}\ngroups:\n  Walk: {providers: [{name: looking, when: [S == a]" + looking + "}, {name: waving" +
        waving + "}]}\n  Look: {when: [S == b], needs: [Head], tasks: [Head]}\n  Head: {tasks: [Neck]}\n  Neck: {}\n");
    const Model& model = compiled.model;
    std::string out;
    for (const PossibleTake& take : possible_takes(model, make_graph(model))) {
      out += model.edge_name(take.taker) + " from " + model.edge_name(take.loser) + ":";
      for (const GroupId id : model.groups.ids()) out += take.groups[id.value] ? " " + model.groups[id].name.value : "";
    }
    return out;
  };
  const std::string all = "root>Look from root>Walk: Head Neck";
  CHECK(walk(", tasks: [Head]", "", "20") == all);
  CHECK(walk(", tasks: [Head]", "", "5") == "root>Walk from root>Look: Head Neck");
  // Optional, and no need of `waving`.
  const std::string both = ", needs: [Head], tasks: {Head: {optional: true}}";
  CHECK(walk(both, "", "10") == all);
  CHECK(walk(both, ", needs: [Head], tasks: [Head]", "10") == "root>Look from root>Walk: Neck");
  CHECK(walk(both, ", when: [S == a]", "10").empty());
}

TEST_CASE("what a pushed provider holds is taken in the states that it causes, also if these end its own condition") {
  const auto kick = [](const std::string& when, const std::string& priority) {
    return take_overs("states: {M: {values: [moving, still], initial: moving}}\nroots: {Kick: {priority: " + priority +
                      "}, Walk: {priority: 10}}\ngroups:\n  Kick: {when: [M == " + when +
                      "], needs: [Legs]}\n  Walk: {when: [M == moving], causing: [M == still], needs: [Legs]}\n"
                      "  Legs: {}\n");
  };
  CHECK(kick("still", "20") == std::vector<std::string>{"root>Kick from root>Walk"});
  CHECK(kick("moving", "20") == std::vector<std::string>{"root>Kick from root>Walk"});
  CHECK(kick("still", "5").empty()); // pushes nothing
}

TEST_CASE("a member of a unit takes what another one requests, if that one may have been requested before it") {
  const auto of_watch = [](const std::string& packs) {
    return take_overs("roots: [Watch]\ngroups:\n  Watch: {" + packs + R"(}
  Walk: {tasks: {Head: {optional: true}}}
  Head: {}
)");
  };
  const std::vector<std::string> head_takes{"Watch>Head from Watch>Walk"};
  CHECK(of_watch("tasks: {Walk: {priority: 0}, Head: {priority: 5}}") == head_takes);
  CHECK(of_watch("packs: {go: {Walk: {priority: 0}, Head: {priority: 5}}}").empty());
  CHECK(of_watch("packs: {go: {Walk: {priority: 0}, Head: {priority: 5}}, stroll: {Walk: {priority: 0}}}") ==
        head_takes);
}

TEST_CASE("a provider counts that runs only while the program disables the preferred one") {
  const std::string lamp = R"(roots: {Lamp: {priority: 5}, Cook: {priority: 10}}
groups:
  Cook: {needs: [Plug], tasks: [Plug]}
  Lamp:
    providers:
      - {name: brightly, tasks: [Bulb]}
      - {name: dimly, tasks: [Plug], allow: [shadowed_provider], because: the program disables `brightly` at night}
  Bulb: {}
  Plug: {}
)";
  CHECK(take_overs(lamp) == std::vector<std::string>{"root>Cook from root>Lamp"});
  const director::tests::Compiled compiled = director::tests::compile("behaviour: test\nlanguage: 1\n" + lamp);
  const Coverage coverage = coverage_of(compiled.model, make_graph(compiled.model));
  const auto is_provider = [](const CoveragePoint& point) { return point.key.kind == CoveragePoint::Kind::provider; };
  CHECK(std::count_if(coverage.points.begin(), coverage.points.end(), is_provider) ==
        static_cast<std::ptrdiff_t>(compiled.model.providers.size()));
}
