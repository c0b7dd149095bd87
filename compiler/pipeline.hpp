#pragma once
// SPDX-License-Identifier: MIT
// From a path to a checked model: the first step of every command that reads a behaviour.

#include "compiler/checks/run_checks.hpp"
#include "compiler/facts/types.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"
#include "dsl/source/file_access.hpp"
#include "dsl/source/source_file.hpp"
#include "dsl/spec.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace director::compiler {

struct SearchProgress;
struct Verdict;

struct CheckOptions {
  checks::Selection selection;
  std::size_t decide = 0;                                       ///< also decide the assertions, in so many states; 0: no
  std::size_t explore = 0;                                      ///< also find what never runs, in so many states; 0: no
  std::function<void(const SearchProgress& so_far)> progress{}; ///< of exploring, called now and then
  TypeReader* types = nullptr;                                  ///< the reader of C++; null: none
};

/// For callers that report no warnings: searching them takes most of the time of a check.
inline CheckOptions only_errors() {
  CheckOptions out;
  out.selection.only_errors = true;
  return out;
}

struct Checked {
  dsl::Spec spec;                                       ///< empty: the path itself cannot be read
  Model model;                                          ///< valid only if `resolved`
  Graph graph;                                          ///< likewise
  bool resolved = false;                                ///< no errors of "Reading" and "Names and domains"
  bool lowerable = false;                               ///< resolved, and nothing prevents running it in the engine
  std::vector<dsl::Diagnostic> findings;                ///< sorted by place
  std::vector<dsl::Diagnostic> allowed;                 ///< findings that an `allow` covers
  std::vector<std::string> headers;                     ///< the user's, that were read for their types
  std::string types_fault;                              ///< why some types of C++, or all, were not read; or empty
  std::shared_ptr<const std::vector<Verdict>> verdicts; ///< of the assertions of the Model; null: not decided
  std::vector<std::string> undecided;                   ///< assertions, and what exploring left open, each in a line
};

Checked check(const std::string& path, dsl::FileAccess& files, dsl::Sources& sources, const CheckOptions& options = {});

} // namespace director::compiler
