#pragma once
// What director-clang can be asked. Each takes the JSON that stands on the standard input and gives what goes to the
// standard output: an object, with the key `error` alone where it cannot be answered. One file each.

#include "compiler/emit/json.hpp"

namespace director::scanning {

using compiler::Json;

/// {} -> {"director": "0.1.0", "clang": "19.1.7"}
Json tell_version(const Json& request);

/// For `directorc stubs`: which classes of a program implement a behaviour's modules, and where. Request and answer:
/// compiler/stubs/scan.hpp. Or several: {"requests": [...]} -> {"answers": [...]}.
Json read_declarations(const Json& request);

/// Likewise: how what was put into files, and whole new ones, are laid out by the .clang-format above them.
Json format_parts(const Json& request);

} // namespace director::scanning
