#include "lamp.hpp"
#include "runtime/dds/asker.hpp"
#include "runtime/dds/bridge.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <thread>

namespace {

using namespace std::chrono_literals;
using director::Outcome;

class SwitchBoard final : public lamp::Switch_board {
public:
  Outcome provide(lamp::Shine::Fully& run) override {
    run.set(lamp::Light::bright);
    return run.keep();
  }
  Outcome provide(lamp::Shine::Faintly& run) override {
    run.set(lamp::Light::dim);
    return run.keep();
  }
};

director::dds::Settings settings(std::uint32_t domain) {
  director::dds::Settings out;
  out.robot = "hall";
  out.domain = domain;
  out.publish = {"Light"};
  out.take_in = {{.robot = "porter", .state = "Door", .into = "Door", .behaviour = "door"}};
  out.offer = {{.task = "Shine"}};
  out.notice = [](const director::dds::Notice& notice) {
    std::fprintf(stderr, "%s: %s\n", notice.robot.c_str(), notice.text.c_str());
  };
  return out;
}

} // namespace

int main(int count, char** values) {
  const auto domain = static_cast<std::uint32_t>(count > 1 ? std::atoi(values[1]) : 0);
  namespace names = lamp::names;
  SwitchBoard board;
  director::dds::Outbox outbox;
  lamp::Behaviour behaviour{board, outbox.observer()};
  director::dds::Bridge bridge{
      director::dds::plug("lamp", behaviour,
                          {names::group, names::provider, names::edge, names::state, names::value, names::condition}),
      outbox, settings(domain)};

  // Another computer would do this; here it is another thread.
  auto asked = std::async(std::launch::async, [domain] {
    director::dds::Asker asker("panel", domain);
    return asker.request({.robot = "hall", .behaviour = "lamp"}, "Shine", 20s);
  });

  const auto begin = std::chrono::steady_clock::now();
  while (behaviour.state<lamp::Shine>() != director::RunState::running) {
    behaviour.step(std::chrono::steady_clock::now() - begin);
    bridge.stepped();
    std::this_thread::sleep_for(10ms);
  }
  std::printf("%s\n", to_text(asked.get()));
}
