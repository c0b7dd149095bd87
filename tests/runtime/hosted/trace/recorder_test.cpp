// SPDX-License-Identifier: MIT
// Tests runtime/hosted/trace/recorder.hpp and the queue in it.
#include "runtime/hosted/trace/json_lines.hpp"
#include "runtime/hosted/trace/recorder.hpp"
#include "runtime/hosted/within_a_day.hpp"
#include "tests/runtime/hosted/trace/lamp.hpp"
#include "tests/support/command.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/no_new_threads.hpp"
#include "tests/support/other_threads.hpp"

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <pthread.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <ctime>
#include <limits>
#include <new>
#include <semaphore>
#include <thread>

using namespace director;
using namespace director::tests;

namespace {

std::string header(const Names& names) {
  std::string out;
  append_header(names, "", out);
  return out + "\n";
}

std::string lines(const Lamp& lamp, int from, int to) {
  std::string out;
  for (int i = from; i < to; ++i) {
    append_event(lamp.event(Event::Kind::exhausted, i), lamp.names, out);
    out += '\n';
  }
  return out;
}

/// A format that blocks until the test releases it.
class Held final : public TraceFormat {
public:
  explicit Held(std::binary_semaphore& begun, std::binary_semaphore& go, const Names& names)
      : begun_(begun),
        go_(go),
        lines_(json_lines(names)) {}
  void begin(std::string&) override {}
  void event(const Event& event, std::string& out) override {
    if (event.time == 0) {
      begun_.release();
      go_.acquire();
    }
    lines_->event(event, out);
  }
  void dropped(std::uint64_t count, std::string& out) override { lines_->dropped(count, out); }

private:
  std::binary_semaphore &begun_, &go_;
  std::unique_ptr<TraceFormat> lines_;
};

} // namespace

TEST_CASE("a recorder writes its header at once, and at its end all events") {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "run.jsonl").string();
  const Lamp lamp;
  {
    Recorder recorder{lamp.names, file};
    CHECK(read_file(file) == header(lamp.names));
    const Observer observer = recorder.observer();
    for (int i = 0; i < 1000; ++i) observer.tell(observer.self, lamp.event(Event::Kind::exhausted, i));
    CHECK(recorder.good());
    CHECK(recorder.dropped() == 0);
  }
  CHECK(read_file(file) == header(lamp.names) + lines(lamp, 0, 1000));
}

TEST_CASE("events that find the queue full are counted, and reported in the file at their place") {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "run.jsonl").string();
  const Lamp lamp;
  std::binary_semaphore begun{0}, go{0};
  {
    Recorder recorder{
        std::make_unique<Held>(begun, go, lamp.names), file, {.queue = 8, .interval = std::chrono::milliseconds(1)}};
    recorder.tell(lamp.event(Event::Kind::exhausted, 0));
    begun.acquire(); // its place is not free yet
    for (int i = 1; i < 13; ++i) recorder.tell(lamp.event(Event::Kind::exhausted, i));
    CHECK(recorder.dropped() == 5);
    go.release();
    for (int tries = 0; tries < 10'000 && recorder.dropped() == 5; ++tries) { // until there is a place again
      if (read_file(file).find("\"t\":7,") != std::string::npos) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    recorder.tell(lamp.event(Event::Kind::exhausted, 13));
    CHECK(recorder.dropped() == 5);
  }
  CHECK(read_file(file) == lines(lamp, 0, 8) + "{\"event\":\"dropped\",\"count\":5}\n" + lines(lamp, 13, 14));
}

TEST_CASE("events that are missing at the end are reported too, also if no event follows") {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "run.jsonl").string();
  const Lamp lamp;
  std::binary_semaphore begun{0}, go{0};
  {
    Recorder recorder{
        std::make_unique<Held>(begun, go, lamp.names), file, {.queue = 2, .interval = std::chrono::milliseconds(1)}};
    recorder.tell(lamp.event(Event::Kind::exhausted, 0));
    begun.acquire();
    for (int i = 1; i < 4; ++i) recorder.tell(lamp.event(Event::Kind::exhausted, i));
    go.release();
    for (int tries = 0; tries < 10'000 && read_file(file).find("dropped") == std::string::npos; ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    CHECK(read_file(file) == lines(lamp, 0, 2) + "{\"event\":\"dropped\",\"count\":2}\n"); // before it is closed
  }
  CHECK(read_file(file) == lines(lamp, 0, 2) + "{\"event\":\"dropped\",\"count\":2}\n");
}

TEST_CASE("a simulation waits for its recorder, and nothing is missing") {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "run.jsonl").string();
  const Lamp lamp;
  {
    Recorder recorder{lamp.names, file, {.queue = 4, .interval = std::chrono::milliseconds(1), .waits = true}};
    for (int i = 0; i < 300; ++i) recorder.tell(lamp.event(Event::Kind::exhausted, i));
    CHECK(recorder.dropped() == 0);
  }
  CHECK(read_file(file) == header(lamp.names) + lines(lamp, 0, 300));
}

TEST_CASE("a recorder with the longest interval sleeps, but not while a thread waits for it") {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "run.jsonl").string();
  const Lamp lamp;
  for (const auto interval : {std::chrono::milliseconds::max(), std::chrono::milliseconds(std::chrono::hours(1)),
                              std::chrono::milliseconds(0), std::chrono::milliseconds::min()}) {
    const std::clock_t before = std::clock();
    {
      Recorder recorder{lamp.names, file, {.queue = 4, .interval = interval, .waits = true}};
      for (int i = 0; i < 300; ++i) recorder.tell(lamp.event(Event::Kind::exhausted, i));
      CHECK(recorder.dropped() == 0);
      std::this_thread::sleep_for(std::chrono::milliseconds(400));
    }
    CHECK(std::clock() - before < CLOCKS_PER_SEC / 5); // processor time
    CHECK(read_file(file) == header(lamp.names) + lines(lamp, 0, 300));
  }
}

TEST_CASE("an interval is at least a millisecond, and at most a day") {
  using std::chrono::milliseconds;
  CHECK(within_a_day(milliseconds::max()) == std::chrono::hours(24));
  CHECK(within_a_day(milliseconds::min()) == milliseconds(1));
  CHECK(within_a_day(milliseconds(0)) == milliseconds(1));
  CHECK(within_a_day(milliseconds(20)) == milliseconds(20));
}

TEST_CASE("a file that cannot be written does not stop the behaviour") {
  const Lamp lamp;
  Recorder nowhere{lamp.names, "/nowhere/run.jsonl"};
  CHECK(nowhere.error() == ENOENT);
  for (int i = 0; i < 10; ++i) nowhere.tell(lamp.event(Event::Kind::exhausted, i));
  Recorder full{lamp.names, "/dev/full"};
  CHECK(full.error() == ENOSPC);
}

TEST_CASE("a recorder whose thread cannot be started has an error, and does not stop the behaviour") {
  const Lamp lamp;
  const TemporaryFolder folder;
  const NoNewThreads limit;
  Recorder recorder{lamp.names, (folder.path() / "run.jsonl").string(), {.queue = 4, .waits = true}};
  CHECK(recorder.error() == EAGAIN);
  for (int i = 0; i < 10; ++i) recorder.tell(lamp.event(Event::Kind::exhausted, i));
  CHECK(recorder.dropped() > 0);
}

TEST_CASE("a recorder without memory ends its file, and does not stop the behaviour") {
  /// There is none from the third event on.
  class Forgetful final : public TraceFormat {
    void begin(std::string&) override {}
    void event(const Event& event, std::string& out) override {
      if (event.time >= 2) throw std::bad_alloc();
      out += "event\n";
    }
    void dropped(std::uint64_t, std::string&) override {}
    void end(std::string& out) override { out += "end\n"; }
  };
  const Lamp lamp;
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "run.jsonl").string();
  Recorder recorder{std::make_unique<Forgetful>(), file, {.interval = std::chrono::milliseconds(1)}};
  const auto tell = [&](int from, int to) {
    for (int i = from; i < to; ++i) recorder.tell(lamp.event(Event::Kind::exhausted, i));
  };
  tell(0, 2);
  while (read_file(file) != "event\nevent\n") std::this_thread::sleep_for(std::chrono::milliseconds(1));
  CHECK(recorder.error() == 0);
  tell(2, 10);
  while (recorder.good()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  CHECK(recorder.error() == ENOMEM);
  tell(10, 20);
  recorder.close();
  CHECK(read_file(file) == "event\nevent\n");
}

TEST_CASE("a recorder without memory for its queue has an error") {
  if (tests::is_sanitized) return; // the sanitizer's allocator ends the program
  const Lamp lamp;
  const TemporaryFolder folder;
  Recorder recorder{lamp.names, (folder.path() / "run.jsonl").string(), {.queue = std::size_t{1} << 45}};
  CHECK(recorder.error() == ENOMEM);
  recorder.tell(lamp.event(Event::Kind::exhausted, 0));
}

TEST_CASE("a signal that the program waits for is not taken by the thread of a recorder that was made before") {
  const Lamp lamp;
  const TemporaryFolder folder;
  const Recorder recorder{lamp.names, (folder.path() / "run.jsonl").string()};
  CHECK(gets_signal_that_it_waits_for());
}

TEST_CASE("a failure of the last write is known when the recorder is closed") {
  const Lamp lamp;
  const TemporaryFolder folder;
  rlimit as_it_was{};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &as_it_was) == 0);
  const rlimit small{header(lamp.names).size() + 10, as_it_was.rlim_max};
  REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
  int open = -1, closed = -1;
  {
    Recorder recorder{lamp.names, (folder.path() / "run.jsonl").string(), {.interval = std::chrono::hours(24)}};
    for (int i = 0; i < 10; ++i) recorder.tell(lamp.event(Event::Kind::exhausted, i));
    open = recorder.error();
    recorder.close();
    closed = recorder.error();
    recorder.tell(lamp.event(Event::Kind::exhausted, 10)); // it is not recorded, without harm
  }
  setrlimit(RLIMIT_FSIZE, &as_it_was);
  CHECK(open == 0);
  CHECK(closed == EFBIG);
}

TEST_CASE("a pipe whose reader has ended is an error of the recorder, and no signal for the program") {
  const Lamp lamp;
  std::array<int, 2> ends{};
  REQUIRE(::pipe(ends.data()) == 0);
  Recorder recorder{lamp.names, "/proc/self/fd/" + std::to_string(ends[1]), {.interval = std::chrono::milliseconds(1)}};
  CHECK(recorder.good());
  ::close(ends[0]);
  recorder.tell(lamp.event(Event::Kind::exhausted, 0)); // written by its thread
  for (int tries = 0; tries < 10'000 && recorder.good(); ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  recorder.close();
  CHECK(recorder.error() == EPIPE);

  // A thread that has a signal of its own pending keeps it.
  sigset_t pipe, before, pending;
  sigemptyset(&pipe);
  sigaddset(&pipe, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &pipe, &before);
  std::raise(SIGPIPE);
  const Recorder other{lamp.names, "/dev/null"};
  sigpending(&pending);
  CHECK(sigismember(&pending, SIGPIPE) == 1);
  const timespec at_once{};
  sigtimedwait(&pipe, nullptr, &at_once);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  ::close(ends[1]);
}

TEST_CASE("a named pipe without a reader is an error at once, and one whose reader takes nothing at the end") {
  const Lamp lamp;
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "run.jsonl").string();
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  CHECK(Recorder(lamp.names, path).error() == ENXIO);

  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  REQUIRE(reader >= 0);
  constexpr int more_than_a_pipe_holds = 5000;
  Recorder recorder{lamp.names, path};
  for (int i = 0; i < more_than_a_pipe_holds; ++i) recorder.tell(lamp.event(Event::Kind::exhausted, i));
  recorder.close();
  CHECK(recorder.error() == ETIMEDOUT);
  ::close(reader);
}

TEST_CASE("a named pipe whose reader is slow gets all events") {
  const Lamp lamp;
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "run.jsonl").string();
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  REQUIRE(reader >= 0);
  constexpr int events = 5000;
  std::string all;
  {
    Recorder recorder{lamp.names, path};
    for (int i = 0; i < events; ++i) recorder.tell(lamp.event(Event::Kind::exhausted, i));
    std::this_thread::sleep_for(std::chrono::milliseconds(100)); // meanwhile the pipe is full
    ::fcntl(reader, F_SETFL, 0);
    std::thread read([&] {
      std::array<char, 10'000> bytes{};
      for (ssize_t count = 1; count > 0;) {
        count = ::read(reader, bytes.data(), bytes.size());
        if (count > 0) all.append(bytes.data(), static_cast<std::size_t>(count));
      }
    });
    recorder.close();
    read.join();
    CHECK(recorder.good());
  }
  ::close(reader);
  CHECK(all == header(lamp.names) + lines(lamp, 0, events));
}

TEST_CASE("the thread of a recorder is not real-time, and otherwise as nice as the one that made it") {
  const TemporaryFolder folder;
  const Lamp lamp;
  const auto record = [&] { return std::make_unique<Recorder>(lamp.names, (folder.path() / "run.jsonl").string()); };
  CHECK(scheduling_of_new_thread(become_nice, record) == Scheduling{SCHED_OTHER, 15});
  const Scheduling real_time = scheduling_of_new_thread(become_real_time, record);
  const int as_here = getpriority(PRIO_PROCESS, 0);
  if (real_time != Scheduling{})
    CHECK(real_time == Scheduling{SCHED_OTHER, as_here}); // not every user may be real-time
}

TEST_CASE("a thread that waits for a place in a queue is released when the queue is closed") {
  const Lamp lamp;
  const TemporaryFolder folder;
  Recorder recorder{lamp.names, (folder.path() / "run.jsonl").string(), {.queue = 4, .waits = true}};
  recorder.close();
  for (int i = 0; i < 10; ++i) recorder.tell(lamp.event(Event::Kind::exhausted, i));
  CHECK(recorder.dropped() > 0);
  CHECK(read_file(folder.path() / "run.jsonl") == header(lamp.names));
}

TEST_CASE("the file of a process that is killed has whole lines, up to shortly before its end") {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "run.jsonl").string();
  const Lamp lamp;
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    Recorder recorder{lamp.names, file, {.interval = std::chrono::milliseconds(1), .waits = true}};
    for (int i = 0;; ++i) recorder.tell(lamp.event(Event::Kind::exhausted, i));
  }
  while (!std::filesystem::exists(file) || std::filesystem::file_size(file) < 500'000)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  const std::string text = read_file(file);
  const std::string whole = text.substr(0, text.rfind('\n') + 1);
  const auto count = static_cast<int>(std::count(whole.begin(), whole.end(), '\n')) - 1;
  CHECK(count > 5000);
  CHECK(whole == header(lamp.names) + lines(lamp, 0, count));
}

TEST_CASE("a queue that no memory can hold is refused") {
  if (tests::is_sanitized) return; // the sanitizer's allocator ends the program
  CHECK_THROWS_AS(EventQueue(std::numeric_limits<std::size_t>::max()), std::bad_alloc);
}
