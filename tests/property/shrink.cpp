// Header: tests/property/shrink.hpp. Test: tests/property/shrink_test.cpp.
// SPDX-License-Identifier: MIT
//
// Documents are trees, so it needs to know little about their contents: first runs of steps are dropped (halves,
// quarters and so on, as in A. Zeller's ddmin), then names with all that mentions them, then every entry of every
// mapping and list by itself. This is repeated until a whole round removes nothing.
#include "tests/property/shrink.hpp"

#include <algorithm>

namespace director::property {

namespace {

/// Whether the text begins with the name: `G1`, `G1.p0`, `S0 == v1`.
bool mentions(const std::string& text, const std::string& name) {
  if (!text.starts_with(name)) return false;
  return text.size() == name.size() || text[name.size()] == '.' || text[name.size()] == ' ';
}

void erase(Node& node, std::size_t at) {
  node.items.erase(node.items.begin() + static_cast<std::ptrdiff_t>(at));
  if (node.kind == Node::Kind::mapping) node.keys.erase(node.keys.begin() + static_cast<std::ptrdiff_t>(at));
}

/// Removes entries, words and mappings that became empty.
void forget(Node& node, const std::string& name) {
  for (std::size_t i = node.items.size(); i-- > 0;) {
    Node& item = node.items[i];
    const bool keyed = node.kind == Node::Kind::mapping && mentions(node.keys[i], name);
    if (keyed || (item.kind == Node::Kind::word && mentions(item.word, name))) {
      erase(node, i);
      continue;
    }
    if (item.empty()) continue;
    forget(item, name);
    if (item.empty()) erase(node, i);
  }
}

class Shrinking {
public:
  Shrinking(Documents documents, const Fails& fails, int tries)
      : best_(std::move(documents)),
        fails_(fails),
        tries_(tries) {}

  Documents run() {
    for (bool smaller = true; smaller && tries_ > 0;) {
      smaller = drop_steps();
      smaller = drop_names() || smaller;
      smaller = drop_entries(&Documents::scenario) || smaller;
      smaller = drop_entries(&Documents::behaviour) || smaller;
    }
    return best_;
  }

private:
  bool take(Documents candidate) {
    if (tries_-- <= 0 || !fails_(candidate)) return false;
    best_ = std::move(candidate);
    return true;
  }

  bool drop_steps() {
    bool smaller = false;
    std::size_t length = best_.scenario.find("steps")->items.size();
    for (; length > 0; length /= 2) {
      for (std::size_t at = 0; at < best_.scenario.find("steps")->items.size();) {
        Documents candidate = best_;
        std::vector<Node>& steps = candidate.scenario.find("steps")->items;
        const std::size_t end = std::min(at + length, steps.size());
        steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(at), steps.begin() + static_cast<std::ptrdiff_t>(end));
        if (!steps.empty() && take(std::move(candidate))) {
          smaller = true;
        } else {
          at += length;
        }
      }
    }
    return smaller;
  }

  bool drop_names() {
    std::vector<std::string> names;
    for (const char* table : {"groups", "states"}) {
      if (const Node* found = best_.behaviour.find(table))
        names.insert(names.end(), found->keys.begin(), found->keys.end());
    }
    if (const Node* triggers = best_.behaviour.find("triggers")) {
      for (const Node& trigger : triggers->items) names.push_back(trigger.word);
    }
    bool smaller = false;
    for (const std::string& name : names) {
      Documents candidate = best_;
      forget(candidate.behaviour, name);
      forget(candidate.scenario, name);
      if (candidate.scenario.find("steps") == nullptr) continue;
      smaller = take(std::move(candidate)) || smaller;
    }
    return smaller;
  }

  /// The n-th node below a node, in the order of the text, from 0. Nothing behind the last.
  static Node* parent_of(Node& node, std::size_t& n, std::size_t& at) {
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      if (n-- == 0) {
        at = i;
        return &node;
      }
      if (Node* found = parent_of(node.items[i], n, at)) return found;
    }
    return nullptr;
  }

  bool drop_entries(Node Documents::*document) {
    bool smaller = false;
    for (std::size_t n = 0;;) {
      Documents candidate = best_;
      std::size_t left = n, at = 0;
      Node* parent = parent_of(candidate.*document, left, at);
      if (parent == nullptr) return smaller;
      erase(*parent, at);
      if (candidate.scenario.find("steps") != nullptr && take(std::move(candidate))) {
        smaller = true;
      } else {
        ++n;
      }
    }
  }

  Documents best_;
  const Fails& fails_;
  int tries_;
};

} // namespace

Documents shrink(Documents documents, const Fails& fails, int most_tries) {
  return Shrinking(std::move(documents), fails, most_tries).run();
}

} // namespace director::property
