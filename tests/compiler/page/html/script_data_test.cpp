// SPDX-License-Identifier: MIT
#include "compiler/page/html/script_data.hpp"

#include <catch2/catch.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace director::tests {

using compiler::Json;
using namespace compiler::page;

TEST_CASE("the script has a limited number of decisions for two groups, and the number of the rest") {
  constexpr std::size_t count = most_decisions_of_two + 3;
  Json decisions = Json::list({}), codes = Json::list({});
  for (std::size_t i = 0; i < count; ++i) {
    decisions.add(Json::object({{"requester", Json::text("Play")},
                                {"first", Json::text("Kick")},
                                {"second", Json::text("Walk")},
                                {"goes_first", Json::text("first")},
                                {"words", Json::text(std::to_string(i))}}));
    codes.add(Json::count(2 * (count - 1 - i) + 1)); // the last one first, each turned
  }
  const Json answers = Json::list({Json::object({{"leads", Json::text("first")}, {"decisions", codes}})});
  const Json pairs = Json::list({Json::list({Json::number(0)})});
  const Json ranks =
      Json::object({{"decisions", decisions}, {"contended", Json::list({})}, {"answers", answers}, {"pairs", pairs}});
  const Json out = script_data(Json::object({{"behaviour", Json::text("test")}, {"ranks", ranks}}));

  CHECK(out.keys() == std::vector<std::string>{"behaviour", "ranks"});
  CHECK(out["ranks"].keys() == std::vector<std::string>{"decisions", "answers", "pairs"});
  CHECK(out["ranks"]["pairs"] == pairs);
  REQUIRE(out["ranks"]["decisions"].items().size() == most_decisions_of_two);
  CHECK(to_line(out["ranks"]["decisions"].items()[0]) == R"({"goes_first":"first","words":"42"})");
  const Json& answer = out["ranks"]["answers"].items()[0];
  CHECK(answer["leads"].as_text() == "first");
  CHECK(answer["more"].as_number() == 3);
  CHECK(answer["decisions"].items()[0].as_number() == 1);
  CHECK(answer["decisions"].items().back().as_number() == 2 * static_cast<std::int64_t>(most_decisions_of_two) - 1);
}

TEST_CASE("a few decisions of two groups are all listed, and data without ranks is unchanged") {
  const Json decision = Json::object({{"goes_first", Json::text("equal")}, {"words", Json::text("Play: …")}});
  const Json answers = Json::list({Json::object({{"decisions", Json::list({Json::number(0)})}})});
  const Json ranks =
      Json::object({{"decisions", Json::list({decision})}, {"answers", answers}, {"pairs", Json::list({})}});
  const Json data = Json::object({{"ranks", ranks}});
  CHECK(script_data(data) == data);
  const Json without = Json::object({{"behaviour", Json::text("test")}});
  CHECK(script_data(without) == without);
}

} // namespace director::tests
