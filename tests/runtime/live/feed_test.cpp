// SPDX-License-Identifier: MIT
// Tests runtime/live/feed.hpp, backlog.hpp and moments.hpp.
#include "runtime/live/feed.hpp"
#include "tests/runtime/live/client.hpp"
#include "tests/runtime/live/courier_moments.hpp"

#include <catch2/catch.hpp>

#include <new>
#include <thread>

using namespace director;
using namespace director::tests;
using live::Feed, live::Place;

namespace {

struct Viewer {
  Feed& feed;
  Place place;
  Follower follower;

  /// Takes all messages for this viewer; returns what is wrong with them.
  std::string look(const std::vector<std::string>& happened) {
    std::string text;
    while (const Feed::Text message = feed.next(place)) text += *message;
    return follower.follow(take_messages(text), happened);
  }
};

} // namespace

TEST_CASE("a state that was loaded is shown, though its micro-step has the number of the last one that was shown") {
  CourierMoments source{16};
  View view = source.behaviour.seen().view();
  view.now = 2'000'000;
  source.moments.show(view, 5);
  CHECK(source.moments.look().events == 5);
  view.now = 3'000'000;
  source.moments.show(view, 5); // nothing happened
  CHECK(source.moments.look().view.now == 2'000'000);
  CHECK(source.moments.now() == 3'000'000);
  source.moments.show(view, 6); // another future
  CHECK(source.moments.look().events == 6);
  for (const Time now : {4'000'000, 1'000'000}) { // loaded, and nothing has happened since
    view.now = now;
    ++view.passes;
    source.moments.show(view, 6);
    CHECK(source.moments.look().view.now == now);
  }
}

TEST_CASE("a viewer from the beginning gets every event, in order") {
  CourierMoments source{1024};
  Feed feed(source.queue, source.moments, source.names, 1 << 20);
  Viewer viewer{feed, {}, {}};
  feed.take();
  CHECK(viewer.look(source.happened).empty());
  for (int round = 0; round < 20; ++round) {
    source.add_events(round);
    source.show();
    feed.take();
    CHECK(viewer.look(source.happened).empty());
  }
  CHECK(viewer.follower.at() == 190);
  CHECK(viewer.follower.gaps() == 0);
}

TEST_CASE(
    "a viewer that connects late gets a header, the number of missed events, the current state, and then every event") {
  CourierMoments source{1024};
  Feed feed(source.queue, source.moments, source.names, 1 << 20);
  source.add_events(100);
  source.show();
  source.add_events(7);
  feed.take();
  Place place;
  std::string text = *feed.next(place);
  const std::vector<Message> first = take_messages(text);
  REQUIRE(first.size() == 2);
  CHECK(first[1].event + " " + first[1].data.at(0) == "standing []");
  CHECK(first[0].id == "100");
  CHECK(first[0].data.at(1) == R"({"event":"dropped","count":100})");
  CHECK(first[0].data.at(2) == R"({"t":0,"n":1,"event":"given","state":"Mood","value":"calm"})");
  Viewer viewer{feed, {}, {}};
  CHECK(viewer.look(source.happened).empty());
  CHECK(viewer.follower.at() == 107);
  CHECK(viewer.follower.missed() == 100);
}

TEST_CASE("a viewer that is too slow misses events, and gets their number and the current state") {
  CourierMoments source{1024};
  Feed feed(source.queue, source.moments, source.names, 2000);
  Viewer slow{feed, {}, {}}, quick{feed, {}, {}};
  for (int round = 0; round < 50; ++round) {
    source.add_events(10);
    source.show();
    feed.take();
    CHECK(quick.look(source.happened).empty());
    if (round == 3 || round == 49) CHECK(slow.look(source.happened).empty());
  }
  CHECK(quick.follower.at() == 500);
  CHECK(quick.follower.missed() == 10); // before its first moment
  CHECK(slow.follower.at() == 500);
  CHECK(slow.follower.gaps() == 2);
  CHECK(slow.follower.missed() == 500); // none of these events was kept
}

TEST_CASE("after a burst that the queue does not hold and then rest, viewers get the number of missing events and the "
          "state") {
  CourierMoments source{16};
  Feed feed(source.queue, source.moments, source.names, 1 << 20);
  Viewer early{feed, {}, {}}, late{feed, {}, {}};
  feed.take();
  CHECK(early.look(source.happened).empty());
  source.add_events(30);
  source.show();
  feed.take();
  for (Viewer* viewer : {&early, &late}) {
    CHECK(viewer->look(source.happened).empty());
    CHECK(viewer->follower.at() == 30);
    CHECK(viewer->follower.begun());
  }
  CHECK(early.follower.missed() == 14);
  CHECK(late.follower.missed() == 30);
  source.add_events(3);
  source.show();
  feed.take();
  for (Viewer* viewer : {&early, &late}) {
    CHECK(viewer->look(source.happened).empty());
    CHECK(viewer->follower.at() == 33);
  }
}

TEST_CASE(
    "groups that do not simply run are sent behind the events of their moment, and again when that may be in doubt") {
  CourierMoments source{1024};
  source.plans.deliver = [](courier::Deliver::Default& run) { return run.enter(courier::Open{}, courier::Walk{{}}); };
  (void)source.behaviour.enable<courier::Open::Unlocking>(false);
  Feed feed(source.queue, source.moments, source.names, 1 << 20);
  const auto look = [&](Place& place) {
    feed.take();
    std::string text, out;
    while (const Feed::Text message = feed.next(place)) text += *message;
    for (const Message& message : take_messages(text))
      out += message.event.empty() ? "to " + message.id + "\n" : message.event + " " + message.data.at(0) + "\n";
    return out;
  };
  const std::string waits =
      R"(standing [{"event":"waits","edge":"Deliver>Walk","why":"waiting","condition":"Door == open"},{"event":"waits","edge":"Deliver>Open","why":"waiting","condition":"Door == open"}])"
      "\n";
  Place place, late;
  CHECK(look(place) == "to 0\n");
  source.add_events(3);
  source.behaviour.request(courier::Deliver{{}});
  source.show();
  source.add_events(2); // events of the next moment
  CHECK(look(place) == "to 3\n" + waits + "to 5\n");
  source.show();
  CHECK(look(place).empty()); // nothing changed since
  Event lose;
  lose.kind = Event::Kind::lose;
  lose.group = 0;
  lose.other = 0;
  REQUIRE(source.queue.put(lose));
  CHECK(look(place) == "to 6\n");
  source.show();
  CHECK(look(place) == waits);
  CHECK(look(place).empty());
  CHECK(look(late) == "to 6\n" + waits);
  late = *feed.resume("6");
  CHECK(look(late) == waits);
  source.add_events(1);
  late = *feed.resume("6");
  CHECK(look(late) == waits + "to 7\n");
  source.behaviour.cancel_all();
  source.show();
  CHECK(look(late) == "standing []\n"); // none waits any more, which no event reported
  CHECK(look(late).empty());
}

TEST_CASE("events that found the queue full are a gap for all viewers") {
  CourierMoments source{16};
  Feed feed(source.queue, source.moments, source.names, 1 << 20);
  Viewer viewer{feed, {}, {}};
  source.add_events(10);
  source.show();
  feed.take();
  CHECK(viewer.look(source.happened).empty());
  source.add_events(20); // four of them are dropped
  feed.take();
  source.add_events(3);
  feed.take();
  CHECK(viewer.look(source.happened).empty());
  CHECK(viewer.follower.at() == 26); // it waits for a moment after the gap
  source.show();
  source.add_events(2);
  feed.take();
  CHECK(viewer.look(source.happened).empty());
  CHECK(viewer.follower.at() == 35);
  CHECK(viewer.follower.missed() == 10 + 7);
}

TEST_CASE("without memory for events they are dropped, and viewers get their number and the current state") {
  CourierMoments source{1024};
  static bool memory_is_left = true;
  Names names = source.names;
  names.group = [](const void*, Index row) {
    if (!memory_is_left) throw std::bad_alloc();
    return courier::names::group(row);
  };
  Feed feed(source.queue, source.moments, names, 1 << 20);
  Viewer viewer{feed, {}, {}};
  feed.take();
  CHECK(viewer.look(source.happened).empty());
  const auto pass = [&] {
    source.add_events(5);
    source.show();
    feed.take();
  };
  pass();
  CHECK(viewer.look(source.happened).empty());
  CHECK(viewer.follower.gaps() == 0);
  source.add_events(5);
  Event run;
  run.kind = Event::Kind::run;
  run.group = run.provider = 0;
  source.happened.emplace_back();
  append_event(run, source.names, source.happened.back());
  REQUIRE(source.queue.put(run));
  memory_is_left = false;
  feed.take();
  memory_is_left = true;
  pass();
  CHECK(viewer.look(source.happened).empty());
  CHECK(viewer.follower.gaps() == 1);
  CHECK(viewer.follower.at() == source.happened.size());
}

TEST_CASE("viewers of a program that shows no moments get the events that are kept") {
  CourierMoments source{16};
  Feed feed(source.queue, source.moments, source.names, 300);
  Viewer early{feed, {}, {}}, late{feed, {}, {}};
  for (int round = 0; round < 30; ++round) {
    source.add_events(2);
    feed.take();
    CHECK(early.look(source.happened).empty());
  }
  CHECK(early.follower.at() == 60);
  CHECK(early.follower.missed() == 0);
  CHECK(late.look(source.happened).empty());
  CHECK(late.follower.at() == 60);
  CHECK(late.follower.missed() > 50);
}

TEST_CASE("a moment that is older than the kept events, as if a program stopped showing, is not sent") {
  CourierMoments source{16};
  Feed feed(source.queue, source.moments, source.names, 300);
  source.add_events(2);
  source.show();
  for (int round = 0; round < 30; ++round) {
    source.add_events(2);
    feed.take();
  }
  Viewer late{feed, {}, {}};
  CHECK(late.look(source.happened).empty());
  CHECK(late.follower.at() == 62);
}

TEST_CASE("a viewer that reconnects with the id of its last message continues there, if that is still kept") {
  CourierMoments source{64};
  Feed feed(source.queue, source.moments, source.names, 1000);
  source.add_events(5);
  source.show();
  feed.take();
  source.add_events(5);
  feed.take();
  for (const char* id : {"5", "10"}) {
    const std::optional<Place> place = feed.resume(id);
    REQUIRE(place);
    CHECK(place->begun);
    CHECK(std::to_string(place->next) == id);
  }
  for (const char* id : {"", "4", "11", "-1", "5 ", "99999999999999999999", "x"}) CHECK_FALSE(feed.resume(id));
  source.add_events(50);
  feed.take();
  CHECK_FALSE(feed.resume("5"));
}

TEST_CASE("a sign of life has the engine's time") {
  CourierMoments source{16};
  Feed feed(source.queue, source.moments, source.names, 1000);
  source.behaviour.step(std::chrono::milliseconds(1500));
  source.moments.show(source.behaviour.seen().view(), 0);
  CHECK(*feed.alive() == "event: alive\ndata: 1500000\n\n");
}

TEST_CASE("a moment has tables that outlive the behaviour, as the view may do") {
  CourierMoments source{16};
  source.show();
  CHECK(source.moments.look().view.tables == source.names.tables);
  CHECK(source.behaviour.seen().view().tables != source.names.tables);
}

TEST_CASE("moments pass from thread to thread whole, and none is refused") {
  CourierMoments source{16};
  std::atomic<bool> over{false};
  std::thread reader([&] {
    std::uint64_t last = 0;
    while (!over) {
      const live::Moment& moment = source.moments.look();
      if (moment.view.tables == nullptr) continue;
      if (moment.events != moment.view.micro_step || moment.events < last) std::abort();
      last = moment.events;
    }
  });
  for (int i = 0; i < 20'000; ++i) {
    (void)source.behaviour.fire<courier::Bell>();
    source.behaviour.step(std::chrono::milliseconds(0));
    const View view = source.behaviour.seen().view();
    source.moments.show(view, view.micro_step);
  }
  over = true;
  reader.join();
  CHECK(source.moments.look().events == source.behaviour.seen().view().micro_step);
}
