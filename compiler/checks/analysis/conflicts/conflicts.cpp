// Door: compiler/checks/analysis/conflicts/conflicts.hpp. Test: tests/checks/pages_test.cpp.
#include "compiler/checks/analysis/conflicts/conflicts.hpp"

#include "compiler/checks/analysis/shared.hpp"

namespace director::checks {

const std::vector<Clash>& Conflicts::clashes() const {
  if (!clashes_) clashes_ = find_clashes(input_.model, input_.graph, input_.facts, input_.shared);
  return *clashes_;
}

const std::vector<PackConflict>& Conflicts::pack_conflicts() const {
  if (!pack_conflicts_)
    pack_conflicts_ = find_pack_conflicts(input_.model, input_.shared.units(), input_.shared.indispensable());
  return *pack_conflicts_;
}

const std::vector<StarvingTask>& Conflicts::starving_tasks() const {
  if (!starving_tasks_) starving_tasks_ = find_starving_tasks(input_);
  return *starving_tasks_;
}

} // namespace director::checks
