// SPDX-License-Identifier: MIT
#include "runtime/dds/once.hpp"

#include <catch2/catch.hpp>

#include <random>
#include <set>

using director::dds::Once;
using Verdict = Once::Verdict;

TEST_CASE("a repeated request has the same answer") {
  Once once;
  CHECK(once.look(7, 1) == Once::Seen{Verdict::first, 0});
  once.note(7, 1, 2);
  CHECK(once.look(7, 1) == Once::Seen{Verdict::repeated, 2});
  CHECK(once.look(8, 1) == Once::Seen{Verdict::first, 0}); // from another asker
}

TEST_CASE("a request that was overtaken is still the first of its number") {
  Once once;
  once.note(7, 5, 0);
  CHECK(once.look(7, 4) == Once::Seen{Verdict::first, 0});
  once.note(7, 4, 1);
  CHECK(once.look(7, 4) == Once::Seen{Verdict::repeated, 1});
  CHECK(once.look(7, 5) == Once::Seen{Verdict::repeated, 0});
}

TEST_CASE("a request that is too old to be remembered is never carried out") {
  Once once;
  once.note(7, 100, 0);
  CHECK(once.look(7, 100 - Once::window).verdict == Verdict::too_old);
  CHECK(once.look(7, 101 - Once::window).verdict == Verdict::first);
}

TEST_CASE("of many askers the one with the oldest request is forgotten") {
  Once once;
  for (std::uint64_t asker = 1; asker <= Once::most_askers; ++asker) once.note(asker, 1, 0);
  once.look(1, 1);
  once.note(1000, 1, 0);
  CHECK(once.look(1, 1).verdict == Verdict::repeated);
  CHECK(once.look(2, 1).verdict == Verdict::first);
}

TEST_CASE("no request is carried out twice, in any order of numbers") {
  std::mt19937 draw(1);
  Once once;
  std::set<std::uint64_t> done;
  std::uint64_t newest = 1;
  for (int i = 0; i < 20'000; ++i) {
    const std::uint64_t jump = draw() % 4 == 0 ? draw() % 100 : draw() % 3;
    newest += jump;
    const std::uint64_t back = draw() % 80;
    const std::uint64_t number = newest > back ? newest - back : 1;
    const Once::Seen seen = once.look(1, number);
    if (seen.verdict == Verdict::first) {
      const bool anew = done.insert(number).second;
      REQUIRE(anew);
      once.note(1, number, static_cast<std::uint8_t>(number % 5));
    } else if (seen.verdict == Verdict::repeated) {
      REQUIRE(done.contains(number));
      REQUIRE(seen.answer == number % 5);
    }
  }
}
