// Header: the program `team`, built with DIRECTOR_WITH_DDS. Test: tests/runtime/dds/team_test.cpp.
// SPDX-License-Identifier: MIT
//
// One of three robots. They are equal but for their number: each tells its Role, and hears that of the others as One,
// Two or Three. The rest is said in team.yaml.
#include "behaviours/team/arguments.hpp"
#include "behaviours/team/player.hpp"
#include "runtime/dds/asker.hpp"
#include "runtime/dds/bridge.hpp"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <thread>
#include <tuple>

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto period = 10ms;

volatile std::sig_atomic_t stopping = 0;
void stop(int) { stopping = 1; }

/// Lines of several threads, whole.
void print(const char* what, const std::string& text) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  const std::chrono::duration<double> now = Clock::now().time_since_epoch();
  std::printf("%.6f %s %s\n", now.count(), what, text.c_str());
  std::fflush(stdout);
}

/// What the camera sees: the ball rolls away when the robot has come close to it.
class Ball {
public:
  int cm() const { return static_cast<int>(cm_); }
  void come_closer(double cm_per_s, double seconds) {
    cm_ -= cm_per_s * seconds;
    if (cm_ < 20) cm_ = 800;
  }

private:
  double cm_ = 300;
};

director::dds::Settings settings_of(const Arguments& arguments) {
  static constexpr const char* states[] = {"One", "Two", "Three"};
  director::dds::Settings settings;
  settings.robot = robots[arguments.robot];
  settings.domain = arguments.domain;
  settings.publish = {"Role", "Ball"};
  for (int other = 0; other < 3; ++other) {
    if (other != arguments.robot)
      settings.take_in.push_back({.robot = robots[other], .state = "Role", .into = states[other]});
  }
  settings.offer = {{.task = "Halt"}};
  settings.notice = [](const director::dds::Notice& notice) { print("notice", notice.robot + ": " + notice.text); };
  return settings;
}

director::Index state(const char* name) {
  director::Index row = 0;
  while (std::string(team::names::state(row)) != name) ++row;
  return row;
}

int play(const Arguments& arguments) {
  namespace names = team::names;
  players::Player player;
  director::dds::Outbox outbox;
  team::Behaviour behaviour{player, outbox.observer()};
  director::dds::Bridge bridge{
      director::dds::plug("team", behaviour,
                          {names::group, names::provider, names::edge, names::state, names::value, names::condition}),
      outbox, settings_of(arguments)};
  if (!behaviour.set(static_cast<team::Number>(arguments.robot))) return 2;
  behaviour.request<team::Play>();

  const director::Index role = state("Role");
  std::int32_t said = director::unset;
  Ball ball;
  const auto begin = Clock::now();
  for (auto next = begin; stopping == 0; next = std::max(next + period, Clock::now() - 10 * period)) {
    const auto now = Clock::now();
    if (arguments.seconds != 0 && now - begin >= std::chrono::seconds(arguments.seconds)) break;
    ball.come_closer(player.cm_per_s(), std::chrono::duration<double>(period).count());
    std::ignore = behaviour.set(team::Ball{ball.cm()}); // too far away: it stays as it was
    behaviour.step(now - begin);
    bridge.stepped();
    if (const std::int32_t is = behaviour.engine().value(role); is != said) {
      print("role", names::value(role, is));
      said = is;
    }
    std::this_thread::sleep_until(next + period);
  }
  const director::dds::Counts counts = bridge.counts();
  print("end", std::to_string(counts.states_said) + " states said, " + std::to_string(counts.states_heard) +
                   " heard, " + std::to_string(counts.decisions_said) + " decisions said, " +
                   std::to_string(counts.requests_taken) + " requests taken");
  return 0;
}

int ask(const Arguments& arguments) {
  director::dds::Asker asker("coach", arguments.domain);
  const director::dds::Asker::To robot{robots[arguments.robot], "team"};
  const auto reply =
      arguments.what == Arguments::What::halt ? asker.request(robot, "Halt", 10s) : asker.cancel(robot, "Halt", 10s);
  print("coach", to_text(reply));
  return reply == director::dds::Reply::taken ? 0 : 1;
}

} // namespace

int main(int count, char** values) {
  const CommandLine command = parse({values + 1, values + count});
  if (!command.run) {
    std::fputs(command.text.c_str(), command.exit_code == 0 ? stdout : stderr);
    return command.exit_code;
  }
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  try {
    return command.run->what == Arguments::What::play ? play(*command.run) : ask(*command.run);
  } catch (const director::dds::Failure& failure) {
    std::fprintf(stderr, "team: %s\n", failure.what());
    return 1;
  }
}
