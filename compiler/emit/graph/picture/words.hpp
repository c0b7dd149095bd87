#pragma once
// SPDX-License-Identifier: MIT
// The texts of a picture: conditions as they are written, `doc` texts, places.

#include "compiler/emit/graph/picture/group_arrows.hpp"
#include "compiler/emit/graph/picture/picture.hpp"

namespace director::compiler {

class PictureWords {
public:
  /// Keeps references to both.
  PictureWords(const Model& model, const dsl::Sources& sources) : model_(model), sources_(sources) {}

  PictureText at(std::string words, const Span& span) const;
  PictureText group(GroupId id) const;
  PictureRow row(ProviderId id) const;
  std::vector<PictureLine> handler_lines(const Group& group) const;
  /// `20`, `20, optional`.
  std::string manner(const Manner& manner) const;

private:
  const Model& model_;
  const dsl::Sources& sources_;
};

} // namespace director::compiler
