// Header: compiler/emit/graph/picture/layers.hpp. Test: tests/compiler/emit/graph/picture/picture_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/picture/layers.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace director::compiler {

namespace {

/// The places of groups: above all layers, in one of them, or below.
class Places {
public:
  Places(const Model& model, const Graph& graph) : model_(model) {
    std::vector<Node> layered;
    for (const GroupId id : model.groups.ids()) {
      if (model.groups[id].layer) layered.push_back(id.value);
    }
    below_ = reachable(graph.claims, std::move(layered));
  }

  static constexpr std::size_t above = 0;
  std::size_t below() const { return model_.layers.size() + 1; }
  std::size_t count() const { return model_.layers.size() + 2; }

  std::size_t of(const PictureBox& box) const {
    if (box.groups.empty() || box.kind == PictureBox::Kind::missing) return below();
    const GroupId id = box.groups.front();
    const Group& group = model_.groups[id];
    if (group.layer) return group.layer->id.value + 1;
    const bool is_unrelated = group.edges.empty() && group.requesters.empty();
    return model_.layers.empty() || below_[id.value] || is_unrelated ? below() : above;
  }

private:
  const Model& model_;
  std::vector<bool> below_; ///< by group: something in a layer leads there
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
  const bool only_pushes = picture.kinds == std::vector{PictureArrow::Kind::push};
  const std::size_t boxes = picture.boxes.size();
  const Places places(model, graph);
  std::vector<bool> led_to(boxes, false), leads(boxes, false);
  for (PictureArrow& arrow : picture.arrows) {
    const std::size_t from = places.of(picture.boxes[arrow.from.box]), to = places.of(picture.boxes[arrow.to.box]);
    // Graphviz draws labelled arrows between neighbours of one rank wrongly, and breaks cycles by itself. Beside other
    // arrows, a push within a layer would only make that higher.
    arrow.ranks =
        only_pushes || from < to ||
        (from == to && arrow.kind != PictureArrow::Kind::push && rank_of(arrow.from.box) < rank_of(arrow.to.box));
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
