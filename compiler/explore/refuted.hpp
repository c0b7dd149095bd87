#pragma once
// SPDX-License-Identifier: MIT
// Reports assertions that are not true. Their page: compiler/checks/assertion_failed.md.

#include "compiler/explore/verdict.hpp"
#include "dsl/source/diagnostic.hpp"

namespace director::compiler {

/// assertion_failed, for each that is refuted.
std::vector<dsl::Diagnostic> refuted_assertions(const Model& model, const std::vector<Verdict>& verdicts);

/// Those that are not decided, each in a line with the reason.
std::vector<std::string> undecided_assertions(const Model& model, const std::vector<Verdict>& verdicts);

} // namespace director::compiler
