#pragma once
// SPDX-License-Identifier: MIT
// Reads a behaviour file and everything that it imports, each file once. All mistakes are collected; what could be read
// is in the Spec all the same, so that a second stage may look at it where there are no errors. Source: the language
// page.

#include "dsl/diagnostic.hpp"
#include "dsl/file_access.hpp"
#include "dsl/source_file.hpp"
#include "dsl/spec.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace director::dsl {

/// A file imports a file that imports a file: each costs a frame of the reader's stack.
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
