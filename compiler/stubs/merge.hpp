#pragma once
// SPDX-License-Identifier: MIT
// What a behaviour wants, put beside what its program has: where to insert what is missing, and what is left over.
// Declared places only: behind another function of the module, at the end of its class, at the end of a source file.

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
  std::vector<std::size_t> fresh;    ///< modules that no class implements, by their place in Wanted
  std::vector<Insertion> insertions; ///< joined
  std::vector<Artefact> sources;     ///< files for definitions that have none: path and text
  std::vector<Remark> leftovers;     ///< of the user's code that serves nothing any more; sorted
  std::vector<Remark> obstacles;     ///< what is missing and cannot be added; sorted
  bool operator==(const Merge&) const = default;
};

/// `texts`: the files that may be added to. Without problems in `found`.
Merge merge(const Wanted& wanted, const Found& found, const Texts& texts);

/// `locomotion.hpp` and the like; any other file is taken for a source, which nobody includes.
bool is_header(const std::string& path);

} // namespace director::compiler::stubs
