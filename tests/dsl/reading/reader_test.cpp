// SPDX-License-Identifier: MIT
// Tests dsl/reading/reader.hpp; its messages for real files are tested beside the readers that use them.
#include "dsl/reading/reader.hpp"
#include "dsl/yaml/yaml_tree.hpp"

#include <catch2/catch.hpp>

#include <map>

using namespace director::dsl;

namespace {

/// A mapping and a reader for it.
struct Fixture {
  std::string text;
  std::vector<Diagnostic> diagnostics;
  YamlNode root;
  Reader reader;
  explicit Fixture(std::string written)
      : text(std::move(written)),
        root(read_yaml({0}, text, diagnostics)),
        reader(text, diagnostics) {}
  std::string messages() const {
    std::string out;
    for (const Diagnostic& d : diagnostics) out += d.message + "\n";
    return out;
  }
};

} // namespace

TEST_CASE("A whole number is written one way only") {
  CHECK(parse_number("0") == 0);
  CHECK(parse_number("-7") == -7);
  CHECK(parse_number("9223372036854775807") == INT64_MAX);
  CHECK(parse_number("-9223372036854775808") == INT64_MIN);
  for (const char* text :
       {"", "-", "+1", "01", "-0", "00", "1.0", "1e3", "0x1", "1_000", " 1", "1 ", "9223372036854775808"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_number(text));
  }
}

TEST_CASE("The help for a number in another spelling is how to write it") {
  for (const auto& [text, help] : std::map<std::string, std::string>{
           {"010", "write `10`, without leading zeros: older YAML tools read those as octal"},
           {"-07", "write `-7`, without leading zeros: older YAML tools read those as octal"},
           {"00", "write `0`, without leading zeros: older YAML tools read those as octal"},
           {"-0", "write `0`"},
           {"+5", "write `5`, without the plus"},
           {"0x10", "write `16`: a number is decimal"},
           {"1.5", ""},
           {"0x", ""},
           {"0x-1", ""},
           {"+", ""},
           {"0a", ""},
           {"", ""}}) {
    CAPTURE(text);
    Fixture f("{n: \"\"}");
    f.root.pairs.at(0).value.text = text;
    CHECK_FALSE(f.reader.number(f.root.find("n"), "n"));
    CHECK(f.diagnostics.at(0).help == help);
  }
  Fixture f("{n: 0x100}");
  CHECK_FALSE(f.reader.number(f.root.find("n"), "n", {0, 100}));
  CHECK(f.diagnostics.at(0).help == "");
}

TEST_CASE("What is absent or was reported before is passed over in silence") {
  Fixture f("a: 1");
  YamlNode broken;
  for (const YamlNode* node : {static_cast<const YamlNode*>(nullptr), static_cast<const YamlNode*>(&broken)}) {
    CHECK_FALSE(f.reader.is_mapping(node, "a"));
    CHECK_FALSE(f.reader.is_list(node, "a"));
    CHECK_FALSE(f.reader.word(node, "a", "a word"));
    CHECK(f.reader.words(node, "a", "a word").empty());
    CHECK_FALSE(f.reader.text(node, "a"));
    CHECK_FALSE(f.reader.flag(node, "a"));
    CHECK_FALSE(f.reader.number(node, "a"));
    CHECK_FALSE(f.reader.duration(node, "a"));
  }
  CHECK(f.messages() == "");
}

TEST_CASE("A key that is only misspelt is not missing") {
  Fixture f("{nmae: a, x: b}");
  f.reader.know_keys(f.root, "a thing", {"name", "other"});
  CHECK(f.reader.require(f.root, "name", "a thing", f.root.span, "name: a") == nullptr);
  CHECK(f.reader.require(f.root, "other", "a thing", f.root.span, "other: a") == nullptr);
  CHECK(f.messages() == "a thing has no key `nmae`\na thing has no key `x`\na thing needs `other`\n");
}

TEST_CASE("A long or folded text is quoted by its beginning") {
  Fixture f("{a: " + std::string(31, 'x') + "äöüäöüäöü, b: \"one\\ntwo\"}");
  f.reader.flag(f.root.find("a"), "a");
  f.reader.flag(f.root.find("b"), "b");
  CHECK(f.messages() == "`a`: expected true or false, found `xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxäöüä…`\n"
                        "`b`: expected true or false, found the text `one…`\n");
}

TEST_CASE("An empty key is no name") {
  Fixture f("{\"\": {}}");
  CHECK(f.reader.name(f.root.pairs.at(0)).value == "");
  CHECK(f.messages() == "a name is a word, found the text ``\n");
}
