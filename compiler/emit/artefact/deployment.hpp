#pragma once
// SPDX-License-Identifier: MIT
// What every output is made from, and what several of them ask of it.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "dsl/source_file.hpp"

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

/// The path of a file as outputs name it: from the folder of the main file, so that equal input gives equal bytes
/// wherever it lies.
std::string portable_path(const Deployment& from, dsl::FileId file);

/// `locomotion.yaml:12`
std::string place_text(const Deployment& from, const dsl::Span& span);

/// The number of an edge among those by which its target can be requested, in order: where the data of its requests
/// lie. 0 for an edge that is only needed.
std::uint32_t data_place(const Model& model, EdgeId edge);

/// How many edges can request the group.
std::uint32_t data_places(const Model& model, GroupId group);

/// The names that levels of requests for a group have, in order of the first entry that uses them, root's before all.
/// For each group of the model.
IdTable<GroupId, std::vector<std::string>> level_names(const Model& model);

} // namespace director::compiler
