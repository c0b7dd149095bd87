// SPDX-License-Identifier: MIT
#include "tests/layout/includes.hpp"
#include "tests/layout/source_tree.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <set>

using namespace director::tests;

namespace {

bool is_cpp(const std::string& path) { return path.ends_with(".cpp") || path.ends_with(".hpp"); }

// Code that is wrong on purpose, or is written by a program in a language of its own layout.
bool is_specimen(const std::string& path) { return path.starts_with("tests/system/compile_fail/"); }

} // namespace

TEST_CASE("every include goes in the direction that the house allows") {
  for (const ProjectFile& file : project_files()) {
    if (!is_cpp(file.path) || is_specimen(file.path)) continue;
    for (const std::string& fault : include_faults(file.path, file.lines)) FAIL_CHECK(fault);
  }
  SUCCEED();
}

TEST_CASE("a library that costs the compiler much is included by one file") {
  std::map<std::string, std::set<std::string>> users;
  for (const ProjectFile& file : project_files()) {
    if (!is_cpp(file.path)) continue;
    for (const std::string& line : file.lines)
      for (const std::string library : {"yaml-cpp/", "CLI/", "boost/"})
        if (line.starts_with("#include <" + library)) users[library].insert(file.path);
  }
  for (const auto& [library, files] : users) {
    CAPTURE(library, files);
    CHECK(files.size() == 1);
  }
}

TEST_CASE("the architecture's table has each folder of the analysis, below those that it includes") {
  std::map<std::string, std::size_t> rows;
  for (const ProjectFile& file : project_files())
    for (const std::string& line : file.lines)
      if (file.path == "docs/architecture.md" && line.starts_with("| `") && line.find("` | ") != std::string::npos)
        rows.emplace(line.substr(3, line.find("` | ") - 3), rows.size());
  const std::string analysis = "compiler/analysis/";
  const auto folder = [&](const std::string& path) {
    const std::size_t end = path.find('/', analysis.size());
    return path.starts_with(analysis) && end != std::string::npos ? path.substr(analysis.size(), end - analysis.size())
                                                                  : std::string{};
  };
  for (const ProjectFile& file : project_files()) {
    const std::string own = folder(file.path);
    if (own.empty()) continue;
    CAPTURE(file.path);
    REQUIRE(rows.contains(own));
    for (const std::string& name : project_includes(file.lines)) {
      const std::string other = folder(name);
      if (!other.empty() && other != own && rows[other] >= rows[own]) FAIL_CHECK(name << " has a later row");
    }
  }
}

TEST_CASE("the include rules know the allowed dependencies of each component") {
  const auto quoted = [](std::string_view path, std::string_view name) { return include_fault(path, name, false); };
  CHECK(quoted("runtime/core/arbitration/order.cpp", "runtime/core/base/tables.hpp").empty());
  CHECK(quoted("runtime/core/arbitration/order.cpp", "runtime/core/engine/engine.hpp") ==
        "\"runtime/core/engine/engine.hpp\" is not among the allowed dependencies of runtime/core/arbitration");
  CHECK(quoted("runtime/core/engine/step.cpp", "runtime/hosted/trace.hpp") ==
        "\"runtime/hosted/trace.hpp\" is not among the allowed dependencies of runtime/core/engine");
  CHECK(quoted("runtime/hosted/trace.hpp", "runtime/dds/bridge.hpp") ==
        "\"runtime/dds/bridge.hpp\" is not among the allowed dependencies of runtime/hosted");
  CHECK(quoted("dsl/spec.cpp", "compiler/model/ids.hpp") ==
        "\"compiler/model/ids.hpp\" is not among the allowed dependencies of dsl");
  CHECK(quoted("dsl/spec.cpp", "schemas/text.hpp") ==
        "\"schemas/text.hpp\" is not among the allowed dependencies of dsl");
  CHECK(quoted("compiler/pipeline.cpp", "dsl/spec.hpp").empty());
  CHECK(quoted("compiler/pipeline.cpp", "tests/support/golden.hpp") ==
        "\"tests/support/golden.hpp\" is not among the allowed dependencies of compiler");
  CHECK(quoted("compiler/pipeline.cpp", "pipeline.hpp") ==
        "\"pipeline.hpp\" must be written from the root of the project");
  CHECK(quoted("behaviours/soccer/striker.hpp", "soccer.hpp").empty());
  CHECK(quoted("behaviours/soccer/striker.hpp", "compiler/pipeline.hpp") ==
        "\"compiler/pipeline.hpp\" is not among the allowed dependencies of behaviours");
  CHECK(quoted("tests/oracle/oracle.cpp", "compiler/lower/lower.hpp") ==
        "\"compiler/lower/lower.hpp\" is not among the allowed dependencies of tests/oracle");
  CHECK(quoted("tests/oracle/oracle.cpp", "runtime/core/step.hpp") ==
        "\"runtime/core/step.hpp\" is not among the allowed dependencies of tests/oracle");
  CHECK(quoted("tests/runtime/step_test.cpp", "runtime/core/step.hpp").empty());
  CHECK(quoted("docs/example.cpp", "runtime/core/step.hpp") ==
        "this folder is no component of the project, so it includes nothing");
}

TEST_CASE("the include rules know where each library lives") {
  const auto angled = [](std::string_view path, std::string_view name) { return include_fault(path, name, true); };
  CHECK(angled("runtime/core/step.hpp", "cstdint").empty());
  CHECK(angled("runtime/core/step.hpp", "vector") ==
        "<vector> is not among the standard headers that runtime/core may use");
  CHECK(angled("generated/soccer/soccer.hpp", "chrono").empty());
  CHECK(angled("generated/soccer/soccer.hpp", "string") ==
        "<string> is not among the standard headers that generated may use");
  CHECK(angled("dsl/yaml/yaml_tree.cpp", "yaml-cpp/eventhandler.h").empty());
  CHECK(angled("dsl/spec.cpp", "yaml-cpp/yaml.h") ==
        "<yaml-cpp/yaml.h> may be included only in dsl/yaml/yaml_tree.cpp");
  CHECK(angled("compiler/checks/needs_cycle.cpp", "boost/graph/adjacency_list.hpp") ==
        "<boost/graph/adjacency_list.hpp> may be included only in compiler/graph/");
  CHECK(angled("runtime/core/engine/step.cpp", "fmt/format.h") == "<fmt/format.h> may be included only in dsl/");
  CHECK(angled("runtime/dds/entity.hpp", "dds/dds.h").empty());
  CHECK(angled("behaviours/team/main.cpp", "dds/dds.h") == "<dds/dds.h> may be included only in runtime/dds/");
  CHECK(angled("compiler/cli/system/child.cpp", "sys/wait.h").empty());
  CHECK(angled("dsl/spec.cpp", "unistd.h") ==
        "<unistd.h> is of no library among the allowed dependencies of this component");
}

TEST_CASE("a fault names the file and the line") {
  CHECK(include_faults("dsl/spec.cpp", {"// one", "#include <vector>", "#  include \"runtime/core/ids.hpp\""}) ==
        std::vector<std::string>{
            "dsl/spec.cpp:3: \"runtime/core/ids.hpp\" is not among the allowed dependencies of dsl"});
}
