// SPDX-License-Identifier: MIT
#include "tests/layout/source_tree.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <string_view>
#include <vector>

using namespace director::tests;

namespace {

// Each word is written in two halves, so that this file does not hold it.
std::vector<std::string> forbidden_words() {
  using namespace std::string_literals;
  return {"/wo"s + "rk/",   "/ro"s + "ot/",    "/ho"s + "me/", "deb.de"s + "bian.org", "registry.np"s + "mjs.org",
          "py"s + "pi.org", "cra"s + "tes.io", "TO"s + "DO",   "FIX"s + "ME",          "not impl"s + "emented"};
}

std::vector<std::string> word_faults(const ProjectFile& file) {
  std::vector<std::string> faults;
  for (std::size_t index = 0; index < file.lines.size(); ++index)
    for (const std::string& word : forbidden_words())
      if (file.lines[index].find(word) != std::string::npos)
        faults.push_back(file.path + ":" + std::to_string(index + 1) + ": holds " + word);
  return faults;
}

} // namespace

TEST_CASE("no file names a machine's folder, a package server or work that is left over") {
  for (const ProjectFile& file : project_files())
    for (const std::string& fault : word_faults(file)) FAIL_CHECK(fault);
  SUCCEED();
}

TEST_CASE("a forbidden word is found where it stands") {
  const std::string word = forbidden_words().front();
  CHECK(word_faults({"docs/a.md", {"fine", "see " + word + "shared"}}) ==
        std::vector<std::string>{"docs/a.md:2: holds " + word});
}
