#pragma once
// SPDX-License-Identifier: MIT
// Threads that write or send what a behaviour does, beside the one that steps.

#include <pthread.h>
#include <sched.h>

#include <csignal>
#include <thread>
#include <utility>

namespace director {

/// Gives the calling thread the normal scheduling, if it has inherited a real-time priority from the thread that made
/// it: that is meant for the thread that steps, which another one of the same priority would delay. Without regard to
/// whether pthread_getschedparam() calls it real-time: glibc answers what held before the program's
/// sched_setscheduler().
inline void leave_real_time() {
  sched_param parameters{};
  int policy = SCHED_OTHER;
  if (pthread_getschedparam(pthread_self(), &policy, &parameters) != 0) return;
  parameters.sched_priority = 0;
#if defined(SCHED_BATCH) && defined(SCHED_IDLE)
  if (policy == SCHED_BATCH || policy == SCHED_IDLE) return; // these are lower
#endif
  pthread_setschedparam(pthread_self(), SCHED_OTHER, &parameters);
}

/// While it lives, signals of the program are not handled by this thread, nor by those that it starts, except those for
/// crashes of these.
class WithoutSignals {
public:
  WithoutSignals() {
    sigset_t others;
    sigfillset(&others);
    for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS}) sigdelset(&others, crash);
    pthread_sigmask(SIG_SETMASK, &others, &before_);
  }
  ~WithoutSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  WithoutSignals(const WithoutSignals&) = delete;
  WithoutSignals& operator=(const WithoutSignals&) = delete;

private:
  sigset_t before_;
};

/// Starts a thread that handles no signal of the program, and is not real-time, like those that it starts itself.
/// Errors: std::system_error.
template <class Work>
std::thread background_thread(Work work) {
  const WithoutSignals guard;
  return std::thread([work = std::move(work)]() mutable {
    leave_real_time();
    work();
  });
}

} // namespace director
