#pragma once
// SPDX-License-Identifier: MIT
// An observer that writes all that happens in a behaviour to a file, to be viewed and replayed:
//
//   director::Recorder recorder{rover::names::all(), "run.jsonl"};
//   rover::Behaviour behaviour{mission, chassis, recorder.observer()};
//
// The thread that steps puts each event into a queue of fixed size, allocated before: no lock, no memory, no system
// call. A thread of the recorder takes the events out and writes them. Events that find the queue full are dropped and
// counted, and the file says so at their place. If the process is killed, the file has all but the last `interval`.

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

/// An observer whose events are written to a file by a thread of its own.
class Recorder {
public:
  /// The size of the queue, the interval, and what happens if the queue is full.
  struct Options {
    std::size_t queue = 65'536;             ///< events that can wait
    std::chrono::milliseconds interval{20}; ///< how often events are written, from a millisecond to a day
    bool waits = false; ///< the thread that steps waits while the queue is full: for simulations faster than real time
  };

  /// The format follows from the end of the path: JSON lines, or Perfetto's packets for `.perfetto-trace` and
  /// `.pftrace`. An existing file is replaced. `names`: `all()` of the behaviour's `names`.
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
  /// Records the event; to be called by an observer of your own.
  void tell(const Event& event) {
    if (!queue_.put(event)) put_when_full(event);
  }

  /// Writes all events that wait and ends the file; later events are not recorded. After it, `error()` covers all
  /// events: before, those of the last `interval` may still fail. A reader of a pipe that takes less than 4 kB in a
  /// second is not waited for (ETIMEDOUT). The behaviour must not step meanwhile.
  void close();

  /// Whether the file could be opened (a named pipe: has a reader), its thread started, and all events so far written.
  /// From any thread.
  bool good() const { return error_.load(std::memory_order_relaxed) == 0; }
  /// The error, as in `errno`; 0: none.
  int error() const { return error_.load(std::memory_order_relaxed); }
  /// Events dropped so far. From any thread.
  std::uint64_t dropped() const { return queue_.dropped(); }

private:
  void put_when_full(const Event& event);
  template <class Write>
  void with_memory(const Write& write);
  void write_all();
  void write_waiting();
  void flush();
  bool write_buffer();

  EventQueue queue_;
  std::unique_ptr<TraceFormat> format_;
  Options options_;
  int file_;
  std::string buffer_;
  std::uint64_t reported_dropped_ = 0;
  std::atomic<int> error_{0};
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stop_ = false;
  bool is_full_ = false; ///< a thread waits for a place
  std::thread writer_;
};

} // namespace director
