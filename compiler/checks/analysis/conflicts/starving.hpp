#pragma once
// Tasks that never run because something that goes before them is always requested with them and takes what they must
// have.

#include "compiler/checks/check.hpp"

#include <vector>

namespace director::checks {

/// Why one entry never gets what it must have.
struct Starver {
  const Task* by = nullptr;   ///< the entry that goes before
  const Task* over = nullptr; ///< the entry beside that one: the starving task's own, or one that leads to it
  GroupId group{};            ///< what it takes
};

struct StarvingTask {
  struct Place {
    const Task* task = nullptr;
    Starver starver;
  };
  std::vector<Place> places; ///< everywhere where this requester asks for it; never empty
  bool optional = false;     ///< the first of these entries is
};

/// In order of edges. Not those whose requester never runs itself for this reason.
std::vector<StarvingTask> find_starving_tasks(const Input& input);

void report_starving_task(const Input& input, const StarvingTask& starving, Findings& findings);

} // namespace director::checks
