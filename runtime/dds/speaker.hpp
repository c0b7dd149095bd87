#pragma once
// SPDX-License-Identifier: MIT
// The half of a bridge that speaks: a thread of its own writes what the behaviour became and decided. It says the
// states again and again, but only as long as somebody steps: a robot whose main loop hangs falls silent.

#include "runtime/dds/decision.hpp"
#include "runtime/dds/entity.hpp"
#include "runtime/dds/notes.hpp"
#include "runtime/dds/outbox.hpp"
#include "runtime/dds/plan.hpp"

#include <semaphore.h>

#include <atomic>
#include <thread>
#include <vector>

namespace director::dds {

class Speaker {
public:
  Speaker(const Entity& participant, const Settings& settings, const Plug& plug, const Plan& plan, Outbox& outbox,
          Notes& notes, std::uint64_t session);
  ~Speaker();

  /// From the thread that steps, after a step.
  void stepped();

private:
  struct Published {
    Index state = nil;
    std::string name;
    std::int32_t said = 0;
    bool ever = false;
  };

  void speak();
  void wake();
  void wait_until(std::chrono::steady_clock::time_point when);
  void say_member();
  void say_goodbye();
  void say_what_was_decided();
  void say_states(bool again);
  void say_state(const Published& state, std::int32_t value);
  void say_decision(const Outbox::Told& told);
  void say_promise(const Event& event);
  template <class Sample>
  void say(const Entity& writer, const Sample& sample, std::uint64_t Counts::*counter);

  const Settings& settings_;
  const Plug& plug_;
  Outbox& outbox_;
  Notes& notes_;
  const std::uint64_t session_;
  const std::string specification_;
  Promises promises_;
  Entity members_, states_, decisions_, kept_; // writers
  std::vector<Published> published_;
  std::uint64_t lost_ = 0;

  // Between the two threads.
  std::vector<std::atomic<std::int32_t>> values_; ///< of `published_`, after the last step
  std::atomic<std::uint64_t> steps_{0};
  std::atomic<bool> awake_{false}, stopping_{false};
  sem_t bell_;
  std::thread thread_;
};

} // namespace director::dds
