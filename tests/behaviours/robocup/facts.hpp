#pragma once
// SPDX-License-Identifier: MIT
// Reads the team's graph from facts/*.yaml, whose notation is explained at their beginning. Several facts have a short
// form and, elsewhere, a full one; then the full one counts.

#include "tests/behaviours/robocup/graph.hpp"

#include <string>
#include <vector>

namespace director::tests {

enum class Source { k1, older };

struct TeamFacts {
  TeamGraph graph;
  struct Place {
    std::string module, at;
  };
  std::vector<Place> places; ///< the place of a provider or handler in the team's source
};

TeamFacts read_facts(Source source);

} // namespace director::tests
