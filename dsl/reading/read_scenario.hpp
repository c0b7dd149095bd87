#pragma once
// SPDX-License-Identifier: MIT
// Reads a scenario file, without the behaviour that it names. Source: docs/scenarios.md.

#include "dsl/scenario_spec.hpp"
#include "dsl/source/diagnostic.hpp"
#include "dsl/source/file_access.hpp"
#include "dsl/source/source_file.hpp"

#include <string>
#include <vector>

namespace director::dsl {

struct ReadScenarioResult {
  ScenarioSpec scenario;
  std::vector<Diagnostic> diagnostics; ///< sorted by place
  bool readable = true;                ///< false: the file itself cannot be read, and that is the only finding
};

/// The file is added to `sources`. Where it cannot be read: import_not_found at the beginning of an empty text.
ReadScenarioResult read_scenario(const std::string& path, FileAccess& files, Sources& sources);

} // namespace director::dsl
