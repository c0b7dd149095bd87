// SPDX-License-Identifier: MIT
#include "compiler/base/json.hpp"

#include <catch2/catch.hpp>

#include <limits>

using director::compiler::Json;
using director::compiler::to_line;
using director::compiler::to_lines;

TEST_CASE("members come out in the order in which they were given") {
  Json json = Json::object({{"zeta", Json::number(-3)}, {"alpha", Json::boolean(true)}});
  json.add("none", Json{}).add("list", Json::list({Json::text("a"), Json::list({}), Json::object({})}));
  CHECK(to_line(json) == R"({"zeta":-3,"alpha":true,"none":null,"list":["a",[],{}]})");
}

TEST_CASE("text is escaped, and what is no UTF-8 is replaced") {
  CHECK(to_line(Json::text("say \"ä\"\n")) == R"("say \"ä\"\n")");
  CHECK(to_line(Json::text("\xff")) == "\"\xEF\xBF\xBD\"");
}

TEST_CASE("lines of JSON are indented") {
  Json list = Json::list({Json::number(1)});
  list.add(Json::object({{"a", Json::boolean(false)}}));
  CHECK(to_lines(list) == "[\n  1,\n  {\n    \"a\": false\n  }\n]\n");
}

TEST_CASE("what was written is read again") {
  const Json json = Json::object(
      {{"a", Json::list({Json::number(-3), Json{}})}, {"b", Json::text("\"ä\"")}, {"c", Json::boolean(true)}});
  CHECK(director::compiler::parse_json(to_lines(json)) == json);
  CHECK_FALSE(director::compiler::parse_json("{\"a\": }"));
  CHECK_FALSE(director::compiler::parse_json("{} {}"));
}

TEST_CASE("what nests without end is no JSON, and numbers without end are the nearest that there are") {
  using director::compiler::parse_json;
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  CHECK(parse_json(nested(500)));
  CHECK_FALSE(parse_json(nested(501)));
  std::string objects;
  for (int i = 0; i < 300'000; ++i) objects += "{\"a\":";
  CHECK_FALSE(parse_json(objects + "1" + std::string(300'000, '}')));
  CHECK(parse_json("[\"" + std::string(1000, '[') + "\\\"\", \"" + std::string(1000, '{') + "\"]"));
  CHECK(parse_json("99999999999999999999")->as_number() == std::numeric_limits<std::int64_t>::max());
  CHECK(parse_json("9223372036854775808")->as_number() == std::numeric_limits<std::int64_t>::max());
  CHECK(parse_json("-1e30")->as_number() == std::numeric_limits<std::int64_t>::min());
  CHECK(parse_json("-9223372036854775808")->as_number() == std::numeric_limits<std::int64_t>::min());
}

TEST_CASE("a list of texts") {
  const Json list = Json::texts({"a", ""});
  CHECK(to_line(list) == R"(["a",""])");
  CHECK(list.as_texts() == std::vector<std::string>{"a", ""});
  CHECK(Json::text("a").as_texts().empty());
}

TEST_CASE("what is of another kind, or is not there, is empty") {
  const Json json = *director::compiler::parse_json(R"({"a": 1.5, "b": {"c": "d"}})");
  CHECK(json["a"].as_number() == 1);
  CHECK(json["a"].as_text().empty());
  CHECK(json["b"]["c"].as_text() == "d");
  CHECK(json["x"]["y"].is_null());
  CHECK(json["b"].keys() == std::vector<std::string>{"c"});
}
