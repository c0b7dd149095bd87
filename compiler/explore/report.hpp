#pragma once
// SPDX-License-Identifier: MIT
// What an exploration comes to, as text for people and scenarios to keep.

#include "compiler/explore/verdict.hpp"

namespace director::compiler {

struct Exploration {
  Searched searched;
  std::vector<Verdict> verdicts; ///< of each assertion
  std::vector<ProviderId> never_ran;
  /// Requested while a provider of it met its conditions, and granted nowhere: it can wait for ever. Only if complete.
  std::vector<EdgeId> starved;
  struct Oscillation {
    std::vector<Taken> way;   ///< to where it begins
    std::vector<Taken> round; ///< what comes again and again
    std::optional<std::string> scenario;
  };
  std::vector<Oscillation> oscillations;
};

struct ExploreOptions {
  std::size_t bound = 1'000'000;
  unsigned threads = 0;
  std::string behaviour; ///< path of the behaviour from where scenarios will be
  std::function<void(const SearchProgress& so_far)> progress;
};

Exploration explore(const Ground& ground, const ExploreOptions& options);

std::string to_text(const Exploration& exploration, const Ground& ground);

/// A scenario to write, by the name of its file.
std::vector<std::pair<std::string, std::string>> scenarios_of(const Exploration& exploration, const Ground& ground);

} // namespace director::compiler
