// SPDX-License-Identifier: MIT
#include "compiler/reference/explain_key.hpp"

#include <catch2/catch.hpp>

using namespace director::compiler;

namespace {

const char* const page = R"(# The language

Words before the sections.

## Groups

| key of a group | what it says |
| --- | --- |
| [`needs`](#needs) | what it takes; `a|b` |
| `start`, `stop` | it has a [handler](other.md#there) |
| `advance: 100 ms` | |

<!-- check
groups: {Legs: {}}
-->
```yaml
Walk: {needs: [Legs], start: true}
```

- `optional: true`: it runs if it can.
- Another entry.

## Needs

A provider runs only while it has them.

## More

Also `start: now` is said here.
)";

} // namespace

TEST_CASE("a key is explained by its row and by the section to which that leads") {
  CHECK(explain_key(page, "needs").value_or("none") ==
        "# needs\n"
        "\n"
        "- `needs`: what it takes; `a|b` (key of a group, under \"Groups\")\n"
        "\n"
        "## Needs\n"
        "\n"
        "A provider runs only while it has them.\n"
        "\n"
        "## An example\n"
        "\n"
        "```yaml\n"
        "Walk: {needs: [Legs], start: true}\n"
        "```\n");
}

TEST_CASE("a row of a table that does not say what kind of key it has is explained with the head of the table") {
  CHECK(
      explain_key("## Scripts\n\n| a case applies if | |\n| --- | --- |\n| `run: 2` | it is the second run |\n", "run")
          .value_or("none") ==
      "# run\n\n- `run: 2`: it is the second run (in the table \"a case applies if\", under \"Scripts\")\n");
}

TEST_CASE("a word that is printed with a name behind it is explained by its row") {
  CHECK(explain_key("## Expect\n\n| event | |\n| --- | --- |\n| `broken Walk.halting` | too late |\n", "broken")
            .value_or("none") ==
        "# broken\n\n- `broken Walk.halting`: too late (in the table \"event\", under \"Expect\")\n");
}

TEST_CASE("the example of the section with the row comes before texts of others that mention the key") {
  CHECK(explain_key("## States\n\n| key | what it says |\n| --- | --- |\n| `to` | the value |\n\n```yaml\n"
                    "expires: {to: lost}\n```\n\n## Assertions\n\nNothing is taken by `to`.\n\n```yaml\nsoft: "
                    "{to: Kick}\n```\n",
                    "to")
            .value_or("none") ==
        "# to\n\n- `to`: the value (key, under \"States\")\n\n## States\n\n```yaml\nexpires: {to: lost}\n```\n\n"
        "## Assertions\n\nNothing is taken by `to`.\n");
}

TEST_CASE("a key whose row leads nowhere is explained by its row and by what else mentions it") {
  CHECK(explain_key(page, "start").value_or("none") ==
        "# start\n"
        "\n"
        "- `start`, `stop`: it has a handler (key of a group, under \"Groups\")\n"
        "\n"
        "## Groups\n"
        "\n"
        "```yaml\n"
        "Walk: {needs: [Legs], start: true}\n"
        "```\n"
        "\n"
        "## More\n"
        "\n"
        "Also `start: now` is said here.\n");
  CHECK(explain_key(page, "advance").value_or("none") ==
        "# advance\n\n- `advance: 100 ms`:  (key of a group, under \"Groups\")\n");
}

TEST_CASE("the head of a table is no entry of it, and belongs to no other table") {
  const char* const tables =
      "## Groups\n\n| key of a group | what it says |\n| --- | --- |\n| `needs` | takes |\n\n## Extend\n\n"
      "| key of `extend` | what it says |\n| --- | --- |\n| `before` | where |\n";
  CHECK(explain_key(tables, "before").value_or("none") ==
        "# before\n\n- `before`: where (key of extend, under \"Extend\")\n");
  CHECK(!explain_key(tables, "extend").value_or("none").starts_with("# extend\n\n- "));
  CHECK(keys_of(tables) == std::vector<std::string>{"before", "needs"});
}

TEST_CASE("a page is printed without its links, which lead to files that its reader may not have") {
  CHECK(page_without_links("See [one](one.md) and [`two`](#two).\n```\n[a](b)\n```\n[c](d)\n") ==
        "See one and `two`.\n```\n[a](b)\n```\nc\n");
}

TEST_CASE("a key without a row is explained by what mentions it") {
  CHECK(explain_key(page, "optional").value_or("none") == "# optional\n"
                                                          "\n"
                                                          "## Groups\n"
                                                          "\n"
                                                          "- `optional: true`: it runs if it can.\n");
}

TEST_CASE("what the page does not have is not explained") {
  CHECK(!explain_key(page, "Walk"));
  CHECK(!explain_key(page, "a"));
  CHECK(!explain_key(page, ""));
  CHECK(keys_of(page) == std::vector<std::string>{"advance", "needs", "start", "stop"});
}
