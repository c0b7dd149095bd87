#pragma once
// SPDX-License-Identifier: MIT
// A running engine made of the text of a behaviour, with lambdas as bodies, for tests of runtime/core. Events are kept
// as lines: `run Walk.halting pushed`, `start Walk`, `queue root>Kick waiting`.

#include "compiler/lower/lower.hpp"
#include "runtime/core/engine/engine.hpp"
#include "runtime/hosted/engine_memory.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace director::tests {

using Lines = std::vector<std::string>;

class Machine {
public:
  using Body = std::function<Outcome(Run&)>;
  using Handler = std::function<void(Handling&)>;

  explicit Machine(const std::string& behaviour, std::size_t inbox = 64);

  /// Sets the body of `Walk.halting` or `Kick`; by default a provider requests all that it may, at the first level.
  Machine& body(const std::string& provider, Body body);
  Machine& handler(const std::string& group, Handler handler); ///< `Walk.start`

  bool request(const std::string& group, const std::string& level = "");
  bool cancel(const std::string& group);
  bool set(const std::string& state, const std::string& value);
  bool fire(const std::string& trigger);
  bool enable(const std::string& provider, bool on);

  /// Steps and returns its lines; the kinds that `shown` names are left out if not there.
  Lines step(Time now = 0);
  StepResult result() const { return result_; } ///< of the last step

  Engine& engine() { return *engine_; }
  const Engine& engine() const { return *engine_; }
  Inbox& inbox() { return inbox_; }
  const compiler::Model& model() const { return compiled_.model; }
  const Tables& tables() const { return tables_; }
  std::span<std::byte> memory() { return memory_.state(); }
  Index edge(const std::string& name) const { return static_cast<Index>(compiled_.edge(name).value); }
  Index group(const std::string& name) const { return static_cast<Index>(compiled_.group(name).value); }
  Index state(const std::string& name) const { return static_cast<Index>(compiled_.model.find_state(name)->value); }
  std::int32_t value(const std::string& state, const std::string& value) const;
  Index level(Index edge, std::size_t place = 0) const {
    return static_cast<Index>(tables_.edges[edge].levels.begin + place);
  }
  Outcome everything(Run& run) const;

  bool decisions = false; ///< also queue, push, release, grant and lose
  bool requests = false;  ///< also the requests of runs
  bool answers =
      false;        ///< also answers and values of runs, values set before the first step, and inputs with their times
  Lines data_moves; ///< `settle root>Kick`

private:
  void handle(Handling& handling, const char* which); ///< `.start`
  void observe(const Event& event);
  std::string provider_name(Index provider) const;
  std::string edge_name(Index edge) const;

  Compiled compiled_;
  compiler::Lowered lowered_;
  Tables tables_;
  EngineMemory memory_;
  std::vector<Inbox::Cell> cells_;
  Inbox inbox_;
  std::map<Index, Body> bodies_;
  std::map<std::string, Handler> handlers_;
  std::unique_ptr<Engine> engine_;
  Lines lines_;
  StepResult result_ = StepResult::quiescent;
};

} // namespace director::tests
