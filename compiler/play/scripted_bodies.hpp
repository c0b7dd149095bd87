#pragma once
// SPDX-License-Identifier: MIT
// Providers and handlers that act by a scenario's script, in place of a robot's C++.

#include "compiler/play/data_slots.hpp"
#include "compiler/play/onlooker.hpp"
#include "compiler/play/scenario/scenario.hpp"
#include "runtime/core/engine/run.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

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
  /// How often a body or handler was called, and how many cases at its front were for an earlier call.
  struct Calls {
    std::int64_t count = 0;
    std::size_t passed = 0;
  };
  static std::span<const Case> cases_of_next_call(const Body& body, Calls& calls);
  void handle(Handling& handling, const IdTable<GroupId, Body>& bodies, std::vector<Calls>& calls);
  bool holds(const Case& each, const Run& run, std::int64_t count) const;
  bool holds(const UseGuard& guard, const Run& run) const;
  bool has_data(const Case& each, DataPlace place) const;

  const Scenario& scenario_;
  const Tables& tables_;
  const Onlooker* onlooker_;
  DataSlots data_;
  std::vector<Calls> runs_, starts_, stops_; ///< of each provider and group
  std::optional<dsl::Diagnostic> refused_;
};

} // namespace director::compiler
