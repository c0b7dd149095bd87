#pragma once
// SPDX-License-Identifier: MIT
// Finds tasks that wait for a condition while the outside keeps all that cause it from running, or from being
// requested.

#include "compiler/analysis/causing/wants.hpp"
#include "compiler/analysis/input.hpp"
#include "compiler/analysis/requests/requests.hpp"

#include <vector>

namespace director::analysis {

struct ExcludedCausers {
  struct Excluded {
    ProviderId causer{};
    StateId state{};
    bool unrequested = false; ///< it is not requested with these values; else it cannot run itself
  };

  Want want;
  Request request;           ///< where it waits
  Region region;             ///< of the request
  std::vector<Excluded> all; ///< one for each causer
};

/// The first request of each condition, and none where a clash is found (clashes()).
std::vector<ExcludedCausers> find_excluded_causers(const Input& input);

} // namespace director::analysis
