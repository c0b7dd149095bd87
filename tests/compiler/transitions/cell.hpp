#pragma once
// SPDX-License-Identifier: MIT
// A cell of the transition matrix of a small behaviour, as text.

#include <string>

namespace director::tests {

/// Its kind and words, what stops and what is taken, then its scenario.
std::string cell(const std::string& behaviour, const std::string& from, const std::string& to);

/// Its kind and words.
std::string cell_words(const std::string& behaviour, const std::string& from, const std::string& to);

/// How the group is brought to run.
std::string row_words(const std::string& behaviour, const std::string& group);

inline constexpr const char* legs = R"(states: {Pose: {values: [moving, still], initial: still}}
roots: {Kick: {priority: 20}, Walk: {priority: 10}, Look: {}}
groups:
  Kick: {when: [Pose == still], needs: [Legs]}
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Pose == still within 2 s], tasks: [Legs]}
  Look: {needs: [Head]}
  Legs: {}
  Head: {}
)";

inline constexpr const char* plans = R"(roots: [Play, Sleep]
groups:
  Play:
    packs:
      shoot: {Kick: {}}
      run: {Walk: {}}
  Kick: {needs: [Legs]}
  Walk: {needs: [Legs]}
  Sleep: {needs: [Legs]}
  Legs: {}
)";

} // namespace director::tests
