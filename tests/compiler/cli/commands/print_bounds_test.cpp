// SPDX-License-Identifier: MIT
#include "tests/compiler/cli/world.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <sstream>
#include <string>
#include <string_view>

namespace {

using director::tests::check_golden;
using director::tests::World;

TEST_CASE("memory and bounds are printed behind the findings, of a deployment", "[golden]") {
  World world;
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nstates: {Day: {values: [a, b], initial: a, of: Lamp}}\n"
                               "roots: [Lamp]\ngroups:\n  Lamp: {sets: [Day == b]}\n");
  CHECK(world.directorc({"check", "--verbose", "lamp.yaml"}) == 0);
  check_golden("tests/compiler/cli/commands/golden/bounds.txt", world.out);
  CHECK(world.directorc({"check", "--verbose", "--format=json", "lamp.yaml"}) == 0);
  check_golden("tests/compiler/cli/commands/golden/bounds.json", world.out);
}

std::string lines_with(const std::string& text, std::string_view word) {
  std::istringstream lines(text);
  std::string out;
  for (std::string line; std::getline(lines, line);)
    if (line.find(word) != std::string::npos) out += line + '\n';
  return out;
}

TEST_CASE("the cost of a unit of work on another machine changes the times, and nothing else") {
  World world;
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups:\n  Lamp: {}\n");
  CHECK(world.directorc({"check", "--verbose", "--work-ns=2500000", "lamp.yaml"}) == 0);
  CHECK(lines_with(world.out, " ms ") ==
        "  time                20 ms at most for one pass, at 2.5e+06 ns a unit of work; `--work-ns` says another\n"
        "                      20 ms at most to decide in one micro-step; bodies and observers come on top\n");
  CHECK(world.directorc({"check", "--work-ns=20", "lamp.yaml"}) == 2);
  CHECK(world.err.find("--work-ns requires --verbose") != std::string::npos);
  CHECK(world.directorc({"check", "--verbose", "--work-ns=0", "lamp.yaml"}) == 2);
  CHECK(world.err.find("--work-ns: Value 0 not in range") != std::string::npos);
  CHECK(world.directorc({"check", "--verbose", "--work-ns=nan", "lamp.yaml"}) == 2);
  CHECK(world.err == "directorc check: --work-ns: Value nan is not a number\nTry `directorc check --help`.\n");
}

TEST_CASE("a module has no bounds of its own") {
  World world;
  world.files.add("bulb.yaml", "behaviour: bulb\nlanguage: 1\ngroups:\n  Bulb: {}\n");
  CHECK(world.directorc({"check", "--verbose", "bulb.yaml"}) == 0);
  CHECK(world.out.empty());
}

TEST_CASE("findings as SARIF") {
  World world;
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nroots: [Lump]\ngroups:\n  Lamp: {}\n");
  CHECK(world.directorc({"check", "--format=sarif", "lamp.yaml"}) == 1);
  const std::string end = world.out.substr(world.out.find("      \"columnKind\""));
  CHECK(end.substr(0, end.find("\"director/v1\"")) == R"(      "columnKind": "unicodeCodePoints",
      "results": [
        {
          "ruleId": "undefined_name",
          "ruleIndex": )" + end.substr(end.find("ruleIndex") + 12, 2) +
                                                          R"(,
          "level": "error",
          "message": {
            "text": "there is no group called `Lump`\nhelp: did you mean `Lamp`?"
          },
          "locations": [
            {
              "physicalLocation": {
                "artifactLocation": {
                  "uri": "lamp.yaml"
                },
                "region": {
                  "startLine": 3,
                  "startColumn": 9,
                  "endLine": 3,
                  "endColumn": 13
                }
              }
            }
          ],
          "partialFingerprints": {
            )");
}

} // namespace
