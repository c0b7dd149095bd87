#pragma once
// SPDX-License-Identifier: MIT
// Reads a behaviour file and everything that it imports, each file once. All mistakes are collected; the Spec has all
// that could be read, so that a second stage can check the parts without errors. Source: the language page.

#include "dsl/source/diagnostic.hpp"
#include "dsl/source/file_access.hpp"
#include "dsl/source/source_file.hpp"
#include "dsl/spec.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace director::dsl {

/// Limit for chains of imports: each file costs a frame of the reader's stack.
inline constexpr std::size_t deepest_import = 200;

struct ReadResult {
  Spec spec;
  std::vector<Diagnostic> diagnostics; ///< sorted by place
  bool readable = true;                ///< false: the file itself cannot be read, and that is the only finding
};

/// The files that were read are added to `sources`, the main one first. Where `path` itself cannot be read: an empty
/// text, and import_not_found (or input_limit) at its beginning.
ReadResult read_behaviour(const std::string& path, FileAccess& files, Sources& sources);

} // namespace director::dsl
