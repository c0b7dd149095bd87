// SPDX-License-Identifier: MIT
// The inbox: whole inputs or nothing, in order, from many threads.

#include "runtime/core/engine/inbox.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <thread>
#include <vector>

namespace director::tests {
namespace {

Input numbered(Index thing, bool more = false) {
  Input input;
  input.thing = thing;
  input.more = more;
  return input;
}

bool post(Inbox& inbox, Index thing) {
  const Input input = numbered(thing);
  return inbox.post({&input, 1});
}

TEST_CASE("records come out in the order in which they went in, also after a wrap-around") {
  std::vector<Inbox::Cell> cells(4);
  Inbox inbox(cells);
  for (Index i = 0; i < 100; ++i) {
    REQUIRE(post(inbox, i));
    inbox.open();
    REQUIRE(inbox.waiting() == 1);
    const Input* const taken = inbox.take();
    REQUIRE(taken != nullptr);
    REQUIRE(taken->thing == i);
  }
  CHECK(inbox.take() == nullptr);
}

TEST_CASE("a full inbox refuses, and accepts again after a record was taken") {
  std::vector<Inbox::Cell> cells(2);
  Inbox inbox(cells);
  CHECK(post(inbox, 1));
  CHECK(post(inbox, 2));
  CHECK_FALSE(post(inbox, 3));
  inbox.open();
  CHECK(inbox.take() != nullptr);
  CHECK(post(inbox, 3));
}

TEST_CASE("an input of several records goes in whole or not at all") {
  std::vector<Inbox::Cell> cells(4);
  Inbox inbox(cells);
  const std::array three{numbered(1, true), numbered(2, true), numbered(3)};
  CHECK(inbox.post(three));
  CHECK_FALSE(inbox.post(three));
  CHECK(inbox.waiting() == 3);
  const std::vector<Input> five(5);
  CHECK_FALSE(inbox.post(five));
  CHECK(inbox.post({}));
}

TEST_CASE("an input that is put first is taken before later ones, and overtakes none") {
  std::vector<Inbox::Cell> cells(4);
  Inbox inbox(cells);
  CHECK(inbox.take() == nullptr);
  CHECK(inbox.put_first(numbered(1)));
  CHECK_FALSE(inbox.put_first(numbered(2))); // another input waits already
  CHECK(post(inbox, 2));
  inbox.open();
  CHECK(inbox.due());
  const Input* const first = inbox.take();
  REQUIRE(first != nullptr);
  CHECK(first->thing == 1);
  CHECK_FALSE(inbox.put_first(numbered(3))); // it would overtake another input
  CHECK(inbox.is_open());
  const Input* const second = inbox.take();
  REQUIRE(second != nullptr);
  CHECK(second->thing == 2);
  CHECK(inbox.take() == nullptr);

  CHECK(inbox.put_first(numbered(4))); // nothing else waits
  inbox.open();
  CHECK(inbox.is_open());
  CHECK(inbox.take() != nullptr);
  CHECK_FALSE(inbox.is_open());
  CHECK_FALSE(inbox.due());
}

TEST_CASE("inputs of several threads arrive whole, those of each thread in its order") {
  std::vector<Inbox::Cell> cells(64);
  Inbox inbox(cells);
  constexpr Index threads = 3, each = 2000;
  std::vector<std::thread> writers;
  for (Index writer = 0; writer < threads; ++writer) {
    writers.emplace_back([&inbox, writer] {
      for (Index i = 0; i < each; ++i) {
        std::array two{numbered(writer, true), numbered(writer)};
        two[0].value = two[1].value = static_cast<std::int32_t>(i);
        while (!inbox.post(two)) std::this_thread::yield();
      }
    });
  }
  std::array<Index, threads> seen{};
  bool in_order = true;
  for (Index taken = 0; taken < threads * each;) {
    inbox.open();
    const Input* const record = inbox.take();
    if (record == nullptr) {
      std::this_thread::yield();
      continue;
    }
    ++taken;
    const Input first = *record;
    const Input* const second = inbox.take_more();
    in_order = in_order && second != nullptr && first.more && !second->more && first.thing == second->thing &&
               first.value == static_cast<std::int32_t>(seen[first.thing]) && second->value == first.value;
    ++seen[first.thing];
  }
  for (std::thread& writer : writers) writer.join();
  CHECK(in_order);
  CHECK(inbox.waiting() == 0);
}

} // namespace
} // namespace director::tests
