// Header: compiler/emit/graph/picture/boxes.hpp. Test: tests/compiler/emit/graph/picture/picture_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/picture/boxes.hpp"

#include "compiler/base/counted.hpp"
#include "compiler/emit/graph/picture/group_arrows.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

bool BoxMaker::is_focused(GroupId id) const {
  return std::find(options_.focus.begin(), options_.focus.end(), id) != options_.focus.end();
}

const Task* BoxMaker::root_of(GroupId id) const {
  for (const Task& root : model_.roots) {
    if (root.target == id) return &root;
  }
  return nullptr;
}

PictureBox BoxMaker::group(GroupId id) const {
  const Group& group = model_.groups[id];
  PictureBox box;
  box.name = group.name.value;
  box.groups = {id};
  box.data = group.data;
  const Task* root = root_of(id);
  if (root != nullptr) box.roots = {box.name};
  if (root != nullptr) box.requested = words_.manner(manner_of(model_, *root, has_priorities(model_, model_.roots)));
  box.lines = words_.handler_lines(group);
  if (group.providers.empty()) box.lines.push_back({PictureLine::Kind::outer, "extern", {}});
  for (const ProviderId provider : group.providers) box.rows.push_back(words_.row(provider));
  box.in_focus = is_focused(id);
  box.about = words_.group(id);
  if (root != nullptr && !root->doc.empty()) box.about.words += "\n" + with_doc("requested by the program", root->doc);
  return box;
}

std::vector<PictureMember> BoxMaker::members(const std::vector<GroupId>& set) const {
  std::vector<PictureMember> out;
  for (const GroupId id : set) out.push_back({model_.groups[id].name.value, words_.group(id)});
  return out;
}

PictureBox BoxMaker::alike(const std::vector<GroupId>& set) const {
  PictureBox box;
  box.kind = PictureBox::Kind::alike;
  for (const GroupId id : set) box.name += (box.name.empty() ? "" : ", ") + model_.groups[id].name.value;
  box.groups = set;
  box.members = members(set);
  box.data = model_.groups[set.front()].data;
  box.about = words_.group(set.front());
  box.about.words = fmt::format("{}: requested alike", box.name);
  return box;
}

PictureBox BoxMaker::folded(const std::vector<GroupId>& set) const {
  PictureBox box;
  box.kind = PictureBox::Kind::folded;
  const Group& first = model_.groups[set.front()];
  const bool modules = options_.fold == PictureOptions::Fold::modules;
  box.name = modules       ? fmt::format("module {}", model_.modules[first.module].name)
             : first.layer ? fmt::format("layer {}", model_.layers[first.layer->id].name.value)
                           : std::string(no_layer);
  box.groups = set;
  box.members = members(set);
  for (const GroupId id : set) {
    const Task* root = root_of(id);
    if (root == nullptr) continue;
    box.roots.push_back(model_.groups[id].name.value);
    if (!box.requested) box.requested.emplace();
    const std::string how = words_.manner(manner_of(model_, *root, has_priorities(model_, model_.roots)));
    *box.requested += fmt::format("{}{}{}", box.requested->empty() ? "" : ", ", model_.groups[id].name.value,
                                  how.empty() ? "" : " " + how);
  }
  box.in_focus = std::any_of(set.begin(), set.end(), [&](GroupId id) { return is_focused(id); });
  box.about = words_.group(set.front());
  box.about.words = fmt::format("{}: {}", box.name, counted(set.size(), "group"));
  return box;
}

} // namespace director::compiler
