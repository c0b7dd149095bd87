// SPDX-License-Identifier: MIT
#include "tests/layout/source_tree.hpp"

#include <catch2/catch.hpp>

#include <sstream>
#include <string>
#include <vector>

using namespace director::tests;

namespace {

/// Macros that would be in the way of a user's name: `reserved_name` keeps only those for Director that begin so.
std::vector<std::string> macro_faults(const ProjectFile& file) {
  std::vector<std::string> faults;
  for (std::size_t index = 0; index < file.lines.size(); ++index) {
    std::istringstream words(file.lines[index]);
    std::string word, name;
    words >> word;
    if (word == "#") words >> name, word += name;
    if (word != "#define" || !(words >> name) || name.starts_with("DIRECTOR_")) continue;
    faults.push_back(file.path + ":" + std::to_string(index + 1) + ": the macro " + name +
                     " does not begin with DIRECTOR_");
  }
  return faults;
}

bool reaches_users(const ProjectFile& file) {
  return (file.path.starts_with("runtime/") || file.path.starts_with("generated/")) &&
         (file.path.ends_with(".hpp") || file.path.ends_with(".cpp"));
}

} // namespace

TEST_CASE("macros of the runtime and of generated code begin as names of a behaviour cannot") {
  for (const ProjectFile& file : project_files()) {
    if (!reaches_users(file)) continue;
    for (const std::string& fault : macro_faults(file)) FAIL_CHECK(fault);
  }
  SUCCEED();
}

TEST_CASE("a macro of another name is found where it stands") {
  CHECK(macro_faults({"runtime/a.hpp", {"#define DIRECTOR_A 1", "", "  # define PART(x) x", "#define B"}}) ==
        std::vector<std::string>{"runtime/a.hpp:3: the macro PART(x) does not begin with DIRECTOR_",
                                 "runtime/a.hpp:4: the macro B does not begin with DIRECTOR_"});
}
