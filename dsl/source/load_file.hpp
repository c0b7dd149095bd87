#pragma once
// SPDX-License-Identifier: MIT
// Loads a file that is named on the command line or in another file.

#include "dsl/source/diagnostic.hpp"
#include "dsl/source/file_access.hpp"
#include "dsl/source/source_file.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace director::dsl {

/// A behaviour of a thousand groups has about 200 KB. A file above this limit is a mistake, or an attempt to exhaust
/// memory.
inline constexpr std::size_t largest_file = 64U * 1024 * 1024;

/// Help for a path without a file: on the command line, and in a file.
inline constexpr const char* relative_to_program = "a path is relative to the folder in which the program runs";
inline constexpr const char* relative_to_file = "a path is relative to the file that it stands in";

struct LoadedFile {
  FileId id{};
  bool readable = false;
};

/// Adds the file to `sources`. If it cannot be read, that is an empty text, with import_not_found or input_limit at its
/// beginning.
LoadedFile load_file(const std::string& path, FileAccess& files, Sources& sources,
                     std::vector<Diagnostic>& diagnostics);

/// Why a file cannot be read, as a finding at the place that names it.
Diagnostic unreadable(const std::string& path, const FileError& error, Span place);

} // namespace director::dsl
