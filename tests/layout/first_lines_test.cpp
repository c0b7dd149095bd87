// SPDX-License-Identifier: MIT
#include "tests/layout/source_tree.hpp"

#include <catch2/catch.hpp>

#include <set>
#include <sstream>

using namespace director::tests;

namespace {

/// The files that the first line of a source names, as in `Header: a/b.hpp. Test: tests/a/b_test.cpp,
/// tests/c_test.cpp.`
std::vector<std::string> files_named(const std::string& line) {
  std::vector<std::string> out;
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    while (!word.empty() && (word.back() == '.' || word.back() == ',' || word.back() == ';')) word.pop_back();
    if (word.starts_with("./")) word.erase(0, 2); // a script at the root
    const bool pattern = word.find_first_of("*<>") != std::string::npos;
    if (word.find('/') != std::string::npos && word != "//" && !pattern) out.push_back(word);
  }
  return out;
}

} // namespace

TEST_CASE("the header and the test that a source names in its first line are there") {
  std::set<std::string> there;
  for (const ProjectFile& file : project_files()) {
    there.insert(file.path);
    for (std::size_t at = file.path.rfind('/'); at != std::string::npos; at = file.path.rfind('/', at - 1)) {
      there.insert(file.path.substr(0, at));
      if (at == 0) break;
    }
  }
  for (const ProjectFile& file : project_files()) {
    if (!file.path.ends_with(".cpp") || file.lines.empty() || !file.lines.front().starts_with("// Header: ")) continue;
    for (const std::string& named : files_named(file.lines.front())) {
      INFO(file.path << ":1: there is no " << named);
      CHECK(there.count(named) == 1);
    }
  }
}

TEST_CASE("the files in a first line are told from its words") {
  CHECK(files_named("// Header: a/b.hpp. Test: tests/a/b_test.cpp, tests/c_test.cpp.") ==
        std::vector<std::string>{"a/b.hpp", "tests/a/b_test.cpp", "tests/c_test.cpp"});
  CHECK(files_named("// Header: itself. Test: every test of this folder, tests/x/*.cpp.").empty());
}
