#pragma once
// SPDX-License-Identifier: MIT
// Providers and handlers that act by a scenario's script, in place of a robot's C++.

#include "compiler/play/data_slots.hpp"
#include "compiler/play/onlooker.hpp"
#include "compiler/play/scenario/scenario.hpp"
#include "runtime/core/engine/run.hpp"

namespace director::compiler {

/// What the language calls a reason, in the engine's words.
director::Reason engine_reason(dsl::Reason reason);

class ScriptedBodies {
public:
  /// The scenario, the tables and the onlooker, if there is one, must outlive this.
  ScriptedBodies(const Scenario& scenario, const Tables& tables, const Onlooker* onlooker = nullptr);
  ScriptedBodies(const ScriptedBodies&) = delete;
  ScriptedBodies& operator=(const ScriptedBodies&) = delete;

  Bodies table(); ///< of functions that call this object; valid during its lifetime
  DataSlots& data() { return data_; }
  /// Why a body could not do what its script requires. Its run was a fault, and the scenario ends there.
  const std::optional<dsl::Diagnostic>& refused() const { return refused_; }

private:
  Outcome run(Run& run);
  void handle(Handling& handling, const IdTable<GroupId, Body>& bodies, std::vector<std::int64_t>& counts);
  bool holds(const Case& each, const Run& run, std::int64_t count) const;
  bool holds(const UseGuard& guard, const Run& run) const;
  bool has_data(const Case& each, DataPlace place) const;

  const Scenario& scenario_;
  const Tables& tables_;
  const Onlooker* onlooker_;
  DataSlots data_;
  std::vector<std::int64_t> runs_, starts_, stops_; ///< of each provider and group, how many there were
  std::optional<dsl::Diagnostic> refused_;
};

} // namespace director::compiler
