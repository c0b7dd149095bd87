#pragma once
// SPDX-License-Identifier: MIT
// Finds how a group is brought to run, by trying its ways and values from outside.

#include "compiler/transitions/player.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace director::compiler::transitions {

class Beginnings {
public:
  /// Both must outlive this.
  Beginnings(const Model& model, const Player& player)
      : model_(model),
        player_(player),
        leaves_choice_(leaves_choice(model)) {}

  /// Declared values come before assumed ones. `why`: set by the first that fails.
  std::optional<Beginning> find(const std::vector<Way>& ways, std::string& why) const;
  /// Empty if the last group does not run then. `why`: set by the first that fails.
  std::optional<Beginning> begin(const Way& way, const Outside& outside, bool only_certain, std::string& why) const;

private:
  std::vector<std::pair<Way, Outside>> tries(const std::vector<Way>& ways, Assume assume) const;

  const Model& model_;
  const Player& player_;
  const PossibleValues possible_ = find_possible_values(model_);
  bool leaves_choice_ = false;
};

} // namespace director::compiler::transitions
