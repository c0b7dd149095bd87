// SPDX-License-Identifier: MIT
// Tests tests/fuzz/mutate_spec.hpp and tests/fuzz/files.hpp.
#include "dsl/reading/read_behaviour.hpp"
#include "tests/fuzz/files.hpp"
#include "tests/fuzz/mutate_spec.hpp"

#include <catch2/catch.hpp>

using namespace director;

namespace {

constexpr const char* walker = R"(behaviour: walker
language: 1
imports: [legs.yaml]
states:
  Pose: {values: [moving, standing]}
roots: [Walk]
groups:
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving]}
      - {name: halting, needs: [Legs], causing: [Pose == standing]}
--- # legs.yaml
behaviour: legs
language: 1
groups:
  Legs: {}
)";

} // namespace

TEST_CASE("Files in one piece of text come apart and together again") {
  const auto files = fuzz::split("a\n--- # b.yaml\nb\n--- # \nc", "main.yaml");
  REQUIRE(files.size() == 3);
  CHECK(files[0].name == "main.yaml");
  CHECK(files[1].name == "b.yaml");
  CHECK(files[1].text == "b\n");
  CHECK(fuzz::join(files) == "a\n--- # b.yaml\nb\n--- # \nc");
}

TEST_CASE("A behaviour that was changed at random can still be read, and not always the same is changed") {
  property::Random random(1);
  std::string text = walker;
  std::size_t readable = 0, different = 0;
  constexpr std::size_t rounds = 300;
  for (std::size_t i = 0; i < rounds; ++i) {
    const std::string next = fuzz::mutate_files(i % 20 == 0 ? walker : text, "main.yaml", random);
    REQUIRE_FALSE(next.empty());
    dsl::MemoryFiles files = fuzz::in_memory(fuzz::split(next, "main.yaml"));
    dsl::Sources sources;
    if (!dsl::has_errors(dsl::read_behaviour("main.yaml", files, sources).diagnostics)) ++readable;
    if (next != text) ++different;
    text = fuzz::mutate_files(next, "main.yaml", random).empty() ? walker : next;
  }
  CHECK(readable > rounds * 9 / 10);
  CHECK(different > rounds * 9 / 10);
}

TEST_CASE("What cannot be read is left to others") {
  property::Random random(1);
  CHECK(fuzz::mutate_files("behaviour: [", "main.yaml", random).empty());
  CHECK(fuzz::cross_files(walker, "behaviour: [", "main.yaml", random).empty());
  CHECK_FALSE(fuzz::cross_files(walker, walker, "main.yaml", random).empty());
}
