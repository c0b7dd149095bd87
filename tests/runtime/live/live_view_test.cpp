// SPDX-License-Identifier: MIT
// Tests runtime/live/live_view.hpp: with viewers that read, that read nothing, and that come and go.
#include "runtime/live/live_view.hpp"
#include "tests/runtime/live/client.hpp"
#include "tests/runtime/live/soccer_game.hpp"
#include "tests/support/command.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/no_new_threads.hpp"
#include "tests/support/other_threads.hpp"

#include <catch2/catch.hpp>
#include <malloc.h>
#include <poll.h>
#include <pthread.h>
#include <sys/socket.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <deque>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <thread>

using namespace director;
using namespace director::tests;
using namespace std::chrono_literals;

namespace {

/// Viewers that read all messages.
class Readers {
public:
  Readers(const std::string& url, std::size_t count) : viewers_(count) {
    for (Viewer& viewer : viewers_) {
      viewer.caller = std::make_unique<Caller>(url);
      viewer.caller->send(get(url, "events"));
    }
  }
  /// Reads the waiting messages of all of them.
  void read() {
    std::vector<pollfd> sockets;
    for (const Viewer& viewer : viewers_) sockets.push_back({viewer.caller->socket(), POLLIN, 0});
    poll(sockets.data(), sockets.size(), 1);
    for (std::size_t i = 0; i < viewers_.size(); ++i) {
      if (sockets[i].revents == 0) continue;
      Viewer& viewer = viewers_[i];
      viewer.ended = !viewer.caller->read(viewer.text);
      if (const std::size_t end = viewer.text.find("\r\n\r\n"); !viewer.answered && end != std::string::npos) {
        viewer.answered = true;
        viewer.text.erase(0, end + 4);
      }
      if (viewer.answered) std::ranges::move(take_messages(viewer.text), std::back_inserter(viewer.messages));
    }
  }
  /// Whether each has begun, and is at this event or behind it; the first difference ends the test.
  bool are_at(const std::vector<std::string>& happened) {
    return std::ranges::all_of(viewers_, [&](Viewer& viewer) {
      if (wrong.empty()) wrong = viewer.follower.follow(viewer.messages, happened);
      viewer.messages.clear();
      if (wrong.empty() && viewer.ended) wrong = "the connection ended";
      return !wrong.empty() || (viewer.follower.begun() && viewer.follower.at() == happened.size());
    });
  }
  std::size_t gaps() const {
    return std::accumulate(viewers_.begin(), viewers_.end(), std::size_t{0},
                           [](std::size_t sum, const Viewer& each) { return sum + each.follower.gaps(); });
  }

  std::string wrong;

private:
  struct Viewer {
    std::unique_ptr<Caller> caller;
    std::string text;
    std::vector<Message> messages;
    Follower follower;
    bool answered = false, ended = false;
  };
  std::vector<Viewer> viewers_;
};

/// A viewer that requests all events, and never reads a byte.
std::vector<Caller> deaf_viewers(const std::string& url, std::size_t count) {
  std::vector<Caller> out;
  for (std::size_t i = 0; i < count; ++i) {
    out.emplace_back(url, 2048);
    out.back().send(get(url, "events"));
  }
  return out;
}

void wait_for_viewers(const LiveView& view, std::size_t count) {
  while (view.viewers() != count) std::this_thread::sleep_for(1ms);
}

/// The durations of steps, in microseconds.
struct Times {
  explicit Times(std::vector<double> took) {
    std::ranges::sort(took);
    half = took[took.size() / 2];
    most = took[took.size() * 99 / 100];
    longest = took.back();
  }
  std::string text() const {
    char out[200];
    std::snprintf(out, sizeof(out), "half of the steps within %5.2f us, 99 %% within %6.2f us, the longest %8.1f us",
                  half, most, longest);
    return out;
  }
  /// Prints these beside those of `other`. No test compares them: they depend on the machine and its load.
  std::string against(const Times& other) const {
    char out[200];
    std::snprintf(out, sizeof(out), "%.2f times, %.2f times, %.1f times", half / other.half, most / other.most,
                  longest / other.longest);
    return out;
  }
  double half = 0, most = 0, longest = 0;
};

} // namespace

TEST_CASE("of 200 viewers half read nothing: the others get every event in order, and steps are not slower") {
  constexpr int steps = 6000;
  const auto play = [](SoccerGame& game) {
    for (int i = 0; i < steps; ++i) {
      game.step();
      if (i % 10 == 0) std::this_thread::sleep_for(1ms); // a hundred times as fast as real time
    }
  };
  SoccerGame alone(nullptr);
  play(alone);
  LiveView nobody_looks{soccer::names::all()};
  SoccerGame unseen(&nobody_looks);
  play(unseen);

  LiveView view{soccer::names::all(), {.memory = 1 << 20, .connections = 256, .interval = 5ms}};
  REQUIRE(view.good());
  SoccerGame game(&view);
  const std::vector<Caller> deaf = deaf_viewers(view.url(), 100);
  Readers readers(view.url(), 100);
  wait_for_viewers(view, 200);

  // The others read in a thread of their own, as in another process.
  std::atomic<bool> over{false};
  std::thread reading([&] {
    while (!over) readers.read();
  });
  play(game);
  over = true;
  reading.join();
  const std::vector<std::string> happened = game.happened();
  while (!readers.are_at(happened)) readers.read();
  CHECK(readers.wrong == "");
  CHECK(view.dropped() == 0);
  CHECK(game.count() == alone.count());
  const Times without(alone.took), with_none(unseen.took), with_all(game.took);
  std::printf("live view: %d steps of soccer, %zu events\n"
              "  nobody can look:                       %s\n"
              "  nobody looks:                          %s\n"
              "  200 viewers, 100 of them read nothing: %s; %zu gaps\n"
              "  nobody looks against nobody can look:  %s\n"
              "  200 viewers against nobody looks:      %s\n",
              steps, game.count(), without.text().c_str(), with_none.text().c_str(), with_all.text().c_str(),
              readers.gaps(), with_none.against(without).c_str(), with_all.against(with_none).c_str());
}

TEST_CASE("the memory for viewers that read nothing does not grow") {
  LiveView view{soccer::names::all(), {.memory = 256 << 10, .connections = 64, .interval = 1ms}};
  SoccerGame game(&view);
  const std::vector<Caller> deaf = deaf_viewers(view.url(), 50);
  Readers reader(view.url(), 1);
  wait_for_viewers(view, 51);
  const auto play = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      game.step();
      if (i % 50 == 0) reader.read();
    }
    const std::vector<std::string> happened = game.happened();
    while (!reader.are_at(happened)) reader.read();
  };
  play(2000); // many times the kept events
  const std::size_t before = mallinfo2().uordblks;
  play(8000);
  const std::size_t after = mallinfo2().uordblks;
  CHECK(reader.wrong == "");
  CHECK(view.viewers() == 51);
  CHECK(after < before + (1 << 20)); // of 3 MB of events, with 50 viewers
}

TEST_CASE("a viewer that reads nothing is disconnected after a while, and the others stay") {
  LiveView view{soccer::names::all(), {.memory = 64 << 10, .interval = 1ms, .patience = 2s}};
  SoccerGame game(&view);
  const std::vector<Caller> deaf = deaf_viewers(view.url(), 10);
  Readers reader(view.url(), 3);
  wait_for_viewers(view, 13);
  while (view.viewers() > 3) {
    for (int i = 0; i < 50; ++i) game.step();
    reader.read();
  }
  for (int i = 0; i < 100; ++i) game.step();
  const std::vector<std::string> happened = game.happened();
  while (!reader.are_at(happened)) reader.read();
  CHECK(reader.wrong == "");
}

TEST_CASE("with the longest patience a viewer that reads nothing stays, and a view with the longest interval sleeps") {
  LiveView patient{soccer::names::all(), {.interval = 1ms, .patience = std::chrono::milliseconds::max()}};
  SoccerGame game(&patient);
  const std::vector<Caller> deaf = deaf_viewers(patient.url(), 10);
  wait_for_viewers(patient, 10);
  for (int i = 0; i < 2000; ++i) game.step();
  std::this_thread::sleep_for(50ms);
  CHECK(patient.viewers() == 10);

  const std::clock_t before = std::clock();
  const LiveView seldom{soccer::names::all(), {.interval = std::chrono::milliseconds::max()}};
  std::this_thread::sleep_for(400ms);
  CHECK(std::clock() - before < CLOCKS_PER_SEC / 5); // processor time, including the first view's
}

TEST_CASE("a viewer that is slow for a while misses events, gets their number, and continues") {
  LiveView view{soccer::names::all(), {.memory = 100'000, .interval = 1ms}};
  SoccerGame game(&view);
  Readers reader(view.url(), 1);
  wait_for_viewers(view, 1);
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 6000; ++i) game.step();
    const std::vector<std::string> happened = game.happened();
    while (!reader.are_at(happened)) reader.read();
    CHECK(reader.wrong == "");
  }
  CHECK(reader.gaps() >= 3);
}

TEST_CASE("a view ends while its viewers are stuck, and in the middle of requests") {
  std::optional<LiveView> view;
  view.emplace(soccer::names::all(), LiveView::Options{.interval = 1ms});
  const std::string url = view->url();
  SoccerGame game(&*view);
  std::vector<Caller> deaf = deaf_viewers(url, 20);
  for (int i = 0; i < 20; ++i) deaf.emplace_back(url).send("GET / HTTP");
  for (int i = 0; i < 20; ++i) deaf.emplace_back(url);
  wait_for_viewers(*view, 20);
  for (int i = 0; i < 3000; ++i) game.step();
  view.reset();
  CHECK_FALSE(Caller(url).connected());
  for (const Caller& each : deaf) each.read_all();
}

TEST_CASE("a client that ends its direction behind its request gets the whole page") {
  const TemporaryFolder folder;
  REQUIRE(
      run_command("directorc docs behaviours/soccer/soccer.yaml -o " + folder.path().string(), source_dir()).status ==
      0);
  const LiveView view{soccer::names::all(), {.page = (folder.path() / "soccer.html").string()}};
  const Response page = call(view.url(), get(view.url(), ""));
  const Caller caller(view.url(), 4096); // so that the page does not fit into what the system keeps
  caller.send(get(view.url(), ""));
  REQUIRE(shutdown(caller.socket(), SHUT_WR) == 0);
  CHECK(split(caller.read_all()).body.size() == page.body.size());
}

TEST_CASE("the page, why, and paths that do not exist") {
  const TemporaryFolder folder;
  REQUIRE(
      run_command("directorc docs behaviours/soccer/soccer.yaml -o " + folder.path().string(), source_dir()).status ==
      0);
  const std::string file = (folder.path() / "soccer.html").string(), html = read_file(file);
  LiveView from_file{soccer::names::all(), {.page = file}}, from_text{soccer::names::all(), {.html = html}};
  SoccerGame game(&from_file);
  for (int i = 0; i < 100; ++i) game.step();
  while (call(from_file.url(), get(from_file.url(), "why")).status != 200) std::this_thread::sleep_for(1ms);
  const Response page = call(from_file.url(), get(from_file.url(), ""));
  CHECK(page.status == 200);
  CHECK(page.body == call(from_text.url(), get(from_text.url(), "")).body);
  CHECK(page.head.find("\r\nContent-Length: " + std::to_string(page.body.size()) + "\r\n") != std::string::npos);
  CHECK(page.body.ends_with("</html>\n"));
  const auto walks = [&] {
    return call(from_file.url(), get(from_file.url(), "why?group=Walk")).body.find(R"("kind":"running")") !=
           std::string::npos;
  };
  for (int i = 0; i < 5000 && !walks(); ++i) std::this_thread::sleep_for(1ms); // until the view has the last state
  CHECK(walks());
  CHECK(call(from_file.url(), get(from_file.url(), "nothing")).status == 404);
  CHECK(call(from_file.url(), get(from_text.url(), "")).status == 403); // the token of another program
  CHECK(call(from_text.url(), get(from_text.url(), "why")).status == 503);
}

TEST_CASE("a browser that reconnects continues where it was") {
  LiveView view{soccer::names::all(), {.interval = 1ms}};
  SoccerGame game(&view);
  for (int i = 0; i < 50; ++i) game.step();
  const std::string id = std::to_string(game.count());
  {
    Readers reader(view.url(), 1);
    const std::vector<std::string> before =
        game.happened(); // all of them taken by the view, once the reader has the last
    while (!reader.are_at(before)) reader.read();
    REQUIRE(reader.wrong.empty());
  }
  for (int i = 0; i < 50; ++i) game.step();
  const std::vector<std::string> happened = game.happened();
  const Caller again(view.url());
  again.send(get(view.url(), "events", "Last-Event-ID: " + id + "\r\n"));
  std::string text;
  std::vector<std::string> data;
  while (data.size() < happened.size() - std::stoul(id)) {
    again.read(text);
    if (const std::size_t head = text.find("\r\n\r\n"); head != std::string::npos) text.erase(0, head + 4);
    for (const Message& message : take_messages(text)) {
      if (message.event.empty()) data.insert(data.end(), message.data.begin(), message.data.end());
    }
    std::this_thread::sleep_for(1ms);
  }
  CHECK(data == std::vector<std::string>(happened.begin() + std::stol(id), happened.end()));
}

TEST_CASE("commands by HTTP work if the program allows them") {
  LiveView view{soccer::names::all(), {.interval = 1ms}};
  CHECK(call(view.url(), get(view.url(), "cancel_all", "", "POST")).status == 403);
  sim::World world{1};
  player::Player<player::Servos> player{world, view.observer()};
  bool cancelled = false;
  struct Post {
    bool* cancelled;
    bool request_row(Index, Index) const { return true; }
    bool cancel_row(Index) const { return true; }
    bool cancel_all() const { return *cancelled = true; }
    bool set_row(Index, std::int32_t) const { return true; }
  };
  view.allow_commands(Post{&cancelled});
  CHECK(call(view.url(), get(view.url(), "cancel_all", "", "POST")).status == 202);
  CHECK(cancelled);
  CHECK(call(view.url(), get(view.url(), "cancel_all", "Origin: http://evil.example\r\n", "POST")).status == 403);
  view.forbid_commands();
  CHECK(call(view.url(), get(view.url(), "cancel_all", "", "POST")).status == 403);
}

TEST_CASE("a view on any address of this computer has the computer's own name in its address, and answers to it") {
  LiveView view{soccer::names::all(), {.address = "0.0.0.0"}};
  REQUIRE(view.good());
  CHECK(view.url().find("0.0.0.0") == std::string::npos);
  const std::string at = authority_of(view.url()),
                    local = "http://127.0.0.1" + at.substr(at.find(':')) + "/" + token_of(view.url()) + "/";
  CHECK(call(local, get(view.url(), "why")).status == 503);
  CHECK(call(local, get(local, "why")).status == 503);
}

TEST_CASE("an IPv6 address is in brackets") {
  const LiveView view{soccer::names::all(), {.address = "::1"}};
  if (view.good())
    CHECK(view.url().starts_with("http://[::1]:"));
  else
    CHECK(view.error().starts_with("cannot listen at [::1]:0: ")); // on a system without IPv6
}

TEST_CASE("a view without memory for its queue says so, and the robot runs on") {
  if (is_sanitized) return; // the sanitizer's allocator ends the program
  for (const std::size_t queue : {std::numeric_limits<std::size_t>::max(), std::size_t{1} << 40}) {
    LiveView view{soccer::names::all(), {.queue = queue}};
    CHECK_FALSE(view.good());
    CHECK(view.error() ==
          "there is no memory for " + std::to_string(queue) + " events that wait: give LiveView a smaller `queue`");
    CHECK(view.url().empty());
    SoccerGame game(&view);
    for (int i = 0; i < 10; ++i) game.step();
    CHECK(view.dropped() > 0);
  }
}

TEST_CASE("a view whose thread cannot be started says so, and leaves the signals of the program as they were") {
  sigset_t before, after;
  pthread_sigmask(SIG_SETMASK, nullptr, &before);
  {
    const NoNewThreads limit;
    const LiveView view{soccer::names::all()};
    CHECK(view.error() ==
          "cannot start the thread that serves viewers: Resource temporarily unavailable; the limits of "
          "threads and memory of the program leave no place for it");
    CHECK(view.url().empty());
  }
  pthread_sigmask(SIG_SETMASK, nullptr, &after);
  for (const int each : {SIGINT, SIGTERM, SIGHUP}) CHECK(sigismember(&after, each) == sigismember(&before, each));
}

TEST_CASE("the thread of a view has a lower priority than the one that made it, also if that is niced or real-time") {
  const auto view = [] { return std::make_unique<LiveView>(soccer::names::all()); };
  const int lower = std::min(getpriority(PRIO_PROCESS, 0) + 10, 19); // the test itself may be niced
  CHECK(scheduling_of_new_thread([] { return true; }, view) == Scheduling{SCHED_OTHER, lower});
  CHECK(scheduling_of_new_thread(become_nice, view) == Scheduling{SCHED_OTHER, 19});
  const Scheduling real_time = scheduling_of_new_thread(become_real_time, view);
  if (real_time != Scheduling{}) CHECK(real_time == Scheduling{SCHED_OTHER, lower}); // not every user may be real-time
}

TEST_CASE("an error of a view is a sentence, and the behaviour continues") {
  const auto error = [](const LiveView::Options& options) {
    LiveView view{soccer::names::all(), options};
    CHECK_FALSE(view.good());
    CHECK(view.url().empty());
    CHECK(view.viewers() == 0);
    SoccerGame game(&view);
    game.step();
    return view.error();
  };
  const TemporaryFolder folder;
  const std::string other = (folder.path() / "other.html").string();
  std::ofstream(other) << "<html></html>";
  CHECK(error({.page = "/nowhere/soccer.html"}) ==
        "cannot read the page /nowhere/soccer.html: No such file or directory; `directorc docs` writes one");
  CHECK(error({.page = other}) ==
        other + " is not one that `directorc docs` wrote, in HTML: it has no policy of its own");
  CHECK(error({.html = "text"}) ==
        "the page is not one that `directorc docs` wrote, in HTML: it has no policy of its own");
  std::ofstream{other}; // empties it
  CHECK(error({.page = other}) ==
        other + " is not one that `directorc docs` wrote, in HTML: it has no policy of its own");
  CHECK(error({.page = folder.path().string()}) ==
        "cannot read the page " + folder.path().string() + ": Is a directory; `directorc docs` writes one");
  const LiveView first{soccer::names::all()};
  const std::string port = authority_of(first.url()).substr(10);
  CHECK(error({.port = static_cast<std::uint16_t>(std::stoi(port))}) ==
        "cannot listen at 127.0.0.1:" + port +
            ": Address already in use; another program has the port: give another one, or 0 for any that is free");
  CHECK(error({.address = "203.0.113.1"}) ==
        "cannot listen at 203.0.113.1:0: Cannot assign requested address; name an address of this computer, such as "
        "127.0.0.1");
  CHECK(error({.address = "no such name"}).starts_with("there is no address \"no such name\" ("));
}
