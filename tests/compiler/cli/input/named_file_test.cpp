// SPDX-License-Identifier: MIT
// A folder in place of a file.
#include "compiler/cli/options/parse.hpp"
#include "tests/support/own_folder.hpp"

#include <catch2/catch.hpp>

#include <sstream>

namespace {

using namespace director::compiler::cli;
namespace fs = std::filesystem;

/// The status and the output, of a command line whose paths are relative to this folder.
std::string said(const fs::path& folder, const std::vector<std::string>& words) {
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  director::dsl::DiskFiles files;
  DiskOutputs outputs;
  ChildPrograms programs;
  std::ostringstream out, err;
  Console console{out, err, false, false, files, outputs, programs};
  const int status = std::visit([&](const auto& command) { return run(command, console); }, parse(words));
  fs::current_path(before);
  return std::to_string(status) + " " + out.str() + err.str();
}

TEST_CASE("if a folder is named instead of a file, the file that may be meant is reported") {
  const director::tests::OwnFolder folder("cli-named-file");
  fs::create_directories(folder.path / "soccer/deeper.yaml");
  fs::create_directories(folder.path / "empty");
  for (const char* file : {"soccer/soccer.yaml", "soccer/another.yml", "soccer/a.scenario.yaml", "soccer/.hidden.yaml",
                           "soccer/game.jsonl", "soccer/zoo.yaml"})
    folder.write(file, "");
  const std::string begin = "2 directorc: cannot read `soccer`: Is a directory; name a file in it, such as `soccer/";
  for (const char* slash : {"soccer", "soccer/"}) {
    const std::string path = slash;
    CAPTURE(path);
    const std::string with =
        "2 directorc: cannot read `" + path + "`: Is a directory; name a file in it, such as `soccer/";
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"check", path},
                                               {"generate", path, "-o", "out"},
                                               {"graph", path},
                                               {"docs", path, "-o", "out"},
                                               {"diff", path, path},
                                               {"explore", path},
                                               {"stubs", path, "-o", "out"},
                                               {"verify", path, "-p", "."},
                                               {"dump", path, "--stage", "model"}}) {
      CAPTURE(words.front());
      CHECK(said(folder.path, words) == with + "soccer.yaml`\n");
    }
    CHECK(said(folder.path, {"simulate", path}) == with + "a.scenario.yaml`\n");
    CHECK(said(folder.path, {"why", path, "Walk"}) == with + "a.scenario.yaml`\n");
    CHECK(said(folder.path, {"trace", path}) == with + "game.jsonl`\n");
    CHECK(said(folder.path, {"replay", path}) == with + "game.jsonl`\n");
  }
  fs::remove(folder.path / "soccer/soccer.yaml");
  CHECK(said(folder.path, {"check", "soccer"}) == begin + "another.yml`\n");
  CHECK(said(folder.path, {"check", "empty"}) == "2 directorc: cannot read `empty`: Is a directory; name a file\n");
  CHECK(said(folder.path, {"check", "-"}) ==
        "2 directorc: cannot read `-`: No such file or directory; the standard input is called `/dev/stdin`, and "
        "relative paths in it begin at `/dev`\n");
  CHECK(said(folder.path, {"check", "none"}) == "2 directorc: cannot read `none`: No such file or directory\n");
}

TEST_CASE("if a file is named instead of the folder of a build, it is reported what is expected") {
  const director::tests::OwnFolder folder("cli-named-build");
  folder.write("lamp.yaml", "behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups: {Lamp: {}}\n");
  folder.write("compile_commands.json", "[]");
  const std::string told = "2 directorc: `compile_commands.json` is a file, and `-p` names the folder of a build\n";
  CHECK(said(folder.path, {"check", "lamp.yaml", "-p", "compile_commands.json"}) == told);
  CHECK(said(folder.path, {"verify", "lamp.yaml", "-p", "compile_commands.json"}) == told);
  CHECK(said(folder.path, {"stubs", "lamp.yaml", "-o", "src", "-p", "compile_commands.json"}) == told);
}

} // namespace
