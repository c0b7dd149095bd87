#pragma once
// SPDX-License-Identifier: MIT
// Spec -> Model: every name is looked up, every value numbered, every edge declared. Findings are those of "Names and
// domains"; all of a run, sorted by place, none that is only the consequence of another one. With an error among them
// the Model is complete as far as it goes, and good for nothing but naming things. Source: semantics.md, section 1, and
// the language page.

#include "compiler/facts/types.hpp"
#include "compiler/model/model.hpp"
#include "dsl/diagnostic.hpp"
#include "dsl/source_file.hpp"
#include "dsl/spec.hpp"

#include <string>
#include <vector>

namespace director::compiler {

struct ResolveOptions {
  std::vector<std::string> check_ids; ///< what `allow` may name; empty: anything
  TypeReader* reader = nullptr;       ///< what C++ is read with; nothing: it cannot be read here
  const Types* types = nullptr;       ///< what it told; nothing: it was not asked
};

struct Resolved {
  Model model;
  std::vector<dsl::Diagnostic> findings;
};

/// `sources` only for the files' names: a module is called after its file.
Resolved resolve(const dsl::Spec& spec, const dsl::Sources& sources, const ResolveOptions& options = {});

} // namespace director::compiler
