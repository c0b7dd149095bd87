// Door: compiler/emit/graph/formats.hpp. Test: tests/compiler/cli/graph_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/formats.hpp"
#include "compiler/emit/artefact/notice.hpp"

namespace director::compiler {

namespace {

Json conditions(const Model& model, const std::vector<ConditionUse>& uses) {
  Json list = Json::list({});
  for (const ConditionUse& use : uses) list.add(Json::text(model.conditions[use.id].text));
  return list;
}

Json groups_named(const Model& model, const std::vector<Use<GroupId>>& uses) {
  Json list = Json::list({});
  for (const Use<GroupId>& use : uses) list.add(Json::text(model.groups[use.id].name.value));
  return list;
}

/// An entry of `tasks`, a pack or `roots`.
Json task(const Model& model, const Task& entry) {
  Json levels = Json::list({});
  for (const Task::NamedLevel& named : entry.levels) {
    const Level& level = model.edges[entry.edge].levels[named.level];
    Json row = Json::object({});
    if (!named.name.empty()) row.add("name", Json::text(named.name));
    row.add("priority", Json::number(level.priority));
    row.add("optional", Json::boolean(level.optional));
    row.add("apart", Json::boolean(level.apart));
    levels.add(std::move(row));
  }
  return Json::object({{"group", Json::text(model.groups[entry.target].name.value)}, {"levels", std::move(levels)}});
}

Json tasks(const Model& model, const std::vector<Task>& entries) {
  Json list = Json::list({});
  for (const Task& entry : entries) list.add(task(model, entry));
  return list;
}

Json provider(const Model& model, const Provider& row) {
  Json out = Json::object({{"name", Json::text(row.name)},
                           {"when", conditions(model, row.when)},
                           {"stay", conditions(model, row.stay)},
                           {"needs", groups_named(model, row.needs)},
                           {"causing", conditions(model, row.causing)},
                           {"sets", conditions(model, row.sets)},
                           {"uses", groups_named(model, row.uses)}});
  if (!row.has_packs) {
    out.add("tasks", row.packs.empty() ? Json::list({}) : tasks(model, row.packs.front().tasks));
    return out;
  }
  Json packs = Json::list({});
  for (const Pack& pack : row.packs)
    packs.add(Json::object({{"name", Json::text(pack.name)}, {"tasks", tasks(model, pack.tasks)}}));
  out.add("packs", std::move(packs));
  return out;
}

Json group(const Model& model, const Group& row) {
  Json out = Json::object({{"name", Json::text(row.name.value)}});
  if (row.layer) out.add("layer", Json::text(model.layers[row.layer->id].name.value));
  out.add("module", Json::text(model.modules[row.module].name));
  if (!row.data.empty()) out.add("data", Json::text(row.data));
  out.add("start", Json::boolean(row.start.has_value()));
  out.add("stop", Json::boolean(row.stop.has_value()));
  Json providers = Json::list({});
  for (const ProviderId id : row.providers) providers.add(provider(model, model.providers[id]));
  out.add("providers", std::move(providers));
  return out;
}

} // namespace

Json graph_json(const Model& model, const Graph& graph) {
  Json layers = Json::list({}), groups = Json::list({}), causing = Json::list({});
  for (const Layer& layer : model.layers) layers.add(Json::text(layer.name.value));
  for (const Group& row : model.groups) groups.add(group(model, row));
  for (const Graph::Causing& row : graph.causing) {
    causing.add(Json::object({{"causer", Json::text(model.full_name(row.causer))},
                              {"promise", Json::text(model.conditions[row.promise.id].text)},
                              {"waiter", Json::text(model.full_name(row.waiter))},
                              {"condition", Json::text(model.conditions[row.condition.id].text)}}));
  }
  return Json::object({{"generated_by", generated_by()},
                       {"behaviour", Json::text(model.name)},
                       {"layers", std::move(layers)},
                       {"roots", tasks(model, model.roots)},
                       {"groups", std::move(groups)},
                       {"causing", std::move(causing)}});
}

} // namespace director::compiler
