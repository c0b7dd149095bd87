#pragma once
// SPDX-License-Identifier: MIT
// A Ground as text, for tests.

#include "compiler/explore/environment/ground.hpp"

#include <string>

namespace director::tests {

/// `A B:2|A|` and so on: the packs of a provider, each edge with its target's name, levels counted from 0.
inline std::string packs(const compiler::Ground& ground, std::size_t provider) {
  std::string out;
  for (const compiler::RequestedPack& pack : ground.bodies[provider].packs) {
    for (const compiler::RequestedLevel& request : pack) {
      const Edge& edge = ground.tables.edges[request.edge];
      out += ground.model.groups[compiler::GroupId{edge.target}].name.value;
      if (request.level != edge.levels.begin) out += ":" + std::to_string(request.level - edge.levels.begin);
      out += ' ';
    }
    out += '|';
  }
  return out;
}

inline std::string puts(const compiler::Ground& ground, const std::vector<compiler::Puts>& all) {
  std::string out;
  for (const compiler::Puts& each : all) {
    for (const compiler::Put& put : each) {
      const compiler::State& state = ground.model.states[compiler::StateId{put.state}];
      out += state.name.value + "=" + state.value_text(put.value) + " ";
    }
    out += '|';
  }
  return out;
}

} // namespace director::tests
