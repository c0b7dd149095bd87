#pragma once
// SPDX-License-Identifier: MIT
// The robot's engine on lowered tables, with the bodies that `directorc simulate` uses, one micro-step at a time.

#include "compiler/play/recorder.hpp"
#include "compiler/play/scripted_bodies.hpp"
#include "runtime/core/engine/engine.hpp"
#include "runtime/hosted/engine_memory.hpp"
#include "tests/property/compiled.hpp"
#include "tests/property/snapshot.hpp"

namespace director::property {

class EngineRun {
public:
  /// `leap`: all of an `advance` at once.
  EngineRun(const Compiled& compiled, bool leap);
  EngineRun(const EngineRun&) = delete;
  EngineRun& operator=(const EngineRun&) = delete;

  void begin_step(const compiler::ScenarioStep& step);
  bool micro_step(); ///< false: it rests, the step is over
  Snapshot snapshot() const;
  const std::vector<std::string>& trace() const { return trace_; }
  const Engine& engine() const { return engine_; }

private:
  void post(const compiler::ScenarioInput& input);

  const Compiled& compiled_;
  const Tables tables_;
  std::vector<std::string> trace_;
  const compiler::Sink sink_;
  compiler::ScriptedBodies bodies_;
  compiler::Recorder recorder_;
  std::vector<Inbox::Cell> cells_;
  Inbox inbox_;
  EngineMemory memory_;
  Engine engine_;
  bool leap_;
  Time now_ = 0, until_ = 0;
};

} // namespace director::property
