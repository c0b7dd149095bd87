// Header: this program. Test: tests/system/arm/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// write_plans OUT.cpp OUT.txt SCENARIO...: the scenarios as constants for the target, and their events on the host.
#include "compiler/cli/input/load_scenario.hpp"
#include "compiler/play/play.hpp"
#include "tests/system/arm/plan_text.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace cli = director::compiler::cli;
namespace dsl = director::dsl;
using namespace director::compiler;

namespace {

std::string trace(const cli::LoadedScenario& loaded, const std::string& title) {
  std::string out = "== " + title + "\n";
  const Played played = play(loaded.scenario, loaded.model, loaded.lowered, {.decisions = true},
                             [&](const Happening& happening) { out += to_text(happening) + "\n"; });
  return played.refused ? out + "refused\n" : out;
}

bool wrote(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) std::cerr << "write_plans: cannot write " << path << "\n";
  return !file.fail();
}

} // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> words(arguments + 1, arguments + count);
  if (words.size() < 3) {
    std::cerr << "write_plans OUT.cpp OUT.txt SCENARIO...\n";
    return 2;
  }
  dsl::DiskFiles files;
  cli::DiskOutputs outputs;
  cli::ChildPrograms programs;
  cli::Console console{std::cout, std::cerr, false, false, files, outputs, programs};
  director::tests::PlanText text;
  std::string traces;
  for (auto file = words.begin() + 2; file != words.end(); ++file) {
    dsl::Sources sources;
    const cli::LoadedScenario loaded = cli::load_scenario(*file, sources, console, {});
    if (loaded.status != cli::clean) return loaded.status;
    const std::string title = std::filesystem::path(*file).filename().string();
    text.add(title, sources, loaded);
    traces += trace(loaded, title);
  }
  return wrote(words[0], text.text()) && wrote(words[1], traces) ? 0 : 2;
}
