// SPDX-License-Identifier: MIT
// The overflow slots: inputs that a full inbox does not refuse, their order, and that they are taken whole.

#include "runtime/core/engine/inbox.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <string>
#include <vector>

namespace director::tests {
namespace {

using Kind = Input::Kind;

/// An inbox of two cells for four root tasks.
struct Small {
  std::vector<Inbox::Cell> cells = std::vector<Inbox::Cell>(2);
  std::vector<OverflowSlot> slots = std::vector<OverflowSlot>(4);
  Inbox inbox{cells, slots};

  bool fire(Index trigger) {
    const Input input{.kind = Kind::fire, .thing = trigger};
    return inbox.post({&input, 1});
  }
  void fill() {
    while (fire(9)) {}
  }
  bool post(Kind kind, std::vector<Index> edges) {
    std::vector<Input> records;
    for (const Index edge : edges) records.push_back({.kind = kind, .more = true, .thing = edge});
    records.back().more = false;
    if (inbox.post_in_turn(records)) return true;
    inbox.reserve(records);
    inbox.publish(records);
    return true;
  }
  /// The inputs in one step of a reader: `request 1+2`, `cancel 0`, `fire`.
  std::vector<std::string> read() {
    std::vector<std::string> out;
    inbox.open();
    while (inbox.due()) {
      if (const Input* const input = inbox.take(); input != nullptr) out.push_back(text(*input));
    }
    return out;
  }
  std::string text(const Input& input) {
    std::string line = input.kind == Kind::fire ? "fire" : input.kind == Kind::cancel ? "cancel " : "request ";
    if (input.kind != Kind::fire) line += std::to_string(input.thing);
    for (const Input* next = &input; next->more && (next = inbox.take_more()) != nullptr;)
      line += "+" + std::to_string(next->thing);
    return line;
  }
};

using Lines = std::vector<std::string>;

TEST_CASE("requests and cancels are stored outside a full inbox, and taken after its inputs, in their order") {
  Small small;
  small.fill();
  CHECK(small.post(Kind::request, {3}));
  CHECK(small.post(Kind::cancel, {0}));
  CHECK(small.post(Kind::request, {1}));
  CHECK(small.read() == Lines{"fire", "fire", "request 3", "cancel 0", "request 1"});
  CHECK(small.read().empty());
}

TEST_CASE("of several inputs about one root task the last one counts, at its place in the order") {
  Small small;
  small.fill();
  for (const Kind kind : {Kind::request, Kind::cancel, Kind::request, Kind::cancel}) CHECK(small.post(kind, {2}));
  CHECK(small.post(Kind::request, {1}));
  CHECK(small.post(Kind::request, {2}));
  CHECK(small.read() == Lines{"fire", "fire", "request 1", "request 2"});
}

TEST_CASE("a later input about a root task waits behind its newest record, even if the inbox has room again") {
  Small small;
  small.fill();
  CHECK(small.post(Kind::request, {1}));
  small.inbox.open();
  CHECK(small.inbox.take() != nullptr);
  CHECK(small.inbox.take() != nullptr); // the inbox is empty, the reader holds the request
  CHECK(small.post(Kind::cancel, {1}));
  const Input* const input = small.inbox.take();
  REQUIRE(input != nullptr);
  CHECK(small.text(*input) == "request 1");
  CHECK(small.inbox.take() == nullptr); // the cancel came after the step began
  CHECK(small.read() == Lines{"cancel 1"});
}

TEST_CASE("inputs of one writer are taken in its order, from the inbox or outside of it") {
  Small small;
  small.fire(9);
  CHECK(small.post(Kind::request, {1}));
  CHECK(small.post(Kind::cancel, {1})); // full
  CHECK(small.post(Kind::request, {0}));
  CHECK(small.read() == Lines{"fire", "request 1", "cancel 1", "request 0"});
  CHECK(small.post(Kind::cancel, {1}));
  CHECK(small.fire(9));
  CHECK(small.post(Kind::request, {1}));
  CHECK(small.read() == Lines{"cancel 1", "fire", "request 1"});
}

TEST_CASE("root tasks that are requested together are taken together") {
  Small small;
  small.fill();
  CHECK(small.post(Kind::request, {1, 3, 0}));
  CHECK(small.post(Kind::cancel, {2}));
  CHECK(small.read() == Lines{"fire", "fire", "request 0+1+3", "cancel 2"});
  small.fill();
  CHECK(small.post(Kind::request, {1, 3}));
  CHECK(small.post(Kind::cancel, {3}));
  CHECK(small.read() == Lines{"fire", "fire", "request 1", "cancel 3"});
}

TEST_CASE("a task that is requested twice in one input is requested once") {
  Small small;
  small.fill();
  CHECK(small.post(Kind::request, {1, 1}));
  CHECK(small.read() == Lines{"fire", "fire", "request 1"});
}

TEST_CASE("a writer that is interrupted in the middle blocks no other thread") {
  Small small;
  const auto reserve = [&] {
    std::array record{Input{.kind = Kind::request, .thing = 1}};
    small.inbox.reserve(record);
    return record[0].handle;
  };
  const auto publish = [&](Index handle, Index level) {
    const Input input{.kind = Kind::request, .thing = 1, .handle = handle, .value = static_cast<std::int32_t>(level)};
    small.inbox.publish({&input, 1});
  };
  std::vector<Index> handles;
  for (Index i = 0; i < OverflowSlot::places; ++i) handles.push_back(reserve());
  CHECK(reserve() == nil); // one of the unfinished records will count as the later one
  publish(handles[2], 2);
  const Index again = reserve(); // the newest record loses its place
  CHECK(again == handles[2]);
  publish(again, 5);
  publish(handles[0], 7);
  small.inbox.open();
  const Input* const input = small.inbox.take();
  REQUIRE(input != nullptr);
  CHECK(input->level() == 7);
  CHECK(small.inbox.take() == nullptr);
}

TEST_CASE("a record that is published before its leader waits for it") {
  Small small;
  std::array both{Input{.kind = Kind::request, .more = true, .thing = 0}, Input{.kind = Kind::request, .thing = 1}};
  small.inbox.reserve(both);
  // The state after a writer of both was interrupted: the leader is not published yet.
  small.inbox.publish({&both[1], 1});
  OverflowSlot::Note& follower = small.slots[1].notes[static_cast<Index>(both[1].handle - waiting_requests)];
  follower.leader = 0;
  follower.input.more = true;
  small.inbox.open();
  CHECK(small.inbox.take() == nullptr);
  small.inbox.publish({both.data(), 1});
  OverflowSlot::Note& first = small.slots[0].notes[static_cast<Index>(both[0].handle - waiting_requests)];
  first.ticket = follower.ticket;
  first.input.more = true;
  small.inbox.open();
  const Input* input = small.inbox.take();
  REQUIRE(input != nullptr);
  CHECK(input->thing == 0);
  REQUIRE(input->more);
  input = small.inbox.take_more();
  REQUIRE(input != nullptr);
  CHECK(input->thing == 1);
}

TEST_CASE("an inbox is empty when a later input about a task that the reader held has been taken") {
  Small small;
  small.fill();
  CHECK(small.post(Kind::request, {2}));
  small.inbox.open(); // a step that ends before the request is taken
  small.fill();
  CHECK(small.post(Kind::cancel, {2}));
  CHECK(small.read() == Lines{"fire", "fire", "cancel 2"});
  CHECK_FALSE(small.inbox.due());
  CHECK(small.inbox.empty());
}

TEST_CASE("an inbox without overflow slots refuses when it is full") {
  std::vector<Inbox::Cell> cells(2);
  Inbox inbox(cells);
  const Input cancel{.kind = Kind::cancel};
  CHECK(inbox.put(cancel, 0));
  CHECK(inbox.put(cancel, 0));
  CHECK(!inbox.put(cancel, 0));
}

} // namespace
} // namespace director::tests
