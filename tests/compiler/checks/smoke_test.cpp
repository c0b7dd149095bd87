// SPDX-License-Identifier: MIT
#include "compiler/pipeline.hpp"
#include "dsl/source/render.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

namespace {

using namespace director;

/// Behaviour files of a folder and those below it.
std::vector<std::string> behaviours_in(const std::filesystem::path& folder) {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().string();
    if (path.ends_with(".yaml") && !path.ends_with(".scenario.yaml")) out.push_back(path);
  }
  std::sort(out.begin(), out.end());
  return out;
}

compiler::Checked check_file(const std::string& path, dsl::Sources& sources) {
  dsl::DiskFiles files;
  return compiler::check(path, files, sources);
}

TEST_CASE("what runs in the conformance scenarios can be lowered") {
  for (const std::string& path : behaviours_in(tests::source_dir() / "tests" / "conformance")) {
    dsl::Sources sources;
    const compiler::Checked checked = check_file(path, sources);
    INFO(dsl::render(checked.findings, sources));
    const bool is_refused = path.find("/refused/") != std::string::npos;
    CHECK(checked.resolved);
    CHECK(checked.lowerable == !is_refused);
  }
}

} // namespace
