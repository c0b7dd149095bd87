#pragma once
// SPDX-License-Identifier: MIT
// The whole way from texts to something that runs, in memory: reader, resolve, lower, and the scenario for both sides.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "compiler/play/scenario.hpp"
#include "dsl/scenario_spec.hpp"
#include "tests/property/document.hpp"

#include <memory>
#include <string>

namespace director::property {

struct Compiled {
  compiler::Model model;
  compiler::Lowered lowered;
  dsl::ScenarioSpec spec;      ///< what the oracle plays
  compiler::Scenario scenario; ///< what the engine plays
};

struct CompileResult {
  std::unique_ptr<Compiled> compiled; ///< nothing where it cannot be run
  std::string why;
};

CompileResult compile(const std::string& behaviour, const std::string& scenario);

} // namespace director::property
