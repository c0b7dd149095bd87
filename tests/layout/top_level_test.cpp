// SPDX-License-Identifier: MIT
// What stands at the top of the project, and that its parts say the same of the licence and the version.
#include "tests/layout/source_tree.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <sstream>

using namespace director::tests;

namespace {

/// One line, with a blank between words: what is compared of a text that is laid out in two ways.
std::string words_of(const std::string& text) {
  std::istringstream stream(text);
  std::string out;
  for (std::string word; stream >> word;)
    if (word != ".") out += (out.empty() ? "" : " ") + word;
  return out;
}

/// Behind the first place of `from`, up to that of `to`.
std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  if (begin == std::string::npos) return "there is no " + from;
  const std::size_t first = begin + from.size();
  return text.substr(first, text.find(to, first) - first);
}

std::string read(const std::string& path) { return read_file(source_dir() / path); }

} // namespace

TEST_CASE("at the top stands what a project has, and nothing else") {
  const std::set<std::string> expected{".ci",
                                       ".clang-format",
                                       ".clang-tidy",
                                       ".gitattributes",
                                       ".gitignore",
                                       ".pre-commit-hooks.yaml",
                                       "CHANGELOG.md",
                                       "CITATION.cff",
                                       "CMakeLists.txt",
                                       "CMakePresets.json",
                                       "CONTRIBUTING.md",
                                       "LICENSE",
                                       "README.md",
                                       "SECURITY.md",
                                       "behaviours",
                                       "bench",
                                       "bless",
                                       "compiler",
                                       "docs",
                                       "dsl",
                                       "generated",
                                       "runtime",
                                       "schemas",
                                       "start",
                                       "test",
                                       "tests"};
  std::set<std::string> there;
  for (const ProjectFile& file : project_files()) there.insert(file.path.substr(0, file.path.find('/')));
  there.erase(".git"); // the link of a second working tree
  there.erase("compile_commands.json");
  CHECK(there == expected);
}

TEST_CASE("the packages have the licence of the project") {
  const std::string licence = read("LICENSE");
  CHECK(licence.starts_with("MIT License\n\nCopyright (c) the Director contributors\n\n"));
  const std::string package = read("compiler/package/copyright");
  CHECK(between(package, "Files: *\n", "\n\n") == "Copyright: the Director contributors\nLicense: Expat");
  // Expat is what Debian calls this licence of MIT.
  const std::string text = words_of(package.substr(package.rfind("License: Expat\n") + 15));
  CHECK(text == words_of(licence.substr(licence.find("Permission is"))));
  CHECK(between(read("CITATION.cff"), "\nlicense: ", "\n") == "MIT");
}

TEST_CASE("the version is said once, and the same elsewhere") {
  const std::string version = between(read("CMakeLists.txt"), "project(Director VERSION ", " ");
  CHECK(between(read("CITATION.cff"), "\nversion: ", "\n") == version);
  const std::string changes = read("CHANGELOG.md");
  CHECK(between(changes, "\n## ", "\n").starts_with(version));
}
