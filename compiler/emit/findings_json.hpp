#pragma once
// SPDX-License-Identifier: MIT
// Findings for other programs: lines and columns from 1, columns in UTF-8 bytes, ends exclusive.

#include "compiler/base/json.hpp"
#include "dsl/source/diagnostic.hpp"
#include "dsl/source/source_file.hpp"

#include <vector>

namespace director::compiler {

/// File, line and column.
Json place_json(const dsl::Span& span, const dsl::Sources& sources);

/// A note: its place and its message.
Json note_json(const dsl::Note& note, const dsl::Sources& sources);

Json finding_json(const dsl::Diagnostic& finding, const dsl::Sources& sources);

/// All of them: `{"findings": [...]}`.
Json findings_json(const std::vector<dsl::Diagnostic>& findings, const dsl::Sources& sources);

} // namespace director::compiler
