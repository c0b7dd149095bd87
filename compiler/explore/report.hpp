#pragma once
// SPDX-License-Identifier: MIT
// The results of an exploration, as text and scenarios.

#include "compiler/explore/oscillations.hpp"
#include "compiler/explore/verdict.hpp"

namespace director::compiler {

struct Exploration {
  Searched searched;
  std::vector<Verdict> verdicts; ///< of each assertion
  std::vector<ProviderId> never_ran;
  /// Requested while a provider of it met its conditions, and granted nowhere: it may wait for ever. Only if complete.
  std::vector<EdgeId> starved;
  std::vector<Oscillation> oscillations;
};

struct ExploreOptions {
  std::size_t bound = 1'000'000;
  unsigned threads = 0;
  std::string behaviour; ///< path of the behaviour from the scenarios' folder
  std::function<void(const SearchProgress& so_far)> progress;
};

Exploration explore(const Ground& ground, const ExploreOptions& options);

std::string to_text(const Exploration& exploration, const Ground& ground);

/// Scenarios to write, by file name.
std::vector<std::pair<std::string, std::string>> scenarios_of(const Exploration& exploration, const Ground& ground);

} // namespace director::compiler
