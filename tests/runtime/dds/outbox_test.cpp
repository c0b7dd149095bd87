// SPDX-License-Identifier: MIT
#include "runtime/dds/outbox.hpp"

#include <catch2/catch.hpp>

#include <thread>

using namespace director;
using dds::Outbox;

namespace {

void tell(Observer observer, Event::Kind kind, Index group = 0) {
  observer.tell(observer.self, Event{.kind = kind, .group = group});
}

} // namespace

TEST_CASE("decisions come out in order and numbered, requests of bodies do not") {
  Outbox outbox(8);
  tell(outbox.observer(), Event::Kind::run, 1);
  tell(outbox.observer(), Event::Kind::ask);
  tell(outbox.observer(), Event::Kind::set);
  tell(outbox.observer(), Event::Kind::done, 1);
  Outbox::Entry told;
  CHECK(outbox.anything_new());
  REQUIRE(outbox.take(told));
  CHECK(told.event.kind == Event::Kind::run);
  CHECK(told.number == 1);
  REQUIRE(outbox.take(told));
  CHECK(told.event.kind == Event::Kind::set);
  CHECK(told.number == 0);
  REQUIRE(outbox.take(told));
  CHECK(told.event.kind == Event::Kind::done);
  CHECK(told.number == 2);
  CHECK(!outbox.take(told));
}

TEST_CASE("events that find no room are counted, and leave a gap in the numbers") {
  Outbox outbox(4);
  for (int i = 0; i < 6; ++i) tell(outbox.observer(), Event::Kind::run);
  CHECK(outbox.lost() == 2);
  Outbox::Entry told;
  std::uint64_t last = 0;
  while (outbox.take(told)) last = told.number;
  CHECK(last == 4);
  tell(outbox.observer(), Event::Kind::run);
  REQUIRE(outbox.take(told));
  CHECK(told.number == 7);
}

TEST_CASE("another observer is called as well, for everything") {
  int told = 0;
  Outbox outbox(2, {[](void* self, const Event&) { ++*static_cast<int*>(self); }, &told});
  tell(outbox.observer(), Event::Kind::ask);
  for (int i = 0; i < 5; ++i) tell(outbox.observer(), Event::Kind::run);
  CHECK(told == 6);
}

TEST_CASE("between two threads no event is torn, and each that is not lost comes once") {
  Outbox outbox(16);
  constexpr Index events = 100'000;
  std::thread stepping([&] {
    for (Index i = 0; i < events; ++i) tell(outbox.observer(), Event::Kind::run, i);
  });
  Outbox::Entry told;
  std::uint64_t taken = 0, last = 0, wrong = 0;
  const auto take_all = [&] {
    while (outbox.take(told)) {
      wrong += told.number != std::uint64_t{told.event.group} + 1 || told.number <= last;
      last = told.number;
      ++taken;
    }
  };
  while (taken + outbox.lost() < events) take_all();
  stepping.join();
  take_all();
  CHECK(wrong == 0);
  CHECK(taken + outbox.lost() == events);
}
