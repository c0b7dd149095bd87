// SPDX-License-Identifier: MIT
#include "behaviours/soccer/timeline/timeline.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <memory>

namespace {

using director::Event;
using director::Index;
using director::nil;
using director::Reason;
using Kind = Event::Kind;

// Walk (walking, halting) and Kick both need Legs, which moves a Servo; Kick waits for Pose.
enum Groups : Index { walk, kick, legs, servo };
enum Providers : Index { walking, halting, kicks, moves_legs, moves_servo };
enum Edges : Index { root_walk, root_kick, walk_legs, kick_legs, legs_servo };

const char* group_name(Index row) { return std::array{"Walk", "Kick", "Legs", "Servo"}[row]; }
const char* provider_name(Index row) { return std::array{"walking", "halting", "default", "default", "default"}[row]; }
const char* state_name(Index) { return "Pose"; }
const char* condition_name(Index) { return "Pose == standing"; }
const char* value_name(Index, std::int32_t value) {
  return value == director::unset ? "unset" : std::array{"moving", "standing"}[static_cast<std::size_t>(value)];
}

struct Told {
  std::array<Index, 9> lists{walk_legs, kick_legs, root_walk, root_kick, walk_legs, kick_legs, legs_servo, 0, 0};
  std::array<director::Group, 4> group_rows{};
  std::array<director::Provider, 5> provider_rows{};
  std::array<director::Edge, 5> edge_rows{};
  std::array<director::StateVariable, 1> state_rows{};
  std::array<director::Condition, 1> condition_rows{};
  director::Tables tables;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file{std::tmpfile(), std::fclose};
  Timeline timeline;
  Event event;

  explicit Told(bool colours = false)
      : timeline({group_name, provider_name, state_name, condition_name, value_name}, Page{file.get(), colours}) {
    group_rows[walk].providers = {walking, kicks};
    group_rows[walk].requesters = {2, 3};
    group_rows[walk].stop = true;
    group_rows[kick].providers = {kicks, moves_legs};
    group_rows[kick].requesters = {3, 4};
    group_rows[legs].providers = {moves_legs, moves_servo};
    group_rows[legs].requesters = {4, 6};
    group_rows[servo].providers = {moves_servo, 5};
    group_rows[servo].requesters = {6, 7};
    provider_rows[halting].group = provider_rows[walking].group = walk;
    provider_rows[walking].needs = provider_rows[halting].needs = {0, 1};
    provider_rows[kicks].group = kick;
    provider_rows[kicks].needs = {1, 2};
    provider_rows[moves_legs].group = legs;
    provider_rows[moves_servo].group = servo;
    edge_rows[root_walk].target = walk;
    edge_rows[root_kick].target = kick;
    edge_rows[walk_legs].requester = walk;
    edge_rows[kick_legs].requester = kick;
    edge_rows[walk_legs].target = edge_rows[kick_legs].target = legs;
    edge_rows[legs_servo].requester = legs;
    edge_rows[legs_servo].target = servo;
    tables.groups = group_rows;
    tables.providers = provider_rows;
    tables.edges = edge_rows;
    tables.states = state_rows;
    tables.conditions = condition_rows;
    tables.lists = lists;
    timeline.tell_of(tables);
  }

  /// The next event, in the same micro-step as the last one.
  Event& next(Kind kind, Index group = nil) {
    Event fresh;
    fresh.kind = kind;
    fresh.group = group;
    fresh.time = event.time;
    fresh.micro_step = event.micro_step;
    event = fresh;
    return event;
  }
  void at(director::Time time) { event.time = time, ++event.micro_step; }
  void tell() { timeline.observer().tell(&timeline, event); }

  void run(Index group, Index provider, Reason reason = Reason::new_task) {
    next(Kind::run, group).provider = provider;
    event.reasons = director::Reasons{static_cast<std::uint8_t>(reason)};
    tell();
  }
  void grant(Index group, Index edge, Index other = nil) {
    next(Kind::grant, group).edge = edge;
    event.other = other;
    tell();
  }
  void queue(Index edge, director::Why why) {
    next(Kind::queue).edge = edge;
    event.why = why;
    tell();
  }
  void set(Kind kind, std::int32_t to) {
    next(kind).state = 0;
    event.input = kind == Kind::input ? Event::Input::set : Event::Input::none;
    event.value = to;
    tell();
  }
  void simply(Kind kind, Index group) { next(kind, group), tell(); }

  std::string text() {
    timeline.finish();
    std::rewind(file.get());
    std::string out;
    for (int c; (c = std::fgetc(file.get())) != EOF;) out += static_cast<char>(c);
    return out;
  }
};

} // namespace

TEST_CASE("a kick interrupts the walk softly, and the timeline shows how") {
  Told told;
  told.at(0);
  told.grant(walk, root_walk);
  told.grant(legs, walk_legs);
  told.simply(Kind::start, walk);
  told.run(walk, walking);
  told.run(legs, moves_legs);
  told.at(500'000);
  told.next(Kind::push, walk).edge = root_kick;
  told.event.provider = halting;
  told.event.condition = 0;
  told.tell();
  told.queue(root_kick, director::Why::waiting);
  told.at(500'000);
  told.run(walk, halting, Reason::pushed);
  told.set(Kind::set, 1);
  told.queue(root_walk, director::Why::blocked);
  told.grant(kick, root_kick);
  told.grant(legs, kick_legs, walk_legs);
  told.simply(Kind::stop, walk);
  told.at(500'000);
  told.run(kick, kicks);
  told.at(700'000);
  told.simply(Kind::done, kick);
  CHECK(told.text() == "   0.00 s  starts     Walk\n"
                       "   0.00 s  runs       Walk          walking\n"
                       "   0.50 s  pushed     Walk          to halting, as Kick waits for Pose == standing\n"
                       "   0.50 s  runs       Walk          halting, pushed\n"
                       "   0.50 s  set        Pose          standing, by Walk\n"
                       "   0.50 s  takes      Kick          Legs from Walk\n"
                       "   0.50 s  stops      Walk\n"
                       "   0.50 s  runs       Kick\n"
                       "   0.70 s  done       Kick\n"
                       "      ...  4 runs: Walk 2, Kick 1, Legs 1\n");
  CHECK(told.timeline.counts().runs == 4);
  CHECK(told.timeline.counts().pushes == 1);
  CHECK(told.timeline.counts().take_overs == 1);
  CHECK(told.timeline.counts().faults == 0);
}

TEST_CASE("what is no longer requested is got, not taken") {
  Told told;
  told.at(0);
  told.grant(kick, root_kick);
  told.grant(legs, kick_legs);
  told.run(kick, kicks);
  told.at(0);
  told.simply(Kind::lose, kick);
  told.grant(walk, root_walk);
  told.grant(legs, walk_legs, kick_legs);
  CHECK(told.text() == "   0.00 s  runs       Kick\n"
                       "   0.00 s  ends       Kick\n"
                       "   0.00 s  gets       Walk          Legs from Kick\n"
                       "      ...  1 runs: Kick 1\n");
  CHECK(told.timeline.counts().take_overs == 0);
}

TEST_CASE("runs of what runs already, of limbs and of servos are only counted, and reported after a pause") {
  Told told;
  told.at(0);
  told.grant(walk, root_walk);
  told.run(walk, walking);
  for (int i = 0; i < 3; ++i) told.run(walk, walking, Reason::subtask_done), told.run(servo, moves_servo);
  told.simply(Kind::done, walk);
  told.simply(Kind::done, walk);
  told.simply(Kind::done, legs);
  told.at(1'200'000);
  told.run(legs, moves_legs);
  told.run(walk, halting);
  CHECK(told.text() == "   0.00 s  runs       Walk          walking\n"
                       "   0.00 s  done       Walk\n"
                       "      ...  9 runs: Walk 5, Servo 3, Legs 1\n"
                       "   1.20 s  runs       Walk          halting\n");
}

TEST_CASE("a state is reported when it changes, with the source of the change") {
  Told told;
  told.at(0);
  told.set(Kind::input, 0);
  told.set(Kind::input, 0);
  told.run(walk, walking);
  told.at(20'000);
  told.next(Kind::input).input = Event::Input::expire;
  told.event.state = 0;
  told.tell();
  told.set(Kind::set, director::unset);
  told.at(30'000);
  told.set(Kind::set, 1);
  CHECK(told.text() == "   0.00 s  sensed     Pose          moving\n"
                       "   0.00 s  runs       Walk          walking\n"
                       "   0.02 s  expired    Pose          unset\n"
                       "   0.03 s  set        Pose          standing\n"
                       "      ...  1 runs: Walk 1\n");
}

TEST_CASE("faults are reported and counted") {
  Told told;
  told.at(0);
  told.next(Kind::broken, walk).provider = halting;
  told.tell();
  told.simply(Kind::fault, kick);
  told.next(Kind::refused, walk).state = 0;
  told.event.value = 1;
  told.tell();
  told.simply(Kind::exhausted, nil);
  told.next(Kind::lost, nil).count = 3;
  told.tell();
  CHECK(told.text() == "   0.00 s  broken     Walk          promise of halting\n"
                       "   0.00 s  fault      Kick\n"
                       "   0.00 s  refused    Pose          standing, which Walk does not declare\n"
                       "   0.00 s  fault                    too many micro-steps in one step\n"
                       "   0.00 s  fault                    3 inputs lost\n");
  CHECK(told.timeline.counts().faults == 4);
}

TEST_CASE("colours are for terminals, and surround one word each") {
  Told told{true};
  told.at(61'000'000);
  told.set(Kind::input, 1);
  CHECK(told.text() == "  61.00 s  \033[36msensed   \033[0m  Pose          standing\n");
}
