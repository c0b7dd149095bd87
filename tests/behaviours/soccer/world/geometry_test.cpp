// SPDX-License-Identifier: MIT
#include "behaviours/soccer/world/geometry.hpp"
#include "behaviours/soccer/world/random.hpp"

#include <catch2/catch.hpp>

using namespace sim;

TEST_CASE("angles wrap to one turn, half a turn being positive") {
  CHECK(wrapped(0) == 0);
  CHECK(wrapped(half_turn) == half_turn);
  CHECK(wrapped(-half_turn) == half_turn);
  CHECK(wrapped(half_turn + 1) == -half_turn + 1);
  CHECK(wrapped(5 * half_turn + 3) == -half_turn + 3);
}

TEST_CASE("sine and cosine are exact where they must be and close everywhere") {
  CHECK(sine(0) == 0);
  CHECK(sine(90 * degree) == one);
  CHECK(sine(-90 * degree) == -one);
  CHECK(sine(30 * degree) == one / 2);
  CHECK(cosine(0) == one);
  CHECK(cosine(half_turn) == -one);
  for (Angle angle = -half_turn; angle <= half_turn; angle += 7) {
    const int square = (sine(angle) * sine(angle) + cosine(angle) * cosine(angle)) / one;
    CHECK(square >= one - 40);
    CHECK(square <= one + 40);
  }
}

TEST_CASE("a length is the whole part of the root") {
  CHECK(length({3, -4}) == 5);
  CHECK(length({1, 1}) == 1);
  CHECK(length({0, 0}) == 0);
  CHECK(length({6000, 4000}) == 7211);
}

TEST_CASE("a bearing is the angle that a point was turned by") {
  CHECK(bearing({0, 0}) == 0);
  CHECK(bearing({5, 0}) == 0);
  CHECK(bearing({0, 5}) == 90 * degree);
  CHECK(bearing({-5, 0}) == half_turn);
  CHECK(bearing({5, -5}) == -45 * degree);
  for (Angle angle = -half_turn + 1; angle <= half_turn; angle += 13) {
    const Angle off = wrapped(bearing(turned({100'000, 0}, angle)) - angle);
    CHECK(off < degree / 2);
    CHECK(off > -degree / 2);
  }
}

TEST_CASE("the random numbers are those of the published generator") {
  Random random(1234567);
  CHECK(random.next() == 6457827717110365317u);
  CHECK(random.next() == 3203168211198807973u);
}

TEST_CASE("random numbers stay between their bounds and reach both") {
  Random random(1);
  bool least = false, most = false;
  for (int i = 0; i < 200; ++i) {
    const int number = random.between(-2, 2);
    REQUIRE(number >= -2);
    REQUIRE(number <= 2);
    least = least || number == -2;
    most = most || number == 2;
  }
  CHECK(least);
  CHECK(most);
  CHECK(random.between(7, 7) == 7);
}
