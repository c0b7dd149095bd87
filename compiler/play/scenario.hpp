#pragma once
// SPDX-License-Identifier: MIT
// A scenario with every name looked up in the Model that it is about: what the player of scenarios works on.

#include "compiler/model/model.hpp"
#include "dsl/data.hpp"
#include "dsl/diagnostic.hpp"
#include "dsl/scenario_spec.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

/// A task as a body or the program asks for it.
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
  std::optional<EdgeId> edge; ///< nothing: nobody of the group asks for it or needs it, so it reads `none`
  dsl::UseState state = dsl::UseState::none;
};

/// One way in which a provider or a handler behaves: the first whose guards hold.
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

  /// Why this provider cannot behave so, where an entry is for several providers of a group and others can.
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
