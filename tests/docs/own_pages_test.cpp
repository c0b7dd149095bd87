// SPDX-License-Identifier: MIT
// The pages of the project's own behaviours, as `directorc docs` writes them now.
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <map>

using namespace director::tests;

TEST_CASE("the pages of the behaviours that come with Director are what directorc docs writes", "[golden]") {
  const TemporaryFolder folder;
  std::string command =
      "directorc docs --format=markdown --link='../../{file}#L{line}' -o '" + folder.path().string() + "'";
  for (const std::string name : {"drone", "greenhouse", "soccer", "team", "warehouse"})
    command += " behaviours/" + name + "/" + name + ".yaml";
  const Ran ran = run_command(command, source_dir());
  INFO(ran.output);
  REQUIRE(ran.status == 0);
  std::map<std::string, std::string> pages;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    pages[entry.path().filename().string()] = read_file(entry.path());
  check_golden_folder("docs/behaviours", pages);
}
