#pragma once
// SPDX-License-Identifier: MIT
// What director-clang can be asked. Each takes the JSON that stands on the standard input and gives what goes to the
// standard output: an object, with the key `error` alone where it cannot be answered. One file each.

#include "compiler/base/json.hpp"

namespace director::scanning {

using compiler::Json;

/// {} -> {"director": "0.1.0", "clang": "19.1.7"}
Json report_version(const Json& request);

/// For `directorc stubs`: which classes of a program implement a behaviour's modules, and where. Request and answer:
/// compiler/stubs/scan.hpp. Or several: {"requests": [...]} -> {"answers": [...]}.
Json read_declarations(const Json& request);

/// Likewise: how what was put into files, and whole new ones, are laid out by the .clang-format above them.
Json format_parts(const Json& request);

/// {"unit": {"file", "directory", "arguments"}, "headers": ["robot/types.hpp"], "namespace": "soccer",
/// "names": ["soccer::GamePhase"]} -> {"types": [...], "paths", "files", "errors"}. Of each name {"complete", "at",
/// "enum": {"at", "enumerators": [{"name", "value", "at"}]}}, `enum` only of one; {"wrong": "..."} where there is no
/// such type. The unit's file is not read: its name only says where the headers are looked for.
Json report_types(const Json& request);

/// {"units": [{"file", "directory", "arguments", "deep"}], "namespace": "soccer"} -> {"units": [...]}, in the same
/// order. `deep`: also what the standard library comes to, to tell what blocks; that takes longer. Of each
/// {"functions", "classes", "aliases", "paths", "files", "errors"}; compiler/facts/code.cpp reads them. Places are [row
/// of `paths`, begin, end] in bytes; `files` are [path, is a system header].
Json report_facts(const Json& request);

} // namespace director::scanning
