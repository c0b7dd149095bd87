// SPDX-License-Identifier: MIT
// The reference of the language against the schemas, which have every key.
#include "compiler/reference/explain_key.hpp"
#include "dsl/yaml/yaml_tree.hpp"
#include "tests/docs/markdown.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

using namespace director;
using namespace director::tests;

namespace {

const std::string scenarios = "docs/scenarios.md";
/// Each page of the reference, and the schema of its keys.
const std::pair<std::string, std::string> pages_of_keys[]{{"docs/language.md", "schemas/behaviour.schema.json"},
                                                          {scenarios, "schemas/scenario.schema.json"}};

/// The keys that a schema describes, at any depth. JSON is YAML too.
void collect(const dsl::YamlNode& node, std::set<std::string>& keys) {
  for (const dsl::YamlNode& item : node.items) collect(item, keys);
  for (const dsl::YamlPair& pair : node.pairs) {
    collect(pair.value, keys);
    if (pair.key.value != "properties") continue;
    for (const dsl::YamlPair& property : pair.value.pairs) keys.insert(property.key.value);
  }
}

std::set<std::string> keys_of(const std::string& schema) {
  const std::string text = read_file(source_dir() / schema);
  std::vector<dsl::Diagnostic> diagnostics;
  std::set<std::string> keys;
  collect(dsl::read_yaml(dsl::FileId{0}, text, diagnostics), keys);
  REQUIRE(diagnostics.empty());
  return keys;
}

bool shows(const std::string& text, const std::string& key) {
  for (std::size_t at = text.find(key + ":"); at != std::string::npos; at = text.find(key + ":", at + 1)) {
    const bool whole = at == 0 || (text[at - 1] != '_' && std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0);
    if (whole) return true;
  }
  return false;
}

} // namespace

TEST_CASE("the reference has an example of each key") {
  for (const auto& [file, schema] : pages_of_keys) {
    const Markdown page = read_markdown(read_file(source_dir() / file));
    std::string examples;
    for (const Block& block : page.blocks) examples += text_of(block.lines);
    if (file == scenarios) { // many of these are shown in a table
      for (const Inline& code : page.code) examples += code.text + "\n";
    }
    const std::set<std::string> keys = keys_of(schema);
    CHECK(keys.size() > 20);
    for (const std::string& key : keys)
      if (!shows(examples, key)) FAIL_CHECK(file << ": no example has the key `" << key << "`");
  }
}

TEST_CASE("each key has a row in a table of the reference, and `directorc explain` prints it") {
  CHECK(std::string(compiler::language_page()) == read_file(source_dir() / "docs/language.md"));
  CHECK(std::string(compiler::scenarios_page()) == read_file(source_dir() / scenarios));
  for (const auto& [file, schema] : pages_of_keys) {
    const std::vector<std::string> rows = compiler::keys_of(read_file(source_dir() / file));
    for (const std::string& key : keys_of(schema)) {
      if (std::find(rows.begin(), rows.end(), key) == rows.end())
        FAIL_CHECK(file << ": no table has a row for `" << key << "`");
      CHECK(compiler::explain_key(compiler::reference(), key).value_or("").starts_with("# " + key + "\n\n- `"));
    }
  }
}
