// SPDX-License-Identifier: MIT
// Tests compiler/trace/level_map.hpp, by replays of a recorded scenario with other versions of its behaviour.
#include "tests/compiler/cli/world.hpp"

#include <catch2/catch.hpp>

namespace {

using director::tests::World;

/// Look and Nod both need Head: the higher priority goes first.
std::string behaviour(const std::string& packs) {
  return "behaviour: robot\nlanguage: 1\nroots: [Play]\ngroups:\n  Play:\n    packs:\n" + packs +
         "  Look: {tasks: [Head]}\n  Nod: {tasks: [Head]}\n  Head: {}\n";
}

/// What `replay` prints of a trace of `recorded`, in which Play answers `answer`, by `other`; and its exit status.
struct Replay {
  int status = 0;
  std::string out, trace;
};
Replay replayed(const std::string& recorded, const std::string& answer, const std::string& other,
                const std::string& roots = "Play") {
  World world;
  world.files.add("robot.yaml", recorded);
  world.files.add("s.yaml", "scenario: levels\nbehaviour: robot.yaml\nscript:\n  Play: {" + answer +
                                "}\n  Look: {tasks: [Head]}\n  Nod: {tasks: [Head]}\nsteps:\n  - request: " + roots +
                                "\n");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  Replay out;
  out.trace = world.outputs.files.at("run.jsonl");
  world.files.add("run.jsonl", out.trace);
  CHECK(world.directorc({"replay", "run.jsonl"}) == 0);
  world.files.add("other.yaml", other);
  out.status = world.directorc({"replay", "run.jsonl", "--behaviour=other.yaml"});
  INFO(world.err);
  out.out = world.out;
  return out;
}

bool is_same(const Replay& replay) {
  CAPTURE(replay.out);
  return replay.status == 0 &&
         replay.out.ends_with("all the same by `other.yaml`, another version than the one recorded\n");
}

bool differs(const Replay& replay) {
  CAPTURE(replay.out);
  return replay.status == 1 && replay.out.find("is decided otherwise by") != std::string::npos;
}

bool is_untold(const Replay& replay) {
  CAPTURE(replay.out);
  return replay.status == 1 && replay.out.find("cannot be replayed by") != std::string::npos;
}

const std::string a_then_b = behaviour("      a: {Look: {priority: 1}, Nod: {priority: 3}}\n"
                                       "      b: {Look: {priority: 5}, Nod: {priority: 3}}\n");

TEST_CASE("a header says who requests which level by which name, and what the level means") {
  const Replay replay =
      replayed(behaviour("      a: {Look: {priority: {calm: 1, firm: 5}}}\n"
                         "      b: {Look: {levels: {spare: {priority: 5, optional: true}}}, Nod: {apart: true}}\n"),
               "pack: a", a_then_b);
  CHECK(
      replay.trace.find(
          R"("conditions":[],"level_uses":[{"edge":"root>Play","level":0,"priority":0},)"
          R"({"edge":"Play>Look","provider":"default","pack_name":"a","name":"calm","level":0,"priority":1},)"
          R"({"edge":"Play>Look","provider":"default","pack_name":"a","name":"firm","level":1,"priority":5},)"
          R"({"edge":"Play>Look","provider":"default","pack":1,"pack_name":"b","name":"spare","level":2,"priority":5,"optional":true},)"
          R"({"edge":"Play>Nod","provider":"default","pack":1,"pack_name":"b","level":0,"priority":0,"apart":true},)"
          R"({"edge":"Look>Head","provider":"default","level":0,"priority":0},)"
          R"({"edge":"Nod>Head","provider":"default","level":0,"priority":0}]})") != std::string::npos);
}

TEST_CASE("a level that packs share is that of the pack that was requested") {
  const auto packs = [](const std::string& loud) {
    return behaviour("      a: {Look: {priority: {calm: 1, firm: 5}}, Nod: {priority: 3}}\n"
                     "      b: {Look: {priority: {loud: " +
                     loud + ", low: 1}}, Nod: {priority: 3}}\n");
  };
  CHECK(differs(replayed(packs("5"), "pack: b", packs("2"))));
  CHECK(is_same(replayed(packs("5"), "pack: b", packs("6"))));
  CHECK(is_same(replayed(packs("5"), "pack: a, with: [{Look: {level: firm}}]", packs("2"))));
}

TEST_CASE("the order of packs and of levels does not change what was requested") {
  const std::string b_then_a = behaviour("      b: {Look: {priority: 5}, Nod: {priority: 3}}\n"
                                         "      a: {Look: {priority: 1}, Nod: {priority: 3}}\n");
  CHECK(is_same(replayed(a_then_b, "pack: a", b_then_a)));
  CHECK(is_same(replayed(a_then_b, "pack: b", b_then_a)));
  const auto levels = [](const std::string& order) {
    return behaviour("      a: {Look: {priority: {" + order + "}}, Nod: {priority: 3}}\n");
  };
  CHECK(is_same(replayed(levels("calm: 1, firm: 5"), "pack: a", levels("firm: 5, calm: 1"))));
  CHECK(is_same(
      replayed(levels("calm: 1, firm: 5"), "pack: a, with: [{Look: {level: firm}}]", levels("firm: 5, calm: 1"))));
}

TEST_CASE("the requests of a run may be declared in another order") {
  CHECK(is_same(replayed(behaviour("      a: {Look: {priority: 1}, Nod: {priority: 3}}\n"), "pack: a",
                         behaviour("      a: {Nod: {priority: 3}, Look: {priority: 1}}\n"))));
}

TEST_CASE("packs that exchange their priorities are another version, though the tables are the same") {
  const auto packs = [](const std::string& b, const std::string& c) {
    return behaviour("      a: {Look: {priority: {x: 1, y: 5}}, Nod: {priority: 3}}\n      b: {Look: {priority: " + b +
                     "}, Nod: {priority: 3}}\n      c: {Look: {priority: " + c + "}, Nod: {priority: 3}}\n");
  };
  CHECK(differs(replayed(packs("1", "5"), "pack: b", packs("5", "1"))));
}

TEST_CASE("a level without its name or pack is one that means the same, or it is unknown") {
  const auto pack = [](const std::string& name, const std::string& look) {
    return behaviour("      " + name + ": {Look: {" + look + "}, Nod: {priority: 3}}\n");
  };
  const std::string recorded = pack("a", "priority: {calm: 1, firm: 5}");
  CHECK(is_same(replayed(recorded, "pack: a", pack("a", "priority: {hasty: 9, easy: 1}"))));
  CHECK(is_same(replayed(recorded, "pack: a", pack("b", "priority: {hasty: 9, easy: 1}"))));
  CHECK(is_untold(replayed(recorded, "pack: a", pack("b", "priority: {hasty: 9, easy: 2}"))));
  CHECK(is_untold(replayed(recorded, "pack: a", pack("a", "priority: 1, optional: true"))));
  // Without a name the first level is requested.
  CHECK(is_same(replayed(pack("a", "priority: 1"), "pack: a", pack("a", "priority: {easy: 2, hasty: 1}"))));
  CHECK(is_untold(replayed(pack("a", "priority: {x: 1, y: 1}"), "pack: a", pack("a", "priority: {x: 1, y: 2}"))));
  // What another pack means does not count.
  const Replay replay = replayed(
      recorded, "pack: a",
      behaviour("      a: {Look: {priority: {easy: 9}}, Nod: {priority: 3}}\n      b: {Look: {priority: 1}}\n"));
  CHECK(replay.status == 1);
  CHECK(
      replay.out ==
      R"(run.jsonl:7: event 6, at 0.000000 s, cannot be replayed by `other.yaml`, another version than the one recorded
  recorded: ask Play>Look
  replayed: the level of this request is unknown: no level of the pack has the recorded name, or means the same; or the recorded one has several names
  5 events before it are the same
)");
}

TEST_CASE("levels of roots are those of the same name") {
  const auto roots = [](const std::string& play) {
    std::string out = a_then_b;
    out.replace(out.find("[Play]"), 6, "{Nod: {priority: 3}, Look: {priority: {" + play + "}}}");
    return out;
  };
  const std::string input = "{Look: {level: firm}, Nod: {}}";
  CHECK(is_same(replayed(roots("calm: 1, firm: 5"), "pack: a", roots("firm: 6, calm: 1"), input)));
  CHECK(differs(replayed(roots("calm: 1, firm: 5"), "pack: a", roots("calm: 1, firm: 2"), input)));
  CHECK(is_untold(replayed(roots("calm: 1, firm: 5"), "pack: a", roots("calm: 1, hasty: 6"), input)));
}

TEST_CASE("a trace of an earlier program, which says nothing of levels, is replayed by their places and names") {
  World world;
  world.files.add("robot.yaml", a_then_b);
  world.files.add("s.yaml",
                  "scenario: levels\nbehaviour: robot.yaml\nscript:\n  Play: {pack: b}\nsteps:\n  - request: Play\n");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  std::string trace = world.outputs.files.at("run.jsonl");
  const std::size_t uses = trace.find(",\"level_uses\"");
  trace.erase(uses, trace.find('\n') - 1 - uses);
  world.files.add("run.jsonl", trace);
  CHECK(world.directorc({"replay", "run.jsonl"}) == 0);
  CHECK(world.err.empty());
  std::string other = a_then_b;
  other.replace(other.find("priority: 5"), 11, "priority: 6");
  world.files.add("other.yaml", other);
  CHECK(world.directorc({"replay", "run.jsonl", "--behaviour=other.yaml"}) == 0);
}

} // namespace
