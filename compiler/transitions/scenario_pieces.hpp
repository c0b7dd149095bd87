#pragma once
// SPDX-License-Identifier: MIT
// Writes the scenario that shows a play, as numbers of pieces of text which scenarios share.

#include "compiler/transitions/player.hpp"

#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace director::compiler::transitions {

class ScenarioPieces {
public:
  /// `behaviour`: its file, as it is written in a scenario.
  ScenarioPieces(const Model& model, std::string behaviour) : model_(model), behaviour_(std::move(behaviour)) {}

  /// Without the bodies that did not run. `pieces`: the same for all calls; grows.
  std::vector<std::size_t> scenario_of(const Play& play, GroupId from, GroupId to, std::vector<std::string>& pieces);

private:
  std::size_t number_of(const std::string& text, std::vector<std::string>& pieces);

  const Model& model_;
  std::string behaviour_;
  std::unordered_map<std::string, std::size_t> numbers_;
};

} // namespace director::compiler::transitions
