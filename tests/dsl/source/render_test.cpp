// SPDX-License-Identifier: MIT
// Tests dsl/source/render.hpp.
#include "dsl/source/render.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <utility>

using namespace director::dsl;

namespace {

struct Shown {
  Sources sources;
  FileId file;
  explicit Shown(std::string text) : file(sources.add("walk.yaml", std::move(text))) {}

  Span span(std::string_view part) const {
    const auto begin = static_cast<std::uint32_t>(sources[file].text().find(part));
    return {file, begin, static_cast<std::uint32_t>(begin + part.size())};
  }
  Diagnostic error(std::string_view part) const {
    return {"unknown_key", Level::error, span(part), "no such key", {}, ""};
  }
};

} // namespace

TEST_CASE("A finding shows its line with marks, its other parties and its help") {
  const Shown shown("groups:\n  Walk: {}\n  Walk: {needs: [Legs]}\n");
  Diagnostic finding{"duplicate_key",
                     Level::warning,
                     {shown.file, 20, 24},
                     "the key stands here twice",
                     {{shown.span("Walk"), "the first one is here"}},
                     "call one of them otherwise"};
  CHECK(render(finding, shown.sources) == R"(walk.yaml:3:2: warning: the key stands here twice [duplicate_key]
    3 |   Walk: {needs: [Legs]}
      |  ^~~~
walk.yaml:2:3: note: the first one is here
    2 |   Walk: {}
      |   ^~~~
  help: call one of them otherwise
)");
}

TEST_CASE("A place between two bytes, and one at the end of the text, have one mark") {
  const Shown shown("when: [Phase]\nx");
  Diagnostic finding = shown.error("]");
  finding.span.end = finding.span.begin;
  CHECK(render(finding, shown.sources) == R"(walk.yaml:1:13: error: no such key [unknown_key]
    1 | when: [Phase]
      |             ^
)");
  finding.span = {shown.file, 15, 15};
  CHECK(render(finding, shown.sources) == R"(walk.yaml:2:2: error: no such key [unknown_key]
    2 | x
      |  ^
)");
}

TEST_CASE("Marks are below what they mean in lines with tabs and letters of several bytes") {
  const Shown shown("\tä: \"grün\"\t# wert\n");
  CHECK(render(shown.error("\"grün\""), shown.sources) == "walk.yaml:1:6: error: no such key [unknown_key]\n"
                                                          "    1 |     ä: \"grün\"   # wert\n"
                                                          "      |        ^~~~~~\n");
  CHECK(render(shown.error("wert"), shown.sources) == "walk.yaml:1:16: error: no such key [unknown_key]\n"
                                                      "    1 |     ä: \"grün\"   # wert\n"
                                                      "      |                   ^~~~\n");
}

TEST_CASE("Marks are below what they mean behind characters of two columns, and of none") {
  const Shown wide("a: \"行動 🤖\" # here\n");
  CHECK(render(wide.error("here"), wide.sources) == "walk.yaml:1:20: error: no such key [unknown_key]\n"
                                                    "    1 | a: \"行動 🤖\" # here\n"
                                                    "      |                ^~~~\n");
  CHECK(render(wide.error("動 🤖"), wide.sources) == "walk.yaml:1:8: error: no such key [unknown_key]\n"
                                                        "    1 | a: \"行動 🤖\" # here\n"
                                                        "      |       ^~~~~\n");
  const Shown accents("e\u0301te\u0301: word\n");
  CHECK(render(accents.error("word"), accents.sources) == "walk.yaml:1:10: error: no such key [unknown_key]\n"
                                                          "    1 | e\u0301te\u0301: word\n"
                                                          "      |      ^~~~\n");
  CHECK(render(accents.error("\u0301"), accents.sources) == "walk.yaml:1:2: error: no such key [unknown_key]\n"
                                                            "    1 | e\u0301te\u0301: word\n"
                                                            "      | ^\n");
}

TEST_CASE("A line of accents without end is cut") {
  std::string accents;
  for (int i = 0; i < 10'000; ++i) accents += "\u0301";
  const Shown shown("a: b" + accents);
  RenderOptions narrow;
  narrow.width = 4;
  CHECK(render(shown.error("b"), shown.sources, narrow) == "walk.yaml:1:4: error: no such key [unknown_key]\n"
                                                           "    1 | a: …\n"
                                                           "      |    ^\n");
}

TEST_CASE("Bytes that are no UTF-8, and control characters of two bytes, do not reach the terminal") {
  const Shown shown("a: \x9B\xC2\x9B\xE8\xA1 b\n");
  CHECK(render(shown.error("b"), shown.sources) == "walk.yaml:1:10: error: no such key [unknown_key]\n"
                                                   "    1 | a: ???? b\n"
                                                   "      |         ^\n");
}

TEST_CASE("What a name holds does not reach the terminal as a command") {
  const Shown shown("roots: [\"\\e[31mred\\n\\x9B\"]\n");
  Diagnostic finding = shown.error("\"\\e[31mred\\n\\x9B\"");
  finding.message = "there is no group called `\033[31mred\n\xC2\x9B`";
  finding.help = "did you mean `\x7F`, `ä` or `\t`?";
  finding.notes.push_back({finding.span, "\rhere"});
  CHECK(render(finding, shown.sources) ==
        "walk.yaml:1:9: error: there is no group called `\\x1B[31mred\\x0A\\x9B` [unknown_key]\n"
        "    1 | roots: [\"\\e[31mred\\n\\x9B\"]\n"
        "      |         ^~~~~~~~~~~~~~~~~\n"
        "walk.yaml:1:9: note: \\x0Dhere\n"
        "  help: did you mean `\\x7F`, `ä` or `\\x09`?\n");
}

TEST_CASE("A span of several lines shows the first and the last") {
  const Shown two("a:\n  b: 1\n"), many("a:\n  b: 1\n  c: 2\n  d: 3\n");
  CHECK(render(two.error("a:\n  b: 1"), two.sources) == R"(walk.yaml:1:1: error: no such key [unknown_key]
    1 | a:
      | ^~
    2 |   b: 1
      |   ~~~~
)");
  CHECK(render(many.error("a:\n  b: 1\n  c: 2\n  d: 3"), many.sources) ==
        R"(walk.yaml:1:1: error: no such key [unknown_key]
    1 | a:
      | ^~
  ... |
    4 |   d: 3
      |   ~~~~
)");
  CHECK(render(two.error("a:\n"), two.sources) == R"(walk.yaml:1:1: error: no such key [unknown_key]
    1 | a:
      | ^~
)");
}

TEST_CASE("A long line is cut around the place") {
  const std::string word(30, 'x');
  const Shown shown("tasks: [" + word + ", here, " + word + "]\n");
  RenderOptions narrow;
  narrow.width = 24;
  CHECK(render(shown.error("here"), shown.sources, narrow) == R"(walk.yaml:1:41: error: no such key [unknown_key]
    1 | …xxxxxx, here, xxxxxxxx…
      |          ^~~~
)");
  CHECK(render(shown.error("tasks"), shown.sources, narrow) == R"(walk.yaml:1:1: error: no such key [unknown_key]
    1 | tasks: [xxxxxxxxxxxxxxx…
      | ^~~~~
)");
  const Shown umlauts("k: " + std::string("äöüäöüäöüäöüäöüäöüäöüäöüäöü") + " here");
  CHECK(render(umlauts.error("here"), umlauts.sources, narrow) == R"(walk.yaml:1:59: error: no such key [unknown_key]
    1 | …üäöü here
      |       ^~~~
)");
}

TEST_CASE("A long line of wide characters is no wider than the terminal") {
  const Shown shown("k: here, 日本語日本語日本語");
  RenderOptions narrow;
  for (const auto& [width, line] : {std::pair{27, "k: here, 日本語日本語日本語"},
                                    {26, "k: here, 日本語日本語日本…"},
                                    {25, "k: here, 日本語日本語日…"},
                                    {24, "k: here, 日本語日本語日…"}}) {
    narrow.width = static_cast<std::size_t>(width);
    CHECK(render(shown.error("here"), shown.sources, narrow) ==
          fmt::format("walk.yaml:1:4: error: no such key [unknown_key]\n    1 | {}\n      |    ^~~~\n", line));
  }
}

TEST_CASE("Control bytes do not reach the terminal") {
  const Shown shown("a: \033[31mred\n");
  CHECK(render(shown.error("\033"), shown.sources) == R"(walk.yaml:1:4: error: no such key [unknown_key]
    1 | a: ?[31mred
      |    ^
)");
}

TEST_CASE("A text that could not be read shows no line") {
  Shown shown("");
  CHECK(render({"import_not_found", Level::error, {shown.file, 0, 0}, "cannot read `walk.yaml`", {}, ""},
               shown.sources) == "walk.yaml:1:1: error: cannot read `walk.yaml` [import_not_found]\n");
}

TEST_CASE("Several findings end in their numbers") {
  const Shown shown("a: b\n");
  Diagnostic warning = shown.error("b"), lint = shown.error("b");
  warning.level = Level::warning;
  lint.level = Level::lint;
  CHECK(render(std::vector{shown.error("a"), shown.error("b"), warning, lint}, shown.sources) ==
        R"(walk.yaml:1:1: error: no such key [unknown_key]
    1 | a: b
      | ^
walk.yaml:1:4: error: no such key [unknown_key]
    1 | a: b
      |    ^
walk.yaml:1:4: warning: no such key [unknown_key]
    1 | a: b
      |    ^
walk.yaml:1:4: lint: no such key [unknown_key]
    1 | a: b
      |    ^
2 errors, 1 warning, 1 lint
)");
  CHECK(render(std::vector<Diagnostic>{}, shown.sources) == "");
}

TEST_CASE(
    "Of many findings with equal messages the last one printed has the number of the rest, and others are not hidden") {
  std::string text;
  for (int i = 0; i < 10; ++i) text += "a\n";
  const Shown shown(text);
  std::vector<Diagnostic> findings;
  for (std::uint32_t i = 0; i < 10; ++i) {
    findings.push_back({"unknown_key",
                        Level::error,
                        {shown.file, 2 * i, 2 * i + 1},
                        "no such key",
                        {{{shown.file, 0, 1}, "here"}},
                        "mend it"});
    findings.push_back(
        {"unknown_key", Level::error, {shown.file, 2 * i, 2 * i + 1}, "no key " + std::to_string(i), {}, {}});
  }
  std::string expected;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    Diagnostic finding = findings[i];
    const bool alike = i % 2 == 0;
    if (alike && i / 2 >= 8) continue;
    if (alike && i / 2 == 7) {
      finding.message = "no such key; it is the same at 2 more places";
      finding.notes.clear();
      finding.help.clear();
    }
    expected += render(finding, shown.sources);
  }
  CHECK(render(findings, shown.sources) == expected + "20 errors\n");
}

TEST_CASE("Lines that are right above are not shown again, and notes keep their order, which is that of a path") {
  Sources sources;
  const FileId walk = sources.add("walk.yaml", "Walk: {}\n"), legs = sources.add("legs.yaml", "Legs: {}\n");
  const Span here{walk, 0, 4}, leg{legs, 0, 4};
  const Diagnostic finding{"x", Level::lint, here, "the finding", {{here, "1"}, {leg, "2"}, {leg, "3"}, {here, "4"}},
                           ""};
  CHECK(render(finding, sources) == R"(walk.yaml:1:1: lint: the finding [x]
    1 | Walk: {}
      | ^~~~
walk.yaml:1:1: note: 1
legs.yaml:1:1: note: 2
    1 | Legs: {}
      | ^~~~
legs.yaml:1:1: note: 3
walk.yaml:1:1: note: 4
    1 | Walk: {}
      | ^~~~
)");
}

TEST_CASE("Colours go around the place, the level, the message and the marks") {
  const Shown shown("a: b\n");
  RenderOptions coloured;
  coloured.colours = true;
  CHECK(render(shown.error("b"), shown.sources, coloured) ==
        "\033[1mwalk.yaml:1:4:\033[0m \033[1;31merror:\033[0m \033[1mno such key [unknown_key]\033[0m\n"
        "    1 | a: b\n"
        "      |    \033[1;32m^\033[0m\n");
}
