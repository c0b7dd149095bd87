// SPDX-License-Identifier: MIT
// Tests dsl/reading/read_data.hpp.
#include "dsl/reading/read_data.hpp"
#include "dsl/yaml/yaml_tree.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

namespace {

Data read(const std::string& written) {
  std::vector<Diagnostic> diagnostics;
  const YamlNode root = read_yaml({0}, "[" + written + "]", diagnostics);
  REQUIRE(diagnostics.empty());
  return data_of(root.items.at(0));
}

} // namespace

TEST_CASE("A scalar is a boolean, a number or a text") {
  using Kind = Data::Kind;
  struct Row {
    const char* written;
    Kind kind;
    const char* text;
  };
  for (const Row& row : {Row{"true", Kind::boolean, "true"},
                         Row{"false", Kind::boolean, "false"},
                         Row{"True", Kind::text, "True"},
                         Row{"yes", Kind::text, "yes"},
                         Row{"'true'", Kind::text, "true"},
                         Row{"3", Kind::integer, "3"},
                         Row{"-3", Kind::integer, "-3"},
                         Row{"+3", Kind::integer, "3"},
                         Row{"007", Kind::integer, "7"},
                         Row{"-0", Kind::integer, "0"},
                         Row{"0x1F", Kind::integer, "31"},
                         Row{"0o17", Kind::integer, "15"},
                         Row{"0x", Kind::text, "0x"},
                         Row{"0xG", Kind::text, "0xG"},
                         Row{"\"3\"", Kind::text, "3"},
                         Row{"123456789012345678901234567890", Kind::integer, "123456789012345678901234567890"},
                         Row{"1.50", Kind::real, "1.5"},
                         Row{".5", Kind::real, "0.5"},
                         Row{"-1e3", Kind::real, "-1000.0"},
                         Row{"2.", Kind::real, "2.0"},
                         Row{"+1.5", Kind::real, "1.5"},
                         Row{"1.2.3", Kind::text, "1.2.3"},
                         Row{"e3", Kind::text, "e3"},
                         Row{".", Kind::text, "."},
                         Row{"left", Kind::text, "left"},
                         Row{"1-2", Kind::text, "1-2"},
                         Row{"++1", Kind::text, "++1"},
                         Row{"\"\"", Kind::text, ""}}) {
    CAPTURE(row.written);
    const Data data = read(row.written);
    CHECK(data.kind == row.kind);
    CHECK(data.text == row.text);
  }
}

TEST_CASE("Lists and mappings keep their order and their kinds") {
  const Data data = read("{b: [1, x, {}], a: 'y z'}");
  CHECK(to_text(data) == "{b: [1, x, {}], a: y z}");
  CHECK(data.items.at(0).items.at(0).kind == Data::Kind::integer);
}
