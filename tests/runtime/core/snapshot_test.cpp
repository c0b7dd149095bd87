// SPDX-License-Identifier: MIT
// What other threads see: whole moments, the newest that was shown, and nobody waits.

#include "runtime/core/snapshot.hpp"
#include "tests/runtime/core/machine.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <thread>

namespace director::tests {
namespace {

TEST_CASE("readers enter the room that was finished last, and none before there is one") {
  TwoRooms rooms;
  CHECK(rooms.enter() == nil);
  const Index first = rooms.begin();
  CHECK(rooms.enter() == nil);
  rooms.finish(first);
  CHECK(rooms.enter() == first);
  const Index second = rooms.begin();
  CHECK(second != first);
  rooms.finish(second);
  CHECK(rooms.enter() == second);
}

TEST_CASE("a room with a reader is not written, and the writer does without until it is empty") {
  TwoRooms rooms;
  rooms.finish(rooms.begin());
  const Index slow = rooms.enter();
  rooms.finish(rooms.begin());
  CHECK(rooms.enter() != slow);
  CHECK(rooms.begin() == nil);
  rooms.leave(slow);
  CHECK(rooms.begin() == slow);
}

TEST_CASE("what readers see is whole while the writer goes on") {
  TwoRooms rooms;
  std::array<std::array<int, 32>, 2> contents{};
  std::atomic<bool> stop{false}, torn{false};
  std::vector<std::thread> readers;
  for (int i = 0; i < 2; ++i) {
    readers.emplace_back([&] {
      for (int newest = 0; !stop;) {
        const Index room = rooms.enter();
        if (room == nil) continue;
        const int first = contents[room][0];
        for (const int each : contents[room]) torn = torn || each != first;
        torn = torn || first < newest; // time goes on
        newest = first;
        rooms.leave(room);
      }
    });
  }
  for (int i = 1; i <= 20'000; ++i) {
    const Index room = rooms.begin();
    if (room == nil) continue;
    contents[room].fill(i);
    rooms.finish(room);
  }
  stop = true;
  for (std::thread& reader : readers) reader.join();
  CHECK(!torn);
}

TEST_CASE("a copy of a view says what the view said when it was made") {
  Machine machine("{behaviour: b, language: 1, states: {S: {values: [x, y], external: true}}, roots: {A: {}},"
                  " groups: {A: {needs: [B], tasks: {B: {}}}, B: {}}}");
  machine.request("A");
  machine.step();
  const Shape shape = Shape::of(machine.tables());
  std::vector<std::uint64_t> room(View::bytes(shape) / sizeof(std::uint64_t));
  const View then = machine.engine().view().copy(reinterpret_cast<std::byte*>(room.data()));
  machine.cancel("A");
  machine.set("S", "y");
  machine.step(7);
  const View now = machine.engine().view();
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
