#pragma once
// SPDX-License-Identifier: MIT
// Enumerates every choice of a provider for each of some needs, and for their own needs, no group twice (semantics.md,
// section 1). Depth first, the nearest need first; the visitor counts the steps, since the number of choices is
// exponential.

#include "compiler/model/model.hpp"

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <vector>

namespace director::analysis {

using namespace director::compiler;

/// The callbacks of a search.
template <class Visitor>
concept ChoiceVisitor = requires(Visitor visitor, ProviderId provider) {
  { visitor.pick(provider) } -> std::same_as<bool>;        ///< false: not with those picked before
  { visitor.leave_needs(provider) } -> std::same_as<bool>; ///< its needs are not searched
  visitor.drop();                                          ///< the one that was picked last
  visitor.dead_end();                                      ///< a need has no choice: its group is held already
  { visitor.complete() } -> std::same_as<bool>;            ///< all needs are met; false: end the search
};

template <ChoiceVisitor Visitor>
class ChoiceSearch {
public:
  ChoiceSearch(const Model& model, std::int64_t steps, Visitor& visitor)
      : model_(model),
        held_(model.groups.size(), false),
        steps_(steps),
        visitor_(visitor) {}

  /// Excludes the group for all needs.
  void hold(GroupId group) { held_[group.value] = true; }

  /// False: it ran out of steps.
  bool run(const std::vector<Use<GroupId>>& needs) {
    const Agenda agenda{&needs, 0, nullptr};
    meet(&agenda);
    return steps_ >= 0;
  }
  std::int64_t steps_left() const { return std::max<std::int64_t>(steps_, 0); }

private:
  /// Needs that are not met yet: a list for each picked provider, the latest first. They are on the call stack of the
  /// search, so that backtracking costs nothing.
  struct Agenda {
    const std::vector<Use<GroupId>>* needs = nullptr;
    std::size_t next = 0;
    const Agenda* then = nullptr;
  };

  void meet(const Agenda* agenda) {
    while (agenda != nullptr && agenda->next == agenda->needs->size()) agenda = agenda->then;
    if (agenda == nullptr) {
      stopped_ = !visitor_.complete();
      return;
    }
    const GroupId group = (*agenda->needs)[agenda->next].id;
    if (held_[group.value]) return visitor_.dead_end();
    held_[group.value] = true;
    const Agenda rest{agenda->needs, agenda->next + 1, agenda->then};
    for (const ProviderId provider : model_.groups[group].providers) {
      if (stopped_ || --steps_ < 0) break;
      if (!visitor_.pick(provider)) continue;
      const Agenda below{&model_.providers[provider].needs, 0, &rest};
      meet(visitor_.leave_needs(provider) ? &rest : &below);
      visitor_.drop();
    }
    held_[group.value] = false;
  }

  const Model& model_;
  std::vector<bool> held_;
  std::int64_t steps_;
  Visitor& visitor_;
  bool stopped_ = false;
};

} // namespace director::analysis
