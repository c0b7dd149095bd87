// Header: tests/system/threads/CMakeLists.txt. Test: itself.
// SPDX-License-Identifier: MIT
//
// Several threads call `post` of a generated behaviour while another one steps it. Built with the thread sanitizer,
// which ends the program with an error at a data race. Also checks that accepted inputs are taken, and that the last of
// all requests and cancels of a root task counts. They read snapshots as well.
#include "tests/system/api/office.hpp"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

namespace {

using namespace director;
using namespace director::tests;
using namespace std::chrono_literals;
using courier::Bell, courier::Deliver, courier::Rest;

constexpr int writers = 4, rounds = 4'000;

void count_bells(void* self, const Event& event) {
  if (event.kind == Event::Kind::input && event.input == Event::Input::fire) ++*static_cast<int*>(self);
}

const char* hammer() {
  Plans plans;
  Skills skills;
  int rung = 0;
  courier::Behaviour behaviour{plans, skills, Observer{&count_bells, &rung}};
  int weight = 0;
  bool whole = true;
  plans.deliver = [&](Deliver::Default& run) {
    whole = whole && run.task().weight != nullptr;
    weight = *run.task().weight;
    return run.keep();
  };
  std::atomic<int> accepted{0}, refused{0}, torn{0}, busy{writers};
  courier::Behaviour::Snapshot snapshot;
  const auto write = [&, post = behaviour.post()] {
    for (int i = 1; i <= rounds; ++i) {
      refused += !post.request(Deliver{{std::make_unique<int>(i)}, Deliver::urgent}, Rest{});
      refused += !post.cancel<Rest>();
      refused += !post.request(Deliver{{std::make_unique<int>(i)}});
      accepted += post.fire<Bell>();
      const auto look = snapshot.look();
      // A requested task runs or waits.
      if (look) torn += ((*look).state<Deliver>() == RunState::running) != ((*look).why<Deliver>().edge == 0);
    }
    busy -= 1;
  };
  std::thread threads[writers];
  for (std::thread& thread : threads) thread = std::thread(write);
  while (busy != 0) {
    behaviour.step(0s);
    behaviour.show(snapshot);
  }
  for (std::thread& thread : threads) thread.join();
  behaviour.step(0s);
  behaviour.step(0s);
  if (torn != 0) return "a snapshot is not of one moment";
  if (refused != 0) return "a request or cancel was refused";
  if (rung != accepted) return "an accepted trigger was lost, or came twice";
  if (!whole || weight != rounds) return "the last request is not the one that counts";
  if (behaviour.state<Rest>() != RunState::none) return "the last cancel is not what counts";
  return nullptr;
}

} // namespace

int main() {
  const char* wrong = hammer();
  if (wrong != nullptr) std::fprintf(stderr, "hammer: %s\n", wrong);
  return wrong == nullptr ? 0 : 1;
}
