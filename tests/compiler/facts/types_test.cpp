// SPDX-License-Identifier: MIT
#include "compiler/base/version.hpp"
#include "compiler/facts/scanned_types.hpp"
#include "tests/compiler/support/memory_facts.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director::compiler;
using director::tests::MemoryFacts;

/// director-clang: its version, then `answer`.
class TypesChild final : public Programs {
public:
  Answer run(const std::vector<std::string>& words, const std::string& text) override {
    if (words.back() == "version")
      return {true, 0, "{\"director\": \"" + std::string(version()) + "\", \"clang\": \"19\"}"};
    if (words.front() == "sh") return {};
    asked.push_back(text);
    return {true, 0, answer};
  }
  std::string answer =
      R"({"types": [{"complete": true, "enum": {"at": [0, 5, 6], "enumerators": [{"name": "a", "value": "0", "at": [0, 7, 8]}]}}],
                           "paths": ["/u/types.hpp"], "files": [["/u/types.hpp", false], ["/usr/include/vector", true]], "errors": []})";
  std::vector<std::string> asked;
};

struct World {
  World() { files.add("/u/types.hpp", "enum A { a };"); }
  Types read(TypeFlags flags) {
    Scanner scanner("director-clang", child);
    ScannedTypes types(std::move(flags), scanner, child, files, store);
    return types.read({{"types.hpp"}, {"A"}, "x"});
  }
  TypesChild child;
  director::dsl::MemoryFiles files;
  MemoryFacts store;
};

const TypeFlags good{
    {{"/u/other.cpp", "/b", {"g++", "-I/nowhere"}}, {"/u/main.cpp", "/b", {"g++", "-I/u", "-DX"}}}, {}, "`build`"};

TEST_CASE("of several files that find the headers one of C++ that finds the runtime is taken") {
  World world;
  world.files.add("/r/runtime/core/behaviour.hpp", "");
  const auto asked = [&](std::vector<CompileCommand> commands) {
    world.child.asked.clear();
    const Types types = world.read({std::move(commands), {}, "`build`"});
    return world.child.asked.empty() ? types.fault : world.child.asked[0];
  };
  const CompileCommand of_c{"/u/tool.c", "/b", {"gcc", "-I/u", "-DC"}};
  const CompileCommand by_standard{"/u/tool", "/b", {"gcc", "-std=gnu11", "-I/u", "-DC"}};
  const CompileCommand sim{"/u/sim.cpp", "/b", {"g++", "-I/u", "-DSIM"}};
  const CompileCommand robot{"/u/robot.cpp", "/b", {"g++", "-I/u", "-I/r", "-DROBOT"}};
  CHECK(asked({of_c, by_standard, sim, robot}).find("-DROBOT") != std::string::npos);
  CHECK(asked({of_c, by_standard, sim}).find("-DSIM") != std::string::npos);
  CHECK(asked({of_c, by_standard}) == "`build` compiles no C++");
}

TEST_CASE("types are read with the flags of a file that finds the headers, and the second time not at all") {
  World world;
  const Types types = world.read(good);
  CHECK(types.fault == "");
  REQUIRE(types.find("A") != nullptr);
  CHECK(types.find("A")->enumerators.at(0).name == "a");
  CHECK(types.find("A")->place.path == "/u/types.hpp");
  CHECK(types.files == std::vector<std::string>{"/u/types.hpp"});
  REQUIRE(world.child.asked.size() == 1);
  CHECK(
      world.child.asked[0] ==
      R"({"unit":{"file":"/b/director_types.cpp","directory":"/b","arguments":["-I/u","-DX"]},"headers":["types.hpp"],"namespace":"x","names":["A"]})"
      "\n");
  CHECK(world.read(good).find("A") != nullptr);
  CHECK(world.child.asked.size() == 1);
  world.files.add("/u/types.hpp", "enum A { a, b };");
  world.read(good);
  CHECK(world.child.asked.size() == 2);
}

TEST_CASE("why nothing is known of the types") {
  World world;
  CHECK(world.read({{}, "cannot read `build`", {}}).fault == "cannot read `build`");
  CHECK(world.read({{{"/u/other.cpp", "/b", {"g++", "-I/nowhere"}}}, {}, "`build`"}).fault ==
        "no include folder of `build` has the header `types.hpp`");
  CHECK(world.read({{}, {}, "`build`"}).fault == "`build` compiles no C++");
  world.child.answer =
      R"({"types": [null], "paths": [], "files": [], "errors": [{"message": "'y.hpp' file not found"}]})";
  CHECK(world.read(good).fault == "Clang does not understand the headers: 'y.hpp' file not found");
}

TEST_CASE("a header that no file of the program could include is missing") {
  World world;
  CHECK(world.read({{{"/u/a.cpp", "/b", {"g++", "-I/nowhere"}}}, {}, "`build`"}).missing ==
        std::vector<std::string>{"types.hpp"});
  CHECK(world.read(good).missing.empty());
  world.files.add("/v/more.hpp", "");
  const auto missing = [&](const std::vector<std::string>& headers) {
    Scanner scanner("director-clang", world.child);
    const TypeFlags flags{{{"/u/a.cpp", "/b", {"g++", "-I/u"}}, {"/u/b.cpp", "/b", {"g++", "-I/v"}}}, {}, "`build`"};
    const Types types = ScannedTypes(flags, scanner, world.child, world.files, world.store).read({headers, {}, "x"});
    return std::pair(types.missing, types.fault);
  };
  CHECK(missing({"types.hpp"}) == std::pair(std::vector<std::string>{}, std::string{}));
  CHECK(missing({"types.hpp", "more.hpp", "gone.hpp"}) ==
        std::pair(std::vector<std::string>{"gone.hpp"},
                  std::string("no include folder of `build` has the header `gone.hpp`")));
  CHECK(missing({"<types.hpp>", "<gone.hpp>"}).first == std::vector<std::string>{"<gone.hpp>"});
  CHECK(missing({"types.hpp", "more.hpp"}) ==
        std::pair(std::vector<std::string>{}, std::string("no include folder of `build` has the header `types.hpp`")));
}

TEST_CASE("a header in angle brackets is not looked for where only one in quotes is") {
  World world;
  const TypeFlags flags{{{"/u/a.cpp", "/b", {"g++", "-iquote", "/u"}}}, {}, "`build`"};
  Scanner scanner("director-clang", world.child);
  ScannedTypes types(flags, scanner, world.child, world.files, world.store);
  CHECK(types.read({{"types.hpp"}, {}, "x"}).missing.empty());
  CHECK(types.read({{"<types.hpp>"}, {}, "x"}).missing == std::vector<std::string>{"<types.hpp>"});
}

TEST_CASE("where a header does not compile, what is missing may only not have been read, and is requested again") {
  World world;
  world.child.answer =
      R"({"types": [{"wrong": "no type named 'A'"}, {"complete": true}], "paths": ["/u/types.hpp"],
          "files": [["/u/types.hpp", false]], "errors": [{"message": "'later.hpp' file not found", "file": "/u/types.hpp", "line": 1, "column": 10}]})";
  Scanner scanner("director-clang", world.child);
  const auto read = [&] {
    return ScannedTypes(good, scanner, world.child, world.files, world.store).read({{"types.hpp"}, {"A", "B"}, "x"});
  };
  const Types types = read();
  CHECK(types.find("A") == nullptr);
  CHECK(types.find("B") != nullptr);
  CHECK(types.fault == "Clang does not understand the headers: /u/types.hpp:1:10: 'later.hpp' file not found");
  read();
  CHECK(world.child.asked.size() == 2);
}

} // namespace
