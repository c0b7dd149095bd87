#pragma once
// SPDX-License-Identifier: MIT
// Finds the values of states with which a task may be requested, and none of its providers can run, whatever is pushed.

#include "compiler/analysis/requests/requests.hpp"
#include "compiler/analysis/uncovered/unserved.hpp"

#include <string>
#include <vector>

namespace director::analysis {

struct Uncoveredness {
  GroupId group{};
  std::vector<std::string> gaps; ///< in words
  bool all = true;               ///< false: there are more than could be listed
  std::vector<Box> boxes;        ///< of each gap
  const Request* where = nullptr;
};

/// By group, of all that are requested.
std::vector<Uncoveredness> find_uncovered(const Input& input, const Unserved& unserved);

} // namespace director::analysis
