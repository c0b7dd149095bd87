// SPDX-License-Identifier: MIT
#include "compiler/cli/system/page_text.hpp"
#include "tests/compiler/cli/world.hpp"

#include <catch2/catch.hpp>

using namespace director;
using namespace director::compiler::cli;
using director::tests::World;

TEST_CASE("lines are broken between words, and a word that is too long has its own line") {
  CHECK(in_lines("one two three", 8, 0, 0) == "one two\nthree");
  CHECK(in_lines("one two three", 8, 6, 2) == "one\n  two\n  three");
  CHECK(in_lines("a unbreakable b", 5, 0, 1) == "a\n unbreakable\n b");
  CHECK(in_lines("  one   two ", 80, 0, 0) == "one two");
  CHECK(in_lines("größer ist nicht breiter", 10, 0, 0) == "größer ist\nnicht\nbreiter");
  CHECK(in_lines("", 80, 0, 0).empty());
}

const std::string page = R"(# a_check
Level: error
Certainty: exact

What it is, in a sentence that
goes on, with `some code` and [a link](page.md#there).

- an item of a list that is longer than a line
- **another** one

## Reported
```yaml
roots: [A]   # a line of code that is far longer than the terminal is wide

groups: {}
```
```yaml
roots: [B]
```

| a | table |
)";

TEST_CASE("a page is printed without its marks, and its code in lines that fit the terminal") {
  CHECK(page_text(page, 30, false) == R"(a_check
Level: error
Certainty: exact

What it is, in a sentence that
goes on, with `some code` and
a link.

- an item of a list that is
  longer than a line
- another one

Reported
    roots: [A]
      # a line of code that is
      # far longer than the
      # terminal is wide

    groups: {}

    roots: [B]

| a | table |
)");
}

TEST_CASE("with colours, headings are bold and code needs no marks") {
  CHECK(page_text("# a\n\nWith `two words`, here.\n", 12, true) ==
        "\033[1ma\033[0m\n\nWith \033[36mtwo\033[0m\n\033[36mwords\033[0m, here.\n");
}

TEST_CASE("a mark without its end is text") {
  CHECK(page_text("An [open link and `open code\n", 80, false) == "An [open link and `open code\n");
}

TEST_CASE(
    "on a terminal explain shows the page, checks has its words in a column, and check says once who tells more") {
  World world;
  world.width = 72;
  REQUIRE(world.directorc({"explain", "needs_cycle"}) == 0);
  CHECK(world.out.starts_with("needs_cycle\nLevel: error\nCertainty: exact\n"));
  std::istringstream lines(world.out);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("    ")) CHECK(line.size() <= 72);
  }
  REQUIRE(world.directorc({"checks"}) == 0);
  CHECK(world.out.find("assertion_failed          error    exact\n"
                       "    A property that the author relies on does not hold.\n") != std::string::npos);
  world.files.add("a.yaml", "behaviour: a\nlanguage: 1\nroots: [B]\ngroups: {A: {}}\n");
  CHECK(world.directorc({"check", "a.yaml"}) == 1);
  CHECK(world.out.ends_with("1 error\n`directorc explain undefined_name` says more\n"));
}

TEST_CASE("what is not read on a terminal stays as it is written") {
  World world;
  REQUIRE(world.directorc({"explain", "needs_cycle"}) == 0);
  CHECK(world.out.starts_with("# needs_cycle\nLevel: error\n"));
}
