#pragma once
// SPDX-License-Identifier: MIT
// Scenarios and the tables of their behaviours as the constants of tests/system/arm/target/plan.hpp.

#include "compiler/cli/input/load_scenario.hpp"
#include "compiler/emit/artefact/code.hpp"

#include <map>
#include <string>
#include <vector>

namespace director::tests {

class PlanText {
public:
  /// Scenarios of one behaviour share its tables.
  void add(const std::string& title, const dsl::Sources& sources, const compiler::cli::LoadedScenario& loaded);
  std::string text() const;

private:
  std::size_t behaviour(const dsl::Sources& sources, const compiler::cli::LoadedScenario& loaded);

  std::map<std::string, std::size_t> behaviours_; ///< text -> number
  compiler::Code code_;
  std::vector<std::string> plans_;
};

} // namespace director::tests
