#pragma once
// SPDX-License-Identifier: MIT
// The actions of the program and the bodies, in the language of scenario files: one entry of a step or of the script
// each.

#include "compiler/explore/search/search.hpp"

#include <string>
#include <utility>
#include <vector>

namespace director::compiler {

class ScenarioWords {
public:
  explicit ScenarioWords(const Ground& ground) : g_(ground), m_(ground.model) {}

  const std::string& group(Index index) const { return m_.groups[GroupId{index}].name.value; }
  std::string provider(Index index) const; ///< `Walk.default`

  std::string request(const RequestedPack& pack) const; ///< `request: Walk`
  std::string set(const Puts& puts) const;              ///< `set: {Pose: standing}`

  /// What a body or a handler sets in this action.
  const Puts& puts_of(const Action& action) const;
  /// The script's entry, and the text of its case without a guard.
  std::pair<std::string, std::vector<std::string>> effects(const Action& action) const;

private:
  /// With the level's name, unless it is the first of the entry.
  std::string request_entry(const std::vector<Task>& tasks, const RequestedLevel& request, bool keep) const;
  void answer(const Provider& row, const RequestedPack& requests, bool kept, std::vector<std::string>& words) const;

  const Ground& g_;
  const Model& m_;
};

} // namespace director::compiler
