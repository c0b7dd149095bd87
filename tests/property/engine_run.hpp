#pragma once
// SPDX-License-Identifier: MIT
// The engine on lowered tables, with the bodies of `directorc simulate`, one micro-step at a time. Its state can be
// saved and loaded into a new engine at any micro-step.

#include "compiler/play/event_converter.hpp"
#include "compiler/play/scripted_bodies.hpp"
#include "runtime/core/engine/engine.hpp"
#include "runtime/core/saved/saved_state.hpp"
#include "runtime/hosted/engine_memory.hpp"
#include "tests/property/compiled.hpp"
#include "tests/property/snapshot.hpp"
#include "tests/support/numbers_of_event.hpp"

#include <memory>

namespace director::property {

class EngineRun {
public:
  /// `leap`: all of an `advance` at once.
  EngineRun(const Compiled& compiled, bool leap);
  EngineRun(const EngineRun&) = delete;
  EngineRun& operator=(const EngineRun&) = delete;

  void begin_step(const compiler::ScenarioStep& step);
  bool micro_step(); ///< false: at rest, the step is over
  Snapshot snapshot() const;
  const std::vector<std::string>& trace() const { return trace_; }
  /// All events of the observer, with the times of an engine that was not interrupted.
  const std::vector<tests::EventNumbers>& events() const { return events_; }
  const Engine& engine() const { return robot_->engine; }
  /// From now on every component is decided whole, or none is.
  void decide_whole(bool whole) { robot_->engine.set_most_decided_whole(whole ? nil : 0); }
  /// Makes the next micro-step decide everything again.
  void forget_trail() { robot_->engine.forget_trail(); }

  /// Continues with a new engine, whose time is later by `shift` and which has only what was saved. If nothing could be
  /// saved or loaded, all stays as it is. `bytes`: the saved bytes.
  SaveResult cut(Time later, std::vector<std::byte>& bytes);
  /// Continues from these bytes, without the inputs that wait in the inbox; false: they are refused.
  LoadResult load(std::span<const std::byte> bytes);

private:
  /// One engine with its memory.
  struct Robot {
    Robot(const Tables& tables, const Bodies& bodies, const Observer& observer);
    std::vector<Inbox::Cell> cells;
    Inbox inbox;
    EngineMemory memory;
    Engine engine;
  };
  std::unique_ptr<Robot> robot();
  void post(const compiler::ScenarioInput& input);

  const Compiled& compiled_;
  const Tables tables_;
  std::vector<std::string> trace_;
  const compiler::Sink sink_;
  compiler::ScriptedBodies bodies_;
  compiler::EventConverter recorder_;
  bool leap_;
  Time now_ = 0, until_ = 0;
  Time shift_ = 0; ///< how much later the engine's time is
  std::vector<tests::EventNumbers> events_;
  std::unique_ptr<Robot> robot_;
};

} // namespace director::property
