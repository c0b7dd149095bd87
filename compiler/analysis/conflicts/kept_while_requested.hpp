#pragma once
// SPDX-License-Identifier: MIT
// Finds tasks that wait for a condition while one that requests them, though not all that do, keeps what the causing
// providers need.

#include "compiler/analysis/causing/wants.hpp"
#include "compiler/analysis/clashes/holdings.hpp"
#include "compiler/analysis/input.hpp"
#include "compiler/analysis/requests/requests.hpp"

#include <vector>

namespace director::analysis {

struct KeptWhileRequested {
  Request request; ///< its requester keeps it
  Want want;
  KeptNeed kept; ///< a need of the first causer
};

/// One for each condition, and none where a clash is found (clashes()).
std::vector<KeptWhileRequested> find_kept_while_requested(const Input& input);

} // namespace director::analysis
