#pragma once
// SPDX-License-Identifier: MIT
// The threads of this process, for tests of what scheduling and which signals a thread has that is not the test's own.

#include <sched.h>
#include <sys/resource.h>
#include <sys/types.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <set>
#include <string>
#include <thread>

namespace director::tests {

inline std::set<pid_t> threads() {
  std::set<pid_t> all;
  for (const auto& each : std::filesystem::directory_iterator("/proc/self/task"))
    all.insert(static_cast<pid_t>(std::stol(each.path().filename().string())));
  return all;
}

struct Scheduling {
  int policy = -1, nice = -1;
  bool operator==(const Scheduling&) const = default;
};

/// How the thread that `make()` starts is scheduled after a moment, if the thread that calls it is made by `prepare()`;
/// of several threads one that is not scheduled as usual, if there is one.
/// `prepare` returns false where the system does not allow it; then the result is Scheduling{}.
template <class Prepare, class Make>
Scheduling scheduling_of_new_thread(Prepare prepare, Make make) {
  Scheduling result;
  std::thread([&] {
    if (!prepare()) return;
    const std::set<pid_t> before = threads();
    const auto owner = make();
    std::this_thread::sleep_for(std::chrono::milliseconds(100)); // until it has set its own priority
    for (const pid_t each : threads()) {
      if (!before.contains(each) && (result == Scheduling{} || result.policy == SCHED_OTHER))
        result = {sched_getscheduler(each), getpriority(PRIO_PROCESS, static_cast<id_t>(each))};
    }
  }).join();
  return result;
}

/// Whether this thread gets a signal to the process that it blocks only now, and waits for. Otherwise another thread
/// takes it, and the process ends.
inline bool gets_signal_that_it_waits_for() {
  sigset_t wanted, before;
  sigemptyset(&wanted);
  sigaddset(&wanted, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &wanted, &before);
  kill(getpid(), SIGTERM);
  const timespec ten_seconds{10, 0};
  const bool out = sigtimedwait(&wanted, nullptr, &ten_seconds) == SIGTERM;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return out;
}

inline bool become_nice() { return setpriority(PRIO_PROCESS, 0, 15) == 0; }

inline bool become_real_time() {
  sched_param parameters{};
  parameters.sched_priority = 1;
  return sched_setscheduler(0, SCHED_FIFO, &parameters) == 0;
}

} // namespace director::tests
