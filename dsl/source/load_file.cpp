// Header: dsl/source/load_file.hpp. Test: tests/dsl/reading/read_behaviour_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/source/load_file.hpp"

#include <fmt/format.h>

#include <utility>

namespace director::dsl {

LoadedFile load_file(const std::string& path, FileAccess& files, Sources& sources,
                     std::vector<Diagnostic>& diagnostics) {
  auto text = files.read(path, largest_file);
  if (text) return {sources.add(path, std::move(text.value())), true};
  const FileId id = sources.add(path, "");
  diagnostics.push_back(unreadable(path, text.error(), {id, 0, 0}));
  if (text.error().kind == FileError::Kind::not_found) diagnostics.back().help = relative_to_program;
  return {id, false};
}

Diagnostic unreadable(const std::string& path, const FileError& error, Span place) {
  if (error.kind == FileError::Kind::too_large)
    return {"input_limit",
            Level::error,
            place,
            fmt::format("`{}` is larger than {} MiB", path, largest_file >> 20U),
            {},
            "divide it into files that import one another"};
  return {"import_not_found",
          Level::error,
          place,
          fmt::format("cannot read `{}`: {}", path, error.message),
          {},
          error.kind == FileError::Kind::not_found ? relative_to_file : "name a file that can be read"};
}

} // namespace director::dsl
