#pragma once
// SPDX-License-Identifier: MIT
// Makes the boxes of a picture: of one group, of several that are requested alike, of a module or a layer.

#include "compiler/emit/graph/picture/picture.hpp"
#include "compiler/emit/graph/picture/words.hpp"

#include <vector>

namespace director::compiler {

class BoxMaker {
public:
  /// All of them are kept by reference.
  BoxMaker(const Model& model, const PictureOptions& options, const PictureWords& words)
      : model_(model),
        options_(options),
        words_(words) {}

  PictureBox group(GroupId id) const;
  PictureBox alike(const std::vector<GroupId>& set) const;
  PictureBox folded(const std::vector<GroupId>& set) const;

  bool is_focused(GroupId id) const;
  /// The program itself requests it.
  bool is_root(GroupId id) const { return root_of(id) != nullptr; }

private:
  const Task* root_of(GroupId id) const;
  std::vector<PictureMember> members(const std::vector<GroupId>& set) const;

  const Model& model_;
  const PictureOptions& options_;
  const PictureWords& words_;
};

} // namespace director::compiler
