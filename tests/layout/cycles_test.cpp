// SPDX-License-Identifier: MIT
#include "tests/layout/includes.hpp"
#include "tests/layout/source_tree.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

using namespace director::tests;

namespace {

using Folders = std::map<std::string, std::set<std::string>>; // each with those whose headers its files include

std::string folder_of(const std::string& path) {
  const std::size_t end = path.rfind('/');
  return end == std::string::npos ? "" : path.substr(0, end);
}

/// What the libraries and programs consist of; a folder and one within it are two.
bool is_product(const std::string& path) {
  return path.starts_with("dsl/") || path.starts_with("compiler/") || path.starts_with("runtime/");
}

Folders folders_of(const std::vector<ProjectFile>& files) {
  Folders out;
  for (const ProjectFile& file : files) {
    if (!is_product(file.path)) continue;
    const std::string from = folder_of(file.path);
    for (const std::string& header : project_includes(file.lines))
      if (const std::string to = folder_of(header); is_product(header) && to != from) out[from].insert(to);
  }
  return out;
}

/// The folders on a cycle, or between two: what is left when those that include nothing of the others, and those that
/// none of the others includes, are taken away.
Folders cyclic(Folders folders) {
  for (bool changed = true; changed;) {
    changed = false;
    std::set<std::string> included;
    for (const auto& [folder, others] : folders) included.insert(others.begin(), others.end());
    for (auto each = folders.begin(); each != folders.end();) {
      std::erase_if(each->second, [&](const std::string& other) { return folders.count(other) == 0; });
      const bool ends = each->second.empty() || included.count(each->first) == 0;
      changed = changed || ends;
      each = ends ? folders.erase(each) : std::next(each);
    }
  }
  return folders;
}

} // namespace

TEST_CASE("no folder includes, by way of others, what includes it") {
  const Folders folders = folders_of(project_files());
  CHECK(folders.count("compiler/analysis/facts") == 1);
  CHECK(cyclic(folders) == Folders{});
}

TEST_CASE("folders that include each other are found, and those beside them are not blamed") {
  const ProjectFile up{"dsl/a/up.cpp", {"#include \"dsl/b/b.hpp\""}};
  const ProjectFile down{"dsl/b/down.cpp", {"#include \"dsl/a/a.hpp\"", "#include <map>", "#include \"dsl/c/c.hpp\""}};
  const ProjectFile beside{"dsl/beside.cpp", {"#include \"dsl/a/a.hpp\""}};
  CHECK(cyclic(folders_of({up, down, beside})) == Folders{{"dsl/a", {"dsl/b"}}, {"dsl/b", {"dsl/a"}}});
  CHECK(cyclic(folders_of({up, beside})) == Folders{});
}

TEST_CASE("a folder and one within it are two") {
  const ProjectFile outer{"runtime/outer.hpp", {"#include \"runtime/inner/inner.hpp\""}};
  const ProjectFile inner{"runtime/inner/inner.hpp", {"#include \"runtime/outer.hpp\""}};
  CHECK(cyclic(folders_of({outer, inner})).size() == 2);
}
