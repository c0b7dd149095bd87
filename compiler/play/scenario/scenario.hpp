#pragma once
// SPDX-License-Identifier: MIT
// A scenario with every name resolved in its Model: the input of the player.

#include "compiler/model/model.hpp"
#include "dsl/data.hpp"
#include "dsl/scenario_spec.hpp"
#include "dsl/source/diagnostic.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

/// A request for a task by a body or the program.
struct RequestedTask {
  EdgeId edge{};
  std::uint32_t level = 0; ///< of Edge::levels
  std::optional<dsl::Data> data;
  bool keep = false;
};

struct Setting {
  StateId state{};
  std::int64_t value = 0;
};

struct UseGuard {
  std::optional<EdgeId> edge; ///< empty: no provider of the group requests or needs it, so it reads `none`
  dsl::UseState state = dsl::UseState::none;
};

/// One case of a provider or a handler: the first whose guards hold applies.
struct Case {
  std::optional<dsl::Reason> reason;
  std::optional<TriggerId> trigger;
  std::optional<dsl::Data> data;
  std::optional<std::int64_t> run;
  std::vector<UseGuard> uses;

  enum class Answer { pack, done, failed, keep };
  Answer answer = Answer::pack;
  std::optional<std::uint32_t> named_pack; ///< place among Provider::packs, where these have names
  std::vector<RequestedTask> pack;
  std::vector<Setting> set;
  Microseconds wait = 0; ///< 0: none

  /// Why this provider cannot do it, if an entry is for several providers of a group and others can.
  std::optional<dsl::Diagnostic> refused;
};

using Body = std::vector<Case>;

struct ScenarioInput {
  dsl::InputSpec::Kind kind = dsl::InputSpec::Kind::request;
  std::vector<RequestedTask> requests; ///< of request
  EdgeId root{};                       ///< of cancel
  std::vector<Setting> set;            ///< of set
  TriggerId trigger{};                 ///< of trigger
  ProviderId provider{};               ///< of enable and disable
};

struct ScenarioStep {
  std::optional<Microseconds> advance; ///< else inputs that are queued together
  std::vector<ScenarioInput> inputs;
  std::vector<std::string> shown; ///< `request Walk`
  std::optional<dsl::ExpectSpec> expect;
  Span span{};
};

struct Scenario {
  std::string title;
  std::vector<Setting> given;
  IdTable<ProviderId, Body> bodies;
  IdTable<GroupId, Body> start_handlers, stop_handlers;
  std::vector<ScenarioStep> steps;
};

} // namespace director::compiler
