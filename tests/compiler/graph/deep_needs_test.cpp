// SPDX-License-Identifier: MIT
#include "compiler/graph/deep_needs.hpp"
#include "compiler/pipeline.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace {

using namespace director;
using namespace director::compiler;

/// `count` groups, each of which needs the next one; the last one needs `last`.
std::string chain(std::size_t count, const std::string& last) {
  std::string out = "behaviour: chain\nlanguage: 1\nroots: [T1]\ngroups:\n";
  for (std::size_t i = 1; i < count; ++i) out += fmt::format("  T{}: {{needs: [T{}]}}\n", i, i + 1);
  return out + fmt::format("  T{}: {{{}}}\n", count, last);
}

std::string check_text(const std::string& text) {
  dsl::MemoryFiles files;
  files.add("main.yaml", text);
  dsl::Sources sources;
  CheckOptions options;
  const Checked checked = check("main.yaml", files, sources, options);
  return dsl::render(checked.findings, sources);
}

TEST_CASE("needs go down a thousand levels and no deeper") {
  CHECK(check_text(chain(deepest_needs + 1, "")).find("input_limit") == std::string::npos);
  CHECK(check_text(chain(deepest_needs + 2, "")) ==
        "main.yaml:5:16: error: `T1` needs more than 1000 groups, one below the other [input_limit]\n"
        "    5 |   T1: {needs: [T2]}\n"
        "      |                ^~\n"
        "  help: let groups need directly what is further down, or leave some of these groups out\n"
        "1 error\n");
}

TEST_CASE("a group may need any number of groups that need nothing") {
  std::string text = "behaviour: fan\nlanguage: 1\nroots: [All]\ngroups:\n", names;
  for (std::size_t i = 0; i < 2 * deepest_needs; ++i) {
    text += fmt::format("  T{}: {{}}\n", i);
    names += fmt::format("{}T{}", i == 0 ? "" : ", ", i);
  }
  CHECK(check_text(text + fmt::format("  All: {{needs: [{0}], tasks: [{0}]}}\n", names)).find("input_limit") ==
        std::string::npos);
}

TEST_CASE("needs that form a large cycle are as deep as it is long") {
  CHECK(check_text(chain(100'000, "needs: [T1]")) ==
        "main.yaml:5:16: error: `T1` needs more than 1000 groups, one below the other [input_limit]\n"
        "    5 |   T1: {needs: [T2]}\n"
        "      |                ^~\n"
        "  help: let groups need directly what is further down, or leave some of these groups out\n"
        "1 error\n");
}

TEST_CASE("a chain of a hundred thousand needs is refused where it becomes too deep") {
  CHECK(check_text(chain(100'000, "")) ==
        "main.yaml:99003:20: error: `T98999` needs more than 1000 groups, one below the other [input_limit]\n"
        "99003 |   T98999: {needs: [T99000]}\n"
        "      |                    ^~~~~~\n"
        "  help: let groups need directly what is further down, or leave some of these groups out\n"
        "1 error\n");
}

} // namespace
