#pragma once
// SPDX-License-Identifier: MIT
// The priority of threads that write or send what a behaviour does.

#include <pthread.h>
#include <sched.h>

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

} // namespace director
