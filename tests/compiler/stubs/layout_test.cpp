// SPDX-License-Identifier: MIT
// The first files of a module, and main.cpp: their text, and that it compiles.
#include "compiler/stubs/layout.hpp"
#include "tests/compiler/stubs/behaviour.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>

using namespace director::tests;
using namespace director::compiler::stubs;
namespace fs = std::filesystem;

TEST_CASE("the first files of a module have the specification in comments, and leave everything as it is", "[golden]") {
  const Wanted wanted = wanted_of(walking_robot);
  std::string files;
  std::vector<ModuleClass> classes;
  for (const WantedModule& module : wanted.modules) {
    for (const auto& file : first_files(wanted, module)) files += "==== " + file.path + "\n" + file.text;
    classes.push_back({module.class_name, module.stem + ".hpp"});
  }
  const auto main = main_file(wanted, classes);
  check_golden("tests/compiler/stubs/golden/first_files.txt", files + "==== " + main.path + "\n" + main.text);
}

TEST_CASE("one class may implement several modules, and a root task with data is left to the user") {
  Wanted wanted{"b",
                "b.hpp",
                "b",
                {{"one", "b::One", "One", "one", {}}, {"two", "b::Two", "Two", "two", {}}},
                {{"b::Go", false}, {"b::Kick", true}, {"b::Look", true}}};
  CHECK(main_file(wanted, {{"my::Both", "both.hpp"}, {"my::Both", "both.hpp"}}).text ==
        R"(// Runs the behaviour b.
#include "b.hpp"
#include "both.hpp"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <thread>

int main() {
  // Ctrl-C, or SIGTERM, ends the loop below; a second one ends the program at once.
  static volatile std::sig_atomic_t stopping = 0;
  const auto stop = [](int signal) {
    stopping = 1;
    std::signal(signal, SIG_DFL);
  };
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);

  my::Both one_part;
  b::Behaviour behaviour{one_part, one_part};

  behaviour.request<b::Go>();
  // With data of their own: behaviour.request(b::Kick{data}) and behaviour.request(b::Look{data}).
  const auto start = std::chrono::steady_clock::now();
  const auto step = [&] { return behaviour.step(std::chrono::steady_clock::now() - start); };
  while (stopping == 0) {
    if (step() == director::StepResult::fault) {
      std::fputs("a body requested a level that its group does not declare\n", stderr);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }

  // What runs is stopped: the end of the behaviour calls no stop handler. End threads that post before this.
  behaviour.cancel_all();
  while (step() != director::StepResult::quiescent) {}
}
)");
}

namespace {

/// Generates from a behaviour, writes the first files for it, and compiles them all together.
void check_compiles(const std::string& name, const std::string& from, const std::string& headers) {
  const fs::path folder = binary_dir() / ("tests/stubs-compiled-" + name); // tests run in parallel
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string to = folder.string();
  const std::string directorc = "'" + (binary_dir() / "bin/directorc").string() + "' ";
  REQUIRE(std::system((directorc + "generate '" + from + "' -o '" + to + "/generated'").c_str()) == 0);
  // Without director-clang, as on a computer that has only directorc.
  REQUIRE(std::system(("DIRECTOR_CLANG=/nowhere/director-clang " + directorc + "stubs '" + from + "' -o '" + to +
                       "/src' --main >/dev/null")
                          .c_str()) == 0);
  std::ofstream all(folder / "all.cpp");
  all << headers;
  for (const auto& file : fs::directory_iterator(folder / "src"))
    if (file.path().extension() == ".cpp") all << "#include \"src/" << file.path().filename().string() << "\"\n";
  all.close();
  for (const std::string compiler : {"g++", "clang++-19"}) {
    if (std::system(("command -v " + compiler + " >/dev/null").c_str()) != 0) continue;
    CAPTURE(compiler);
    CHECK(
        std::system((compiler + " -std=c++20 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fsyntax-only -I'" +
                     to + "/generated' -I'" + source_dir().string() + "' '" + to + "/all.cpp'")
                        .c_str()) == 0);
  }
  fs::remove_all(folder);
}

} // namespace

TEST_CASE("what is written first compiles at once with strict warnings") {
  check_compiles("rover", (source_dir() / "tests/docs/rover/rover.yaml").string(), "");
}

TEST_CASE("what is written first compiles where a module is called like a type of C, or like the namespace") {
  const std::string from = (binary_dir() / "tests/stubs-names.yaml").string();
  for (const char* name_space : {"Legs", "Legs::FILE", "provide", "start"}) {
    std::ofstream(from) << "behaviour: b\nlanguage: 1\nroots: [A, _]\ncpp: {namespace: '" << name_space
                        << "'}\ngroups:\n  A: {module: legs, start: true, stop: true}\n  _: {module: FILE}\n";
    check_compiles("names", from, "#include <cstdio>\n");
  }
  fs::remove(from);
}
