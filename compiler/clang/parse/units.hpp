#pragma once
// SPDX-License-Identifier: MIT
// Units in JSON: as in requests, and the report about how one was read.

#include "compiler/base/json.hpp"
#include "compiler/clang/parse/parse.hpp"

namespace director::scanning {

/// From {"file", "directory", "arguments": [...], "deep"}.
Unit unit_of(const compiler::Json& json);

/// Adds `files` as [path, is a system header], and `errors` as {"message", "file", "line", "column"}.
void report_reading(compiler::Json& answer, const Reading& reading);

} // namespace director::scanning
