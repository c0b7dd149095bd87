// SPDX-License-Identifier: MIT
#include "runtime/dds/asker.hpp"
#include "runtime/dds/entity.hpp"
#include "tests/runtime/dds/robot.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <cstring>

using namespace director;
using namespace director::tests;
using dds::Reply;

namespace {

const dds::Asker::To one{"one", "courier"};

dds::Settings offering() { return {.robot = "one", .offer = {{.task = "Rest"}}}; }

/// A robot that steps in a thread of its own.
class Running {
public:
  explicit Running(Robot& robot)
      : thread_([this, &robot] {
          while (!stop_) {
            robot.step();
            std::this_thread::sleep_for(1ms);
          }
        }) {}
  ~Running() {
    stop_ = true;
    thread_.join();
  }

private:
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

} // namespace

TEST_CASE("a root task is requested and cancelled from another process") {
  loopback_domain();
  Robot robot(offering());
  std::atomic<int> rests{0};
  robot.plans.rest = [&](courier::Rest::Default& run) { return ++rests, run.keep(); };
  dds::Asker asker("coach", loopback_domain());
  CHECK(asker.request(one, "Rest", patience) == Reply::taken);
  CHECK(robot.comes_true([&] { return robot.behaviour.state<courier::Rest>() == RunState::running; }));
  CHECK(asker.cancel(one, "Rest", patience) == Reply::taken);
  CHECK(robot.comes_true([&] { return robot.behaviour.state<courier::Rest>() == RunState::none; }));
  CHECK(rests == 1);
}

TEST_CASE("a request that is too long for any robot is answered at once") {
  CHECK_THROWS_WITH(dds::Asker("", loopback_domain()), "dds: an asker's name has 1 to 255 bytes, this one has 0");
  CHECK_THROWS_WITH(dds::Asker(std::string(256, 'a'), loopback_domain()),
                    "dds: an asker's name has 1 to 255 bytes, this one has 256");
  Robot robot(offering());
  dds::Asker asker("coach", loopback_domain());
  const std::vector<std::byte> data(dds::longest_data + 1);
  CHECK(asker.request(one, "Rest", 1h, {}, data) == Reply::refused);
  CHECK(asker.request(one, "Rest", 1h, std::string(256, 'l')) == Reply::refused);
  CHECK(asker.request(one, std::string(256, 't'), 1h) == Reply::unknown_task);
  CHECK(asker.cancel(one, "", 1h) == Reply::unknown_task);
  CHECK(robot.bridge.counts().bad_samples == 0);
}

TEST_CASE("a request for a task that is not offered is not carried out") {
  Robot robot(offering());
  dds::Asker asker("coach", loopback_domain());
  CHECK(asker.request(one, "Deliver", patience) == Reply::unknown_task);
  CHECK(asker.request(one, "Rest", patience, "urgent") == Reply::refused);
  CHECK(robot.bridge.counts().requests_refused == 2);
  CHECK(robot.was_told("refused coach: request Deliver: unknown task"));
  CHECK(robot.was_told("refused coach: request Rest: refused"));
}

TEST_CASE("a task with data goes through a function that reads them") {
  std::atomic<courier::Behaviour*> behaviour{nullptr};
  const auto deliver = [&](const dds::Asked& asked) {
    int weight = 0;
    if (asked.cancel || asked.level != "urgent" || asked.data.size() != sizeof weight) return false;
    std::memcpy(&weight, asked.data.data(), sizeof weight);
    return behaviour.load()->post().request(
        courier::Deliver{{std::make_unique<int>(weight)}, courier::Deliver::urgent});
  };
  Robot robot({.robot = "one", .offer = {{.task = "Deliver", .take = deliver}}});
  behaviour = &robot.behaviour;
  int delivered = 0;
  robot.plans.deliver = [&](courier::Deliver::Default& run) { return delivered = *run.task().weight, run.keep(); };
  dds::Asker asker("coach", loopback_domain());
  const int data = 1234;
  CHECK(asker.request(one, "Deliver", patience, "urgent", std::as_bytes(std::span{&data, 1})) == Reply::taken);
  CHECK(robot.comes_true([&] { return delivered == 1234; }));
  CHECK(asker.request(one, "Deliver", patience) == Reply::refused);
}

TEST_CASE("a function that throws refuses the request") {
  Robot robot({.robot = "one", .offer = {{.task = "Rest", .take = [](const dds::Asked&) -> bool { throw 1; }}}});
  dds::Asker asker("coach", loopback_domain());
  CHECK(asker.request(one, "Rest", patience) == Reply::refused);
  CHECK(asker.cancel(one, "Rest", patience) == Reply::refused);
}

TEST_CASE("a repeated request is carried out once") {
  Robot robot(offering());
  const dds::Entity participant = dds::join(loopback_domain());
  const dds::Entity requests = dds::make_writer<dds::Request>(participant);
  const dds::Entity answers = dds::make_reader<dds::Answer>(participant);
  std::string name = "one", behaviour = "courier", asker = "coach", task = "Rest", level;
  dds::Request request{.robot = dds::text(name),
                       .behaviour = dds::text(behaviour),
                       .session = 0,
                       .asker = dds::text(asker),
                       .asker_session = 5,
                       .number = 1,
                       .kind = 0,
                       .task = dds::text(task),
                       .level = dds::text(level),
                       .data = {}};
  std::vector<Reply> replies;
  const auto answered = [&](std::size_t count) {
    return robot.comes_true([&] {
      dds::write(requests, request);
      dds::take<dds::Answer>(answers, [&](const dds::Answer& answer, const dds_sample_info_t&) {
        replies.push_back(static_cast<Reply>(answer.reply));
      });
      return replies.size() >= count;
    });
  };
  CHECK(answered(10));
  for (const Reply reply : replies) CHECK(reply == Reply::taken);
  CHECK(robot.bridge.counts().requests_taken == 1);
  CHECK(robot.bridge.counts().requests_repeated >= 9);

  request.session = robot.bridge.session() + 1; // as if the robot had been restarted
  request.number = 2;
  replies.clear();
  CHECK(robot.comes_true([&] {
    dds::write(requests, request);
    dds::take<dds::Answer>(answers, [&](const dds::Answer& answer, const dds_sample_info_t&) {
      if (answer.number == 2) replies.push_back(static_cast<Reply>(answer.reply));
    });
    return !replies.empty();
  }));
  CHECK(replies.front() == Reply::another_session);

  request.number = 0;
  CHECK(robot.comes_true([&] { return dds::write(requests, request), robot.bridge.counts().bad_samples > 0; }));
  CHECK(robot.bridge.counts().requests_taken == 1);
}

TEST_CASE("a request to a robot that is not there is not answered") {
  dds::Asker asker("coach", loopback_domain());
  CHECK(asker.request({"nobody", "courier"}, "Rest", 300ms) == Reply::unanswered);
}

TEST_CASE("many askers at once are all answered, and each request is carried out once") {
  Robot robot(offering());
  std::atomic<int> rests{0};
  robot.plans.rest = [&](courier::Rest::Default& run) { return ++rests, run.keep(); };
  const Running running(robot);
  constexpr int askers = 4, requests = 20;
  std::atomic<int> taken{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < askers; ++i)
    threads.emplace_back([&taken, i] {
      dds::Asker asker("coach " + std::to_string(i), loopback_domain());
      for (int j = 0; j < requests; ++j) taken += asker.request(one, "Rest", patience) == Reply::taken;
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(taken == askers * requests);
  CHECK(robot.bridge.counts().requests_taken == askers * requests);
}
