#include "compiler/emit/json.hpp"

#include <catch2/catch.hpp>

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

TEST_CASE("for people it is indented") {
  Json list = Json::list({Json::number(1)});
  list.add(Json::object({{"a", Json::boolean(false)}}));
  CHECK(to_lines(list) == "[\n  1,\n  {\n    \"a\": false\n  }\n]\n");
}
