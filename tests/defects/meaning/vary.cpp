// Header: tests/defects/meaning/vary.hpp. Test: tests/defects/meaning/measure.cpp.
// SPDX-License-Identifier: MIT
#include "tests/defects/meaning/vary.hpp"

#include <algorithm>
#include <functional>

namespace director::defects {

namespace {

void shuffle(Node& node, Random& random) {
  for (std::size_t i = 0; i + 1 < node.items.size(); ++i) {
    const std::size_t other = i + random.below(node.items.size() - i);
    std::swap(node.items[i], node.items[other]);
    if (!node.keys.empty()) std::swap(node.keys[i], node.keys[other]);
  }
}

void visit(Node& node, const std::function<void(const std::string& key, Node& value)>& visitor) {
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    visitor(node.keys.empty() ? "" : node.keys[i], node.items[i]);
    visit(node.items[i], visitor);
  }
}

/// An entry of a section into that of another file.
bool move_between_files(Robot& robot, Random& random) {
  if (robot.files.size() < 2) return false;
  const std::string what = random.one_of({"groups", "groups", "states", "triggers"});
  const std::size_t from = random.below(robot.files.size()), to = random.below(robot.files.size());
  Node* const all = robot.files[from].node.find(what);
  if (from == to || all == nullptr || all->items.empty()) return false;
  const std::size_t at = random.below(all->items.size());
  const auto place = static_cast<std::ptrdiff_t>(at);
  Node moved = all->items[at];
  const std::string key = all->keys.empty() ? "" : all->keys[at];
  all->items.erase(all->items.begin() + place);
  if (!key.empty()) all->keys.erase(all->keys.begin() + place);
  Node& target = robot.section(to, what);
  if (key.empty()) {
    target.kind = Node::Kind::list;
    target.add(std::move(moved));
  } else {
    target.add(key, std::move(moved));
  }
  return true;
}

/// The states that something promises.
std::set<std::string> promised(Robot& robot) {
  std::set<std::string> out;
  for (File& file : robot.files) {
    visit(file.node, [&](const std::string& key, Node& value) {
      for (const Node& each : value.items) {
        if (key == "causing") out.insert(each.word.substr(0, each.word.find(' ')));
      }
    });
  }
  return out;
}

/// Those whose order says nothing. The order of roots says something where two are of one rank, that of conditions
/// where something may be pushed for two of them.
bool reorder(Robot& robot, Random& random) {
  const std::set<std::string> pushed_for = promised(robot);
  const auto decides = [&](const std::string& key, const Node& value) {
    return key == "when" && std::count_if(value.items.begin(), value.items.end(), [&](const Node& each) {
                              return pushed_for.count(each.word.substr(0, each.word.find(' '))) != 0;
                            }) > 1;
  };
  const std::set<std::string> free{"states",  "groups", "triggers", "cpp",     "when",       "stay",  "sets",
                                   "causing", "uses",   "extern",   "imports", "assertions", "start", "stop"};
  for (File& file : robot.files) {
    visit(file.node, [&](const std::string& key, Node& value) {
      if (free.count(key) != 0 && !decides(key, value) && random.chance(0.5)) shuffle(value, random);
    });
    Node* const groups = file.node.find("groups");
    if (groups == nullptr) continue;
    for (Node& group : groups->items) {
      if (group.kind == Node::Kind::mapping && random.chance(0.5)) shuffle(group, random);
    }
    shuffle(file.node, random);
  }
  if (Node* const roots = robot.files.front().node.find("roots")) {
    std::set<std::string> ranks;
    for (Node& each : roots->items) {
      Node* const rank = each.find("priority");
      ranks.insert(rank == nullptr ? "0" : rank->word);
    }
    if (roots->kind == Node::Kind::mapping && ranks.size() == roots->items.size()) shuffle(*roots, random);
  }
  return true;
}

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

/// `Charge > 30` as `Charge >= 31`, `Pose == a|b` as `Pose == b|a`, one condition twice.
bool say_otherwise(Robot& robot, Random& random) {
  bool any = false;
  for (File& file : robot.files) {
    visit(file.node, [&](const std::string& key, Node& value) {
      if ((key != "when" && key != "stay") || value.kind != Node::Kind::list) return;
      const std::size_t count = value.items.size();
      for (std::size_t i = 0; i < count; ++i) {
        if (random.chance(0.5)) continue;
        const std::string text = value.items[i].word;
        const std::size_t op = text.find(" > "), below = text.find(" < "), bar = text.find('|'), is = text.find(" == ");
        std::string other = text;
        if (op != std::string::npos && is_number(text.substr(op + 3)) && text.substr(op + 3).size() < 6) {
          other = text.substr(0, op) + " >= " + std::to_string(std::stol(text.substr(op + 3)) + 1);
        } else if (below != std::string::npos && is_number(text.substr(below + 3)) && text.substr(below + 3) != "0") {
          other = text.substr(0, below) + " <= " + std::to_string(std::stol(text.substr(below + 3)) - 1);
        } else if (bar != std::string::npos && is != std::string::npos &&
                   text.find('|', bar + 1) == std::string::npos) {
          other = text.substr(0, is + 4) + text.substr(bar + 1) + "|" + text.substr(is + 4, bar - is - 4);
        }
        if (other == text && random.chance(0.7)) continue;
        if (other == text) {
          value.add(text);
        } else {
          value.items[i] = Node(other);
        }
        any = true;
      }
    });
  }
  return any;
}

/// `Pose == standing` as `Pose != moving`, for a state of these two values.
bool say_by_its_opposite(Robot& robot, Random& random) {
  std::map<std::string, std::pair<std::string, std::string>> two;
  for (File& file : robot.files) {
    Node* const states = file.node.find("states");
    for (std::size_t i = 0; states != nullptr && i < states->items.size(); ++i) {
      Node* const values = states->items[i].find("values");
      // One that may be unset too is unset for neither; the checks warn of `!=` there.
      if (values != nullptr && values->items.size() == 2 && states->items[i].find("initial") != nullptr &&
          states->items[i].find("expires") == nullptr)
        two[states->keys[i]] = {values->items[0].word, values->items[1].word};
    }
  }
  bool any = false;
  for (File& file : robot.files) {
    visit(file.node, [&](const std::string& key, Node& value) {
      if (key != "when" && key != "stay") return;
      for (Node& each : value.items) {
        const std::size_t is = each.word.find(" == ");
        const auto at = is == std::string::npos ? two.end() : two.find(each.word.substr(0, is));
        if (at == two.end() || random.chance(0.5)) continue;
        const std::string held = each.word.substr(is + 4);
        if (held != at->second.first && held != at->second.second) continue;
        each = Node(at->first + " != " + (held == at->second.first ? at->second.second : at->second.first));
        any = true;
      }
    });
  }
  return any;
}

/// `tasks: [Legs]` as `tasks: {Legs: {}}`, `{priority: 0}`, `{optional: false}`.
bool spell_tasks(Robot& robot, Random& random) {
  bool any = false;
  for (File& file : robot.files) {
    visit(file.node, [&](const std::string& key, Node& value) {
      if (key != "tasks" || value.kind != Node::Kind::list || value.items.empty() || random.chance(0.5)) return;
      Node map;
      for (const Node& each : value.items) {
        Node entry;
        if (random.chance(0.5)) entry.add("priority", "0");
        if (random.chance(0.3)) entry.add("optional", "false");
        map.add(each.word, entry);
      }
      value = map;
      any = true;
    });
  }
  return any;
}

bool rename_a_file(Robot& robot, Random& random) {
  if (robot.files.size() < 2) return false;
  const std::size_t at = 1 + random.below(robot.files.size() - 1);
  const std::string was = robot.files[at].path, is = "renamed_" + was;
  robot.files[at].path = is;
  for (File& file : robot.files) {
    visit(file.node, [&](const std::string&, Node& value) {
      if (value.word == was) value.word = is;
    });
  }
  return true;
}

bool write_docs(Robot& robot, Random& random) {
  bool any = false;
  for (File& file : robot.files) {
    for (const char* const section : {"groups", "states"}) {
      Node* const all = file.node.find(section);
      if (all == nullptr) continue;
      for (Node& each : all->items) {
        if (each.kind != Node::Kind::mapping || each.find("doc") != nullptr || random.chance(0.7)) continue;
        each.add("doc", "What nobody has said so far");
        any = true;
      }
    }
  }
  return any;
}

} // namespace

void vary(Robot& robot, Random& random, Ways& ways) {
  const std::vector<std::pair<const char*, bool (*)(Robot&, Random&)>> all{
      {"moved between files", move_between_files},
      {"order that says nothing", reorder},
      {"conditions in other words", say_otherwise},
      {"a condition by its opposite", say_by_its_opposite},
      {"tasks in other words", spell_tasks},
      {"another file name", rename_a_file},
      {"docs", write_docs}};
  for (const auto& [name, way] : random.some(all, 1, 4)) {
    if (way(robot, random)) ++ways[name];
  }
  robot.block_depth = random.between(3, 7);
}

void comment(Texts& texts, Random& random, Ways& ways) {
  ++ways["comments"];
  for (auto& [path, text] : texts) {
    std::string out = random.chance(0.5) ? "# A comment\n" : "";
    for (const char c : text) {
      if (c == '\n' && random.chance(0.2)) out += " # so it is";
      out += c;
      if (c == '\n' && random.chance(0.1)) out += random.chance(0.5) ? "\n" : "# between\n";
    }
    text = out;
  }
}

} // namespace director::defects
