// SPDX-License-Identifier: MIT
#include "compiler/cli/system/wrapping.hpp"
#include "tests/support/command.hpp"
#include "tests/support/running_program.hpp"

#include <catch2/catch.hpp>

#include <ostream>
#include <regex>
#include <sstream>

namespace {

using director::compiler::cli::wrapped_line;
using director::compiler::cli::WrappingBuffer;

TEST_CASE("a line that is too wide is broken between words, and goes on further right") {
  CHECK(wrapped_line("it fits", 10) == "it fits");
  CHECK(wrapped_line("robot.yaml:4:15: warning: who asks first keeps it", 30) ==
        "robot.yaml:4:15: warning: who\n    asks first keeps it");
  CHECK(wrapped_line("  help: give one of them a higher priority", 30) ==
        "  help: give one of them a\n      higher priority");
  CHECK(wrapped_line("a_name_that_is_wider_than_the_line", 20) == "a_name_that_is_wider_than_the_line");
}

TEST_CASE("colours take no columns") {
  CHECK(wrapped_line("\033[1mbold\033[0m text fits", 15) == "\033[1mbold\033[0m text fits");
}

TEST_CASE("of a table the last column is broken, and source that is shown stays whole") {
  CHECK(wrapped_line("  waiting runs    5 at most in one of them", 38) ==
        "  waiting runs    5 at most in one of\n                  them");
  for (const char* line : {"   12 |   tasks: [Legs, LeftArm, RightArm]", "      |           ^~~~~~~~~~~~~~~~~~~~~~",
                           "  ... |  and so on, however long it may be"})
    CHECK(wrapped_line(line, 20) == line);
}

TEST_CASE("a stream breaks what was printed in pieces, and shows at once what is flushed") {
  std::ostringstream terminal;
  WrappingBuffer buffer(*terminal.rdbuf(), 20);
  std::ostream out(&buffer);
  out << "one two three" << ' ' << "four five six" << '\n';
  CHECK(terminal.str() == "one two three four\n    five six\n");
  terminal.str("");
  out << "12 states of many, and more" << std::flush;
  CHECK(terminal.str() == "12 states of many, and more");
  out << " that follow here\nnext\n";
  CHECK(terminal.str() == "12 states of many, and more that follow here\nnext\n");
}

TEST_CASE("on a terminal of 80 columns no line of sentences is wider, and a pipe gets what was written") {
  using namespace director::tests;
  const std::filesystem::path& source = source_dir();
  const std::vector<std::vector<std::string>> commands{
      {"directorc", "check", "tests/docs/tutorial/4_equal/gardener.yaml"},
      {"directorc", "check", "--verbose", "tests/docs/rover/rover.yaml"},
      {"directorc", "checks"},
      {"directorc", "explain", "equal_priority"},
      {"directorc", "explain", "needs"},
      {"directorc", "test", "tests/docs/idioms/without"},
      {"directorc", "diff", "tests/docs/rover/rover.yaml", "tests/docs/diff/rover.yaml"},
      {"directorc", "why", "tests/docs/rover/rover.scenario.yaml", "Photograph", "--step", "2"},
      {"directorc", "explore", "tests/docs/rover/rover.yaml"},
  };
  for (const std::vector<std::string>& words : commands) {
    RunningProgram program(words, source, RunningProgram::To::terminal);
    // The progress of an exploration is printed only while it runs.
    const std::string stays = std::regex_replace(program.rest(), std::regex("[^\n]*\r\033\\[K"), "");
    std::istringstream lines(std::regex_replace(stays, std::regex("\033\\[[0-9;]*[A-Za-z]|\r"), ""));
    for (std::string line; std::getline(lines, line);) {
      INFO(words[1] << ": " << line);
      CHECK((line.size() <= 80 || line.find(' ', line.find_first_not_of(' ')) == std::string::npos));
    }
  }
  const Ran piped =
      run_command("directorc check '" + (source / "tests/docs/tutorial/4_equal/gardener.yaml").string() + "'", source);
  CHECK(piped.output.find(
            "whichever takes it first keeps it, and if both want it at once `Tend` takes it [equal_priority]\n") !=
        std::string::npos);
}

} // namespace
