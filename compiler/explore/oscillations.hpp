#pragma once
// SPDX-License-Identifier: MIT
// The cycles of a search in which the engine never comes to rest, and the findings about them. The page of these:
// compiler/checks/never_at_rest.md.

#include "compiler/explore/search/search.hpp"
#include "dsl/source/diagnostic.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

struct Oscillation {
  std::vector<Taken> way;   ///< to the beginning of the cycle
  std::vector<Taken> round; ///< what repeats
  bool keeps_promises =
      false; ///< a body sets in it what it promises: where that takes time, the engine rests meanwhile
  std::optional<std::string> scenario;
};

/// `behaviour`: its path from the scenarios' folder.
std::vector<Oscillation> find_oscillations(const Ground& ground, const Searched& searched,
                                           const std::string& behaviour);

/// `Never at rest: after request A it repeats 2 micro-steps: A, B`.
std::string in_words(const Ground& ground, const Oscillation& oscillation);

/// Errors: only of cycles in which no body keeps a promise.
std::vector<dsl::Diagnostic> never_at_rest(const Ground& ground, const std::vector<Oscillation>& oscillations);

} // namespace director::compiler
