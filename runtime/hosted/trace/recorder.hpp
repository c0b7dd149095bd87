#pragma once
// SPDX-License-Identifier: MIT
// An observer that writes all that happens in a behaviour to a file, to be looked at and played again:
//
//   director::Recorder recorder{rover::names::all(), "run.jsonl"};
//   rover::Behaviour behaviour{mission, chassis, recorder.observer()};
//
// The thread that steps puts each event into a queue of fixed size, which was taken from the heap before: no lock, no
// memory, no system call. A thread of the recorder's own takes them out and writes. What finds the queue full is
// dropped, counted, and said in the file at its place. Of a process that is killed the file has all but what happened
// within the last `interval`.

#include "runtime/hosted/trace/event_queue.hpp"
#include "runtime/hosted/trace/trace_format.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace director {

/// An observer whose events a thread of its own writes into a file.
class Recorder {
public:
  /// How much waits, how long, and what happens when there is no more room.
  struct Options {
    std::size_t queue = 65'536;             ///< how many events can wait
    std::chrono::milliseconds interval{20}; ///< how often what waits is written, from a millisecond to a day
    bool waits = false; ///< who steps waits while the queue is full: for simulations, which run faster than the world
  };

  /// What is written follows from the end of the path: JSON lines, or Perfetto's packets for `.perfetto-trace` and
  /// `.pftrace`. A file that is there is replaced. `names`: `all()` of the behaviour's `names`.
  Recorder(const Names& names, const std::string& path);
  /// The same, with options.
  Recorder(const Names& names, const std::string& path, Options options);
  /// In a format of your own.
  Recorder(std::unique_ptr<TraceFormat> format, const std::string& path, Options options);
  /// `close`s it. The behaviour must not step any more.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// For the constructor of a Behaviour, which the recorder must outlive.
  Observer observer();
  /// Records the event; what an observer of your own may do besides.
  void tell(const Event& event) {
    if (!queue_.put(event)) put_when_full(event);
  }

  /// Writes what waits and ends the file; what is told later is not recorded. Then `error()` is about all of it:
  /// before, what happened within the last `interval` may still fail to be written. The behaviour must not step
  /// meanwhile.
  void close();

  /// The file could be opened, and all so far could be written. From any thread.
  bool good() const { return error_.load(std::memory_order_relaxed) == 0; }
  /// Why not, as `errno` has it; 0: it is good.
  int error() const { return error_.load(std::memory_order_relaxed); }
  /// Events that found the queue full, so far. From any thread.
  std::uint64_t dropped() const { return queue_.dropped(); }

private:
  void put_when_full(const Event& event);
  void write_all();
  void write_waiting();
  void flush();

  EventQueue queue_;
  std::unique_ptr<TraceFormat> format_;
  Options options_;
  int file_;
  std::string buffer_;
  std::uint64_t told_dropped_ = 0;
  std::atomic<int> error_{0};
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stop_ = false;
  bool is_full_ = false; ///< and somebody waits for a place
  std::thread writer_;
};

} // namespace director
