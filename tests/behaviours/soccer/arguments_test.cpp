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

TEST_CASE("a value follows its name, or an equals sign") {
  const CommandLine command = parse({"--seed", "7", "--seconds=90"});
  REQUIRE(command.play);
  CHECK(command.play->seed == 7);
  CHECK(command.play->seconds == 90);
  CHECK(command.play->trace.empty());
  CHECK(parse({"--trace", "run.jsonl"}).play->trace == "run.jsonl");
  CHECK(parse({"--seed=18446744073709551615"}).play->seed == 18446744073709551615u);
}

TEST_CASE(
    "a browser may look at any port, or at one that is given, at a game that is played in real time for an hour") {
  const CommandLine any = parse({"--live"});
  REQUIRE(any.play);
  CHECK(any.play->live == std::uint16_t{0});
  CHECK(any.play->speed == 1.0);
  CHECK(any.play->seconds == 3600);
  CHECK(parse({"--live", "8080", "--seconds", "60"}).play->live == std::uint16_t{8080});
  CHECK(parse({"--live", "8080", "--seconds", "60"}).play->seconds == 60);
  CHECK(parse({"--live=8080"}).play->live == std::uint16_t{8080});
  CHECK(parse({"--live", "--seed", "7"}).play->seed == 7);
  CHECK(parse({"--live", "--speed", "2.5"}).play->speed == 2.5);
  CHECK_FALSE(parse({}).play->live);
  CHECK_FALSE(parse({}).play->speed);
  CHECK(parse({"--speed", "10"}).play->speed == 10.0);
  CHECK(parse({"--speed", "10"}).play->seconds == 60);
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
  CHECK(refused({"--live", "65536"}) == "soccer: --live takes a port from 0 to 65535, not \"65536\"");
  CHECK(refused({"--live=web"}) == "soccer: --live takes a port from 0 to 65535, not \"web\"");
  CHECK(refused({"--live", "web"}) == "soccer: unknown argument web");
  CHECK(refused({"--speed"}) == "soccer: --speed needs a number");
  for (const std::string_view speed : {"0", "-1", "0.001", "1001", "nan", "fast", ""})
    CHECK(refused({"--speed", speed}) ==
          "soccer: --speed takes a number from 0.01 to 1000, not \"" + std::string(speed) + "\"");
  CHECK(refused({"--seconds", "1.5"}) == "soccer: --seconds takes a whole number from 1 to 3600, not \"1.5\"");
}
