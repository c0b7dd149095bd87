// SPDX-License-Identifier: MIT
// The known faults of yaml-cpp, one test each: how the reader handles texts that yaml-cpp misreads, or never finishes.
#include "tests/dsl/reading/reading.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;
using namespace std::string_literals;

namespace {

/// Behind `language`, in line 3.
void check_behaviour(const std::string& body, const std::string& findings) {
  CAPTURE(body);
  CHECK(read_body(body).findings() == findings);
}

void check_scenario(const std::string& body, const std::string& findings) {
  CAPTURE(body);
  CHECK(read_scenario_body(body).findings() == findings);
}

} // namespace

TEST_CASE("yaml-cpp: the document `,` is read for ever when documents are requested one after another") {
  CHECK(read_text(",").findings() ==
        "1:1 `,` yaml_syntax: text behind the end of the document (is the line indented as it should be?)\n");
}

TEST_CASE("yaml-cpp: what follows the first root is dropped") {
  check_behaviour("- a\n",
                  "3:1 `-` yaml_syntax: expected another key, or the end of this mapping (is the line indented as it "
                  "should be?)\n");
  check_behaviour("layers: {a: 1} garbage\n",
                  "3:16 `g` yaml_syntax: expected another key, or the end of this mapping (is the line indented as it "
                  "should be?)\n");
}

TEST_CASE("yaml-cpp: a word without a colon is a key without a value") {
  check_behaviour("doc: bar\nnot-a-key\n", "4:1 `not-a-key` yaml_syntax: expected `:` behind `not-a-key`\n");
  check_scenario("not-a-key\n", "2:1 `not-a-key` yaml_syntax: expected `:` behind `not-a-key`\n");
}

TEST_CASE("yaml-cpp: a quote that is never closed ends the text silently") {
  check_behaviour("doc: \"never\n", "3:6 `\"` yaml_syntax: this quote is never closed (close it with `\"`)\n");
  check_scenario("scenario: 'never\n", "2:11 `'` yaml_syntax: this quote is never closed (close it with `'`)\n");
}

TEST_CASE("yaml-cpp: a key may occur twice") {
  check_behaviour("doc: a\ndoc: b\n", "4:1 `doc` duplicate_key: the key `doc` stands here twice (leave one of them "
                                      "out, or put into one what both say)\n"
                                      "  3:1 `doc` the first one is here\n");
  check_scenario(
      "given: {A: b, A: c}\n",
      "2:15 `A` duplicate_key: the key `A` stands here twice (leave one of them out, or put into one what both say)\n"
      "  2:9 `A` the first one is here\n");
}

TEST_CASE("yaml-cpp: an alias may be part of what it refers to") {
  check_behaviour("layers: &x [*x]\n",
                  "3:9 `&x` yaml_syntax: anchors are not part of the language (write the value wherever it is needed)\n"
                  "3:13 `*x` yaml_syntax: aliases are not part of the language (write the value itself)\n");
  check_scenario("given: &x {A: *x}\n",
                 "2:8 `&x` yaml_syntax: anchors are not part of the language (write the value wherever it is needed)\n"
                 "2:15 `*x` yaml_syntax: aliases are not part of the language (write the value itself)\n");
}

TEST_CASE("yaml-cpp: an alias that doubles what is in it may make gigabytes of a line") {
  check_behaviour(
      "layers: [&a [x, x], &b [*a, *a]]\n",
      "3:10 `&a` yaml_syntax: anchors are not part of the language (write the value wherever it is needed)\n"
      "3:13 `[x, x]` wrong_node_kind: `layers`: expected the name of a layer, found a list\n"
      "3:21 `&b` yaml_syntax: anchors are not part of the language (write the value wherever it is needed)\n"
      "3:24 `[*a, *a]` wrong_node_kind: `layers`: expected the name of a layer, found a list\n"
      "3:25 `*a` yaml_syntax: aliases are not part of the language (write the value itself)\n"
      "3:29 `*a` yaml_syntax: aliases are not part of the language (write the value itself)\n");
}

TEST_CASE("yaml-cpp: invalid UTF-8 is taken as it comes") {
  check_behaviour("doc: \xC3(\n",
                  "3:6 `\xC3` yaml_syntax: the byte 0xC3 is not UTF-8 (save the file as UTF-8 without a byte order "
                  "mark)\n");
  check_scenario("scenario: \x80\n",
                 "2:11 `\x80` yaml_syntax: the byte 0x80 is not UTF-8 (save the file as UTF-8 without a byte order "
                 "mark)\n");
}

TEST_CASE("yaml-cpp: a byte order mark and a NUL are taken for text") {
  CHECK(read_text("\xEF\xBB\xBF"
                  "behaviour: b\n")
            .findings() == "1:1 `\xEF\xBB\xBF` yaml_syntax: the file begins with a byte order mark (save the file as "
                           "UTF-8 without a byte order mark)\n");
  check_behaviour("doc: a\0b\n"s, "3:7 `\0` yaml_syntax: the byte 0x00 may not stand in a text (leave it out)\n"s);
}

TEST_CASE("yaml-cpp: merge keys are keys") {
  check_behaviour("cpp: {<<: {namespace: a}}\n",
                  "3:7 `<<` yaml_syntax: merge keys are not part of the language (write the keys themselves)\n");
  check_scenario("given: {<<: {A: b}}\n",
                 "2:9 `<<` yaml_syntax: merge keys are not part of the language (write the keys themselves)\n");
}

TEST_CASE("yaml-cpp: yes, on and NO are booleans") {
  check_behaviour(
      "states:\n  A: {values: [yes, on, NO], external: yes}\n",
      "4:16 `yes` warning yaml_word_trap: older YAML tools read a bare `yes` as a boolean (write \"yes\", "
      "or choose another word)\n"
      "4:21 `on` warning yaml_word_trap: older YAML tools read a bare `on` as a boolean (write \"on\", or "
      "choose another word)\n"
      "4:25 `NO` warning yaml_word_trap: older YAML tools read a bare `NO` as a boolean (write \"NO\", or "
      "choose another word)\n"
      "4:40 `yes` wrong_node_kind: `external`: expected true or false, found `yes` (write `true`, without quotes)\n");
  check_scenario("script:\n  A: {done: on}\n",
                 "3:13 `on` wrong_node_kind: `done`: expected true, found `on` (write `true`, without quotes)\n");
}

TEST_CASE("yaml-cpp: 010 is eight, and 0x1F thirty-one") {
  check_behaviour(
      "roots: {A: {priority: 010}, B: {priority: 0x1F}, C: {priority: 1_000}}\n",
      "3:23 `010` wrong_node_kind: `priority`: expected a whole number from -2147483648 to 2147483647, found "
      "`010` (write `10`, without leading zeros: older YAML tools read those as octal)\n"
      "3:43 `0x1F` wrong_node_kind: `priority`: expected a whole number from -2147483648 to 2147483647, found "
      "`0x1F` (write `31`: a number is decimal)\n"
      "3:64 `1_000` wrong_node_kind: `priority`: expected a whole number from -2147483648 to 2147483647, "
      "found `1_000`\n");
  check_scenario("script:\n  A: {run: 010}\n",
                 "3:12 `010` wrong_node_kind: `run`: expected a whole number from 1, found `010` (write `10`, without "
                 "leading zeros: older YAML tools read those as octal)\n");
}

TEST_CASE("yaml-cpp: a number in quotes is a number") {
  check_behaviour(
      "roots: {A: {priority: '7'}}\n",
      "3:23 `'7'` wrong_node_kind: `priority`: expected a whole number from -2147483648 to 2147483647, found "
      "the text `7` (write it without quotes)\n");
  check_scenario("script:\n  A: {run: \"7\"}\n", "3:12 `\"7\"` wrong_node_kind: `run`: expected a whole number from 1, "
                                                 "found the text `7` (write it without quotes)\n");
}

TEST_CASE("yaml-cpp: a value that is not there is null") {
  check_behaviour("groups:\n  A:\n  B: ~\n",
                  "4:3 `A` wrong_node_kind: `A`: expected a mapping, found nothing (an empty one is `{}`)\n"
                  "5:6 `~` wrong_node_kind: `B`: expected a mapping, found nothing (an empty one is `{}`)\n");
  check_scenario("script:\n  A:\n",
                 "3:3 `A` wrong_node_kind: `A`: expected a case or a list of cases, found nothing (an empty one is "
                 "`[]`)\n");
}

TEST_CASE("yaml-cpp: tags are ignored") {
  check_behaviour("doc: !!int a\n", "3:6 `!!int` yaml_syntax: tags are not part of the language (leave it out)\n");
  check_scenario("scenario: !x a\n", "2:11 `!x` yaml_syntax: tags are not part of the language (leave it out)\n");
}

TEST_CASE("yaml-cpp: a tab may indent") {
  check_behaviour("layers: [\n\ta]\n", "4:1 `\t` yaml_syntax: a tab in the indentation (indent with blanks)\n");
  check_scenario("given: {\n\tA: b}\n", "3:1 `\t` yaml_syntax: a tab in the indentation (indent with blanks)\n");
}

TEST_CASE("yaml-cpp: a no-break space is no blank") {
  check_behaviour("groups:\n  A: {}\n \xC2\xA0"
                  "B: {}\n",
                  "5:2 `\xC2\xA0` yaml_syntax: a no-break space, U+00A0, in the indentation (indent with blanks)\n");
}

TEST_CASE("yaml-cpp: nesting ends the program, or an exception, at 500 levels") {
  check_behaviour("layers: " + std::string(600, '[') + "\n",
                  "3:41 `[` input_limit: nested deeper than 64 levels (the language needs ten at most: leave out what "
                  "nests the others)\n");
}

TEST_CASE("a key without its colon is reported at its place, not in the line behind it") {
  const std::string help =
      " (a key and its value are written `key: value`; a text goes on in a line of its own only with "
      "`|` or in quotes)\n";
  const std::string comma = " (if it belongs to the text before the comma, put that text in quotes)\n";
  check_behaviour("groups:\n  Walk\n    needs: [Legs]\n", "4:3 `Walk` yaml_syntax: expected `:` behind `Walk`" + help);
  check_behaviour("groups\n  Legs: {}\n", "3:1 `groups` yaml_syntax: expected `:` behind `groups`" + help);
  check_behaviour("groups:\n  Walk:\n    needs [Legs]  # both\n\n    # now\n    tasks: [Legs]\n",
                  "5:5 `needs` yaml_syntax: expected `:` behind `needs`" + help);
  check_behaviour("groups:\n  Walk:\n    needs:[Legs]\n    tasks: [Legs]\n",
                  "5:5 `needs:` yaml_syntax: expected a blank behind `needs:`" + help);
  check_behaviour("groups:\n  Walk:\n    providers:\n      - name a\n        needs: [Legs]\n",
                  "6:9 `name` yaml_syntax: expected `:` behind `name`" + help);
  check_behaviour("groups:\n  Walk: {stop: true, needs [Legs], tasks: [Legs]}\n",
                  "4:22 `needs` yaml_syntax: expected `:` behind `needs`" + help);
  check_behaviour("groups: {Legs {}}\n", "3:10 `Legs` yaml_syntax: expected `:` behind `Legs`" + help);
  check_behaviour("groups:\n  Walk:\n    providers:\n      - {name a, needs: [Legs]}\n",
                  "6:10 `name a` yaml_syntax: expected `:` behind `name a`\n"); // and no report of a missing name
  check_behaviour("groups:\n  Walk: {doc: slowly, not at all, tasks: []}\n",
                  "4:23 `not at all` yaml_syntax: expected `:` behind `not at all`" + comma);
  CHECK(read_text("behaviour b\nlanguage: 1\n").findings() ==
        "1:1 `behaviour` yaml_syntax: expected `:` behind `behaviour`" + help);
  check_behaviour(
      "groups:\n  Walk:\n    needs [Legs]\n",
      "5:5 `needs [Legs]` wrong_node_kind: `Walk`: expected a mapping, found `needs [Legs]` (if `needs` is a "
      "key, write `needs:`)\n");
}

TEST_CASE("a second colon in a line, or one in a text, is no key without its colon") {
  const std::string said =
      "yaml_syntax: a `:` that belongs to no key (is the line indented as it should be? A text with "
      "`: ` in it needs quotes)\n";
  check_behaviour("layers:\n  - a\ndoc: b: c\n", "5:7 `:` " + said);
  check_behaviour("doc: a text that\n  goes on: here\n", "4:10 `:` " + said);
}
