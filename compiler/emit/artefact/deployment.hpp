#pragma once
// SPDX-License-Identifier: MIT
// The input of every output, and what several outputs compute from it.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "dsl/source/source_file.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace director::compiler {

/// A deployment without errors. The parts belong together: the same files, resolved and lowered.
struct Deployment {
  const dsl::Sources& sources;
  const Model& model;
  const Lowered& lowered;
};

/// The path of a file in outputs: relative to the folder of the main file, so that equal input gives equal bytes in any
/// folder.
std::string portable_path(const Deployment& from, dsl::FileId file);

/// `locomotion.yaml:12`
std::string place_text(const Deployment& from, const dsl::Span& span);

/// The number of an edge among those by which its target can be requested, in order: the place of the data of its
/// requests. 0 for an edge that is only needed.
std::uint32_t data_place(const Model& model, EdgeId edge);

/// How many edges can request the group.
std::uint32_t data_places(const Model& model, GroupId group);

/// The names of the levels with which a group is requested, in order of the first entry that uses them, those of root
/// first. For each group of the model.
IdTable<GroupId, std::vector<std::string>> level_names(const Model& model);

} // namespace director::compiler
