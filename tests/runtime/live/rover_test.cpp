// SPDX-License-Identifier: MIT
// The rover of docs/live.md: viewers get a trace, and commands are as on the page.
#include "rover.hpp"
#include "rover_page.hpp"
#include "runtime/live/live_view.hpp"
#include "tests/docs/rover/scripted.hpp"
#include "tests/runtime/live/client.hpp"
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <thread>

using namespace director::tests;
using namespace std::chrono_literals;

namespace {

/// Like the main function of a program, until it is stopped.
void drive(std::atomic<const std::string*>& url, const std::atomic<bool>& running) {
  ScriptedMission mission;
  ScriptedChassis chassis;
  director::LiveView view{rover::names::all(), {.html = director::pages::rover()}};
  rover::Behaviour behaviour{mission, chassis, view.observer()};
  std::puts(view.good() ? view.url().c_str() : view.error().c_str());
  view.allow_commands(behaviour.post());
  url = &view.url();

  const auto start = std::chrono::steady_clock::now();
  while (running) {
    behaviour.step(std::chrono::steady_clock::now() - start);
    view.show(behaviour);
    std::this_thread::sleep_for(1ms);
  }
  view.forbid_commands();
}

/// The output of `curl -N .../events | sed -n 's/^data: {/{/p'`, up to a line that contains this.
std::string saved_until(const std::string& url, std::string_view last) {
  const Caller viewer(url);
  viewer.send(get(url, "events"));
  std::string received, out;
  while (out.find(last) == std::string::npos) {
    viewer.read(received);
    std::this_thread::sleep_for(1ms);
    if (const std::size_t head = received.find("\r\n\r\n"); head != std::string::npos) received.erase(0, head + 4);
    for (const Message& message : take_messages(received)) {
      for (const std::string& line : message.data) out += line.starts_with('{') ? line + "\n" : "";
    }
  }
  return out;
}

} // namespace

TEST_CASE("a viewer gets a trace that can be printed, from the beginning or from the middle") {
  const TemporaryFolder folder;
  std::atomic<const std::string*> url{nullptr};
  std::atomic<bool> running{true};
  std::thread program([&] { drive(url, running); });
  while (url == nullptr) std::this_thread::sleep_for(1ms);
  const std::string at = *url;
  const auto post = [&](const char* what) { return call(at, get(at, what, "", "POST")).body; };
  const auto print = [&](const std::string& trace) {
    const std::string file = (folder.path() / "run.jsonl").string();
    std::ofstream(file) << trace;
    return run_command("directorc trace " + file + " | sed 's/^\\[[^]]*\\] //'", source_dir()).output;
  };

  CHECK(post("request?task=Explore") == "posted: request Explore\n");
  const std::string first = print(saved_until(at, R"("event":"run","group":"Wheels")"));
  CHECK(first.find("run Drive.rolling new_task\n") != std::string::npos);
  CHECK(post("request?task=Photograph") == "posted: request Photograph\n");
  const std::string second = print(saved_until(at, R"("event":"done","group":"Photograph")"));
  CHECK(second.find(" events are missing\n") != std::string::npos);
  CHECK(second.find("run Photograph new_task\n") != std::string::npos);
  CHECK(second.find("fault") == std::string::npos);
  CHECK(call(at, get(at, "")).body.find("<title>rover</title>") != std::string::npos);
  running = false;
  program.join();
}
