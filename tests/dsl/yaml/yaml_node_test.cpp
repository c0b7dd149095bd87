// SPDX-License-Identifier: MIT
// Tests dsl/yaml/yaml_node.hpp.
#include "dsl/source/source_file.hpp"
#include "dsl/yaml/yaml_node.hpp"
#include "dsl/yaml/yaml_tree.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

namespace {

struct Value {
  std::string text;
  YamlNode node;
  explicit Value(const std::string& written) : text("k: " + written + "\n") {
    std::vector<Diagnostic> diagnostics;
    const YamlNode root = read_yaml({0}, text, diagnostics);
    REQUIRE(diagnostics.empty());
    node = root.pairs.at(0).value;
  }
  std::string part(const std::string& what) const {
    const std::size_t first = node.text.find(what);
    const Span span = PlacesWithin(node, text).span(first, first + what.size());
    return text.substr(span.begin, span.end - span.begin);
  }
};

} // namespace

TEST_CASE("A part of a scalar has a place of its own") {
  CHECK(Value("ab cd").part("cd") == "cd");
  CHECK(Value("ab\n  \n cd ef").part("ef") == "ef");
  CHECK(Value("ab\n cd").part("b c") == "b\n c");
  CHECK(Value("'ab cd'").part("cd") == "cd");
  CHECK(Value("\"ab cd\"").part("cd") == "cd");
  const Value value("ab");
  CHECK(PlacesWithin(value.node, value.text).span(2, 2) == Span{{0}, 5, 5});
}

TEST_CASE("Where escapes or folding hide the place it is the whole scalar's") {
  CHECK(Value("'it''s on'").part("on") == "'it''s on'");
  CHECK(Value("\"a\\tb\"").part("b") == "\"a\\tb\"");
  CHECK(Value("|\n  ab cd").part("cd") == "|\n  ab cd");
}

TEST_CASE("The lines of a literal have their places") {
  const Value value("|\n  run Walk\n\n    # c  \n  done");
  std::vector<std::string> lines, places;
  for (const Word& line : lines_of(value.node, value.text)) {
    lines.push_back(line.value);
    places.push_back(value.text.substr(line.span.begin, line.span.end - line.span.begin));
  }
  CHECK(lines == std::vector<std::string>{"run Walk", "", "# c", "done"});
  CHECK(places == lines);
  const Value windows("|\r\n  a \r\n  b\r\n");
  CHECK(lines_of(windows.node, windows.text).at(0).value == "a");
  CHECK(lines_of(windows.node, windows.text).size() == 2);
}

TEST_CASE("Lines of other scalars have the place of the whole") {
  const Value value("\"a\\n b \"");
  const auto lines = lines_of(value.node, value.text);
  REQUIRE(lines.size() == 2);
  CHECK(lines[1].value == "b");
  CHECK(lines[1].span == value.node.span);
  CHECK(lines_of(Value("\"\"").node, "k: \"\"\n").empty());
}

TEST_CASE("A value is found by its key") {
  const Value value("{a: 1, b: 2}");
  REQUIRE(value.node.find("b"));
  CHECK(value.node.find("b")->text == "2");
  CHECK_FALSE(value.node.find("c"));
  CHECK_FALSE(Value("3").node.find("a"));
}
