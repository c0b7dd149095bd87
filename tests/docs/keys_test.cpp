// SPDX-License-Identifier: MIT
// The reference of the language against the schemas, which have every key.
#include "compiler/reference/explain_key.hpp"
#include "dsl/yaml/yaml_tree.hpp"
#include "tests/docs/markdown.hpp"
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
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

/// The keys in a JSON value, without those of the lines of a trace.
void collect_printed(const dsl::YamlNode& node, std::set<std::string>& keys) {
  for (const dsl::YamlNode& item : node.items) collect_printed(item, keys);
  for (const dsl::YamlPair& pair : node.pairs) {
    keys.insert(pair.key.value);
    if (pair.key.value != "recorded" && pair.key.value != "replayed") collect_printed(pair.value, keys);
  }
}

/// Of a program that prints one JSON value, or one in each line.
std::set<std::string> keys_printed_by(const std::string& command) {
  const std::string text = run_command(command, source_dir()).output;
  std::vector<std::string> values{text};
  if (!text.starts_with("{\n")) {
    values.clear();
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) values.push_back(line);
  }
  std::set<std::string> keys;
  for (const std::string& value : values) {
    std::vector<dsl::Diagnostic> diagnostics;
    collect_printed(dsl::read_yaml(dsl::FileId{0}, value, diagnostics), keys);
    REQUIRE(diagnostics.empty());
  }
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

TEST_CASE("each key of the JSON that subcommands print is on the page that describes it") {
  std::set<std::string> known;
  const Markdown page = read_markdown(read_file(source_dir() / "docs/findings.md"));
  for (const Inline& code : page.code) known.insert(code.text);
  for (const char* of_a_finding : {"id", "line", "column", "end_line", "end_column", "message"})
    known.insert(of_a_finding);
  const TemporaryFolder folder;
  const std::string rover = "tests/docs/rover/rover.scenario.yaml", trace = (folder.path() / "trace.jsonl").string(),
                    other = (folder.path() / "rover.yaml").string();
  const std::pair<std::string, std::string> printed[]{
      {"directorc check --format=json --explain-reachable Drive.braking tests/docs/rover/rover.yaml", "steps"},
      {"directorc check --format=json --explain-reachable Tend.returning tests/docs/tutorial/9_shadow/gardener.yaml",
       "missing"},
      {"directorc simulate --format=json --decisions --times " + rover, "reasons"},
      {"directorc why --format=json " + rover + " Photograph --step 2", "notes"},
      {"directorc test --format=json --coverage " + rover, "compared"},
      {"directorc test --format=json tests/docs/idioms/without/outputs_never_say_done.scenario.yaml", "exhausted"},
      {"directorc simulate --trace " + trace + " " + rover +
           " >/dev/null && sed 's/Photograph: {priority: 20/Photograph: {priority: 5/' tests/docs/rover/rover.yaml >" +
           other + " && directorc replay --format=json " + trace + " --behaviour " + other,
       "difference"}};
  for (const auto& [command, expected] : printed) {
    CAPTURE(command);
    const std::set<std::string> keys = keys_printed_by(command);
    CHECK(keys.contains(expected));
    for (const std::string& key : keys)
      if (!known.contains(key)) FAIL_CHECK("no page describes `" << key << "`");
  }
}
