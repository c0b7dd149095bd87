// Header: tests/property/generate.hpp. Test: tests/property/generate_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/generate.hpp"

#include <algorithm>

namespace director::property {

namespace {

class Joining {
public:
  Joining(Random& random, BehaviourDraft& whole) : r_(random), whole_(whole), by_(whole.groups.size()) {}

  void add(BehaviourDraft part) {
    for (const StateDraft& state : part.states) states_.push_back(place_of(state));
    move(part.roots);
    whole_.roots.insert(whole_.roots.end(), part.roots.begin(), part.roots.end());
    for (const std::string& trigger : part.triggers) {
      if (std::find(whole_.triggers.begin(), whole_.triggers.end(), trigger) == whole_.triggers.end())
        whole_.triggers.push_back(trigger);
    }
    for (GroupDraft& group : part.groups) {
      group.name = "G" + std::to_string(whole_.groups.size());
      move(group);
      whole_.groups.push_back(std::move(group));
    }
  }

private:
  /// Some states are shared with an earlier part.
  std::size_t place_of(StateDraft state) {
    for (std::size_t s = 0; s < whole_.states.size() && !state.owner; ++s) {
      const StateDraft& other = whole_.states[s];
      if (other.values == state.values && other.first_unordered == state.first_unordered && !other.owner &&
          other.is_range == state.is_range && r_.chance(0.3))
        return s;
    }
    state.name = "S" + std::to_string(whole_.states.size());
    if (state.owner) *state.owner += by_;
    whole_.states.push_back(std::move(state));
    return whole_.states.size() - 1;
  }

  void move(GroupDraft& group) const {
    move(group.start_sets), move(group.stop_sets);
    for (ProviderDraft& provider : group.providers) {
      for (auto* list : {&provider.when, &provider.stay, &provider.causing, &provider.sets}) move(*list);
      for (auto* list : {&provider.needs, &provider.uses}) {
        for (std::size_t& each : *list) each += by_;
      }
      for (PackDraft& pack : provider.packs) move(pack.tasks);
    }
  }
  void move(std::vector<TaskDraft>& tasks) const {
    for (TaskDraft& each : tasks) each.target += by_;
  }
  void move(std::vector<ConditionDraft>& conditions) const {
    for (ConditionDraft& each : conditions) each.state = states_[each.state];
  }

  Random& r_;
  BehaviourDraft& whole_;
  std::size_t by_;                  ///< number of groups before this part
  std::vector<std::size_t> states_; ///< the state for each state of the part
};

} // namespace

Documents generate_parts(std::uint64_t seed) {
  Random random(seed + 40'000'000);
  const Flavour flavour = random_flavour(random);
  BehaviourDraft whole;
  for (int parts = random.between(2, 4); parts > 0; --parts) {
    const auto groups = static_cast<std::size_t>(random.between(3, 8));
    Joining(random, whole).add(random_behaviour(random, flavour, groups));
  }
  return {to_document(whole), random_scenario(random, flavour, whole)};
}

} // namespace director::property
