// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/resolve.hpp"
#include "dsl/reading/read_behaviour.hpp"
#include "dsl/source/render.hpp"

#include <catch2/catch.hpp>

using namespace director;

namespace {

/// `text` follows the two lines that every file has.
compiler::Resolved resolved(const std::string& text, dsl::Sources& sources) {
  dsl::MemoryFiles files;
  files.add("test.yaml", "behaviour: test\nlanguage: 1\n" + text);
  const dsl::ReadResult read = dsl::read_behaviour("test.yaml", files, sources);
  REQUIRE(read.diagnostics.empty());
  return compiler::resolve(read.spec, sources);
}

} // namespace

TEST_CASE("a range that the tables cannot number is refused at the end that is too low or too large") {
  dsl::Sources sources;
  std::vector<dsl::Diagnostic> errors = resolved(R"(states:
  Small: {range: [-2147483647, 2147483647], external: true}
  Large: {range: [-2147483648, 4000000000], external: true}
roots: []
)",
                                                 sources)
                                            .findings;
  std::erase_if(errors, [](const dsl::Diagnostic& finding) { return finding.level != dsl::Level::error; });
  CHECK(
      dsl::render(errors, sources) ==
      R"(test.yaml:5:19: error: `-2147483648` is too low for a state: its numbers go from -2147483647 to 2147483647 [value_outside_domain]
    5 |   Large: {range: [-2147483648, 4000000000], external: true}
      |                   ^~~~~~~~~~~
  help: count in larger steps
test.yaml:5:32: error: `4000000000` is too large for a state: its numbers go from -2147483647 to 2147483647 [value_outside_domain]
    5 |   Large: {range: [-2147483648, 4000000000], external: true}
      |                                ^~~~~~~~~~
  help: count in larger steps
2 errors
)");
}

TEST_CASE("a comparison with one of four thousand million values looks at the ends alone") {
  dsl::Sources sources;
  const compiler::Resolved wide = resolved(R"(states:
  Wide: {range: [-2147483647, 2147483647], external: true}
roots: [Walk]
groups:
  Walk: {when: [Wide > -2147483647, Wide != 0|3, Wide <= 2147483646]}
)",
                                           sources);
  CHECK(wide.findings.empty());
  REQUIRE(wide.model.conditions.size() == 3);
  CHECK(wide.model.conditions[compiler::ConditionId{0}].accepts.count() == 4294967294);
  CHECK(wide.model.conditions[compiler::ConditionId{1}].accepts.intervals() ==
        std::vector<compiler::ValueSet::Interval>{{-2147483647, -1}, {1, 2}, {4, 2147483647}});
}
