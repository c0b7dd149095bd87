#pragma once
// SPDX-License-Identifier: MIT
// The result of several units for `declarations`: rows of JSON by place. A place that several units see counts once.

#include "compiler/base/json.hpp"

#include <clang/Basic/SourceManager.h>

#include <map>
#include <set>
#include <string>

namespace director::scanning {

using compiler::Json;

struct Findings {
  using Place = std::pair<std::string, std::uint64_t>; ///< canonical path, offset
  std::map<Place, Json> classes, functions, problems;
  std::set<std::string> seen; ///< files, by their canonical paths
};

std::string canonical(clang::FileEntryRef file);

/// Path and offset of a place; in a macro, of its use.
Findings::Place place_of(const clang::SourceManager& sources, clang::SourceLocation at);
/// A row with path, line and column of a place.
Json row_at(const clang::SourceManager& sources, clang::SourceLocation at);

} // namespace director::scanning
