// SPDX-License-Identifier: MIT
#include "runtime/dds/outbox.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <new>
#include <thread>

using namespace director;
using dds::Outbox;

namespace {

void notify(Observer observer, Event::Kind kind, Index group = 0) {
  observer.tell(observer.self, Event{.kind = kind, .group = group});
}

} // namespace

TEST_CASE("decisions come out in order and numbered, requests of bodies do not") {
  Outbox outbox(8);
  notify(outbox.observer(), Event::Kind::run, 1);
  notify(outbox.observer(), Event::Kind::ask);
  notify(outbox.observer(), Event::Kind::set);
  notify(outbox.observer(), Event::Kind::broken); // has a topic of its own
  notify(outbox.observer(), Event::Kind::done, 1);
  Outbox::Entry entry;
  CHECK(outbox.anything_new());
  REQUIRE(outbox.take(entry));
  CHECK(entry.event.kind == Event::Kind::run);
  CHECK(entry.number == 1);
  REQUIRE(outbox.take(entry));
  CHECK(entry.event.kind == Event::Kind::set);
  CHECK(entry.number == 0);
  REQUIRE(outbox.take(entry));
  CHECK(entry.event.kind == Event::Kind::broken);
  CHECK(entry.number == 0);
  REQUIRE(outbox.take(entry));
  CHECK(entry.event.kind == Event::Kind::done);
  CHECK(entry.number == 2);
  CHECK(!outbox.take(entry));
}

TEST_CASE("events that find no room are counted, and leave a gap in the numbers") {
  Outbox outbox(4);
  for (int i = 0; i < 6; ++i) notify(outbox.observer(), Event::Kind::run);
  CHECK(outbox.lost() == 2);
  Outbox::Entry entry;
  std::uint64_t last = 0;
  while (outbox.take(entry)) last = entry.number;
  CHECK(last == 4);
  notify(outbox.observer(), Event::Kind::run);
  REQUIRE(outbox.take(entry));
  CHECK(entry.number == 7);
}

TEST_CASE("another observer is called as well, for everything") {
  int calls = 0;
  Outbox outbox(2, {[](void* self, const Event&) { ++*static_cast<int*>(self); }, &calls});
  notify(outbox.observer(), Event::Kind::ask);
  for (int i = 0; i < 5; ++i) notify(outbox.observer(), Event::Kind::run);
  CHECK(calls == 6);
}

TEST_CASE("a program with an observer of its own hands events on to it") {
  Outbox outbox;
  outbox.tell(Event{.kind = Event::Kind::run, .group = 3});
  Outbox::Entry entry;
  REQUIRE(outbox.take(entry));
  CHECK(entry.event.group == 3);
}

TEST_CASE("between two threads no event is torn, and each that is not lost comes once") {
  Outbox outbox(16);
  constexpr Index events = 100'000;
  std::thread stepping([&] {
    for (Index i = 0; i < events; ++i) notify(outbox.observer(), Event::Kind::run, i);
  });
  Outbox::Entry entry;
  std::uint64_t taken = 0, last = 0, wrong = 0;
  const auto take_all = [&] {
    while (outbox.take(entry)) {
      wrong += entry.number != std::uint64_t{entry.event.group} + 1 || entry.number <= last;
      last = entry.number;
      ++taken;
    }
  };
  while (taken + outbox.lost() < events) take_all();
  stepping.join();
  take_all();
  CHECK(wrong == 0);
  CHECK(taken + outbox.lost() == events);
}

TEST_CASE("an outbox that no memory can hold is refused") {
  if (tests::is_sanitized) return; // the sanitizer's allocator ends the program
  CHECK_THROWS_AS(Outbox(std::numeric_limits<std::size_t>::max()), std::bad_alloc);
}
