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

TEST_CASE("a key whose row leads nowhere is explained by its row and by what else mentions it") {
  CHECK(explain_key(page, "start").value_or("none") ==
        "# start\n"
        "\n"
        "- `start`, `stop`: it has a handler (key of a group, under \"Groups\")\n"
        "\n"
        "## More\n"
        "\n"
        "Also `start: now` is said here.\n"
        "\n"
        "## An example\n"
        "\n"
        "```yaml\n"
        "Walk: {needs: [Legs], start: true}\n"
        "```\n");
  CHECK(explain_key(page, "advance").value_or("none") ==
        "# advance\n\n- `advance: 100 ms`:  (key of a group, under \"Groups\")\n");
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
