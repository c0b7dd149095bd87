// SPDX-License-Identifier: MIT
// A game of soccer with viewers uses no heap in the thread that steps, and makes no system calls: it waits for no lock,
// and wakes no thread.

#include "behaviours/soccer/player/player.hpp"
#include "behaviours/soccer/player/servos.hpp"
#include "behaviours/soccer/world/world.hpp"
#include "runtime/live/live_view.hpp"
#include "tests/runtime/live/client.hpp"
#include "tests/system/no_heap/heap_trap.hpp"

#include <catch2/catch.hpp>
#include <dlfcn.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <mutex>
#include <thread>
#include <vector>

namespace {
thread_local int locks = 0; ///< that this thread took so far
using Lock = int (*)(pthread_mutex_t*);
const Lock real_lock = reinterpret_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
} // namespace

// The program's own comes before that of the C library, which std::mutex calls.
extern "C" int pthread_mutex_lock(pthread_mutex_t* mutex) {
  ++locks;
  static const Lock early = reinterpret_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
  return (real_lock != nullptr ? real_lock : early)(mutex);
}

namespace director::tests {
namespace {

using namespace std::chrono_literals;

/// From now on system calls of this thread fail with ENOSYS, except its exit and naming a thread.
bool forbid_system_calls() {
  constexpr std::array<unsigned, 9> allowed{SYS_exit,    SYS_exit_group,     SYS_munmap,
                                            SYS_madvise, SYS_rt_sigprocmask, SYS_rt_sigreturn,
                                            SYS_write,   SYS_rt_sigaction,   SYS_set_robust_list};
  std::vector<sock_filter> filter{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  for (const unsigned call : allowed) {
    filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 1));
    filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  }
  filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP));
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

std::atomic<int> system_calls{0};

void count_system_calls() {
  struct sigaction action {};
  action.sa_handler = [](int) { system_calls.fetch_add(1); };
  sigaction(SIGSYS, &action, nullptr);
}

TEST_CASE("to show a game of soccer takes no heap, no lock and no system call from the thread that steps") {
  LiveView view{soccer::names::all(), {.queue = 1 << 20, .connections = 128, .interval = 1ms}};
  REQUIRE(view.good());
  std::vector<Caller> viewers; // who read nothing, which is the worst case
  for (int i = 0; i < 100; ++i) {
    viewers.emplace_back(view.url(), 2048);
    viewers.back().send(get(view.url(), "events"));
  }
  while (view.viewers() != 100) std::this_thread::sleep_for(1ms);

  count_system_calls();
  std::size_t used = 0;
  int called = 0, locked = 0;
  bool forbidden = false;
  std::thread stepping([&] {
    sim::World world{1};
    player::Player<player::Servos> player{world, view.observer()};
    const std::size_t before = heap_uses();
    const int locked_before = locks;
    forbidden = forbid_system_calls();
    while (world.now() < 20'000) {
      world.step();
      const HeapTrap trap;
      player.step();
      view.show(player.behaviour());
    }
    used = heap_uses() - before;
    called = system_calls;
    locked = locks - locked_before;
  });
  stepping.join();
  CHECK(used == 0);
  CHECK(called == 0);
  CHECK(locked == 0);
  if (!forbidden) WARN("this system does not let a thread forbid itself system calls: they were not counted");
  CHECK(view.dropped() == 0);
}

TEST_CASE("a lock that is taken is counted") {
  std::mutex mutex;
  const int before = locks;
  { const std::lock_guard lock(mutex); }
  CHECK(locks == before + 1);
}

TEST_CASE("a system call that is forbidden is counted") {
  count_system_calls();
  const int before = system_calls;
  bool forbidden = false;
  std::thread([&] {
    forbidden = forbid_system_calls();
    if (forbidden) syscall(SYS_getppid);
  }).join();
  CHECK(system_calls == before + (forbidden ? 1 : 0));
}

} // namespace
} // namespace director::tests
