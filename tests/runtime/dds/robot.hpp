#pragma once
// SPDX-License-Identifier: MIT
// A robot with the courier's behaviour (tests/system/api) and a bridge, and conditions to wait for.

#include "runtime/dds/bridge.hpp"
#include "tests/runtime/dds/loopback.hpp"
#include "tests/system/api/office.hpp"

#include <chrono>
#include <functional>
#include <mutex>
#include <thread>

namespace director::tests {

using namespace std::chrono_literals;

/// Longer than anything takes; a test that reaches it has failed.
inline constexpr auto patience = 20s;

/// Waits until the condition is true; false after `patience`.
bool comes_true(const std::function<bool()>& what, std::chrono::milliseconds at_most = patience);

dds::Plug plug(courier::Behaviour& behaviour);
Index state_row(const std::string& name);

class Robot {
public:
  explicit Robot(dds::Settings settings);

  void step(); ///< and calls the bridge
  /// Steps until the condition is true.
  bool comes_true(const std::function<bool()>& what);
  std::int32_t value(const std::string& state) { return behaviour.engine().value(state_row(state)); }

  /// The notices, as "kind robot: text".
  std::vector<std::string> notices();
  bool was_told(const std::string& notice);

  Plans plans;
  Skills skills;
  dds::Outbox outbox{64};
  courier::Behaviour behaviour{plans, skills, outbox.observer()};

private:
  std::mutex mutex_;
  std::vector<std::string> notices_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();

public:
  dds::Bridge bridge;
};

} // namespace director::tests
