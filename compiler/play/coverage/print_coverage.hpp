#pragma once
// SPDX-License-Identifier: MIT
// Coverage as text and as JSON.

#include "compiler/base/json.hpp"
#include "compiler/play/coverage/coverage.hpp"
#include "dsl/source/source_file.hpp"

#include <string>

namespace director::compiler {

struct CoverageReport {
  std::string behaviour; ///< the path of its file
  std::size_t scenarios = 0;
  Coverage coverage;

  struct Missing {
    CoverageClass of = CoverageClass::providers;
    std::string path;
    std::uint32_t line = 1, column = 1; ///< from 1
    std::string text;                   ///< `Walk.halting` never ran
  };
  std::vector<Missing> missing; ///< what is not covered, in the order of the points
};

/// Every point in words, covered or not.
std::vector<CoverageReport::Missing> coverage_texts(const Coverage& coverage, const Model& model,
                                                    const dsl::Sources& sources);

/// A line for each class, and below it what is missing.
std::string to_text(const CoverageReport& report);
Json to_json(const CoverageReport& report);

} // namespace director::compiler
