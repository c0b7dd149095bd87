// SPDX-License-Identifier: MIT
// Two robots and an observer in one process, each with a participant of its own.
#include "runtime/dds/entity.hpp"
#include "runtime/dds/plan.hpp"
#include "tests/runtime/dds/keeper_module.hpp"
#include "tests/runtime/dds/robot.hpp"
#include "tests/support/other_threads.hpp"

#include <arpa/inet.h>
#include <catch2/catch.hpp>
#include <dds/ddsrt/log.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstring>
#include <map>
#include <random>

using namespace director;
using namespace director::tests;
using dds::Settings;

namespace {

const Settings speaks{.robot = "one", .publish = {"Mood", "Battery"}};
const Settings hears{.robot = "two",
                     .take_in = {{.robot = "one", .state = "Mood", .into = "Mood"},
                                 {.robot = "one", .state = "Battery", .into = "Battery"}}};
constexpr std::int32_t calm = 0, hurried = 1;

/// Publishes any sample for a robot without a bridge.
class Stranger {
public:
  void publish(const char* state, int kind, int number, const char* name, const char* robot = "one") {
    const dds::State sample{.robot = const_cast<char*>(robot),
                            .behaviour = const_cast<char*>("courier"),
                            .state = const_cast<char*>(state),
                            .kind = static_cast<std::uint8_t>(kind),
                            .number = number,
                            .name = const_cast<char*>(name),
                            .stamp = {}};
    REQUIRE(dds::write(states_, sample));
  }
  void says_goodbye(const char* state) {
    const dds::State sample{.robot = const_cast<char*>("one"),
                            .behaviour = const_cast<char*>("courier"),
                            .state = const_cast<char*>(state),
                            .kind = 0,
                            .number = 0,
                            .name = nullptr,
                            .stamp = {}};
    dds_dispose(states_.get(), &sample);
  }
  void is_member(const char* robot, std::uint64_t session, const char* specification) {
    const dds::Member sample{.robot = const_cast<char*>(robot),
                             .behaviour = const_cast<char*>("courier"),
                             .session = session,
                             .specification = const_cast<char*>(specification)};
    REQUIRE(dds::write(members_, sample));
  }

private:
  const dds::Entity participant_ = dds::join(loopback_domain());
  const dds::Entity states_ = dds::make_writer<dds::State>(participant_);
  const dds::Entity members_ = dds::make_writer<dds::Member>(participant_);
};

/// Receives all samples.
class Onlooker {
public:
  std::string state(const std::string& name) {
    dds::take<dds::State>(states_, [this](const dds::State& sample, const dds_sample_info_t& info) {
      if (!info.valid_data) return;
      ++heard;
      said_[sample.state] = sample.kind == 0   ? "nothing"
                            : sample.kind == 1 ? sample.name
                                               : std::to_string(sample.number);
    });
    return said_[name];
  }
  std::vector<std::string> decisions() {
    std::vector<std::string> out;
    dds::take<dds::DecisionSample>(decisions_, [&](const dds::DecisionSample& d, const dds_sample_info_t&) {
      in_order = in_order && d.number > last_;
      gaps += d.number - last_ - 1;
      last_ = d.number;
      out.push_back(std::string(d.kind) + " " + d.group + " " + d.requester + " " + d.reason);
    });
    return out;
  }
  std::string promise() {
    dds::take<dds::PromiseSample>(promises_, [this](const dds::PromiseSample& p, const dds_sample_info_t&) {
      promise_ = std::string(p.kept ? "kept " : "broken ") + p.group + "." + p.provider + " " + p.condition;
    });
    return promise_;
  }
  bool receives(const dds::Entity& of_type) {
    dds_subscription_matched_status_t status{};
    dds_get_subscription_matched_status(of_type.get(), &status);
    return status.current_count > 0;
  }
  bool ready() { return receives(decisions_); }

  int heard = 0;
  bool in_order = true;
  std::uint64_t gaps = 0;

private:
  const dds::Entity participant_ = dds::join(loopback_domain());
  const dds::Entity states_ = dds::make_reader<dds::State>(participant_);
  const dds::Entity decisions_ = dds::make_reader<dds::DecisionSample>(participant_);
  const dds::Entity promises_ = dds::make_reader<dds::PromiseSample>(participant_);
  std::map<std::string, std::string> said_;
  std::uint64_t last_ = 0;
  std::string promise_;
};

bool is(Robot& robot, const std::string& state, std::int32_t value) {
  return robot.comes_true([&] { return robot.value(state) == value; });
}

} // namespace

TEST_CASE("a robot receives the states of another") {
  Robot one(speaks), two(hears);
  CHECK(one.behaviour.set(post::Mood::hurried, courier::Battery{-7}));
  one.step();
  CHECK(is(two, "Mood", hurried));
  CHECK(is(two, "Battery", -7));
  CHECK(one.behaviour.set(post::Mood::calm));
  one.step();
  CHECK(is(two, "Mood", calm));
  CHECK(one.bridge.counts().states_said >= 3);
  CHECK(two.bridge.counts().states_heard >= 3);
}

TEST_CASE("no thread of a bridge is real-time, or takes a signal that the program waits for") {
  const auto robot = [] { return std::make_unique<Robot>(speaks); };
  const Scheduling real_time = scheduling_of_new_thread(become_real_time, robot);
  if (real_time != Scheduling{}) CHECK(real_time.policy == SCHED_OTHER); // not every user may be real-time
  const Robot one(speaks);
  CHECK(gets_signal_that_it_waits_for());
}

TEST_CASE("a robot that joins late receives current states that were published before") {
  Robot one(speaks);
  CHECK(one.behaviour.set(post::Mood::hurried));
  one.step();
  std::this_thread::sleep_for(20ms);
  Robot two(hears);
  CHECK(is(two, "Mood", hurried)); // robot one has not stepped again
}

TEST_CASE("a robot that joins very late does not receive states that were not repeated for long") {
  Robot one({.robot = "one", .publish = {"Mood"}, .say_again = 20ms});
  CHECK(one.behaviour.set(post::Mood::hurried));
  one.step();
  std::this_thread::sleep_for(400ms); // it does not step any more: its last samples last for five times say_again
  Robot two(hears);
  CHECK(two.comes_true([&] { return two.was_told("joined one: the behaviour courier is there"); }));
  for (int i = 0; i < 20; ++i) {
    two.step();
    std::this_thread::sleep_for(10ms);
  }
  CHECK(two.value("Mood") == calm);
}

TEST_CASE("a robot repeats its states, but only while it steps") {
  Robot one({.robot = "one", .publish = {"Mood"}, .say_again = 10ms});
  Onlooker onlooker;
  CHECK(one.comes_true([&] { return onlooker.state("Mood") == "calm" && onlooker.heard > 5; }));
  std::this_thread::sleep_for(50ms);
  onlooker.state("Mood");
  const int heard = onlooker.heard;
  std::this_thread::sleep_for(100ms);
  onlooker.state("Mood");
  CHECK(onlooker.heard == heard);
}

TEST_CASE("an unset state is published as unset, and changes nothing") {
  Robot one(speaks), two(hears);
  Onlooker onlooker;
  CHECK(one.comes_true([&] { return onlooker.state("Battery") == "nothing"; }));
  CHECK(two.behaviour.set(courier::Battery{5}));
  CHECK(one.behaviour.set(post::Mood::hurried));
  one.step();
  CHECK(is(two, "Mood", hurried));
  CHECK(two.value("Battery") == 5);
}

TEST_CASE("an unknown value is reported once, and changes nothing") {
  Robot two(hears);
  Stranger one;
  for (int i = 0; i < 5; ++i) {
    one.publish("Mood", 1, 0, "merry");
    one.publish("Battery", 2, 1000, "");
    CHECK(two.comes_true([&, i] { return two.bridge.counts().unknown_values >= 2U * static_cast<unsigned>(i) + 2; }));
  }
  one.publish("Mood", 1, 0, "hurried");
  CHECK(is(two, "Mood", hurried));
  CHECK(two.value("Battery") == unset);
  CHECK(two.notices() ==
        std::vector<std::string>{
            "unknown_value one: the state Mood is merry, a value that Mood does not have; it stays as it is",
            "unknown_value one: the state Battery is 1000, a value that Battery does not have; it stays as it is"});
}

TEST_CASE("invalid samples are reported and change nothing") {
  Robot two(hears);
  Stranger one;
  std::uint64_t faults = 0; // one after the other: only the newest sample of a state is kept
  const auto is_counted = [&] {
    ++faults;
    return comes_true([&] { return two.bridge.counts().bad_samples + two.bridge.counts().unknown_values == faults; });
  };
  one.publish("Mood", 77, 1, "hurried");
  CHECK(is_counted());
  one.publish("", 1, 0, "hurried");
  CHECK(is_counted());
  one.publish("Mood", 1, 1, "hurried", "");
  CHECK(is_counted());
  one.is_member("", 1, "");
  CHECK(is_counted());
  CHECK(two.bridge.counts().bad_samples == 4);
  one.publish("Mood", 1, 1, std::string(1'000'000, 'x').c_str());
  CHECK(is_counted());
  one.publish("Mood", 2, 1, ""); // the number of a value with a name
  CHECK(is_counted());
  CHECK(two.bridge.counts().unknown_values == 2);
  one.publish("Mood", 1, 0, "hurried", "somebody"); // a robot that is not in the settings
  one.publish("Sound", 1, 0, "hurried");
  one.publish("Battery", 2, 1, "");
  CHECK(is(two, "Battery", 1));
  CHECK(two.value("Mood") == calm);
  CHECK(two.was_told("bad_sample one: the state Mood comes as something that is neither a name nor a number"));
  CHECK(two.was_told("unknown_value one: the state Mood is " + std::string(60, 'x') +
                     "..., a value that Mood does not have; it stays as it is"));
}

TEST_CASE("bytes that are no message change nothing") {
  Robot two(hears);
  Stranger one;
  std::atomic<int> complaints{0}; // messages of the library, not to be printed
  dds_set_log_sink([](void* count, const dds_log_data_t*) { ++*static_cast<std::atomic<int>*>(count); }, &complaints);
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  REQUIRE(socket >= 0);
  std::mt19937 draw(1);
  for (int i = 0; i < 1000; ++i) {
    std::string bytes(draw() % 200, 0);
    for (char& byte : bytes) byte = static_cast<char>(draw());
    if (i % 2 == 0) bytes.insert(0, "RTPS\x02\x01"); // the beginning of an RTPS message
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to.sin_port = htons(static_cast<std::uint16_t>(7400 + 250 * loopback_domain() + 10 +
                                                   draw() % 4)); // ports of the first two participants
    sendto(socket, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
  }
  close(socket);
  one.publish("Battery", 2, 42, "");
  CHECK(is(two, "Battery", 42));
  CHECK(two.value("Mood") == calm);
  CHECK(comes_true([&] { return complaints > 0; }));
  dds_set_log_sink(nullptr, nullptr);
}

TEST_CASE("a writer of states with insufficient quality is reported") {
  Robot two(hears);
  const dds::Entity participant = dds::join(loopback_domain());
  const dds_entity_t topic =
      dds_create_topic(participant.get(), &director_msgs_msg_dds__State__desc, "rt/director/state", nullptr, nullptr);
  const dds::Entity writer{dds_create_writer(participant.get(), topic, nullptr, nullptr), "a writer"}; // volatile
  CHECK(two.comes_true([&] {
    return two.was_told("incompatible : somebody says states with a quality of service that is not enough, and is not "
                        "heard (policy " +
                        std::to_string(DDS_DURABILITY_QOS_POLICY_ID) + ")");
  }));
}

TEST_CASE("robots that join, leave, restart or run another specification are reported") {
  Robot two(hears);
  {
    Robot one(speaks);
    CHECK(two.comes_true([&] { return two.was_told("joined one: the behaviour courier is there"); }));
  }
  CHECK(two.comes_true([&] { return two.was_told("gone one: the behaviour courier said goodbye"); }));
  Robot again(speaks);
  CHECK(two.comes_true([&] { return two.was_told("restarted one: the behaviour courier was started again"); }));
  CHECK(two.notices().size() == 3); // its specification is as before
  const std::string mine = dds::specification_of(plug(two.behaviour));
  Stranger three;
  three.is_member("three", 9, "0123");
  CHECK(two.comes_true([&] {
    return two.was_told(
        "other three: the behaviour courier decides otherwise there: its specification is 0123, here it is " + mine);
  }));
}

TEST_CASE("a robot whose predecessor of the same name ends after it has started is there again") {
  Robot two(hears);
  auto before = std::make_unique<Robot>(speaks);
  CHECK(two.comes_true([&] { return two.was_told("joined one: the behaviour courier is there"); }));
  Robot after(speaks);
  CHECK(two.comes_true([&] { return two.was_told("restarted one: the behaviour courier was started again"); }));
  before.reset();
  CHECK(two.comes_true([&] { return two.was_told("gone one: the behaviour courier said goodbye"); }));
  CHECK(two.comes_true([&] { return two.was_told("joined one: the behaviour courier is heard again"); }));
}

TEST_CASE("the state of a process that is gone lasts until it expires, that of one that said goodbye ends at once") {
  KeeperModule module;
  dds::Outbox outbox{64};
  keeper::Behaviour behaviour{module, outbox.observer()};
  std::atomic<bool> lost{false};
  Settings settings{.robot = "hall",
                    .domain = loopback_domain(),
                    .take_in = {{.robot = "one", .state = "Mood", .into = "Door", .behaviour = "courier"}}};
  settings.notice = [&](const dds::Notice& notice) { lost = lost || notice.kind == dds::Notice::Kind::lost; };
  dds::Bridge bridge{plug(behaviour), outbox, settings};
  const auto door = [&](std::int32_t value) {
    return comes_true([&] {
      behaviour.step(0s);
      return behaviour.engine().value(1) == value;
    });
  };
  constexpr std::int32_t unknown = 0, open = 1;
  auto killed = std::make_unique<Stranger>();
  killed->is_member("one", 9, "0123");
  killed->publish("Mood", 1, 0, "open");
  CHECK(door(open));
  killed.reset(); // without a goodbye
  CHECK(comes_true([&] { return lost.load(); }));
  std::this_thread::sleep_for(100ms); // the state's instance has ended as well
  behaviour.step(0s);
  CHECK(behaviour.engine().value(1) == open);
  Stranger polite;
  polite.publish("Mood", 1, 0, "open");
  polite.says_goodbye("Mood");
  CHECK(door(unknown));
}

TEST_CASE("two processes with one name are reported, once") {
  Robot two(hears); // before both
  Robot one(speaks), twin(speaks);
  const std::string notice =
      "twin one: another process says that it is this robot with the behaviour courier; both are "
      "heard as one";
  CHECK(one.comes_true([&] { return one.was_told(notice); }));
  CHECK(twin.comes_true([&] { return twin.was_told(notice); }));
  const auto begin = std::chrono::steady_clock::now(); // several times as long as until what they say is repeated
  CHECK(one.comes_true([&] { return std::chrono::steady_clock::now() - begin > 500ms; }));
  for (Robot* robot : {&one, &twin}) {
    const std::vector<std::string> all = robot->notices();
    CHECK(std::count(all.begin(), all.end(), notice) == 1);
  }
  const std::vector<std::string> seen = two.notices();
  CHECK(std::count(seen.begin(), seen.end(), "restarted one: the behaviour courier was started again") <= 1);
}

TEST_CASE("values that are not taken in time are reported, and the newest one is taken") {
  Robot two(hears);
  Stranger one;
  for (int i = 0; i < 200; ++i) { // without a step
    one.publish("Battery", 2, i % 100, "");
    std::this_thread::sleep_for(1ms);
  }
  CHECK(comes_true([&] { return two.bridge.counts().inbox_full > 0; }));
  CHECK(two.was_told("inbox_full one: inputs were lost, because the inbox had no room, as Battery arrived: is the behaviour stepped "
                     "often enough?"));
  one.publish("Battery", 2, 42, "");
  CHECK(is(two, "Battery", 42));
}

TEST_CASE("others receive the decisions of a robot in order, and the ends of its promises") {
  Onlooker onlooker;
  Robot one(speaks);
  one.plans.deliver = [](courier::Deliver::Default& run) {
    return run.enter(courier::Open{}, courier::Walk{post::Steps{}});
  };
  one.skills.unlocking = [](courier::Open::Unlocking& run) {
    run.set(courier::Door::open);
    return run.keep();
  };
  CHECK(one.comes_true([&] { return onlooker.ready(); }));
  one.behaviour.request(courier::Deliver{{std::make_unique<int>(1)}});
  std::vector<std::string> decisions;
  CHECK(one.comes_true([&] {
    const auto more = onlooker.decisions();
    decisions.insert(decisions.end(), more.begin(), more.end());
    return onlooker.promise() == "kept Open.unlocking Door == open";
  }));
  CHECK(one.comes_true([&] {
    const auto more = onlooker.decisions();
    decisions.insert(decisions.end(), more.begin(), more.end());
    return decisions.size() >= 6;
  }));
  CHECK(decisions.front() == "grant Deliver root ");
  CHECK(decisions[1] == "run Deliver  new_task");
  CHECK(onlooker.in_order);
  CHECK(onlooker.gaps == 0);
}

TEST_CASE("decisions that find the outbox full are counted, and others see the gap") {
  Onlooker onlooker;
  Robot one(speaks);
  CHECK(one.comes_true([&] { return onlooker.ready(); }));
  one.plans.rest = [](courier::Rest::Default& run) { return run.request(courier::Sing{}); };
  for (int i = 0; i < 200; ++i) { // without a call of the bridge: its decisions wait
    one.behaviour.request<courier::Rest>();
    one.behaviour.step(0s);
  }
  CHECK(one.comes_true([&] { return one.bridge.counts().decisions_lost > 0; }));
  CHECK(one.was_told(
      "decisions_lost one: more was decided at once than the outbox has room for; others see gaps in the numbers"));
  one.behaviour.request<courier::Rest>();
  CHECK(one.comes_true([&] {
    onlooker.decisions();
    return onlooker.gaps > 0;
  }));
  CHECK(onlooker.in_order);
}

TEST_CASE("a domain that does not exist, or has no network, is reported as an error") {
  loopback_domain();
  Plans plans;
  Skills skills;
  dds::Outbox outbox;
  courier::Behaviour behaviour{plans, skills, outbox.observer()};
  const auto enter = [&](std::uint32_t domain) -> std::string {
    try {
      dds::Bridge bridge(plug(behaviour), outbox, {.robot = "one", .domain = domain});
    } catch (const dds::Failure& failure) { return failure.what(); }
    return "";
  };
  CHECK(enter(233) == "dds: there is no domain 233; the highest is 232");
  const std::string loopback = std::getenv("CYCLONEDDS_URI");
  setenv("CYCLONEDDS_URI",
         R"(<CycloneDDS><Domain Id="any"><General><Interfaces><NetworkInterface address="203.0.113.1"/></Interfaces>)"
         R"(</General></Domain></CycloneDDS>)",
         1);
  CHECK(enter(231) ==
        "dds: no way into domain 231: Error. Is the network there that CYCLONEDDS_URI names, and not every "
        "participant's port taken?");
  setenv("CYCLONEDDS_URI", loopback.c_str(), 1);
}
