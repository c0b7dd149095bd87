// Header: this program, started by tests/fuzz/grow. Test: tests/fuzz/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// fuzz_seeds FOLDER: the behaviours, scenarios and blocks of pages of this project, as files that the fuzzers can begin
// with, in FOLDER/behaviour, FOLDER/scenario and FOLDER/pipeline.
#include "dsl/reading/read_behaviour.hpp"
#include "dsl/reading/read_scenario.hpp"
#include "tests/fuzz/files.hpp"
#include "tests/property/generate.hpp"
#include "tests/schemas/corpus.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

namespace fs = std::filesystem;
using namespace director;

constexpr std::size_t largest = 16'384; ///< that the fuzzers make
constexpr std::size_t some = 50;        ///< of the files that differ in one place, one in so many

void write(const fs::path& folder, const std::vector<fuzz::NamedText>& files) {
  static std::size_t number = 0;
  const std::string text = fuzz::join(files);
  if (text.size() <= largest) std::ofstream(folder / std::to_string(++number), std::ios::binary) << text;
}

/// The behaviour with all that it imports, the main file first.
std::vector<fuzz::NamedText> with_imports(const std::string& path) {
  dsl::DiskFiles disk;
  dsl::Sources sources;
  (void)dsl::read_behaviour(path, disk, sources);
  std::vector<fuzz::NamedText> out;
  for (const dsl::SourceFile& file : sources)
    out.push_back({fs::path(file.path()).lexically_relative(fs::path(path).parent_path()).string(), file.text()});
  return out;
}

void write_file(const fs::path& out, const fs::path& file) {
  if (!file.string().ends_with(".scenario.yaml")) {
    write(out / "behaviour", with_imports(file.string()));
    return write(out / "pipeline", with_imports(file.string()));
  }
  dsl::DiskFiles disk;
  dsl::Sources sources;
  const dsl::ReadScenarioResult read = dsl::read_scenario(file.string(), disk, sources);
  std::vector<fuzz::NamedText> files = with_imports(read.scenario.behaviour_path);
  const fs::path here = file.parent_path(), there = fs::path(read.scenario.behaviour_path).parent_path();
  for (fuzz::NamedText& each : files) each.name = (there / each.name).lexically_relative(here).string();
  files.insert(files.begin(), {"", sources[dsl::FileId{0}].text()});
  write(out / "scenario", files);
}

} // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "fuzz_seeds FOLDER\n";
    return 2;
  }
  const fs::path out = arguments[1], root = DIRECTOR_SOURCE_DIR;
  for (const char* kind : {"behaviour", "scenario", "pipeline"}) fs::create_directories(out / kind);
  for (const fs::path& folder : {root / "behaviours", root / "tests/conformance", root / "tests/compiler"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".yaml") write_file(out, entry.path());
  std::size_t changed = 0;
  for (const tests::CorpusFile& file : tests::corpus()) {
    if (file.name.ends_with(", changed") && ++changed % some != 0) continue;
    write(out / (file.scenario ? "scenario" : "behaviour"), {{"", file.text}});
    if (!file.scenario) write(out / "pipeline", {{"", file.text}});
  }
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const property::Documents made = property::generate(seed);
    write(out / "pipeline", {{"", property::to_yaml(made.behaviour)}});
    write(out / "scenario",
          {{"", property::to_yaml(made.scenario)}, {"behaviour.yaml", property::to_yaml(made.behaviour)}});
  }
  return 0;
}
