#pragma once
// SPDX-License-Identifier: MIT
// Spec -> Model: every name is looked up, every value numbered, every edge declared. Findings are those of "Names and
// domains"; all of a run, sorted by place, without consequences of others. With an error among them the Model is
// incomplete, and only good for names. Source: semantics.md, section 1, and the language page.

#include "compiler/facts/types.hpp"
#include "compiler/model/model.hpp"
#include "dsl/source/diagnostic.hpp"
#include "dsl/source/source_file.hpp"
#include "dsl/spec.hpp"

#include <string>
#include <vector>

namespace director::compiler {

struct ResolveOptions {
  std::vector<std::string> check_ids; ///< ids for `allow`; empty: any
  TypeReader* reader = nullptr;       ///< the reader of C++; null: none
  const Types* types = nullptr;       ///< what it read; null: it was not used
};

struct Resolved {
  Model model;
  std::vector<dsl::Diagnostic> findings;
};

/// `sources` only for the files' names: a module has the name of its file.
Resolved resolve(const dsl::Spec& spec, const dsl::Sources& sources, const ResolveOptions& options = {});

} // namespace director::compiler
