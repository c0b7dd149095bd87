#pragma once
// SPDX-License-Identifier: MIT
// Two searches of one behaviour, of which one takes every micro-step and the other none that it foresees to end as
// another.

#include "compiler/explore/search/search.hpp"

#include <string>

namespace director::tests {

/// In what they differ; empty: in nothing.
inline std::string search_both_ways(const compiler::Ground& ground, compiler::SearchOptions options) {
  options.foresees = true;
  const compiler::Searched some = search(ground, options);
  options.foresees = false;
  const compiler::Searched all = search(ground, options);
  std::string out;
  const auto compare = [&](const char* what, bool same) { out += same ? "" : std::string(what) + " "; };
  compare("states", some.states == all.states && some.complete == all.complete);
  compare("explored", some.explored == all.explored);
  compare("micro-steps", some.micro_steps == all.micro_steps);
  compare("seen", some.seen == all.seen);
  compare("ran", some.happened.ran == all.happened.ran);
  compare("granted", some.happened.granted == all.happened.granted);
  compare("asked", some.happened.runnable == all.happened.runnable);
  compare("cycles", some.cycles == all.cycles);
  compare("root sets", some.root_sets == all.root_sets);
  return out;
}

} // namespace director::tests
