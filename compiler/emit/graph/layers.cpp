// Header: compiler/emit/graph/layers.hpp. Test: tests/compiler/emit/picture_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/layers.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace director::compiler {

namespace {

std::size_t layer_of(const Model& model, const PictureBox& box) {
  if (box.groups.empty() || box.kind == PictureBox::Kind::missing) return model.layers.size();
  const Group& group = model.groups[box.groups.front()];
  return group.layer ? group.layer->id.value : model.layers.size();
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
  std::vector<bool> led_to(boxes, false), leads(boxes, false);
  for (PictureArrow& arrow : picture.arrows) {
    const std::size_t from = layer_of(model, picture.boxes[arrow.from.box]),
                      to = layer_of(model, picture.boxes[arrow.to.box]);
    arrow.ranks = arrow.kind != PictureArrow::Kind::push && (!bands || from <= to) &&
                  (from != to || rank_of(arrow.from.box) < rank_of(arrow.to.box));
    if (from != to || !arrow.ranks) continue;
    led_to[arrow.to.box] = true;
    leads[arrow.from.box] = true;
  }
  std::vector<PictureLayer> layers(model.layers.size() + 1);
  for (std::size_t i = 0; i < model.layers.size(); ++i)
    layers[i].name = model.layers[LayerId{static_cast<std::uint32_t>(i)}].name.value;
  for (std::size_t box = 0; box < boxes; ++box) {
    PictureLayer& layer = layers[bands ? layer_of(model, picture.boxes[box]) : model.layers.size()];
    layer.boxes.push_back(box);
    if (!led_to[box]) layer.first.push_back(box);
    if (!leads[box]) layer.last.push_back(box);
  }
  std::erase_if(layers, [](const PictureLayer& layer) { return layer.boxes.empty(); });
  picture.layers = std::move(layers);
}

} // namespace director::compiler
