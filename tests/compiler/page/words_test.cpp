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

TEST_CASE("a line of a doc is an item of a list behind a dash, or behind a number that is no year") {
  using compiler::page::DocBlock;
  const auto blocks = [](const std::string& text) {
    std::string out;
    for (const DocBlock& block : compiler::page::doc_blocks(Json::object({{"doc", Json::text(text)}}))) {
      out += block.kind == DocBlock::Kind::paragraph ? "p" : block.kind == DocBlock::Kind::bullets ? "b" : "n";
      for (const std::string& item : block.items) out += "[" + item + "]";
    }
    return out;
  };
  CHECK(blocks("One.\n- two\n- three\n\n1. four\n999. five\n") == "p[One.]b[two][three]n[four][five]");
  CHECK(blocks("It was built in\n2024. It rolls.") == "p[It was built in\n2024. It rolls.]");
  CHECK(blocks("-dry\n1.5 m\n. end") == "p[-dry\n1.5 m\n. end]");
}

TEST_CASE("of two that run beside each other only what is pushed is explained") {
  const auto is_explained = [](const char* kind, Json pushes) {
    return compiler::page::needs_explanation(Json::object({{"kind", Json::text(kind)}, {"pushes", std::move(pushes)}}));
  };
  CHECK(is_explained("soft", Json{}));
  CHECK(is_explained("both", Json::list({})));
  CHECK_FALSE(is_explained("both", Json{}));
  CHECK_FALSE(is_explained("same chain", Json::list({})));
  CHECK_FALSE(is_explained("unreachable", Json{}));
}

} // namespace director::tests
