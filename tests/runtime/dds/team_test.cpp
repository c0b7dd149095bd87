// SPDX-License-Identifier: MIT
// Three robots as three processes over loopback, which are killed, frozen, halted and restarted. Only one bound depends
// on speed: how long two robots may both have the role.
#include "tests/runtime/dds/loopback.hpp"
#include "tests/runtime/dds/process.hpp"
#include "tests/runtime/dds/robot.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <random>
#include <sstream>

using namespace director::tests;

namespace {

constexpr int count = 3;
constexpr std::array names{"one", "two", "three"};
/// The bound in runtime/dds/README.md, in seconds.
constexpr double never_two_for_longer = 2.0;

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

struct Span {
  int robot = 0;
  double begin = 0, end = 0;
};

std::vector<std::string> command(const std::string& what, int robot) {
  return {(binary_dir() / "bin/team").string(), what, names[static_cast<std::size_t>(robot)], "--domain",
          std::to_string(loopback_domain())};
}

/// One process of a robot, and the times in which it was frozen.
struct Life {
  explicit Life(int which) : robot(which), process(command("play", which)) {}

  std::string role() {
    std::string last;
    for (const std::string& line : process.lines()) {
      std::istringstream words(line);
      double time = 0;
      std::string what, role;
      words >> time >> what >> role;
      if (what == "role") last = role;
    }
    return last;
  }

  bool was_told(const std::string& notice) {
    return std::ranges::any_of(process.lines(), [&](const auto& line) { return line.ends_with("notice " + notice); });
  }

  /// The times in which it had the striker's role, without those in which it was frozen.
  std::vector<Span> strikes() {
    std::vector<Span> out;
    double since = -1;
    for (const std::string& line : process.lines()) {
      std::istringstream words(line);
      double time = 0;
      std::string what, role;
      words >> time >> what >> role;
      if (what != "role" && what != "end") continue;
      if (since >= 0) add(out, since, time);
      since = role == "striking" ? time : -1;
    }
    if (since >= 0) add(out, since, ended.value_or(seconds()));
    return out;
  }

  int robot;
  Process process;
  std::optional<double> frozen, thawed, ended;

private:
  void add(std::vector<Span>& out, double begin, double end) const {
    if (frozen && begin < *frozen && end > *frozen) {
      out.push_back({robot, begin, *frozen});
      begin = thawed.value_or(end);
    }
    if (begin < end) out.push_back({robot, begin, end});
  }
};

class Team {
public:
  void start(int robot) {
    lives_.push_back(std::make_unique<Life>(robot));
    living_[static_cast<std::size_t>(robot)] = lives_.back().get();
  }
  Life& life(int robot) { return *living_[static_cast<std::size_t>(robot)]; }
  bool lives(int robot) { return living_[static_cast<std::size_t>(robot)] != nullptr; }
  void end(int robot, int signal) {
    life(robot).process.signal(signal);
    life(robot).process.wait();
    life(robot).ended = seconds();
    living_[static_cast<std::size_t>(robot)] = nullptr;
  }

  int first() {
    int robot = 0;
    while (robot < count && !lives(robot)) ++robot;
    return robot;
  }
  /// The first living robot strikes, all others support.
  bool settled() { return settled_on(first()); }
  bool settled_on(int striker) {
    for (int robot = 0; robot < count; ++robot) {
      if (lives(robot) && life(robot).role() != (robot == striker ? "striking" : "supporting")) return false;
    }
    return true;
  }
  std::string roles() {
    std::string out;
    for (int robot = 0; robot < count; ++robot)
      out +=
          std::string(names[static_cast<std::size_t>(robot)]) + " " + (lives(robot) ? life(robot).role() : "-") + "; ";
    return out;
  }

  double longest_with_two() {
    std::vector<Span> spans;
    for (const auto& each : lives_) {
      for (const Span& span : each->strikes()) spans.push_back(span);
    }
    double longest = 0;
    for (const Span& a : spans) {
      for (const Span& b : spans) {
        if (a.robot < b.robot) longest = std::max(longest, std::min(a.end, b.end) - std::max(a.begin, b.begin));
      }
    }
    return longest;
  }

private:
  std::vector<std::unique_ptr<Life>> lives_;
  std::array<Life*, count> living_{};
};

void check_settled(Team& team, const std::string& after) {
  const double begin = seconds();
  const bool settled = comes_true([&] { return team.settled(); });
  std::printf("   %-28s %s after %.2f s\n", after.c_str(), team.roles().c_str(), seconds() - begin);
  CAPTURE(after, team.roles());
  CHECK(settled);
}

void check_never_two(Team& team) {
  const double longest = team.longest_with_two();
  std::printf("   two strikers at once: for %.3f s at most\n", longest);
  CHECK(longest <= never_two_for_longer);
}

} // namespace

TEST_CASE("the role passes to another robot when the striker is killed, and back when it is restarted") {
  Team team;
  for (int robot = 0; robot < count; ++robot) team.start(robot);
  check_settled(team, "all three are there");
  CHECK(comes_true([&] { return team.life(1).was_told("one: the behaviour team is there"); }));
  team.end(0, SIGKILL);
  check_settled(team, "one is killed");
  CHECK(comes_true([&] { return team.life(1).was_told("one: the behaviour team is not heard any more"); }));
  team.end(1, SIGKILL);
  check_settled(team, "two is killed");
  team.start(1);
  check_settled(team, "two is started again");
  team.start(0);
  check_settled(team, "one is started again");
  check_never_two(team);
}

TEST_CASE("whichever robots are killed and restarted, one robot strikes in the end") {
  const unsigned seed = std::random_device{}();
  std::printf("   seed %u\n", seed);
  CAPTURE(seed);
  std::mt19937 draw(seed);
  Team team;
  for (int robot = 0; robot < count; ++robot) team.start(robot);
  for (int round = 0; round < 5; ++round) {
    for (int change = 0; change < 2; ++change) {
      const int robot = static_cast<int>(draw() % count);
      if (team.lives(robot)) {
        team.end(robot, SIGKILL);
      } else {
        team.start(robot);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(draw() % 300));
    }
    if (team.first() == count) team.start(2);
    check_settled(team, "round " + std::to_string(round + 1));
  }
  check_never_two(team);
}

TEST_CASE("a striker that freezes loses the role, and when it continues there is one striker again") {
  Team team;
  for (int robot = 0; robot < count; ++robot) team.start(robot);
  check_settled(team, "all three are there");
  team.life(0).frozen = seconds();
  team.life(0).process.signal(SIGSTOP);
  CHECK(comes_true([&] { return team.life(1).role() == "striking"; }));
  team.life(0).thawed = seconds();
  team.life(0).process.signal(SIGCONT);
  check_settled(team, "one goes on");
  check_never_two(team);
}

TEST_CASE("a robot that ends, or is halted by the coach, leaves the role to the next") {
  Team team;
  for (int robot = 0; robot < count; ++robot) team.start(robot);
  check_settled(team, "all three are there");
  CHECK(Process(command("halt", 0)).wait() == 0);
  CHECK(comes_true([&] { return team.life(1).role() == "striking"; }));
  CHECK(team.life(0).role() == "resting");
  CHECK(Process(command("go-on", 0)).wait() == 0);
  check_settled(team, "one is no longer halted");
  Process& one = team.life(0).process;
  team.end(0, SIGTERM);
  CHECK(one.wait() == 0);
  check_settled(team, "one says goodbye");
  check_never_two(team);
}

TEST_CASE("a command line that is wrong is refused") {
  const std::string team = (binary_dir() / "bin/team").string();
  CHECK(Process({team, "four"}).wait() == 2);
  CHECK(Process({team}).wait() == 2);
  CHECK(Process({team, "one", "--domain", "x"}).wait() == 2);
  CHECK(Process({team, "one", "--domain", "999"}).wait() == 1);
  CHECK(Process({team, "--help"}).wait() == 0);
}
