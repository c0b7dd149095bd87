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

/// Whether the test is called like the source, `a/b.cpp`, and is neither `tests/a/b_test.cpp` nor the mirror of another
/// source, nor in tests/property, which has random tests of any folder. Helpers in tests/ have their tests beside them.
bool is_displaced(const std::string& source, const std::string& test, const std::set<std::string>& there) {
  const auto name = [](const std::string& path) { return path.substr(path.rfind('/') + 1); };
  const std::string tests = "tests/", end = "_test.cpp";
  if (source.starts_with(tests) || !test.starts_with(tests) || !test.ends_with(end) ||
      test.starts_with("tests/property/"))
    return false;
  const std::string mirrored = test.substr(tests.size(), test.size() - tests.size() - end.size()) + ".cpp";
  return name(mirrored) == name(source) && there.count(mirrored) == 0;
}

} // namespace

TEST_CASE("the header and the test that a source names in its first line are there, and the test mirrors the source") {
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
      INFO(file.path << ":1: " << named);
      CHECK(there.count(named) == 1);
      CHECK_FALSE(is_displaced(file.path, named, there));
    }
  }
}

TEST_CASE("a test that has the name of a source mirrors its place") {
  const std::set<std::string> there{"a/b.cpp", "c/b.cpp"};
  CHECK_FALSE(is_displaced("a/b.cpp", "tests/a/b_test.cpp", there));
  CHECK_FALSE(is_displaced("a/b.cpp", "tests/c/b_test.cpp", there));
  CHECK_FALSE(is_displaced("a/b.cpp", "tests/d/other_test.cpp", there));
  CHECK(is_displaced("a/b.cpp", "tests/d/b_test.cpp", there));
}

TEST_CASE("the files in a first line are told from its words") {
  CHECK(files_named("// Header: a/b.hpp. Test: tests/a/b_test.cpp, tests/c_test.cpp.") ==
        std::vector<std::string>{"a/b.hpp", "tests/a/b_test.cpp", "tests/c_test.cpp"});
  CHECK(files_named("// Header: itself. Test: every test of this folder, tests/x/*.cpp.").empty());
}
