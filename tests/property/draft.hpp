#pragma once
// SPDX-License-Identifier: MIT
// A behaviour in construction: what the generator knows about it while it writes a scenario for it.

#include "tests/property/document.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace director::property {

struct StateDraft {
  std::string name;
  std::vector<std::string> values; ///< ascending; of a range all its numbers
  bool is_range = false;
  bool first_unordered = false;
  std::optional<std::size_t> initial;
  bool external = true;
  std::optional<int> expires;            ///< ms
  std::optional<std::size_t> expires_to; ///< a value
  std::optional<std::size_t> owner;      ///< a group
};

struct ConditionDraft {
  std::size_t state = 0;
  std::string op; ///< empty: any value (in `sets`)
  std::vector<std::size_t> values;
  std::optional<int> within; ///< ms
};

struct LevelDraft {
  std::string name; ///< empty: the only one
  int priority = 0;
  bool optional = false, apart = false;
};

struct TaskDraft {
  std::size_t target = 0;
  std::vector<LevelDraft> levels; ///< at least one
};

struct PackDraft {
  std::string name; ///< empty: flat `tasks`
  std::vector<TaskDraft> tasks;
};

struct ProviderDraft {
  std::string name; ///< `default` if the group declares it directly
  std::vector<ConditionDraft> when, stay, causing, sets;
  std::vector<std::size_t> needs;
  std::vector<PackDraft> packs; ///< one without a name, or several with names
  std::vector<std::string> triggers;
  std::optional<int> every; ///< ms
  std::vector<std::size_t> uses;
};

struct GroupDraft {
  std::string name;
  bool data = false;
  bool start = false, stop = false;
  std::vector<ConditionDraft> start_sets, stop_sets;
  std::vector<std::string> triggers; ///< of all providers
  std::vector<ProviderDraft> providers;
};

struct BehaviourDraft {
  std::vector<StateDraft> states;
  std::vector<std::string> triggers;
  std::vector<TaskDraft> roots;
  std::vector<GroupDraft> groups;
};

std::string to_text(const BehaviourDraft& draft, const ConditionDraft& condition);
Node to_document(const BehaviourDraft& draft);

} // namespace director::property
