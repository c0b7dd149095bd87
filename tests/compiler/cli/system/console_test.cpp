// SPDX-License-Identifier: MIT
#include "compiler/cli/system/console.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/own_folder.hpp"
#include "tests/support/running_program.hpp"

#include <catch2/catch.hpp>
#include <sys/stat.h>

#include <fstream>

namespace {

using namespace director::compiler;
using namespace director::compiler::cli;
namespace fs = std::filesystem;

TEST_CASE("a file on the disk that has its text already is not touched") {
  const fs::path folder = director::tests::binary_dir() / "tests/cli-disk";
  fs::remove_all(folder);
  const std::string path = (folder / "deep/file.txt").string();
  DiskOutputs outputs;
  CHECK(!outputs.write({{path, "one"}}));
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(path, long_ago);
  CHECK(!outputs.write({{path, "one"}}));
  CHECK(fs::last_write_time(path) == long_ago);
  CHECK(!outputs.write({{path, "one", nullptr, true}}));
  CHECK(fs::last_write_time(path) != long_ago);
  CHECK(!outputs.write({{path, "two"}}));
  CHECK(director::tests::read_file(path) == "two");
  CHECK(outputs.write({{path + "/below", "three"}}).has_value());
  fs::remove_all(folder);
}

TEST_CASE("a child gets its input and gives its output, however much there is") {
  ChildPrograms programs;
  const std::string much(3'000'000, 'x');
  const director::compiler::Answer echo = programs.run({"cat"}, much);
  CHECK(echo.started);
  CHECK(echo.status == 0);
  CHECK(echo.output == much);
}

TEST_CASE("a child that fails, that reads nothing, that is not there") {
  ChildPrograms programs;
  CHECK(programs.run({"false"}, std::string(1'000'000, 'x')).status == 1);
  CHECK(programs.run({"sh", "-c", "exit 7"}, "").status == 7);
  CHECK(!programs.run({"no-such-program-here"}, "").started);
}

TEST_CASE("on a terminal it is reported that a pipe is waited for, and what comes then is read") {
  const director::tests::OwnFolder folder("cli-pipe");
  REQUIRE(::mkfifo(folder.at("pipe.yaml").c_str(), 0600) == 0);
  using director::tests::RunningProgram;
  RunningProgram program({"directorc", "check", "pipe.yaml"}, folder.path, RunningProgram::To::terminal);
  program.read_until("directorc: nothing comes from `pipe.yaml` yet: waiting for it, 10 s at most");
  std::ofstream(folder.at("pipe.yaml")) << "behaviour: piped\nlanguage: 2\n";
  program.read_until("language_version");
  CHECK(program.wait() == 1);
}

} // namespace
