#pragma once
// SPDX-License-Identifier: MIT
// All stages from texts to something that runs, in memory: reader, resolve, lower, and the scenario for both sides.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "compiler/play/scenario/scenario.hpp"
#include "dsl/scenario_spec.hpp"
#include "tests/property/document.hpp"

#include <memory>
#include <string>

namespace director::property {

struct Compiled {
  compiler::Model model;
  compiler::Lowered lowered;
  dsl::ScenarioSpec spec;      ///< for the oracle
  compiler::Scenario scenario; ///< for the engine
};

struct CompileResult {
  std::unique_ptr<Compiled> compiled; ///< nothing if it cannot be run
  std::string why;
};

CompileResult compile(const std::string& behaviour, const std::string& scenario);

} // namespace director::property
