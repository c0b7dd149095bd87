#pragma once
// SPDX-License-Identifier: MIT
// A document as a tree of mappings, lists and words, and its text as YAML. Only words that need no quotes.

#include <string>
#include <utility>
#include <vector>

namespace director::property {

struct Node {
  enum class Kind { word, list, mapping };
  Kind kind = Kind::mapping;
  std::string word;
  std::vector<std::string> keys; ///< of a mapping, one for each item
  std::vector<Node> items;

  Node() = default;
  Node(std::string text) : kind(Kind::word), word(std::move(text)) {}
  Node(const char* text) : Node(std::string(text)) {}
  static Node list(const std::vector<std::string>& words = {});

  Node& add(std::string key, Node value);
  Node& add(Node item);
  /// Adds an entry if it is not empty.
  void add_some(std::string key, Node value);
  bool empty() const { return kind != Kind::word && items.empty(); }
  Node* find(const std::string& key);
};

/// The text, in block style down to a depth, and in flow style below it.
std::string to_yaml(const Node& node, int block_depth = 4);

} // namespace director::property
