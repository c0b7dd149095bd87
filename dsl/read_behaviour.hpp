#pragma once
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

/// A behaviour of a thousand groups has about 200 KB. More than this is a mistake, or somebody who wants our memory.
inline constexpr std::size_t largest_file = 64U * 1024 * 1024;
/// A file imports a file that imports a file: each costs a frame of the reader's stack.
inline constexpr std::size_t deepest_import = 200;

struct ReadResult {
  Spec spec;
  std::vector<Diagnostic> diagnostics; ///< sorted by place
};

/// The files that were read are added to `sources`, the main one first. Nothing in the result's `spec` and
/// import_not_found at the beginning of an empty text: `path` itself cannot be read.
ReadResult read_behaviour(const std::string& path, FileAccess& files, Sources& sources);

} // namespace director::dsl
