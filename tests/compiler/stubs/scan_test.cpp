// SPDX-License-Identifier: MIT
// Requests to director-clang, as JSON, and the parsing of its answers, also of invalid ones.
#include "compiler/stubs/scan.hpp"

#include <catch2/catch.hpp>

using namespace director::compiler;
using namespace director::compiler::stubs;

TEST_CASE("a question names the generated header, the files with their flags, and what is not on the disk yet") {
  const DeclarationsRequest request{
      {"b.hpp", "// b"},
      {"b.facts.hpp", "// facts"},
      {"b::Legs"},
      {{"/p/legs.cpp", "/p", {"-std=c++20", "-DX=\"y\""}, false}, {"/p/l.hpp", "/p", {}, true}},
      {{"/p/legs.cpp", 3, "\nx"}},
      {{"/p/new.cpp", "// new"}}};
  CHECK(
      to_line(to_json(request)) ==
      R"({"header":{"path":"b.hpp","text":"// b"},"facts":{"path":"b.facts.hpp","text":"// facts"},"interfaces":["b::Legs"],"units":[)"
      R"({"path":"/p/legs.cpp","directory":"/p","flags":["-std=c++20","-DX=\"y\""],"only_unseen":false},)"
      R"({"path":"/p/l.hpp","directory":"/p","flags":[],"only_unseen":true}],)"
      R"("insertions":[{"path":"/p/legs.cpp","offset":3,"text":"\nx"}],)"
      R"("fresh":[{"path":"/p/new.cpp","text":"// new"}]})");
}

TEST_CASE("an answer has classes, functions and problems with their places") {
  const auto answer = parse_json(R"({
    "classes": [{"path": "/p/l.hpp", "line": 4, "column": 7, "name": "my::Legs", "interfaces": ["b::Legs"],
                 "bases": [{"path": "/p/b.hpp", "line": 3, "column": 8}], "end": 90, "inside": 12, "public": true, "macro": true, "only_inline": true,
                 "given": ["provide b::Run::Default"], "hides": true}],
    "functions": [{"path": "/p/l.cpp", "line": 2, "column": 15, "class": "my::Legs", "name": "provide",
                   "context": "b::Walk::Default", "begin": 20, "end": 60, "inside": -1, "known": false, "within": true,
                   "defines": true, "overrides": true, "macro": true, "inline": true, "result": "Outcome",
                   "qualifier": "Legs::", "pure": true, "class_at": {"path": "/p/l.hpp", "line": 4, "column": 7}}],
    "problems": [{"path": "/p/l.cpp", "line": 9, "column": 1, "message": "expected ';'"}]})");
  REQUIRE(answer);
  const Found expected{{{"my::Legs",
                         {"b::Legs"},
                         {{"/p/b.hpp", 3, 8}},
                         {"/p/l.hpp", 4, 7},
                         90,
                         12,
                         true,
                         true,
                         true,
                         {"provide b::Run::Default"},
                         true}},
                       {{"my::Legs",
                         "provide",
                         "b::Walk::Default",
                         {"/p/l.cpp", 2, 15},
                         20,
                         60,
                         unconditional,
                         false,
                         true,
                         true,
                         true,
                         true,
                         true,
                         "Outcome",
                         "Legs::",
                         false,
                         true,
                         {"/p/l.hpp", 4, 7}}},
                       {{{"/p/l.cpp", 9, 1}, "expected ';'"}}};
  CHECK(found_in(*answer) == expected);
}

TEST_CASE("an answer without what was requested contains nothing") {
  CHECK(found_in(Json::object({})) == Found{});
  CHECK(found_in(Json()) == Found{});
  CHECK(replacements_in(Json::object({{"files", Json::text("none")}})).empty());
}

TEST_CASE("a formatter is given whole texts of new files, and of others only what was put into them") {
  CHECK(to_line(to_json(
            std::vector<FormatRequest>{{"/p/new.cpp", "int  a;", {}}, {"/p/old.cpp", "", {{"/p/old.cpp", 5, "b"}}}})) ==
        R"({"files":[{"path":"/p/new.cpp","text":"int  a;"},)"
        R"({"path":"/p/old.cpp","insertions":[{"path":"/p/old.cpp","offset":5,"text":"b"}]}]})");
  const auto answer = parse_json(R"({"files": [[{"offset": 3, "length": 2, "text": " "}], []]})");
  REQUIRE(answer);
  const auto all = replacements_in(*answer);
  REQUIRE(all.size() == 2);
  REQUIRE(all[0].size() == 1);
  CHECK(all[0][0].offset == 3);
  CHECK(all[0][0].length == 2);
  CHECK(all[0][0].text == " ");
  CHECK(all[1].empty());
}
