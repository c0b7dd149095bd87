// SPDX-License-Identifier: MIT
#include "runtime/core/inspect/double_buffer.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <atomic>
#include <thread>
#include <vector>

namespace director::tests {
namespace {

TEST_CASE("readers enter the buffer that was finished last, and none if there is none") {
  DoubleBuffer buffers;
  CHECK(buffers.enter() == nil);
  const Index first = buffers.begin();
  CHECK(buffers.enter() == nil);
  buffers.finish(first);
  CHECK(buffers.enter() == first);
  const Index second = buffers.begin();
  CHECK(second != first);
  buffers.finish(second);
  CHECK(buffers.enter() == second);
}

TEST_CASE("a buffer with a reader is not written, and the writer skips it until it is empty") {
  DoubleBuffer buffers;
  buffers.finish(buffers.begin());
  const Index slow = buffers.enter();
  buffers.finish(buffers.begin());
  CHECK(buffers.enter() != slow);
  CHECK(buffers.begin() == nil);
  buffers.leave(slow);
  CHECK(buffers.begin() == slow);
}

TEST_CASE("readers see whole buffers while the writer continues") {
  DoubleBuffer buffers;
  std::array<std::array<int, 32>, 2> contents{};
  std::atomic<bool> stop{false}, torn{false};
  std::array<std::atomic<int>, 2> looks{};
  std::vector<std::thread> readers;
  for (std::atomic<int>& own : looks) {
    readers.emplace_back([&] {
      for (int newest = 0; !stop;) {
        const Index buffer = buffers.enter();
        if (buffer == nil) continue;
        const int first = contents[buffer][0];
        for (const int each : contents[buffer]) torn = torn || each != first;
        torn = torn || first < newest; // time does not go back
        newest = first;
        buffers.leave(buffer);
        ++own;
      }
    });
  }
  int written = 0;
  const auto goes_on = [&] { return written < 20'000 || looks[0] == 0 || looks[1] == 0; };
  for (int i = 1; i < 100'000'000 && goes_on(); ++i) {
    const Index buffer = buffers.begin();
    if (buffer == nil || written % 1'000 == 999) std::this_thread::yield(); // a reader may have to wait for a processor
    if (buffer == nil) continue;
    ++written;
    contents[buffer].fill(i);
    buffers.finish(buffer);
  }
  stop = true;
  for (std::thread& reader : readers) reader.join();
  CHECK(!torn);
  CHECK_FALSE(goes_on());
}

} // namespace
} // namespace director::tests
