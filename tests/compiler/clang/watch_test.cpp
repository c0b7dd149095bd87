// SPDX-License-Identifier: MIT
// `check --watch` with the types of a program: its headers are watched.
#include "tests/support/command.hpp"
#include "tests/support/running_program.hpp"

#include <catch2/catch.hpp>

#include <fstream>

namespace {

using namespace director::tests;
namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

/// Without its first and its last line, which have times.
std::string next_findings(RunningProgram& program) {
  const std::string text = program.read_until("Ctrl-C ends\n");
  const std::size_t begin = text.find('\n') + 1;
  return text.substr(begin, text.rfind("== ") - begin);
}

TEST_CASE("a header of the program that changes, also one that another includes, is read again") {
  const TemporaryFolder folder;
  const fs::path& here = folder.path();
  write(here / "bot.yaml", "behaviour: bot\nlanguage: 1\ncpp: {headers: [types.hpp]}\n"
                           "states: {Mode: {type: \"bot::Mode\", values: [still, moving], initial: still}}\n"
                           "roots: [Walk]\ngroups: {Walk: {when: [Mode == moving]}}\n");
  write(here / "include/types.hpp", "#include \"inner.hpp\"\n");
  const std::string good = "namespace bot { enum class Mode { still, moving }; }\n";
  write(here / "include/inner.hpp", good);
  write(here / "main.cpp", "");
  const std::string path = here.string();
  write(here / "build/compile_commands.json", R"([{"directory": ")" + path + R"(/build", "file": ")" + path +
                                                  R"(/main.cpp", "command": "g++ -I)" + path + R"(/include -c )" +
                                                  path + R"(/main.cpp"}])");
  RunningProgram program({"directorc", "check", "--watch", "-p", "build", "bot.yaml"}, here);
  const std::string clean = next_findings(program);
  write(here / "include/inner.hpp", "namespace bot { enum class Mode { still, rolling }; }\n");
  CHECK(next_findings(program).find("error: `bot::Mode` has no `moving` [enum_drift]\n") != std::string::npos);
  write(here / "include/inner.hpp", good);
  CHECK(next_findings(program) == clean);
  fs::rename(here / "include/types.hpp", here / "types.hpp");
  CHECK(next_findings(program).find(" has `types.hpp` [missing_header]\n") != std::string::npos);
  fs::rename(here / "types.hpp", here / "include/types.hpp");
  CHECK(next_findings(program) == clean);
}

} // namespace
