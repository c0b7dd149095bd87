// Header: compiler/analysis/chains/unit_places.hpp. Test: tests/compiler/page/facts/ranks_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/chains/unit_places.hpp"

#include <algorithm>

namespace director::analysis {

std::vector<Mate> mates_of(const Model& model, const std::vector<Task>& entries, EdgeId member, EdgeId rival) {
  std::vector<Mate> out;
  for (const Task& task : entries) {
    if (task.edge == member || task.edge == rival) continue;
    for (const Task::NamedLevel& named : task.levels) {
      const Level& level = model.edges[task.edge].levels[named.level];
      if (level.shares_unit()) out.push_back({&task, &named, level.priority});
    }
  }
  return out;
}

bool any_always(const std::vector<Mate>& mates, const std::function<bool(const Mate&)>& test) {
  for (std::size_t i = 0; i < mates.size();) { // each of its levels is next to the others
    const Task* const task = mates[i].task;
    std::size_t passed = 0;
    for (; i < mates.size() && mates[i].task == task; ++i) passed += test(mates[i]) ? 1 : 0;
    if (passed == task->levels.size()) return true;
  }
  return false;
}

Leaders find_leaders(const Model& model, const std::vector<Task>& entries, bool whole, EdgeId member,
                     std::int32_t priority, EdgeId rival, std::int32_t rivals_priority) {
  const std::vector<Mate> mates = mates_of(model, entries, member, rival);
  const auto goes_before = [&](const Mate& mate) { return mate.priority > rivals_priority; };
  Leaders out;
  for (const Mate& mate : mates) {
    const bool beside = mate.priority == rivals_priority && priority < rivals_priority;
    if (goes_before(mate) || beside) out.all.push_back({mate.task->edge, mate.priority, beside});
  }
  std::sort(out.all.begin(), out.all.end());
  out.all.erase(std::unique(out.all.begin(), out.all.end()), out.all.end());
  out.always = whole && any_always(mates, goes_before);
  return out;
}

} // namespace director::analysis
