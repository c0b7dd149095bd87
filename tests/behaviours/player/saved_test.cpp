// SPDX-License-Identifier: MIT
// The soccer player's behaviour is saved in the middle of a game and continues in a new object: the data of its tasks
// are included.
#include "behaviours/soccer/player/player.hpp"
#include "behaviours/soccer/player/servos.hpp"
#include "runtime/hosted/trace/fingerprint.hpp"
#include "tests/property/random.hpp"
#include "tests/support/numbers_of_event.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <chrono>
#include <memory>
#include <vector>

namespace {

using director::LoadResult, director::SaveResult;
using Events = std::vector<director::tests::EventNumbers>;
using Bytes = std::array<std::byte, soccer::Behaviour::saved_bytes()>;

/// The player of behaviours/soccer with a behaviour that can be replaced between two ticks.
struct Player {
  explicit Player(std::uint64_t seed) : world(seed), behaviour(fresh()) {
    behaviour->request<soccer::FallRecovery>();
    behaviour->request<soccer::Striker>();
  }
  std::unique_ptr<soccer::Behaviour> fresh() {
    const auto tell = [](void* self, const director::Event& event) {
      Player& player = *static_cast<Player*>(self);
      player.events.push_back(director::tests::numbers_of(event, player.shift.count() * 1000));
    };
    return std::make_unique<soccer::Behaviour>(recovery, safety, locomotion, kicking, looking, planning, strategy,
                                               limbs, legs, director::Observer{tell, this});
  }
  std::chrono::milliseconds now() const { return std::chrono::milliseconds(world.now()) + shift; }
  director::StepResult step() { return behaviour->step(now()); }
  void tick() {
    world.step();
    senses.tell(*behaviour);
  }
  void cut(std::chrono::milliseconds later) {
    Bytes bytes, again;
    REQUIRE(behaviour->save(bytes) == SaveResult::saved);
    std::unique_ptr<soccer::Behaviour> next = fresh();
    REQUIRE(next->load(bytes, now() + later) == LoadResult::loaded);
    shift += later;
    if (later.count() == 0) {
      REQUIRE(next->save(again) == SaveResult::saved);
      REQUIRE(bytes == again);
    }
    behaviour = std::move(next);
  }

  sim::World world;
  player::Senses senses{world};
  player::Recovery recovery;
  player::Safety safety;
  player::Locomotion locomotion{world.robot()};
  player::Kicking kicking;
  player::Looking looking;
  player::Planning planning{world.robot()};
  player::Strategy strategy{world.robot()};
  player::Limbs limbs{world.robot()};
  player::Servos legs{world.robot()};
  std::chrono::milliseconds shift{0};
  Events events;
  std::unique_ptr<soccer::Behaviour> behaviour;
};

TEST_CASE("the fingerprint in generated code is the one that traces have") {
  CHECK(soccer::detail::Whole::fingerprint() == director::fingerprint(soccer::names::all()));
}

constexpr int a_minute = 60'000;

TEST_CASE("a game whose behaviour is replaced several times by its saved state is the same game") {
  for (const std::uint64_t seed : {1U, 2U}) {
    CAPTURE(seed);
    Player whole(seed), cut(seed);
    director::property::Random random(seed);
    int cuts = 0, in_the_middle = 0;
    while (whole.world.now() < a_minute) {
      whole.tick();
      whole.step();
      cut.tick();
      cut.behaviour->set_budget(static_cast<std::uint32_t>(random.between(1, 20)));
      for (bool more = true; more;) {
        more = cut.step() != director::StepResult::quiescent;
        if (cut.events.back()[0] == static_cast<std::int64_t>(director::Event::Kind::exhausted)) cut.events.pop_back();
        director::SaveResult possible = SaveResult::inputs_wait;
        Bytes bytes;
        if (random.chance(0.1)) possible = cut.behaviour->save(bytes);
        if (possible == SaveResult::inputs_wait) continue; // taken later, micro-step by micro-step
        cut.cut(std::chrono::milliseconds(random.chance(0.5) ? 0 : random.between(-1000, 100'000)));
        cut.behaviour->set_budget(static_cast<std::uint32_t>(random.between(1, 20)));
        ++cuts;
        in_the_middle += more ? 1 : 0;
      }
    }
    CHECK(cuts > 500);
    CHECK(in_the_middle > 50);
    CHECK(whole.world.kicks() > 0);
    CHECK(whole.events == cut.events);
  }
}

/// In the middle of a game.
Bytes some_state(Player& player) {
  while (player.world.now() < 20'000) {
    player.tick();
    player.step();
  }
  Bytes bytes;
  REQUIRE(player.behaviour->save(bytes) == SaveResult::saved);
  return bytes;
}

TEST_CASE("a slot of data that is neither full nor empty, or empty although it is in use, is refused") {
  Player player(1);
  Bytes bytes = some_state(player);
  const std::size_t data = director::saved_bytes(soccer::detail::Whole::shape);
  const director::saved::Layout at(soccer::detail::Whole::shape);
  const auto walk = director::saved::read<director::saved::GroupRow>(bytes.data() + at.groups,
                                                                     soccer::detail::Whole::Groups::row<soccer::Walk>);
  REQUIRE(walk.active != director::nil);
  REQUIRE(walk.data_from != director::nil);
  // The first slots are those of Walk, one for each way of requesting it, then its own.
  const std::size_t slot = data + soccer::detail::Whole::places[walk.data_from] * (1 + sizeof(soccer::WalkCommand));
  for (const int full : {0, 2}) {
    bytes[slot] = static_cast<std::byte>(full);
    director::saved::seal(bytes);
    CHECK(player.behaviour->load(bytes, player.now()) == LoadResult::impossible);
  }
  bytes[slot] = std::byte{1};
  director::saved::seal(bytes);
  CHECK(player.behaviour->load(bytes, player.now()) == LoadResult::loaded);
}

TEST_CASE("a game that continues from bytes that were never saved does no harm") {
  Player origin(2);
  const Bytes state = some_state(origin);
  director::property::Random random(1);
  const std::size_t decisions = director::saved_bytes(soccer::detail::Whole::shape);
  const std::size_t head = director::saved::bytes_of<director::saved::HeadRow>();
  int accepted = 0, refused = 0;
  for (int i = 0; i < 2000; ++i) {
    Bytes bytes = state;
    for (std::size_t changes = 1 + random.below(3); changes > 0; --changes) {
      std::byte& each = bytes[head + random.below(decisions - head)]; // bodies have to check other data themselves
      each = random.chance(0.5)   ? static_cast<std::byte>(random.below(30))
             : random.chance(0.5) ? std::byte{0xFF}
                                  : each ^ std::byte{1};
    }
    director::saved::seal(bytes);
    Player player(2);
    const LoadResult result = player.behaviour->load(bytes, player.now());
    ++(result == LoadResult::loaded ? accepted : refused);
    for (int tick = 0; result == LoadResult::loaded && tick < 20; ++tick) {
      player.tick();
      player.step();
    }
  }
  CHECK(accepted > 100);
  CHECK(refused > 100);
}

} // namespace
