// SPDX-License-Identifier: MIT
#include "behaviours/soccer/arguments.hpp"

#include <catch2/catch.hpp>

namespace {

std::string refused(const std::vector<std::string_view>& arguments) {
  const CommandLine command = parse(arguments);
  CHECK_FALSE(command.play);
  CHECK(command.exit_code == 2);
  return command.text.substr(0, command.text.find('\n'));
}

} // namespace

TEST_CASE("without arguments a minute of the first world is played") {
  const CommandLine command = parse({});
  REQUIRE(command.play);
  CHECK(command.play->seed == 1);
  CHECK(command.play->seconds == 60);
}

TEST_CASE("a value stands behind its name or behind an equals sign") {
  const CommandLine command = parse({"--seed", "7", "--seconds=90"});
  REQUIRE(command.play);
  CHECK(command.play->seed == 7);
  CHECK(command.play->seconds == 90);
  CHECK(command.play->trace.empty());
  CHECK(parse({"--trace", "run.jsonl"}).play->trace == "run.jsonl");
  CHECK(parse({"--seed=18446744073709551615"}).play->seed == 18446744073709551615u);
}

TEST_CASE("help and version are no faults") {
  CHECK(parse({"--help"}).exit_code == 0);
  CHECK(parse({"--help"}).text.substr(0, 14) == "Usage: soccer ");
  CHECK(parse({"--version"}).exit_code == 0);
  CHECK(parse({"--version"}).text == "soccer, built with Director 0.1.0\n");
}

TEST_CASE("what is no argument is refused with its reason") {
  CHECK(refused({"--sed", "7"}) == "soccer: unknown argument --sed");
  CHECK(refused({"7"}) == "soccer: unknown argument 7");
  CHECK(refused({"--trace"}) == "soccer: --trace needs a file");
  CHECK(refused({"--seed"}) == "soccer: --seed needs a number");
  CHECK(refused({"--seed", "seven"}) == "soccer: --seed takes a whole number, not \"seven\"");
  CHECK(refused({"--seed", "-1"}) == "soccer: --seed takes a whole number, not \"-1\"");
  CHECK(refused({"--seed="}) == "soccer: --seed takes a whole number, not \"\"");
  CHECK(refused({"--seconds", "0"}) == "soccer: --seconds takes a whole number from 1 to 3600, not \"0\"");
  CHECK(refused({"--seconds", "3601"}) == "soccer: --seconds takes a whole number from 1 to 3600, not \"3601\"");
  CHECK(refused({"--seconds", "1.5"}) == "soccer: --seconds takes a whole number from 1 to 3600, not \"1.5\"");
}
