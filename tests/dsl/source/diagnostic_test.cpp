// SPDX-License-Identifier: MIT
// Tests dsl/source/diagnostic.hpp.
#include "dsl/source/diagnostic.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

namespace {

Diagnostic at(std::uint32_t file, std::uint32_t begin, const char* id, Level level = Level::error) {
  return {id, level, {{file}, begin, begin + 1}, "message", {}, ""};
}

} // namespace

TEST_CASE("Findings are sorted by file, place and id, and none is given twice") {
  std::vector<Diagnostic> findings{at(1, 0, "a"), at(0, 9, "b"), at(0, 9, "a"), at(0, 2, "z"), at(0, 9, "b")};
  sort_by_place(findings);
  CHECK(findings == std::vector{at(0, 2, "z"), at(0, 9, "a"), at(0, 9, "b"), at(1, 0, "a")});
}

TEST_CASE("Only errors are errors") {
  CHECK_FALSE(has_errors({}));
  CHECK_FALSE(has_errors({at(0, 0, "a", Level::warning), at(0, 0, "b", Level::lint)}));
  CHECK(has_errors({at(0, 0, "a", Level::warning), at(0, 0, "b")}));
}
