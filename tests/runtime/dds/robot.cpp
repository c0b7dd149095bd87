// Header: tests/runtime/dds/robot.hpp. Test: the tests beside it.
// SPDX-License-Identifier: MIT
#include "tests/runtime/dds/robot.hpp"

#include <algorithm>

namespace director::tests {

namespace {

const char* name_of(dds::Notice::Kind kind) {
  constexpr const char* all[] = {"joined",     "restarted",      "gone",          "lost",       "twin",
                                 "other",      "incompatible",   "unknown_value", "bad_sample", "refused",
                                 "inbox_full", "decisions_lost", "not_written"};
  return all[static_cast<std::size_t>(kind)];
}

} // namespace

bool comes_true(const std::function<bool()>& what, std::chrono::milliseconds at_most) {
  const auto end = std::chrono::steady_clock::now() + at_most;
  while (!what()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(2ms);
  }
  return true;
}

dds::Plug plug(courier::Behaviour& behaviour) {
  namespace names = courier::names;
  return dds::plug("courier", behaviour,
                   {names::group, names::provider, names::edge, names::state, names::value, names::condition});
}

Index state_row(const std::string& name) {
  Index row = 0;
  while (name != courier::names::state(row)) ++row;
  return row;
}

Robot::Robot(dds::Settings settings)
    : bridge(tests::plug(behaviour), outbox, [this, &settings] {
        settings.domain = loopback_domain();
        settings.notice = [this](const dds::Notice& notice) {
          const std::lock_guard lock(mutex_);
          notices_.push_back(std::string(name_of(notice.kind)) + " " + notice.robot + ": " + notice.text);
        };
        return settings;
      }()) {}

void Robot::step() {
  behaviour.step(std::chrono::steady_clock::now() - begin_);
  bridge.stepped();
}

bool Robot::comes_true(const std::function<bool()>& what) {
  return tests::comes_true([&] {
    step();
    return what();
  });
}

std::vector<std::string> Robot::notices() {
  const std::lock_guard lock(mutex_);
  return notices_;
}

bool Robot::was_told(const std::string& notice) {
  const std::lock_guard lock(mutex_);
  return std::ranges::find(notices_, notice) != notices_.end();
}

} // namespace director::tests
