// SPDX-License-Identifier: MIT
// The coverage by the scenarios of soccer, as `directorc test --coverage` prints it.
#include "compiler/cli/options/parse.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <sstream>

using namespace director;

namespace {

std::vector<std::string> scenarios() {
  std::vector<std::string> out;
  const std::filesystem::path folder = "behaviours/soccer/scenarios";
  for (const auto& entry : std::filesystem::directory_iterator(tests::source_dir() / folder))
    out.push_back((folder / entry.path().filename()).generic_string());
  std::ranges::sort(out);
  return out;
}

/// The working directory is the root of the source tree.
std::string coverage() {
  compiler::cli::Test request{scenarios(), compiler::cli::Format::text, true, 0};
  dsl::DiskFiles files;
  compiler::cli::DiskOutputs outputs;
  compiler::cli::ChildPrograms programs;
  std::ostringstream out, err;
  compiler::cli::Console console{out, err, false, false, files, outputs, programs};
  CHECK(compiler::cli::run(request, console) == compiler::cli::clean);
  CHECK(err.str().empty());
  return out.str().substr(std::min(out.str().find("coverage of"), out.str().size()));
}

} // namespace

TEST_CASE("what the scenarios of soccer do not exercise is known", "[golden]") {
  tests::check_golden("tests/behaviours/soccer/golden/coverage.txt", coverage());
}

TEST_CASE("the page of soccer has the coverage of the scenarios") {
  const std::string page = tests::read_file(tests::source_dir() / "behaviours/soccer/README.md");
  std::istringstream lines(coverage());
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("coverage of")) continue;
    const std::size_t name = line.rfind('/', line.find(" by ")) + 1, colon = line.find(": ");
    const std::string file = line.substr(name, line.find(" by ") - name);
    const std::string percent = line.substr(colon + 2, line.find(" (") - colon - 2);
    CAPTURE(file, percent);
    CHECK(page.find(percent + " of `" + file + "`") != std::string::npos);
  }
}
