// SPDX-License-Identifier: MIT
#include "compiler/cli/input/load.hpp"
#include "tests/compiler/cli/world.hpp"
#include "tests/support/own_folder.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <sstream>

namespace {

using director::tests::World;

World lamp() {
  World world;
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups:\n"
                               "  Lamp: {packs: {bright: {}, dim: {}}}\n");
  world.files.add("bright.yaml", "behaviour: lamp.yaml\nscript: {Lamp: {pack: bright}}\nsteps: [request: Lamp]\n");
  world.files.add("dim.yaml", "behaviour: lamp.yaml\nscript: {Lamp: {pack: dim}}\nsteps: [request: Lamp]\n");
  world.files.add("broken.yaml", "steps: []\n");
  world.files.add("wrong.yaml", "scenario: it rings\nbehaviour: lamp.yaml\nsteps:\n  - request: Lamp\n"
                                "    expect: run Bell new_task\n");
  return world;
}

TEST_CASE("what scenarios cover together is reported for each behaviour") {
  World world = lamp();
  CHECK(world.directorc({"test", "--coverage", "bright.yaml"}) == 0);
  CHECK(world.out == "holds bright.yaml\n"
                     "coverage of lamp.yaml by 1 scenario: 75 % (3 of 4)\n"
                     "  providers     1 of 1\n"
                     "  packs         1 of 2\n"
                     "    lamp.yaml:5:30: `Lamp` never requested its pack `dim`\n"
                     "  levels        1 of 1\n");
  CHECK(world.directorc({"test", "--coverage", "bright.yaml", "dim.yaml"}) == 0);
  CHECK(world.out == "holds bright.yaml\nholds dim.yaml\n2 of 2 hold\n"
                     "coverage of lamp.yaml by 2 scenarios: 100 % (4 of 4)\n"
                     "  providers     1 of 1\n"
                     "  packs         2 of 2\n"
                     "  levels        1 of 1\n");
}

TEST_CASE("a behaviour that scenarios name by several paths is one in the coverage") {
  const director::tests::OwnFolder folder("cli-coverage");
  std::filesystem::create_directories(folder.path / "below");
  folder.write("lamp.yaml", "behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups:\n"
                            "  Lamp: {packs: {bright: {}, dim: {}}}\n");
  std::filesystem::create_symlink("../lamp.yaml", folder.path / "below/linked.yaml");
  folder.write("bright.yaml", "behaviour: lamp.yaml\nscript: {Lamp: {pack: bright}}\nsteps: [request: Lamp]\n");
  folder.write("below/dim.yaml", "behaviour: linked.yaml\nscript: {Lamp: {pack: dim}}\nsteps: [request: Lamp]\n");
  director::dsl::DiskFiles files;
  director::compiler::cli::MemoryOutputs outputs;
  director::tests::FakePrograms programs;
  std::ostringstream out, err;
  director::compiler::cli::Console console{out, err, false, false, files, outputs, programs};
  const std::string first = (folder.path / "bright.yaml").string(), second = (folder.path / "below/dim.yaml").string();
  const int status = std::visit([&](const auto& command) { return run(command, console); },
                                director::compiler::cli::parse({"test", "--coverage", "--min=100", first, second}));
  CHECK(status == 0);
  CHECK(err.str().empty());
  using director::compiler::cli::shown_path;
  CHECK(out.str() == "holds " + shown_path(first) + "\nholds " + shown_path(second) + "\n2 of 2 hold\ncoverage of " +
                         shown_path((folder.path / "lamp.yaml").string()) +
                         " by 2 scenarios: 100 % (4 of 4)\n"
                         "  providers     1 of 1\n"
                         "  packs         2 of 2\n"
                         "  levels        1 of 1\n");
}

TEST_CASE("too little that is covered is a failure where a minimum is requested") {
  World world = lamp();
  CHECK(world.directorc({"test", "--coverage", "--min", "75", "bright.yaml"}) == 0);
  CHECK(world.err.empty());
  CHECK(world.directorc({"test", "--coverage", "--min=76", "bright.yaml"}) == 1);
  CHECK(world.err == "directorc: 75 % of lamp.yaml is covered; --min requires 76 %\n");
  CHECK(world.directorc({"test", "--min=76", "bright.yaml"}) == 2);
  CHECK(world.err == "directorc test: --min requires --coverage\nTry `directorc test --help`.\n");
  CHECK(world.directorc({"test", "--coverage", "--min=101", "bright.yaml"}) == 2);
}

TEST_CASE("results and coverage as JSON") {
  World world = lamp();
  CHECK(world.directorc(
            {"test", "--format=json", "--coverage", "bright.yaml", "wrong.yaml", "none.yaml", "broken.yaml"}) == 2);
  CHECK(world.err == "directorc: cannot read `none.yaml`: No such file or directory\n"
                     "broken.yaml:1:1: error: a scenario file needs `behaviour` [missing_key]\n"
                     "    1 | steps: []\n"
                     "      | ^~~~~\n"
                     "  help: for example `behaviour: walker.yaml`\n"
                     "1 error\n");
  CHECK(world.out == R"({
  "scenarios": [
    {
      "file": "bright.yaml",
      "holds": true,
      "compared": 0,
      "mismatches": [],
      "findings": []
    },
    {
      "file": "wrong.yaml",
      "scenario": "it rings",
      "holds": false,
      "compared": 1,
      "mismatches": [
        {
          "step": 1,
          "line": 5,
          "column": 13,
          "inputs": [
            "request Lamp"
          ],
          "exhausted": false,
          "expected": [
            "run Bell new_task"
          ],
          "happened": [
            "run Lamp new_task"
          ]
        }
      ],
      "findings": []
    },
    {
      "file": "none.yaml",
      "holds": false,
      "findings": []
    },
    {
      "file": "broken.yaml",
      "holds": false,
      "findings": [
        {
          "id": "missing_key",
          "level": "error",
          "file": "broken.yaml",
          "line": 1,
          "column": 1,
          "end_line": 1,
          "end_column": 6,
          "message": "a scenario file needs `behaviour`",
          "notes": [],
          "help": "for example `behaviour: walker.yaml`"
        }
      ]
    }
  ],
  "coverage": [
    {
      "behaviour": "lamp.yaml",
      "scenarios": 2,
      "percent": 75,
      "covered": 3,
      "points": 4,
      "providers": {
        "covered": 1,
        "points": 1
      },
      "packs": {
        "covered": 1,
        "points": 2
      },
      "levels": {
        "covered": 1,
        "points": 1
      },
      "conditions": {
        "covered": 0,
        "points": 0
      },
      "pushes": {
        "covered": 0,
        "points": 0
      },
      "take_overs": {
        "covered": 0,
        "points": 0
      },
      "missing": [
        {
          "class": "packs",
          "file": "lamp.yaml",
          "line": 5,
          "column": 30,
          "message": "`Lamp` never requested its pack `dim`"
        }
      ]
    }
  ]
}
)");
}

} // namespace
