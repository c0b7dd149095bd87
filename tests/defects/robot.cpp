// Header: tests/defects/robot.hpp. Test: tests/defects/measure.cpp.
// SPDX-License-Identifier: MIT
#include "tests/defects/robot.hpp"

#include <algorithm>
#include <stdexcept>

namespace director::defects {

namespace {

const std::vector<std::string> verbs{
    "Sweep",  "Turn", "Reach", "Point", "Scan",  "Patrol", "Carry", "Lift",  "Follow", "Inspect", "Greet", "Show",
    "Signal", "Seek", "Align", "Hold",  "Wave",  "Mow",    "Dig",   "Rinse", "Prune",  "Polish",  "Load",  "Sort",
    "Guide",  "Warn", "Lean",  "Nod",   "Track", "Press",  "Strew", "Weigh", "Paint",  "Wipe",    "Climb", "Measure"};
const std::vector<std::string> nouns{"Wheels", "Arm",   "Gripper", "Neck", "Lamp",  "Speaker", "Camera", "Radio",
                                     "Winch",  "Brush", "Pump",    "Mast", "Tail",  "Torso",   "Legs",   "Tracks",
                                     "Screen", "Drum",  "Hopper",  "Fan",  "Blade", "Nozzle",  "Rotor",  "Crane"};

std::string lower(std::string text) {
  text.front() = static_cast<char>(text.front() | 0x20);
  return text;
}

/// Sections without anything are left out.
Node without_empty(const Node& file) {
  Node out;
  for (std::size_t i = 0; i < file.items.size(); ++i) {
    if (!file.items[i].empty() || file.keys[i] == "groups") out.add(file.keys[i], file.items[i]);
  }
  return out;
}

/// Takes the signs away, and says where they stood.
void take_marks(const std::string& path, std::string& text, std::vector<Mark>& marks) {
  std::string out;
  std::size_t line = 1;
  for (const char c : text) {
    if (c == '@') {
      marks.push_back({path, line});
    } else {
      out += c;
      line += c == '\n';
    }
  }
  text = out;
}

} // namespace

Node& Robot::section(std::size_t file, const std::string& key) {
  Node& node = files.at(file).node;
  if (Node* found = node.find(key)) return *found;
  return node.add(key, {});
}

Node* Robot::find(const std::string& section, const std::string& name) {
  for (File& file : files) {
    Node* all = file.node.find(section);
    if (all == nullptr) continue;
    for (std::size_t i = 0; i < all->keys.size(); ++i) {
      if (all->keys[i] == name || all->keys[i] == "@" + name) return &all->items[i];
    }
  }
  return nullptr;
}

Node& Robot::group(const std::string& name) {
  if (Node* found = find("groups", name)) return *found;
  throw std::logic_error("no group " + name);
}

Node& Robot::state(const std::string& name) {
  if (Node* found = find("states", name)) return *found;
  throw std::logic_error("no state " + name);
}

Node& Robot::add_group(const std::string& name, std::string_view text, const std::vector<std::string>& words) {
  return section(r.below(files.size()), "groups").add(name, flow(text, words));
}

Node& Robot::add_state(const std::string& name, std::string_view text, const std::vector<std::string>& words) {
  return section(r.below(files.size()), "states").add(name, flow(text, words));
}

void Robot::add_root(const std::string& name, int priority) {
  Node& roots = section(0, "roots"); // two near misses may make a root of one skill
  if (roots.find(name) == nullptr) roots.add(name, flow("{priority: $0}", {std::to_string(priority)}));
}

std::vector<Node*> Robot::providers(const std::string& name) {
  Node& found = group(name);
  std::vector<Node*> out;
  if (Node* list = found.find("providers")) {
    for (Node& each : list->items) out.push_back(&each);
  } else {
    out.push_back(&found);
  }
  return out;
}

Node& Robot::add_pack(const std::string& planner, const std::string& name) {
  return group(planner).find("packs")->add(name, {});
}

std::string Robot::name(const std::string& stem) {
  std::string out = stem;
  for (int i = 2; std::find(used_.begin(), used_.end(), lower(out)) != used_.end(); ++i) out = stem + std::to_string(i);
  used_.push_back(lower(out));
  return out;
}

std::string Robot::verb() { return name(r.one_of(verbs)); }
std::string Robot::noun() { return name(r.one_of(nouns)); }

const Sense& Robot::sense(SenseKind kind) {
  std::vector<const Sense*> all;
  for (const Sense& each : senses) {
    if (each.kind == kind) all.push_back(&each);
  }
  return *r.one_of(all);
}

std::size_t Robot::whole_part() {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (whole[i]) all.push_back(i);
  }
  return r.one_of(all);
}

std::size_t Robot::skilled_part() {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (skills[i].size() > 1) all.push_back(i);
  }
  return r.one_of(all);
}

std::string Robot::add_part() {
  std::string out = noun();
  add_group(out, r.chance(0.5) ? "{}" : "{data: robot::Setpoint, realtime: true}");
  return out;
}

std::string Robot::add_skill(const std::string& on) {
  std::string out = verb();
  Node& added = add_group(out, "{needs: [$0], tasks: [$0]}", {on});
  if (r.chance(0.3)) added.add("uses", flow("[$0]", {on}));
  if (r.chance(0.3)) added.add("start", "true");
  if (r.chance(0.3)) added.add("stop", "true");
  if (r.chance(0.2)) added.add("every", "20 ms");
  if (r.chance(0.2)) added.add("data", "robot::Command");
  return out;
}

Texts Robot::render(std::vector<Mark>& marks) const {
  Texts texts;
  for (const File& file : files) texts[file.path] = to_yaml(without_empty(file.node), block_depth);
  for (const auto& edit : edits) edit(texts);
  for (auto& [path, text] : texts) take_marks(path, text, marks);
  return texts;
}

std::string condition(Random& random, const Sense& sense) {
  if (sense.kind == SenseKind::number) {
    const std::string number = std::to_string(random.between(1, 9) * 10);
    return sense.name + random.one_of({" < ", " > ", " >= ", " <= "}) + number;
  }
  const std::size_t first = sense.kind == SenseKind::sentinel ? 1 : 0;
  const std::size_t at = first + 1 + random.below(sense.values.size() - first - 1);
  if (sense.kind == SenseKind::sentinel && random.chance(0.6)) return sense.name + " >= " + sense.values[at];
  if (sense.kind == SenseKind::plain && random.chance(0.3)) {
    return sense.name + random.one_of({" < ", " >= ", " != "}) + sense.values[at];
  }
  if (random.chance(0.3) && sense.values.size() > 2)
    return sense.name + " == " + sense.values[0] + "|" + sense.values[at];
  return sense.name + " == " + sense.values[at];
}

} // namespace director::defects
