// Header: compiler/lower/level_names.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/lower/level_names.hpp"

namespace director::compiler {

std::vector<std::string> level_names(const Model& model, const Lowered& lowered) {
  const Tables tables = lowered.view();
  std::vector<std::string> out(tables.levels.size());
  const auto add = [&](const std::vector<Task>& tasks, bool with_first) {
    for (const Task& task : tasks) {
      for (const Task::NamedLevel& each : task.levels) {
        std::string& name = out[tables.edges[task.edge.value].levels.begin + each.level];
        if ((with_first || each.level != task.levels.front().level) && name.empty()) name = each.name;
      }
    }
  };
  add(model.roots, true);
  for (const Provider& provider : model.providers) {
    for (const Pack& pack : provider.packs) add(pack.tasks, false);
  }
  return out;
}

} // namespace director::compiler
