// SPDX-License-Identifier: MIT
#include "compiler/base/for_shell.hpp"

#include <catch2/catch.hpp>

using director::compiler::for_shell;

TEST_CASE("a name of plain characters is a word of a command as it is") {
  CHECK(for_shell("runs/soccer_1.jsonl") == "runs/soccer_1.jsonl");
  CHECK(for_shell("/a.b-c,d:e=f@g+h%i") == "/a.b-c,d:e=f@g+h%i");
}

TEST_CASE("a name with anything else is quoted, and so is none") {
  CHECK(for_shell("my run.jsonl") == "'my run.jsonl'");
  CHECK(for_shell("$HOME/*.yaml") == "'$HOME/*.yaml'");
  CHECK(for_shell("it's") == R"('it'\''s')");
  CHECK(for_shell("h\u00fcgel.yaml") == "'h\u00fcgel.yaml'");
  CHECK(for_shell("") == "''");
}

TEST_CASE("a name that begins like an option is made a path") {
  CHECK(for_shell("-n.yaml") == "./-n.yaml");
  CHECK(for_shell("- n.yaml") == "'./- n.yaml'");
}
