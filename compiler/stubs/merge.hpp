#pragma once
// SPDX-License-Identifier: MIT
// Compares what a behaviour wants with what its program has: where to insert what is missing, and what is left over.
// Insertions are only made at fixed places: behind another function of the module, at the end of its class, at the end
// of a source file.

#include "compiler/emit/artefact/artefact.hpp"
#include "compiler/stubs/found.hpp"
#include "compiler/stubs/insertion.hpp"
#include "compiler/stubs/wanted.hpp"

#include <string>
#include <vector>

namespace director::compiler::stubs {

struct Remark {
  SourcePlace place;
  std::string message;
  bool operator==(const Remark&) const = default;
};

struct Merge {
  std::vector<std::size_t> fresh;    ///< modules that no class implements, by index in Wanted
  std::vector<Insertion> insertions; ///< joined
  std::vector<Artefact> sources;     ///< new files for definitions: path and text
  std::vector<Remark> leftovers;     ///< code of the user without a purpose; sorted
  std::vector<Remark> obstacles;     ///< what is missing and cannot be added; sorted
  bool operator==(const Merge&) const = default;
};

/// `texts`: the files that may be changed. `found` must have no problems.
Merge merge(const Wanted& wanted, const Found& found, const Texts& texts);

/// `locomotion.hpp` and the like; any other file counts as a source, which no file includes.
bool is_header(const std::string& path);

} // namespace director::compiler::stubs
