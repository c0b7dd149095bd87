// SPDX-License-Identifier: MIT
#include "tests/layout/used_names.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace director::tests;

namespace {

const ProjectFile walk{"dsl/walk.hpp",
                       {"#include <string>", "namespace director::dsl {", "struct Walk {", "  int speed() const;", "};",
                        "Walk walk_of(const std::string& name);", "}"}};

std::vector<std::string> missing(const std::string& path, std::vector<std::string> lines) {
  return missing_includes({walk, {path, std::move(lines)}});
}

} // namespace

TEST_CASE("each file of a component includes what it uses, itself or by way of others") {
  std::vector<ProjectFile> files = project_files();
  std::erase_if(files, [](const ProjectFile& file) {
    const bool cpp = file.path.ends_with(".cpp") || file.path.ends_with(".hpp");
    const bool component =
        file.path.starts_with("dsl/") || file.path.starts_with("compiler/") || file.path.starts_with("runtime/");
    return !cpp || !component;
  });
  CHECK(files.size() > 400);
  for (const std::string& fault : missing_includes(files)) FAIL_CHECK(fault);
}

TEST_CASE("a type and a function of a header that is not included are missed, each once a file") {
  CHECK(
      missing("dsl/use.cpp",
              {"namespace director::dsl {", "Walk made(Walk from) { return dsl::walk_of(from); }", "}"}) ==
      std::vector<std::string>{"dsl/use.cpp:2: Walk is declared in dsl/walk.hpp, which this file does not include",
                               "dsl/use.cpp:2: walk_of is declared in dsl/walk.hpp, which this file does not include"});
}

TEST_CASE("a name of the standard library or of fmt is missed where its header is not included by anybody") {
  CHECK(missing("dsl/use.cpp", {"#include \"dsl/walk.hpp\"", "std::string a;", "std::vector<int> b;",
                                "auto c = fmt::format(\"\");"}) ==
        std::vector<std::string>{"dsl/use.cpp:3: std::vector is declared in <vector>, which this file does not include",
                                 "dsl/use.cpp:4: fmt:: is of <fmt/format.h>, which this file does not include"});
}

TEST_CASE("what a file includes by way of others, declares itself, or only has in texts is not missed") {
  const std::vector<std::string> none;
  CHECK(missing_includes({walk,
                          {"dsl/between.hpp", {"#include \"dsl/walk.hpp\""}},
                          {"dsl/use.cpp", {"#include \"dsl/between.hpp\"", "const Walk walk = walk_of(\"\");"}}}) ==
        none);
  CHECK(missing("dsl/use.cpp", {"class Walk;", "int walk_of(int);", "int two(Walk& walk) { return walk_of(2); }"}) ==
        none);
  CHECK(missing("dsl/use.cpp",
                {"// Walk", "const char* a = \"Walk\";", "const char* b = R\"(Walk", "std::vector)\";"}) == none);
  CHECK(missing("dsl/use.cpp", {"Other::Walk a;", "int b = c.walk_of(1'000);", "int d = library::walk_of(2);"}) ==
        none);
  // Not among the allowed dependencies: it must be another one of that name.
  CHECK(missing("runtime/core/base/use.cpp", {"Walk walk;"}) == none);
}
