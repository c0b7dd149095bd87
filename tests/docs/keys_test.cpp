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

using namespace director;
using namespace director::tests;

namespace {

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
  const Markdown page = read_markdown(read_file(source_dir() / "docs/language.md"));
  std::string examples, inputs;
  for (const Block& block : page.blocks) examples += text_of(block.lines);
  for (const Inline& code : page.code) inputs += code.text + "\n";
  const std::set<std::string> keys = keys_of("schemas/behaviour.schema.json");
  CHECK(keys.size() > 30);
  for (const std::string& key : keys)
    if (!shows(examples, key)) FAIL_CHECK("docs/language.md: no example has the key `" << key << "`");
  for (const std::string& key : keys_of("schemas/scenario.schema.json")) // many of these are shown in a table
    if (!shows(examples, key) && !shows(inputs, key))
      FAIL_CHECK("docs/language.md: no example has the key `" << key << "` of scenarios");
}

TEST_CASE("each key has a row in a table of the reference, and `directorc explain` prints it") {
  const std::string page = read_file(source_dir() / "docs/language.md");
  CHECK(std::string(compiler::language_page()) == page);
  const std::vector<std::string> rows = compiler::keys_of(page);
  for (const char* schema : {"schemas/behaviour.schema.json", "schemas/scenario.schema.json"}) {
    for (const std::string& key : keys_of(schema)) {
      if (std::find(rows.begin(), rows.end(), key) == rows.end())
        FAIL_CHECK("docs/language.md: no table has a row for `" << key << "`");
      CHECK(compiler::explain_key(page, key).value_or("").starts_with("# " + key + "\n\n- `"));
    }
  }
}
