// Header: compiler/emit/graph/layers.hpp. Test: tests/compiler/emit/picture_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/layers.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace director::compiler {

namespace {

/// All that these lead to, over any number of requesters, and they themselves.
IdSet<GroupId> led_to_by(const Model& model, std::vector<GroupId> open) {
  IdTable<GroupId, std::vector<GroupId>> targets(model.groups.size());
  for (const Edge& edge : model.edges) {
    if (edge.requester) targets[*edge.requester].push_back(edge.target);
  }
  IdSet<GroupId> out(model.groups.size());
  for (const GroupId id : open) out.add(id);
  while (!open.empty()) {
    const GroupId from = open.back();
    open.pop_back();
    for (const GroupId to : targets[from]) {
      if (out.add(to)) open.push_back(to);
    }
  }
  return out;
}

/// Where groups stand: above all layers, in one of them, or below.
class Places {
public:
  explicit Places(const Model& model) : model_(model), below_(model.groups.size()), related_(model.groups.size()) {
    std::vector<GroupId> layered;
    for (const GroupId id : model.groups.ids()) {
      if (model.groups[id].layer) layered.push_back(id);
    }
    below_ = led_to_by(model, layered);
    for (const Edge& edge : model.edges) {
      related_.add(edge.target);
      if (edge.requester) related_.add(*edge.requester);
    }
  }

  static constexpr std::size_t above = 0;
  std::size_t below() const { return model_.layers.size() + 1; }
  std::size_t count() const { return model_.layers.size() + 2; }

  std::size_t of(const PictureBox& box) const {
    if (box.groups.empty() || box.kind == PictureBox::Kind::missing) return below();
    const GroupId id = box.groups.front();
    if (const auto& layer = model_.groups[id].layer) return layer->id.value + 1;
    return model_.layers.empty() || below_.contains(id) || !related_.contains(id) ? below() : above;
  }

private:
  const Model& model_;
  IdSet<GroupId> below_;   ///< something in a layer leads there
  IdSet<GroupId> related_; ///< requests something, or is requested
};

/// Boxes that are layers themselves need no bands.
PictureLayer in_one(const std::vector<PictureLayer>& layers) {
  PictureLayer out;
  out.in_order = true;
  for (const PictureLayer& layer : layers) out.boxes.insert(out.boxes.end(), layer.boxes.begin(), layer.boxes.end());
  return out;
}

} // namespace

void arrange_in_layers(const Model& model, const Graph& graph, bool bands, Picture& picture) {
  std::vector<std::size_t> rank(model.groups.size());
  for (std::size_t i = 0; i < graph.order.size(); ++i) rank[graph.order[i]] = i;
  const auto rank_of = [&](std::size_t box) {
    const PictureBox& each = picture.boxes[box];
    return each.kind == PictureBox::Kind::missing ? rank.size() : rank[each.groups.front().value];
  };
  const std::size_t boxes = picture.boxes.size();
  const Places places(model);
  std::vector<bool> led_to(boxes, false), leads(boxes, false);
  for (PictureArrow& arrow : picture.arrows) {
    const std::size_t from = places.of(picture.boxes[arrow.from.box]), to = places.of(picture.boxes[arrow.to.box]);
    arrow.ranks = arrow.kind != PictureArrow::Kind::push && from <= to &&
                  (from != to || rank_of(arrow.from.box) < rank_of(arrow.to.box));
    if (from != to || !arrow.ranks) continue;
    led_to[arrow.to.box] = true;
    leads[arrow.from.box] = true;
  }
  std::vector<PictureLayer> layers(places.count());
  layers[Places::above].is_above = true;
  for (std::size_t i = 0; i < model.layers.size(); ++i)
    layers[i + 1].name = model.layers[LayerId{static_cast<std::uint32_t>(i)}].name.value;
  for (std::size_t box = 0; box < boxes; ++box) {
    PictureLayer& layer = layers[places.of(picture.boxes[box])];
    layer.boxes.push_back(box);
    if (!led_to[box]) layer.first.push_back(box);
    if (!leads[box]) layer.last.push_back(box);
  }
  std::erase_if(layers, [](const PictureLayer& layer) { return layer.boxes.empty(); });
  picture.layers = bands || layers.empty() ? std::move(layers) : std::vector{in_one(layers)};
}

} // namespace director::compiler
