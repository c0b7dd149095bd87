#pragma once
// SPDX-License-Identifier: MIT
// The subcommands of director-clang. Each takes the JSON of the standard input and returns that of the standard output:
// an object, which has only the key `error` if it cannot be answered. One file each.

#include "compiler/base/json.hpp"

namespace director::scanning {

using compiler::Json;

/// {} -> {"director": "0.1.0", "clang": "19.1.7"}
Json report_version(const Json& request);

/// For `directorc stubs`: the classes of a program that implement a behaviour's modules. Request and answer:
/// compiler/stubs/scan.hpp. Or several: {"requests": [...]} -> {"answers": [...]}.
Json read_declarations(const Json& request);

/// Likewise: formats insertions and new files with the .clang-format above them.
Json format_parts(const Json& request);

/// {"unit": {"file", "directory", "arguments"}, "headers": ["robot/types.hpp"], "namespace": "soccer", "names":
/// ["soccer::GamePhase"]} -> {"types": [...], "paths", "files", "errors"}. Of each name {"complete", "at", "enum":
/// {"at", "enumerators": [{"name", "value", "at"}]}}, `enum` only of one; {"wrong": "..."} if there is no such type.
/// The unit's file is not read: its name only decides where headers are searched.
Json report_types(const Json& request);

/// {"units": [{"file", "directory", "arguments", "deep"}], "namespace": "soccer"} -> {"units": [...]}, in the same
/// order. `deep`: also the effects of the standard library, to find what blocks; that takes longer. Of each
/// {"functions", "classes", "aliases", "paths", "files", "errors"}; compiler/facts/code.cpp reads them. Places are [row
/// of `paths`, begin, end] in bytes; `files` are [path, is a system header].
Json report_facts(const Json& request);

} // namespace director::scanning
