#include "compiler/model/resolve.hpp"
#include "dsl/read_behaviour.hpp"
#include "dsl/render.hpp"

#include <catch2/catch.hpp>

using namespace director;

TEST_CASE("a range that the tables cannot number is refused at the end that is too large") {
  dsl::MemoryFiles files;
  files.add("test.yaml", R"(behaviour: test
language: 1
states:
  Small: {range: [-2147483647, 2147483647], external: true}
  Large: {range: [-2147483648, 4000000000], external: true}
roots: []
)");
  dsl::Sources sources;
  const dsl::ReadResult read = dsl::read_behaviour("test.yaml", files, sources);
  REQUIRE(read.diagnostics.empty());
  std::vector<dsl::Diagnostic> errors = compiler::resolve(read.spec, sources).findings;
  std::erase_if(errors, [](const dsl::Diagnostic& finding) { return finding.level != dsl::Level::error; });
  CHECK(
      dsl::render(errors, sources) ==
      R"(test.yaml:5:19: error: `-2147483648` is too large for a state: its numbers go from -2147483647 to 2147483647 [value_outside_domain]
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
