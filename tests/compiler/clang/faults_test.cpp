// SPDX-License-Identifier: MIT
// Each fault that is planted in a copy of soccer's bodies is found, and a damaged or old cache does no harm.
#include "compiler/base/json.hpp"
#include "tests/compiler/clang/workshop.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>

namespace {

using namespace director::tests;
using director::compiler::Json;
namespace fs = std::filesystem;

struct Planted {
  const char* file;
  const char* from;
  const char* to;
  const char* found; ///< id, and place
};

constexpr Planted faults[] = {
    {"locomotion.cpp", "    run.set(Stability::standing);", "    robot_.stride({});",
     "causing_never_set: no path of `Walk.halting` sets what it promises, `Stability == standing`"},
    {"locomotion.cpp", ", LeftArm{{-arms}},\n                     RightArm{{arms}});",
     ", LeftArm{{-arms + 0 * arms}});", "task_never_requested: no path of `Walk.walking` requests `RightArm`"},
    {"planning.cpp", "return run.stand_by();", "return run.keep();",
     "pack_never_requested: no path of `KickTo` requests `stand_by`"},
    {"recovery.cpp", "run.set(RisingStep::tucked);", "run.try_set(RisingStep::kneeling);",
     "undeclared_state_write: `GetUp.tucking` sets `RisingStep` to `kneeling`, which it does not declare"},
    {"strategy.cpp", "return run.sweep(LookAt{{sweeps_left_ ? 60 * degree : -60 * degree}});", "return run.keep();",
     "only_keeps: every path of `Look.sweeping` ends in `keep()`: it never requests anything, and is never done"},
    {"kicking.hpp", "  director::Outcome provide(soccer::Kick::Default& run) override;",
     "  director::Outcome provide(soccer::Kick::Default& run) override;\n"
     "  director::Outcome provide(soccer::LookAt::Default& run) { return run.keep(); }",
     "handler_without_provider: nothing calls this body for `LookAt`: it belongs to the module `looking`, which "
     "`player::Kicking` does not implement here"},
    {"limbs.hpp", "  director::Outcome provide(soccer::Head::Default& run) override;",
     "  director::Outcome provide(soccer::Head::Default& run);", ""}, // still overrides: nothing is wrong with it
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  for (std::size_t i = at; i != std::string::npos; i = text.find(from, i + to.size())) text.replace(i, from.size(), to);
  return text;
}

std::vector<std::string> found_in(const std::string& text) {
  const auto json = director::compiler::parse_json(text);
  REQUIRE(json);
  std::vector<std::string> out;
  for (const Json& each : (*json)["findings"].items())
    out.push_back(each["id"].as_text() + ": " + each["message"].as_text());
  std::sort(out.begin(), out.end());
  return out;
}

TEST_CASE("faults planted in the bodies of soccer are each found") {
  const Workshop work("soccer");
  const fs::path bodies = fs::path(source_folder()) / "behaviours/soccer/player";
  std::vector<std::string> files, expected;
  for (const auto& entry : fs::directory_iterator(bodies)) {
    std::string text = read_file(entry.path().string());
    const std::string name = entry.path().filename().string();
    for (const Planted& fault : faults) {
      if (name == fault.file) text = replaced(text, fault.from, fault.to);
    }
    work.write("behaviours/soccer/player/" + name, text);
    if (name.ends_with(".cpp") && name != "legs.cpp") files.push_back(work.path("behaviours/soccer/player/" + name));
  }
  for (const Planted& fault : faults) {
    if (*fault.found != '\0') expected.emplace_back(fault.found);
  }
  const std::string soccer = source_folder() + "/behaviours/soccer/soccer.yaml";
  CHECK(work.directorc({"generate", soccer, "-o", work.path("generated")}).status == 0);
  work.write_commands(files, {"-std=c++20", "-I" + work.path(), "-I" + work.path("generated"), "-I" + source_folder()});
  const Worked verified = work.directorc({"verify", soccer, "-p", work.path(), "--format=json"});
  INFO(verified.err);
  std::sort(expected.begin(), expected.end());
  CHECK(found_in(verified.out) == expected);

  SECTION("the second time from the cache, spoilt or not") {
    const auto begin = std::chrono::steady_clock::now();
    CHECK(work.directorc({"verify", soccer, "-p", work.path(), "--format=json"}).out == verified.out);
    WARN("a second run takes "
         << std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begin).count()
         << " ms");
    for (const auto& entry : fs::directory_iterator(work.path(".director"))) {
      fs::resize_file(entry.path(), fs::file_size(entry.path()) / 2);
      break;
    }
    CHECK(work.directorc({"verify", soccer, "-p", work.path(), "--format=json"}).out == verified.out);
    const std::string file = work.path("behaviours/soccer/player/strategy.cpp");
    std::ofstream(file, std::ios::binary) << read_file((bodies / "strategy.cpp").string());
    std::erase_if(expected, [](const std::string& each) { return each.starts_with("only_keeps"); });
    CHECK(found_in(work.directorc({"verify", soccer, "-p", work.path(), "--format=json"}).out) == expected);
  }
}

} // namespace
