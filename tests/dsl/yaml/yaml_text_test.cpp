// SPDX-License-Identifier: MIT
// Tests dsl/yaml/yaml_text.hpp; that every text is read back is tested in tests/dsl/reading/print_spec_test.cpp.
#include "dsl/yaml/yaml_text.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

TEST_CASE("Names, conditions, types and paths need no quotes") {
  for (const char* text : {"Walk", "_a", "-5", "Phase == ready|set", "Charge >= -1", "soccer::Phase", "../a/b.yaml",
                           "Pose == standing within 2 s", "Plays when the game is on."})
    CHECK(yaml_word(text) == text);
}

TEST_CASE("What YAML would read as something else is quoted") {
  struct Row {
    const char* text;
    const char* written;
  };
  for (const Row& row : {Row{"", "\"\""}, Row{"null", "\"null\""}, Row{"On", "\"On\""}, Row{"a: b", "\"a: b\""},
                         Row{"a:", "\"a:\""}, Row{"...", "\"...\""}, Row{"...a", "\"...a\""}, Row{"a #b", "\"a #b\""},
                         Row{" a", "\" a\""}, Row{"a ", "\"a \""}, Row{"a, b", "\"a, b\""}, Row{"- a", "\"- a\""},
                         Row{"say \"a\\b\"", "\"say \\\"a\\\\b\\\"\""}, Row{"a\n\tb\r", "\"a\\n\\tb\\r\""},
                         Row{"\x01", "\"\\x01\""}, Row{"grün", "\"grün\""}})
    CHECK(yaml_word(row.text) == row.written);
}

TEST_CASE("Lists and mappings are written in brackets") {
  CHECK(yaml_list({}) == "[]");
  CHECK(yaml_list({"a", "b"}) == "[a, b]");
  CHECK(yaml_mapping({}) == "{}");
  CHECK(yaml_mapping({"a: 1", "b: {}"}) == "{a: 1, b: {}}");
}
