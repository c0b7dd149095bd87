#pragma once
// SPDX-License-Identifier: MIT
// Finds the earlier providers of a group because of which one never runs: they leave it nothing where the group is
// requested.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/states/choice.hpp"

#include <cstddef>
#include <vector>

namespace director::analysis {

/// The providers before one that never runs because of them.
struct Culprits {
  std::vector<ProviderId> all;
  bool each = false;              ///< each of them is enough alone; else all together
  bool others_are_enough = false; ///< those that are not named here are enough together
};

class Shadows {
public:
  /// Limit for the rivals of which each is tried to be left out, and for those that are enough alone.
  static constexpr std::size_t most_left_out = 64;

  /// All must outlive this.
  Shadows(const Model& model, const Facts& facts, const Rivals& rivals, Budget& budget);

  /// Whether the earlier providers leave it nothing, even if the missing values that are reported were there.
  bool is_shadowed(ProviderId id) const;
  /// All that are enough alone, or else as few as are enough together.
  Culprits find_culprits(ProviderId id) const;
  /// Whether one that runs now would never run if this one were preferred to it.
  bool would_be_shadowed(ProviderId earlier, ProviderId id) const;

private:
  Region region_here(ProviderId id) const;
  Covering find_choice_here(ProviderId id, const std::vector<Rival>& rivals,
                            const IdTable<StateId, ValueSet>& values) const;
  void add_after_rivals(ProviderId id, std::vector<ProviderId>& out) const;

  const Model& model_;
  const Facts& facts_;
  const Rivals& rivals_;
  Budget& budget_;
  const IdTable<StateId, ValueSet> corrected_; ///< the values of states, with what is reported as missing
};

} // namespace director::analysis
