// SPDX-License-Identifier: MIT
// Tests dsl/reading/read_behaviour.hpp and dsl/source/load_file.hpp.
#include "dsl/reading/read_behaviour.hpp"
#include "dsl/source/load_file.hpp"
#include "tests/dsl/reading/reading.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace director::dsl;

namespace {

struct Files {
  MemoryFiles access;
  Sources sources;
  ReadResult result;

  void add(const std::string& path, const std::string& imports) {
    access.add(path, "behaviour: b\nlanguage: 1\nimports: " + imports + "\n");
  }
  void read(const std::string& path) { result = read_behaviour(path, access, sources); }
  std::string findings() const { return findings_text(result.diagnostics, sources); }
  /// Paths in order of declaration.
  std::string order() const {
    std::string out;
    for (const BehaviourSpec& file : result.spec.files) out += (out.empty() ? "" : " ") + sources[file.file].path();
    return out;
  }
};

} // namespace

TEST_CASE("What is imported is declared before what imports it, each file once") {
  Files files;
  files.add("play/main.yaml", "[a.yaml, sub/b.yaml]");
  files.add("play/a.yaml", "[../common.yaml]");
  files.add("play/sub/b.yaml", "[../a.yaml, ../../common.yaml]");
  files.add("common.yaml", "[]");
  files.read("play/main.yaml");
  CHECK(files.findings() == "");
  CHECK(files.order() == "common.yaml play/a.yaml play/sub/b.yaml play/main.yaml");
  CHECK(files.sources.size() == 4);
  CHECK(files.sources[FileId{0}].path() == "play/main.yaml");
  const auto& imports = files.result.spec.files.back().imports;
  REQUIRE(imports.size() == 2);
  CHECK(imports[0].path.value == "a.yaml");
  REQUIRE(imports[1].file);
  CHECK(files.sources[*imports[1].file].path() == "play/sub/b.yaml");
}

TEST_CASE("Files that import each other are shown as a cycle") {
  Files files;
  files.add("main.yaml", "[a.yaml]");
  files.add("a.yaml", "[b.yaml]");
  files.add("b.yaml", "[./a.yaml]");
  files.read("main.yaml");
  CHECK(files.findings() == "b.yaml:3:11 `./a.yaml` import_cycle: `a.yaml` imports `b.yaml` imports `a.yaml` "
                            "(move what both need into a file that imports neither of them)\n"
                            "  a.yaml:3:11 `b.yaml` `a.yaml` imports `b.yaml`\n");
  Files narcissus;
  narcissus.add("main.yaml", "[main.yaml]");
  narcissus.read("main.yaml");
  CHECK(narcissus.findings() ==
        "3:11 `main.yaml` import_cycle: `main.yaml` imports `main.yaml` (leave this import out)\n");
}

TEST_CASE("An import that cannot be read is found where it is written, and the others are read") {
  Files files;
  files.add("play/main.yaml", "[lost.yaml, a.yaml]");
  files.add("play/a.yaml", "[]");
  files.read("play/main.yaml");
  CHECK(files.findings() ==
        "3:11 `lost.yaml` import_not_found: cannot read `play/lost.yaml`: No such file or directory "
        "(a path is relative to the file that it stands in)\n");
  CHECK(files.order() == "play/a.yaml play/main.yaml");
  CHECK(files.result.readable);
}

TEST_CASE("The mistakes of all files are found in one run") {
  Files files;
  files.add("main.yaml", "[a.yaml, b.yaml]\nstate: {}");
  files.access.add("a.yaml", "behaviour: a\nlanguage: 1\ngroups: [\n");
  files.access.add("b.yaml", "behaviour: b\nlanguage: 3\n");
  files.read("main.yaml");
  CHECK(files.findings() ==
        "4:1 `state` unknown_key: a behaviour file has no key `state` (did you mean `states`?)\n"
        "a.yaml:3:10 `` yaml_syntax: expected `,` or `]` here (close what is opened there, or put the text in quotes)\n"
        "  a.yaml:3:9 `[` opened here\n"
        "b.yaml:2:11 `3` language_version: this compiler reads language 1, found 3 (use the compiler that the file was "
        "written for)\n");
}

TEST_CASE("A file that cannot be read at all is the only finding") {
  Files files;
  files.read("lost.yaml");
  CHECK(files.findings() == "1:1 `` import_not_found: cannot read `lost.yaml`: No such file or directory (a path is "
                            "relative to the folder in which the program runs)\n");
  CHECK_FALSE(files.result.readable);
  CHECK(files.result.spec.files.empty());
}

TEST_CASE("A file above the limit is refused unread") {
  Files files;
  files.access.add("large.yaml", std::string(largest_file + 1, ' '));
  files.add("main.yaml", "[large.yaml]");
  files.read("main.yaml");
  CHECK(files.findings() == "3:11 `large.yaml` input_limit: `large.yaml` is larger than 64 MiB (divide it into files "
                            "that import one another)\n");
}

TEST_CASE("imports of imports have a limit") {
  Files files;
  for (std::size_t i = 0; i <= deepest_import; ++i)
    files.add(fmt::format("{}.yaml", i), fmt::format("[{}.yaml]", i + 1));
  files.read("0.yaml");
  CHECK(files.findings() ==
        fmt::format("{0}.yaml:3:11 `{1}.yaml` input_limit: more than 200 files import one another in a chain "
                    "(import it from a file nearer to the main one)\n",
                    deepest_import - 1, deepest_import));
}
