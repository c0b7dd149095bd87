// SPDX-License-Identifier: MIT
// Copies for other threads: whole, the newest one, and without waiting.

#include "runtime/core/inspect/snapshot.hpp"
#include "runtime/core/inspect/view.hpp"
#include "tests/runtime/core/machine.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <thread>

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

TEST_CASE("a copy of a view is equal to the view when it was made") {
  Machine machine("{behaviour: b, language: 1, states: {S: {values: [x, y], external: true}}, roots: {A: {}},"
                  " groups: {A: {needs: [B], tasks: {B: {}}}, B: {}}}");
  machine.request("A");
  machine.step();
  const Shape shape = Shape::of(machine.tables());
  std::vector<std::uint64_t> buffer(View::bytes(shape) / sizeof(std::uint64_t));
  const View then = view_of(machine.engine()).copy(reinterpret_cast<std::byte*>(buffer.data()));
  machine.cancel("A");
  machine.set("S", "y");
  machine.step(7);
  const View now = view_of(machine.engine());
  const Index b = machine.group("B"), root = machine.edge("root>A");
  CHECK(then.holding(b).group == machine.group("A"));
  CHECK(now.holding(b) == Holding{});
  CHECK(then.state(root) == RunState::running);
  CHECK(now.state(root) == RunState::none);
  CHECK(then.values[0].value == unset);
  CHECK(now.values[0].value == 1);
  CHECK(then.now == 0);
  CHECK(now.now == 7);
}

} // namespace
} // namespace director::tests
