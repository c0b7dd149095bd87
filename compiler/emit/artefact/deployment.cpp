// Header: compiler/emit/artefact/deployment.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/artefact/deployment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace director::compiler {

std::string portable_path(const Deployment& from, dsl::FileId file) {
  const std::filesystem::path main = from.sources[from.model.name_span.file].path();
  const std::filesystem::path path = from.sources[file].path();
  const std::filesystem::path way = path.lexically_normal().lexically_relative(main.lexically_normal().parent_path());
  return way.empty() ? path.filename().generic_string() : way.generic_string(); // one is absolute, the other is not
}

std::string place_text(const Deployment& from, const dsl::Span& span) {
  return fmt::format("{}:{}", portable_path(from, span.file), from.sources[span.file].place(span.begin).line);
}

std::uint32_t data_place(const Model& model, EdgeId edge) {
  std::uint32_t place = 0;
  for (const EdgeId other : model.groups[model.edges[edge].target].requesters) {
    if (other == edge) break;
    if (!model.edges[other].levels.empty()) ++place;
  }
  return model.edges[edge].levels.empty() ? 0 : place;
}

std::uint32_t data_places(const Model& model, GroupId group) {
  const std::vector<EdgeId>& edges = model.groups[group].requesters;
  return static_cast<std::uint32_t>(
      std::count_if(edges.begin(), edges.end(), [&](EdgeId edge) { return !model.edges[edge].levels.empty(); }));
}

IdTable<GroupId, std::vector<std::string>> level_names(const Model& model) {
  IdTable<GroupId, std::vector<std::string>> names(model.groups.size());
  const auto add = [&](const std::vector<Task>& tasks) {
    for (const Task& task : tasks) {
      std::vector<std::string>& known = names[task.target];
      for (const Task::NamedLevel& level : task.levels) {
        const bool fresh = std::find(known.begin(), known.end(), level.name) == known.end();
        if (fresh && !level.name.empty()) known.push_back(level.name);
      }
    }
  };
  add(model.roots);
  for (const Provider& provider : model.providers) {
    for (const Pack& pack : provider.packs) add(pack.tasks);
  }
  return names;
}

} // namespace director::compiler
