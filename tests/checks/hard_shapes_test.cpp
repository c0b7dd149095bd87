// Many of one kind of mistake: each has its place, and what is said does not grow with the square of them.
#include "tests/compiler/support/checked.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <map>
#include <set>

namespace {

using namespace director;

/// By id, how many there are and at how many places.
std::map<std::string, std::pair<std::size_t, std::size_t>> count(const std::string& text) {
  const tests::CheckedText checked = tests::check_text(text);
  std::map<std::string, std::size_t> found;
  std::map<std::string, std::set<std::uint32_t>> places;
  for (const dsl::Diagnostic& finding : checked.checked.findings) {
    ++found[finding.id];
    places[finding.id].insert(finding.span.begin);
  }
  std::map<std::string, std::pair<std::size_t, std::size_t>> out;
  for (const auto& [id, number] : found) out[id] = {number, places[id].size()};
  return out;
}

std::string names(std::size_t from, std::size_t to) {
  std::string out;
  for (std::size_t i = from; i < to; ++i) out += fmt::format("T{}, ", i);
  return out;
}

/// So many tasks want one group.
std::string rivals(std::size_t size, const std::string& asked_for) {
  std::string out = "roots: [All]\ngroups:\n  Shared: {}\n  All: {" + asked_for + "}\n";
  for (std::size_t i = 0; i < size; ++i) out += fmt::format("  T{}: {{needs: [Shared], tasks: [Shared]}}\n", i);
  return out;
}

using Counts = std::map<std::string, std::pair<std::size_t, std::size_t>>;

TEST_CASE("of a hundred equal tasks of a list each but the first is told of, once") {
  CHECK(count(rivals(100, "tasks: [" + names(0, 100) + "]")) ==
        Counts{{"equal_priority", {99, 99}}, {"possible_pack_conflict", {99, 99}}});
}

TEST_CASE("of a hundred members of a pack that exclude each other each but the first is told of, once") {
  CHECK(count(rivals(100, "packs: {a: [" + names(0, 100) + "], b: []}")) ==
        Counts{{"equal_priority", {99, 99}}, {"pack_conflict", {99, 99}}});
}

TEST_CASE("of twenty equal tasks of a list each is told of with every other") {
  CHECK(count(rivals(20, "tasks: [" + names(0, 20) + "]")) ==
        Counts{{"equal_priority", {190, 19}}, {"possible_pack_conflict", {190, 19}}});
}

TEST_CASE("of forty groups, each needing all behind it, none is left out") {
  std::string text = "roots: [T0]\ngroups:\n";
  for (std::size_t i = 0; i < 40; ++i) text += fmt::format("  T{}: {{needs: [{}]}}\n", i, names(i + 1, 40));
  CHECK(count(text) == Counts{{"needs_conflict", {38, 38}}});
}

TEST_CASE("of three thousand names that are nowhere each is told of, and the first ones with what was meant") {
  std::string text = "roots: [T0]\ngroups:\n";
  for (std::size_t i = 0; i < 3'000; ++i) text += fmt::format("  T{0}: {{needs: [t{0}]}}\n", i);
  const tests::CheckedText checked = tests::check_text(text);
  REQUIRE(checked.checked.findings.size() == 3'000);
  CHECK(checked.checked.findings.front().help == "did you mean `T0`?");
  CHECK(checked.checked.findings.back().help ==
        "declare it under `groups`, import a file that does, or list it under `extern`");
}

TEST_CASE("more conditions of one provider than there is room for in a message are looked at all the same") {
  std::string text = "states:\n", when;
  for (std::size_t i = 0; i < 3'000; ++i) {
    text += fmt::format("  S{}: {{values: [low, high], initial: low, external: true}}\n", i);
    when += fmt::format("S{} == high, ", i);
  }
  CHECK(count(text + "roots: [T]\ngroups: {T: {when: [" + when + "]}}\n") == Counts{});
}

} // namespace
