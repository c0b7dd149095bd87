#pragma once
// SPDX-License-Identifier: MIT
// The team's graph according to the facts and to our files, in one form, and as lines for comparison.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace director::tests {

struct Ask {
  std::string group;
  std::vector<std::int32_t> priorities; ///< one for each level; in a pack always one
  bool optional = false;
};

struct Provider {
  std::vector<std::string> when, needs, causing; ///< conditions as our language writes them
  std::vector<std::string> uses, triggers;
  std::vector<std::string> sets; ///< sorted
  std::optional<std::int64_t> every_us;
  bool flat = false; ///< any subset of the only entry of `packs`
  std::vector<std::vector<Ask>> packs;
};

struct Group {
  std::string name, layer, module;
  std::optional<std::vector<std::string>> start, stop; ///< what the handlers set
  std::vector<Provider> providers;
};

struct Module {
  std::string name;                 ///< `skill_walk`
  std::vector<std::string> externs; ///< sorted
  std::vector<Group> groups;
};

struct Role {
  std::string name; ///< `webots/robocup`
  std::vector<std::string> imports;
  std::vector<Ask> roots;
};

struct State {
  std::string name, type;
  std::vector<std::string> values, unordered;
  std::string initial; ///< empty: none
  bool external = false;
};

struct TeamGraph {
  std::vector<State> states;
  std::vector<std::string> triggers; ///< sorted
  std::vector<Module> modules;       ///< sorted by name
  std::vector<Role> roles;           ///< sorted by name
};

std::vector<std::string> lines(const State& state);
std::vector<std::string> lines(const Module& module);
std::vector<std::string> lines(const Role& role);

/// The lines to remove from `facts` (-) and to add to it (+) to get `told`, each with its neighbours of equal lines;
/// empty if they are equal.
std::string difference(const std::vector<std::string>& facts, const std::vector<std::string>& told);

} // namespace director::tests
