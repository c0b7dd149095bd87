// SPDX-License-Identifier: MIT
// A thread that adds events and the recorder's own that writes them, under the thread sanitizer; the queue is full now
// and then.
#include "courier.hpp"
#include "runtime/hosted/trace/recorder.hpp"

#include <cstdio>
#include <cstdlib>

int main() {
  constexpr int events = 200'000;
  std::uint64_t dropped = 0;
  {
    director::Recorder recorder{
        post::courier::names::all(), "/dev/null", {.queue = 64, .interval = std::chrono::milliseconds(1)}};
    director::Event event;
    event.kind = director::Event::Kind::exhausted;
    for (event.time = 0; event.time < events; ++event.time) {
      recorder.tell(event);
      if (event.time % 50 == 0) std::this_thread::sleep_for(std::chrono::microseconds(10));
    }
    dropped = recorder.dropped();
    if (!recorder.good()) return EXIT_FAILURE;
  }
  std::printf("%d events, %llu of them dropped\n", events, static_cast<unsigned long long>(dropped));
  return dropped < events ? EXIT_SUCCESS : EXIT_FAILURE;
}
