#pragma once
// SPDX-License-Identifier: MIT
// The robot's engine on lowered tables, with the bodies that `directorc simulate` uses, one micro-step at a time. What
// it decides by can be saved and put into a new engine at any micro-step.

#include "compiler/play/recorder.hpp"
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
  bool micro_step(); ///< false: it rests, the step is over
  Snapshot snapshot() const;
  const std::vector<std::string>& trace() const { return trace_; }
  /// All that the observer was told, with the times of an engine that was never cut.
  const std::vector<tests::EventNumbers>& events() const { return events_; }
  const Engine& engine() const { return robot_->engine; }
  /// From now on every component is decided whole, or none is.
  void decide_whole(bool whole) { robot_->engine.set_most_decided_whole(whole ? nil : 0); }
  /// The next micro-step decides everything again.
  void forget_trail() { robot_->engine.forget_trail(); }

  /// Goes on with a new engine, which stands at a time that is later by so much and knows only what was saved. If
  /// nothing could be saved or loaded, all stays as it is. `bytes`: what was saved.
  SaveResult cut(Time later, std::vector<std::byte>& bytes);
  /// What waits in the inbox is lost, and it goes on from these bytes instead; false: they are refused.
  LoadResult load(std::span<const std::byte> bytes);

private:
  /// All that belongs to one engine.
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
  compiler::Recorder recorder_;
  bool leap_;
  Time now_ = 0, until_ = 0;
  Time shift_ = 0; ///< the engine's time is so much later
  std::vector<tests::EventNumbers> events_;
  std::unique_ptr<Robot> robot_;
};

} // namespace director::property
