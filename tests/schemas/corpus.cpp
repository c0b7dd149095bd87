// Header: tests/schemas/corpus.hpp. Test: tests/schemas/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "tests/schemas/corpus.hpp"

#include "dsl/yaml/yaml_tree.hpp"
#include "tests/compiler/checks/page.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace director::tests {

namespace fs = std::filesystem;
using dsl::YamlNode;
using dsl::YamlPair;

namespace {

const fs::path source_dir = DIRECTOR_SOURCE_DIR;

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

constexpr std::array values{"~",
                            "5",
                            "-1",
                            "0",
                            "99999999999999999999",
                            "true",
                            "false",
                            "word",
                            "\"\"",
                            "\"true\"",
                            "\"5\"",
                            "[]",
                            "{}",
                            "[a, b]",
                            "{a: b}",
                            "{a: {}}",
                            "[[]]",
                            "[~]",
                            "10 ms",
                            "0 s",
                            "\" \"",
                            "A == b",
                            "3 < A",
                            "-3 == 3",
                            "\"-| == b\"",
                            "A <= 3",
                            "\"A < b|c\"",
                            "\"A = b\"",
                            "\"A == b|c\"",
                            "two words",
                            "bool", // a type of C++ itself is no enum, nor of another language
                            "string",
                            "\"const const int*\"",
                            "1.5",
                            "A.b",
                            "\"A == b within 1 s\"",
                            "9999999999 min",
                            "10000000000 min"};

bool is_plain(const YamlNode& node) {
  return !node.quoted() && node.text.find_first_of(",[]{}#:&*!|>'\"%@`") == std::string::npos;
}

std::string in_quotes(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '\n') {
      out += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

/// A place in a tree, and what stands there instead.
struct Change {
  const YamlNode* value = nullptr; ///< becomes `text`
  const YamlPair* key = nullptr;   ///< is called `text`
  const YamlPair* gone = nullptr;  ///< is left out
  std::string text;
};

std::string in_flow(const YamlNode& node, const Change& change) {
  if (&node == change.value) return change.text;
  std::string out;
  const auto comma = [&] { out += out.size() > 1 ? ", " : ""; };
  switch (node.kind) {
  case YamlNode::Kind::broken:
  case YamlNode::Kind::null: return "~";
  case YamlNode::Kind::scalar: return is_plain(node) ? node.text : in_quotes(node.text);
  case YamlNode::Kind::list:
    out = "[";
    for (const YamlNode& item : node.items) {
      comma();
      out += in_flow(item, change);
    }
    return out + "]";
  case YamlNode::Kind::mapping: break;
  }
  out = "{";
  for (const YamlPair& pair : node.pairs) {
    if (&pair == change.gone) continue;
    comma();
    out += &pair == change.key ? change.text : in_quotes(pair.key.value);
    out += ": " + in_flow(pair.value, change);
  }
  return out + "}";
}

template <class Visit>
void each_node(const YamlNode& node, const Visit& visit) {
  visit(node);
  for (const YamlNode& item : node.items) each_node(item, visit);
  for (const YamlPair& pair : node.pairs) each_node(pair.value, visit);
}

/// The two lines that blocks of pages leave out.
std::string whole(const std::string& text) {
  const bool named = text.starts_with("behaviour:") || text.find("\nbehaviour:") != std::string::npos;
  return named ? text : "behaviour: example\nlanguage: 1\n" + text;
}

bool is_scenario(const std::string& text) {
  return text.starts_with("scenario:") || text.starts_with("steps:") || text.find("\nsteps:") != std::string::npos;
}

void add_blocks(const std::string& path, const std::string& page, std::vector<CorpusFile>& out) {
  const std::string begin = "```yaml\n", end = "\n```";
  for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at)) {
    at += begin.size();
    const std::size_t stop = std::min(page.find(end, at - 1), page.size());
    const std::string text = page.substr(at, stop > at ? stop - at + 1 : 0);
    out.push_back({path + ": a block", is_scenario(text), is_scenario(text) ? text : whole(text)});
  }
}

void add_specimens(const std::string& path, const std::string& text, std::vector<CorpusFile>& out) {
  const Page page = read_page(text);
  for (const auto* list : {&page.reported, &page.accepted}) {
    for (const Specimen& specimen : *list) {
      for (const auto& [file, body] : specimen.files) {
        if (!file.ends_with(".yaml")) continue; // C++
        out.push_back(
            {path + ":" + std::to_string(specimen.line) + ": " + file, file.ends_with(".scenario.yaml"), body});
      }
    }
  }
}

std::vector<std::string> paths_below(const char* folder) {
  std::vector<std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(source_dir / folder)) {
    if (entry.is_regular_file()) out.push_back(entry.path().lexically_relative(source_dir).generic_string());
  }
  std::ranges::sort(out);
  return out;
}

/// The file with its first two keys and one other thing, for each of these: what is small is read fast.
std::vector<YamlNode> parts_of(const YamlNode& file) {
  std::vector<YamlNode> out;
  const auto add = [&](const YamlPair& pair, const YamlNode& value) {
    YamlNode part = file;
    std::erase_if(part.pairs,
                  [](const YamlPair& each) { return each.key.value != "behaviour" && each.key.value != "language"; });
    part.pairs.push_back(pair);
    part.pairs.back().value = value;
    out.push_back(std::move(part));
  };
  for (const YamlPair& pair : file.pairs) {
    if (pair.key.value == "behaviour" || pair.key.value == "language") continue;
    YamlNode empty = pair.value;
    empty.pairs.clear();
    empty.items.clear();
    for (const YamlPair& inner : pair.value.pairs) {
      YamlNode one = empty;
      one.pairs.push_back(inner);
      add(pair, one);
    }
    for (const YamlNode& inner : pair.value.items) {
      YamlNode one = empty;
      one.items.push_back(inner);
      add(pair, one);
    }
    if (pair.value.pairs.empty() && pair.value.items.empty()) add(pair, pair.value);
  }
  return out;
}

/// All keys of language, and names that stand in the two files.
std::vector<std::string> keys_of(const std::string& text) {
  std::set<std::string> keys{"unknown"};
  std::vector<dsl::Diagnostic> faults;
  const YamlNode root = dsl::read_yaml({}, text, faults);
  each_node(root, [&](const YamlNode& node) {
    for (const YamlPair& pair : node.pairs) keys.insert(pair.key.value);
  });
  return {keys.begin(), keys.end()};
}

} // namespace

std::vector<std::string> changed(const std::string& text, const std::vector<std::string>& keys) {
  std::vector<dsl::Diagnostic> faults;
  std::vector<std::string> out;
  for (const YamlNode& root : parts_of(dsl::read_yaml({}, text, faults))) {
    out.push_back(in_flow(root, {}));
    each_node(root, [&](const YamlNode& node) {
      for (const char* value : values) out.push_back(in_flow(root, {&node, nullptr, nullptr, value}));
      for (const YamlPair& pair : node.pairs) {
        out.push_back(in_flow(root, {nullptr, nullptr, &pair, ""}));
        for (const std::string& key : keys) out.push_back(in_flow(root, {nullptr, &pair, nullptr, in_quotes(key)}));
        out.push_back(in_flow(root, {nullptr, &pair, nullptr, "\"\""}));
      }
    });
  }
  std::set<std::string> seen;
  std::erase_if(out, [&](const std::string& each) { return !seen.insert(each).second; });
  return out;
}

std::vector<CorpusFile> corpus() {
  std::vector<CorpusFile> out;
  for (const char* folder : {"behaviours", "tests", "docs", "compiler/checks"}) {
    for (const std::string& path : paths_below(folder)) {
      if (path.ends_with(".yaml"))
        out.push_back({path, path.ends_with(".scenario.yaml"), read_file(source_dir / path)});
      if (!path.ends_with(".md")) continue;
      const std::string page = read_file(source_dir / path);
      if (path.starts_with("compiler/checks/")) {
        add_specimens(path, page, out);
      } else {
        add_blocks(path, page, out);
      }
    }
  }
  add_blocks("README.md", read_file(source_dir / "README.md"), out);
  for (const std::string path : {"tests/schemas/everything.yaml", "tests/schemas/everything.scenario.yaml"}) {
    const std::string text = read_file(source_dir / path);
    for (std::string& each : changed(text, keys_of(text)))
      out.push_back({path + ", changed", path.ends_with(".scenario.yaml"), std::move(each)});
  }
  return out;
}

} // namespace director::tests
