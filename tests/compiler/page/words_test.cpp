// SPDX-License-Identifier: MIT
#include "compiler/page/words.hpp"

#include <catch2/catch.hpp>

namespace director::tests {

using compiler::Json;

TEST_CASE("of two that request the same each decision is listed once, up to a limit") {
  std::vector<Json> decisions, codes;
  for (int i = 0; i < 10; ++i) {
    decisions.push_back(Json::object({{"words", Json::text("decision " + std::to_string(i))}}));
    for (const int side : {0, 1}) codes.push_back(Json::number(2 * i + side));
  }
  const auto told = [&](std::size_t count) {
    const Json rivals =
        Json::object({{"second", Json::text("Play")},
                      {"decisions", Json::list({codes.begin(), codes.begin() + std::ptrdiff_t(count)})}});
    const Json contended = Json::object({{"group", Json::text("Legs")}, {"rivals", Json::list({rivals})}});
    const Json ranks = Json::object({{"decisions", Json::list(decisions)}, {"contended", Json::list({contended})}});
    const std::vector<compiler::page::Rivals> all = compiler::page::rivals_in(ranks);
    REQUIRE(all.size() == 1);
    std::string out = all.front().group + ": " + all.front().first + " and " + all.front().second;
    for (const std::string& decision : all.front().decisions) out += "\n" + decision;
    return out;
  };
  CHECK(told(4) == "Legs: the program and Play\ndecision 0\ndecision 1");
  CHECK(told(20) == "Legs: the program and Play\ndecision 0\ndecision 1\ndecision 2\ndecision 3\ndecision 4\n"
                    "decision 5\ndecision 6\ndecision 7\nand 2 more");
}

TEST_CASE("a legend of cells has the kinds that there are, in the order of all") {
  const auto cell = [](const char* kind) { return Json::object({{"kind", Json::text(kind)}}); };
  const auto row = [](std::vector<Json> cells) { return Json::object({{"cells", Json::list(std::move(cells))}}); };
  const Json rows = Json::list({row({cell("both"), cell("soft")}), row({cell("waits"), cell("soft")})});
  std::string signs;
  for (const compiler::page::CellKind& kind : compiler::page::cell_kinds_in(rows)) signs += kind.sign;
  CHECK(signs == "SWB");
}

} // namespace director::tests
