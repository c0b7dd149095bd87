// Door: compiler/emit/graph/picture.hpp. Test: tests/compiler/cli/graph_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/picture.hpp"

#include <algorithm>
#include <map>

namespace director::compiler {

namespace {

std::string texts_of(const Model& model, const std::vector<ConditionUse>& uses) {
  std::string out;
  for (const ConditionUse& use : uses) {
    if (!out.empty()) out += ", ";
    out += model.conditions[use.id].text;
  }
  return out;
}

PictureBox box_of(const Model& model, GroupId id) {
  const Group& group = model.groups[id];
  PictureBox box{id, group.name.value, group.data, false, {}};
  box.root = std::any_of(model.roots.begin(), model.roots.end(), [&](const Task& root) { return root.target == id; });
  for (const ProviderId provider_id : group.providers) {
    const Provider& provider = model.providers[provider_id];
    box.rows.push_back({provider_id, provider.direct ? std::string{} : provider.name, texts_of(model, provider.when),
                        texts_of(model, provider.stay), texts_of(model, provider.causing)});
  }
  return box;
}

std::vector<PictureLayer> layers_of(const Model& model) {
  std::vector<PictureLayer> layers;
  for (const Layer& layer : model.layers) layers.push_back({layer.name.value, {}});
  layers.push_back({});
  for (const GroupId id : model.groups.ids()) {
    const Group& group = model.groups[id];
    layers[group.layer ? group.layer->id.value : layers.size() - 1].groups.push_back(id);
  }
  const auto empty = [](const PictureLayer& layer) { return layer.groups.empty(); };
  layers.erase(std::remove_if(layers.begin(), layers.end(), empty), layers.end());
  return layers;
}

/// What one provider asks for and needs, by target.
std::map<GroupId, PictureArrow> arrows_of(const Model& model, ProviderId id) {
  const Provider& provider = model.providers[id];
  std::map<GroupId, PictureArrow> arrows;
  const auto arrow_to = [&](GroupId to) -> PictureArrow& {
    PictureArrow& arrow = arrows[to];
    arrow.from = provider.group;
    arrow.to = to;
    return arrow;
  };
  for (const Pack& pack : provider.packs) {
    for (const Task& task : pack.tasks) {
      PictureArrow& arrow = arrow_to(task.target);
      const std::vector<Level>& levels = model.edges[task.edge].levels;
      const bool optional = std::all_of(task.levels.begin(), task.levels.end(),
                                        [&](const Task::NamedLevel& level) { return levels[level.level].optional; });
      arrow.optional = optional && (arrow.optional || !arrow.task);
      arrow.task = true;
    }
  }
  for (const Use<GroupId>& need : provider.needs) arrow_to(need.id).need = true;
  return arrows;
}

void add_arrows(const Model& model, const Group& group, std::vector<PictureArrow>& out) {
  std::vector<std::map<GroupId, PictureArrow>> all;
  for (const ProviderId provider : group.providers) all.push_back(arrows_of(model, provider));
  std::map<GroupId, std::vector<PictureArrow>> by_target;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const auto& [to, arrow] : all[i]) {
      const bool shared = std::all_of(all.begin(), all.end(), [&](const auto& other) {
        const auto same = other.find(to);
        return same != other.end() && same->second == arrow;
      });
      if (shared && i > 0) continue;
      PictureArrow told = arrow;
      if (!shared) told.provider = group.providers[i];
      by_target[to].push_back(told);
    }
  }
  for (const auto& [to, arrows] : by_target) out.insert(out.end(), arrows.begin(), arrows.end());
}

} // namespace

Picture make_picture(const Model& model, const Graph& graph) {
  Picture picture;
  picture.title = model.name;
  picture.layers = layers_of(model);
  for (const GroupId id : model.groups.ids()) {
    picture.boxes.push_back(box_of(model, id));
    add_arrows(model, model.groups[id], picture.arrows);
  }
  for (const Graph::Causing& causing : graph.causing) {
    const GroupId from = model.providers[causing.causer].group, to = model.providers[causing.waiter].group;
    if (from == to) continue;
    PictureCause cause{from, to, causing.causer, causing.waiter, model.conditions[causing.condition.id].text};
    if (std::find(picture.causes.begin(), picture.causes.end(), cause) == picture.causes.end())
      picture.causes.push_back(std::move(cause));
  }
  return picture;
}

} // namespace director::compiler
