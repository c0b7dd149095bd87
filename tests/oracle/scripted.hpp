#pragma once
// SPDX-License-Identifier: MIT
// Plays a scenario file on the oracle: scripted bodies and listed inputs, as in the second half of the language page.
// It works on the scenario as written; names are resolved when they are used. Errors in a scenario are thrown.

#include "dsl/scenario_spec.hpp"
#include "tests/oracle/behaviour.hpp"

namespace director::oracle {

class Script final : public Bodies {
public:
  Script(const Model& model, const dsl::ScenarioSpec& scenario) : model_(model), scenario_(scenario) {}

  Commit run(const Sight& sight) override;
  Settings start(GroupId group, const std::optional<dsl::Data>& data) override { return handle(group, "start", data); }
  Settings stop(GroupId group, const std::optional<dsl::Data>& data) override { return handle(group, "stop", data); }

  Input input(const dsl::InputSpec& spec) const;
  std::pair<StateId, std::int64_t> setting(const dsl::SettingSpec& spec) const;

private:
  Settings handle(GroupId group, const std::string& which, const std::optional<dsl::Data>& data);
  const std::vector<dsl::CaseSpec>* cases(const std::string& group, const std::string& part) const;
  bool applies(const dsl::CaseSpec& spec, const Sight& sight, std::int64_t count) const;
  bool applies(const dsl::UseGuardSpec& spec, const Sight& sight) const;
  Commit commit(const dsl::CaseSpec& spec, const compiler::Provider& provider) const;
  Asked asked(const std::vector<compiler::Task>& tasks, const dsl::RequestSpec& spec) const;
  Settings settings(const std::vector<dsl::SettingSpec>& specs) const;

  const Model& model_;
  const dsl::ScenarioSpec& scenario_;
  std::map<ProviderId, std::int64_t> runs_;
  std::map<std::pair<GroupId, std::string>, std::int64_t> handled_;
};

/// As `directorc test` runs it: with the budget each time that the engine runs, and each due time by itself. Or, with
/// `leap`, all of an `advance` at once.
class Player {
public:
  static constexpr int budget = 10'000;

  Player(const Model& model, const dsl::ScenarioSpec& scenario, bool leap = false);

  Behaviour& behaviour() { return behaviour_; }

  // A step is begun, then taken one micro-step at a time until there is none left.
  void begin_step(const dsl::StepSpec& step);
  bool micro_step(); ///< false: the step is over
  bool exhausted() const { return exhausted_; }

  /// The lines of a whole step, `budget_exhausted` included.
  std::vector<std::string> play(const dsl::StepSpec& step);

private:
  Script script_;
  Behaviour behaviour_;
  Time now_ = 0, until_ = 0;
  int spent_ = 0;
  bool leap_;
  bool exhausted_ = false;
};

} // namespace director::oracle
