// Header: tests/property/document.hpp. Test: tests/property/document_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/document.hpp"

#include <algorithm>

namespace director::property {

Node Node::list(const std::vector<std::string>& words) {
  Node out;
  out.kind = Kind::list;
  for (const std::string& word : words) out.items.emplace_back(word);
  return out;
}

Node& Node::add(std::string key, Node value) {
  keys.push_back(std::move(key));
  items.push_back(std::move(value));
  return items.back();
}

Node& Node::add(Node item) {
  items.push_back(std::move(item));
  return items.back();
}

void Node::add_some(std::string key, Node value) {
  if (!value.empty()) add(std::move(key), std::move(value));
}

Node* Node::find(const std::string& key) {
  const auto at = std::find(keys.begin(), keys.end(), key);
  return at == keys.end() ? nullptr : &items[static_cast<std::size_t>(at - keys.begin())];
}

namespace {

std::string flow(const Node& node) {
  if (node.kind == Node::Kind::word) return node.word;
  std::string out;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    if (i > 0) out += ", ";
    if (node.kind == Node::Kind::mapping) out += node.keys[i] + ": ";
    out += flow(node.items[i]);
  }
  return node.kind == Node::Kind::list ? "[" + out + "]" : "{" + out + "}";
}

constexpr std::size_t short_line = 100;

void block(const Node& node, int depth, const std::string& indent, std::string& out) {
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Node& item = node.items[i];
    const bool in_list = node.kind == Node::Kind::list;
    out += indent + (in_list ? "-" : node.keys[i] + ":");
    const std::string text = flow(item);
    if (item.kind == Node::Kind::word || item.empty() || depth <= 1 || (in_list && text.size() < short_line)) {
      out += " " + text + "\n";
    } else {
      out += "\n";
      block(item, depth - 1, indent + "  ", out);
    }
  }
}

} // namespace

std::string to_yaml(const Node& node, int block_depth) {
  std::string out;
  block(node, block_depth, "", out);
  return out;
}

} // namespace director::property
