#pragma once
// SPDX-License-Identifier: MIT
// One behaviour, with a defect and without, and what is found in it.

#include "tests/defects/planter.hpp"

#include <cstdint>
#include <functional>
#include <set>
#include <string>

namespace director::defects {

struct Case {
  const Planter* planter = nullptr;
  std::uint64_t seed = 0;
  int size = 0; ///< of the robot: 0 to 4
};

/// The files of a behaviour, and where findings are expected.
struct Planted {
  std::string main;
  Texts texts;
  std::set<Mark> expected;
  bool edited = false; ///< its texts are no documents any more
};

/// `change`: done to the robot in the end, which has no signs any more then, and nothing is expected.
Planted make_planted(const Case& one, bool defect, const std::function<void(Robot&)>& change = {});

struct Outcome {
  Texts texts;
  std::set<Mark> expected;
  std::string report;       ///< all that is found, as people see it
  bool found = false;       ///< the check, where it is expected
  bool elsewhere = false;   ///< the check, but only at other places
  std::size_t others = 0;   ///< errors and warnings of other checks
  std::size_t findings = 0; ///< errors and warnings
};

Outcome try_out(const Case& one, bool defect);

} // namespace director::defects
