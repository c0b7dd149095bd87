#pragma once
// SPDX-License-Identifier: MIT
// What a picture of a behaviour shows, before any format: boxes in layers, and arrows, each told once. Where every
// provider of a group has the same arrow it leaves from the group, and an arrow says all that it stands for.

#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

struct PictureRow {
  ProviderId provider{};
  std::string name; ///< empty where the group writes its words directly
  std::string when; ///< its conditions, as one text; empty: none
  std::string stay;
  std::string causing;
};

struct PictureBox {
  GroupId group{};
  std::string name;
  std::string data; ///< C++ type; empty: none
  bool root = false;
  std::vector<PictureRow> rows;
};

/// Groups beside one another.
struct PictureLayer {
  std::string name; ///< empty: what is in no layer
  std::vector<GroupId> groups;
};

struct PictureArrow {
  GroupId from{}, to{};
  std::optional<ProviderId> provider; ///< it leaves from this one; nothing: from all of the group
  bool task = false;                  ///< may be requested
  bool optional = false;              ///< ... and wherever it is, it is optional
  bool need = false;
  bool operator==(const PictureArrow&) const = default;
};

/// A provider makes a condition true that another one waits for.
struct PictureCause {
  GroupId causer_group{}, waiter_group{};
  ProviderId causer{}, waiter{};
  std::string condition;
  bool operator==(const PictureCause&) const = default;
};

struct Picture {
  std::string title;
  std::vector<PictureLayer> layers; ///< in the order declared; what is in none comes last
  std::vector<PictureBox> boxes;    ///< by group
  std::vector<PictureArrow> arrows; ///< by group and target
  std::vector<PictureCause> causes;
};

Picture make_picture(const Model& model, const Graph& graph);

} // namespace director::compiler
