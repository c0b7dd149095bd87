#pragma once
// SPDX-License-Identifier: MIT
// The sending half of a bridge: a thread publishes states and decisions. It repeats the states as long as steps are
// taken: a robot whose main loop hangs stops publishing.

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
  Speaker(const Entity& participant, const SettingsView& settings, const Plug& plug, const Plan& plan, Outbox& outbox,
          Notes& notes, std::uint64_t session);
  ~Speaker();

  /// To be called from the thread that steps, after a step.
  void stepped();

private:
  struct Published {
    Index state = nil;
    std::string name;
    std::int32_t published = 0;
    bool ever = false;
  };

  void run();
  void wake();
  void wait_until(std::chrono::steady_clock::time_point when);
  void publish_member();
  void dispose_all();
  void publish_decisions();
  void publish_states(bool again);
  void publish_state(const Published& state, std::int32_t value);
  void publish_decision(const Outbox::Entry& entry);
  void publish_promise(const Event& event);
  template <class Sample>
  void publish(const Entity& writer, const Sample& sample, std::uint64_t Counts::*counter);

  const SettingsView& settings_;
  const Plug& plug_;
  Outbox& outbox_;
  Notes& notes_;
  const std::uint64_t session_;
  const std::string specification_;
  Promises promises_;
  Entity members_, states_, decisions_, kept_; // writers
  std::vector<Published> published_;
  std::uint64_t lost_ = 0;

  // Shared by the two threads.
  std::vector<std::atomic<std::int32_t>> values_; ///< of `published_`, after the last step
  std::atomic<std::uint64_t> steps_{0};
  std::atomic<bool> awake_{false}, stopping_{false};
  sem_t semaphore_;
  std::thread thread_;
};

} // namespace director::dds
