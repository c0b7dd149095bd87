// Header: compiler/lower/level_names.hpp. Test: tests/compiler/lower/level_names_test.cpp.
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

std::vector<LevelUse> level_uses(const Model& model, const Lowered& lowered) {
  const Tables tables = lowered.view();
  std::vector<LevelUse> out;
  const auto add = [&](const std::vector<Task>& tasks, LevelUse use) {
    for (const Task& task : tasks) {
      use.edge = static_cast<Index>(task.edge.value);
      for (const Task::NamedLevel& each : task.levels) {
        use.level = static_cast<Index>(tables.edges[use.edge].levels.begin + each.level);
        use.name = each.name.c_str();
        out.push_back(use);
      }
    }
  };
  add(model.roots, {});
  for (const ProviderId id : model.providers.ids()) {
    LevelUse use{.provider = static_cast<Index>(id.value)};
    for (const Pack& pack : model.providers[id].packs) {
      use.pack_name = pack.name.c_str();
      add(pack.tasks, use);
      ++use.pack;
    }
  }
  return out;
}

} // namespace director::compiler
