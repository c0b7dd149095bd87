#pragma once
// SPDX-License-Identifier: MIT
// What is known of a program after some units, for `declarations`: rows of JSON by place. A place that several units
// see counts once.

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

/// Of what stands there; in a macro, where that is used. Path and offset.
Findings::Place place_of(const clang::SourceManager& sources, clang::SourceLocation at);
/// Its path, line and column, as a row begins.
Json row_at(const clang::SourceManager& sources, clang::SourceLocation at);

} // namespace director::scanning
