// SPDX-License-Identifier: MIT
// The programs as a user starts them.
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>
#include <sys/wait.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace {

using director::tests::binary_dir;
using director::tests::check_golden;

struct Ran {
  int exit_code = 0;
  std::string text;
};

Ran run(const std::string& program, const std::string& arguments, const std::string& streams) {
  const std::string command = "'" + (binary_dir() / program).string() + "' " + arguments + " " + streams;
  std::FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  Ran out;
  for (int c; (c = std::fgetc(pipe)) != EOF;) out.text += static_cast<char>(c);
  const int status = pclose(pipe);
  REQUIRE(WIFEXITED(status));
  out.exit_code = WEXITSTATUS(status);
  return out;
}

std::string game(const std::string& program, const std::string& arguments) {
  const Ran ran = run(program, arguments, "2>&1");
  CHECK(ran.exit_code == 0);
  return ran.text;
}

bool has(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// Each part comes after the one before.
void check_order(std::string_view text, const std::vector<std::string_view>& parts) {
  std::size_t from = 0;
  for (const std::string_view part : parts) {
    const std::size_t at = text.find(part, from);
    INFO("looking for: " << part);
    REQUIRE(at != std::string_view::npos);
    from = at + part.size();
  }
}

const std::vector<std::string_view> story{
    "runs       WalkToBall    striding",
    "runs       Walk          walking, for WalkTo",
    "pushed     Walk          to halting, as Kick waits for Stability == standing",
    "runs       Walk          halting, pushed",
    "set        Stability     standing, by Walk",
    "takes      Kick          LeftLeg, RightLeg from Walk",
    "stops      Walk",
    "runs       Kick",
    "done       Kick",
    "starts     Walk",
    "sensed     Stability     falling",
    "runs       FallRecovery  protecting",
    "takes      Brace         LeftArm, RightArm, LeftLeg, RightLeg from Walk",
    "stops      Walk",
    "sensed     Stability     fallen",
    "runs       GetUp         tucking",
    "runs       GetUp         pushing",
    "runs       GetUp         rising",
    "done       GetUp",
    "runs       FallRecovery  watching",
    "starts     Walk",
    "pushed     Walk          to halting",
    "takes      Kick          LeftLeg, RightLeg from Walk",
};

} // namespace

TEST_CASE("a seed is the same game, byte for byte, with every compiler", "[golden]") {
  check_golden("tests/behaviours/soccer/golden/seed_1.txt", game("bin/soccer", "--seed 1"));
}

TEST_CASE("another seed is another game") { CHECK(game("bin/soccer", "--seed 2") != game("bin/soccer", "--seed 3")); }

TEST_CASE("the robot walks, is pushed to a halt, kicks, falls in the middle of a walk, gets up and plays on") {
  check_order(game("bin/soccer", ""), story);
}

TEST_CASE("the same player has the same timeline on other legs") { check_order(game("bin/soccer_simple", ""), story); }

TEST_CASE("for ten minutes of any game the robot kicks again and again") {
  for (const char* seed : {"4", "8", "21"}) {
    const std::string text = game("bin/soccer", std::string("--seconds 600 --seed ") + seed);
    std::size_t kicks = 0;
    for (std::size_t at = 0; (at = text.find("runs       Kick ", at)) != std::string::npos; ++at) ++kicks;
    CHECK(kicks > 30);
    CHECK_FALSE(has(text, "broken"));
  }
}

TEST_CASE("without the promise of halting there is no push, and no kick") {
  const std::string text = game("tests/bin/soccer_without_promise", "");
  CHECK(has(text, "waits      Kick          for Stability == standing"));
  CHECK(has(text, "runs       Walk          walking"));
  CHECK_FALSE(has(text, "pushed"));
  CHECK_FALSE(has(text, "halting"));
  CHECK_FALSE(has(text, "runs       Kick "));
  CHECK(has(text, ": 0 kicks, 0 goals."));
  CHECK(has(text, " runs, 0 pushes, "));
}

TEST_CASE("a pipe gets no colours") { CHECK_FALSE(has(game("bin/soccer", "--seconds 20"), "\033")); }

TEST_CASE("wrong usage is reported on standard error, with exit code 2") {
  const Ran ran = run("bin/soccer", "--sed 7", "2>&1 >/dev/null");
  CHECK(ran.exit_code == 2);
  CHECK(ran.text.substr(0, ran.text.find('\n')) == "soccer: unknown argument --sed");
}

TEST_CASE("the cart turns until it sees the ball, and drives to it", "[golden]") {
  check_golden("tests/behaviours/soccer/golden/chase_ball.txt", game("bin/chase_ball", ""));
}
