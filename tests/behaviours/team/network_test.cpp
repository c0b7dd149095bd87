// SPDX-License-Identifier: MIT
// The three robots of behaviours/team in one program, over a network that delays, loses and partitions, with simulated
// time: the behaviour's promises follow from the behaviour, not from the middleware.
#include "behaviours/team/player.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <random>
#include <vector>

namespace {

using namespace std::chrono_literals;
using Time = std::chrono::milliseconds;

constexpr int count = 3;
constexpr Time step_time = 10ms, say_again = 100ms, longest_delay = 50ms;

struct Robot {
  explicit Robot(int number, Time now) : started(now) {
    CHECK(behaviour.set(static_cast<team::Number>(number)));
    behaviour.request<team::Play>();
  }
  team::Role role() const {
    director::Index row = 0;
    while (std::string(team::names::state(row)) != "Role") ++row;
    return static_cast<team::Role>(behaviour.engine().value(row));
  }
  /// Like the bridge: the values of Role have the same names in One, Two and Three.
  void hear(int from, team::Role role_there) {
    const auto number = static_cast<std::int32_t>(role_there) + 2; // after unheard and silent
    switch (from) {
    case 0: return void(behaviour.set(static_cast<team::One>(number)));
    case 1: return void(behaviour.set(static_cast<team::Two>(number)));
    default: return void(behaviour.set(static_cast<team::Three>(number)));
    }
  }

  players::Player player;
  team::Behaviour behaviour{player};
  Time started;
  Time next_word{0};
  team::Role said = team::Role::resting;
};

struct Word {
  Time arrives;
  int from = 0, to = 0;
  team::Role role = team::Role::resting;
};

class Team {
public:
  explicit Team(unsigned seed) : draw_(seed) {
    for (int i = 0; i < count; ++i) start(i);
  }

  void start(int i) { at(i) = std::make_unique<Robot>(i, now_); }
  void kill(int i) { at(i).reset(); }
  bool there(int i) const { return robots_[static_cast<std::size_t>(i)] != nullptr; }
  void part(bool parted) { parted_ = parted; }
  void lose(double share) { lost_ = share; }

  void run(Time how_long) {
    for (const Time end = now_ + how_long; now_ < end; now_ += step_time) step();
  }
  int strikers() const {
    return static_cast<int>(
        std::ranges::count_if(robots_, [](const auto& r) { return r && r->role() == team::Role::striking; }));
  }
  int striker() const {
    const auto found =
        std::ranges::find_if(robots_, [](const auto& r) { return r && r->role() == team::Role::striking; });
    return found == robots_.end() ? -1 : static_cast<int>(found - robots_.begin());
  }
  int first() const {
    return static_cast<int>(std::ranges::find_if(robots_, [](const auto& r) { return r != nullptr; }) -
                            robots_.begin());
  }
  Time longest_with_two() const { return longest_; }

private:
  std::unique_ptr<Robot>& at(int i) { return robots_[static_cast<std::size_t>(i)]; }

  void step() {
    std::erase_if(words_, [this](const Word& word) {
      if (word.arrives > now_) return false;
      if (at(word.to)) at(word.to)->hear(word.from, word.role);
      return true;
    });
    for (int i = 0; i < count; ++i) {
      if (!at(i)) continue;
      Robot& robot = *at(i);
      CHECK(robot.behaviour.set(team::Ball{300}));
      robot.behaviour.step(now_ - robot.started);
      if (robot.role() == robot.said && now_ < robot.next_word) continue;
      robot.said = robot.role();
      robot.next_word = now_ + say_again;
      for (int other = 0; other < count; ++other) say(i, other, robot.said);
    }
    with_two_ = strikers() > 1 ? with_two_ + step_time : 0ms;
    longest_ = std::max(longest_, with_two_);
  }

  /// In order: a message never overtakes another one of the same robot.
  void say(int from, int to, team::Role role) {
    if (from == to || parted_ || std::uniform_real_distribution<>(0, 1)(draw_) < lost_) return;
    Time arrives =
        now_ + step_time * std::uniform_int_distribution<>(0, static_cast<int>(longest_delay / step_time))(draw_);
    for (const Word& word : words_) {
      if (word.from == from && word.to == to) arrives = std::max(arrives, word.arrives);
    }
    words_.push_back({arrives, from, to, role});
  }

  std::mt19937 draw_;
  std::array<std::unique_ptr<Robot>, count> robots_;
  std::vector<Word> words_;
  Time now_ = 0ms, with_two_ = 0ms, longest_ = 0ms;
  bool parted_ = false;
  double lost_ = 0;
};

/// Robots come and go at random times.
void come_and_go(Team& team, std::mt19937& draw, int times) {
  for (int i = 0; i < times; ++i) {
    const int robot = std::uniform_int_distribution<>(0, count - 1)(draw);
    team.there(robot) ? team.kill(robot) : team.start(robot);
    team.run(step_time * std::uniform_int_distribution<>(1, 250)(draw));
  }
}

} // namespace

TEST_CASE("the first of the team has the role soon after the start, and hands it on in order") {
  Team team(1);
  team.run(1200ms);
  CHECK(team.striker() == 0);
  team.kill(0);
  team.run(1200ms);
  CHECK(team.striker() == 1);
  team.kill(1);
  team.run(1200ms);
  CHECK(team.striker() == 2);
  team.start(0);
  team.run(300ms);
  CHECK(team.strikers() == 0); // three has given up; one has not received yet that two is silent
  team.run(900ms);
  CHECK(team.striker() == 0);
  CHECK(team.longest_with_two() == 0ms);
}

TEST_CASE("however robots come and go, two never strike for longer than a message takes") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Team team(seed);
    std::mt19937 draw(seed);
    come_and_go(team, draw, 40);
    if (!team.there(0) && !team.there(1) && !team.there(2)) team.start(2);
    team.run(2500ms);
    CAPTURE(seed);
    CHECK(team.strikers() == 1);
    CHECK(team.striker() == team.first());
    CHECK(team.longest_with_two() <= longest_delay + 2 * step_time);
  }
}

TEST_CASE("a network that loses every third message changes nothing") {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    Team team(seed);
    team.lose(0.3);
    std::mt19937 draw(seed);
    come_and_go(team, draw, 40);
    if (!team.there(0) && !team.there(1) && !team.there(2)) team.start(2);
    team.run(4000ms);
    CAPTURE(seed);
    CHECK(team.strikers() == 1);
    CHECK(team.striker() == team.first());
  }
}

TEST_CASE("robots that receive no messages all strike, and one remains soon after they hear each other") {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    Team team(seed);
    team.part(true);
    team.run(1500ms);
    CAPTURE(seed);
    CHECK(team.strikers() == 3);
    team.part(false);
    team.run(say_again + longest_delay + 2 * step_time);
    CHECK(team.strikers() <= 1);
    team.run(1000ms);
    CHECK(team.striker() == 0);
  }
}
