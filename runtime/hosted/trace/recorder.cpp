// Header: runtime/hosted/trace/recorder.hpp. Test: tests/runtime/hosted/trace/recorder_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/hosted/trace/recorder.hpp"

#include "runtime/hosted/background_thread.hpp"
#include "runtime/hosted/within_a_day.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <new>
#include <system_error>
#include <utility>

namespace director {

namespace {

constexpr std::size_t full_buffer = 1 << 20; ///< bytes in the buffer, after which they are written to the file
constexpr std::chrono::seconds patience{1};  ///< of close() with a reader of a pipe that takes hardly anything

/// While it lives, a write of this thread to a pipe without a reader, or beyond the limit of a file's size, is an error
/// only: without it, the kernel also sends a signal that ends the program.
class NoSignalOfWrites {
public:
  NoSignalOfWrites() {
    sigset_t pending;
    sigpending(&pending);
    sigemptyset(&signals_);
    for (const int each : {SIGPIPE, SIGXFSZ}) {
      if (sigismember(&pending, each) == 0) sigaddset(&signals_, each); // one that waits already is the program's
    }
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  }
  ~NoSignalOfWrites() {
    const timespec at_once{};
    while (sigtimedwait(&signals_, nullptr, &at_once) >= 0 || errno == EINTR) {}
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoSignalOfWrites(const NoSignalOfWrites&) = delete;
  NoSignalOfWrites& operator=(const NoSignalOfWrites&) = delete;

private:
  sigset_t signals_, before_;
};

} // namespace

std::unique_ptr<TraceFormat> trace_format_of(const std::string& path, const Names& names, std::string file) {
  return path.ends_with(".perfetto-trace") || path.ends_with(".pftrace") ? perfetto(names)
                                                                         : json_lines(names, std::move(file));
}

Recorder::Recorder(const Names& names, const std::string& path) : Recorder(names, path, Options()) {}

Recorder::Recorder(const Names& names, const std::string& path, Options options)
    : Recorder(trace_format_of(path, names), path, options) {}

Recorder::Recorder(std::unique_ptr<TraceFormat> format, const std::string& path, Options options)
    : queue_(EventQueue::with_room_for(options.queue)),
      format_(std::move(format)),
      options_(options),
      file_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NONBLOCK, 0666)) {
  if (file_ < 0) error_ = errno;
  if (queue_.size() < options.queue) error_ = ENOMEM;
  options_.interval = within_a_day(options.interval);
  format_->begin(buffer_);
  write_buffer();
#ifdef __cpp_exceptions
  try {
    writer_ = background_thread([this] { write_all(); });
  } catch (const std::system_error& problem) {
    if (good()) error_ = problem.code().value();
    stop_ = true;
    ::close(std::exchange(file_, -1));
  }
#else
  writer_ = background_thread([this] { write_all(); });
#endif
}

/// Without memory the file ends, as it does on a full disk.
template <class Write>
void Recorder::with_memory(const Write& write) {
#ifdef __cpp_exceptions
  try {
    write();
  } catch (const std::bad_alloc&) {
    buffer_ = std::string();
    if (good()) error_ = ENOMEM;
  }
#else
  write();
#endif
}

Recorder::~Recorder() { close(); }

void Recorder::close() {
  {
    const std::lock_guard lock(mutex_);
    if (std::exchange(stop_, true)) return;
  }
  wake_.notify_one();
  writer_.join();
  with_memory([&] {
    write_waiting();
    format_->end(buffer_);
    flush();
  });
  if (file_ >= 0 && ::close(file_) != 0 && good()) error_ = errno;
  file_ = -1;
}

Observer Recorder::observer() {
  return {[](void* self, const Event& event) { static_cast<Recorder*>(self)->tell(event); }, this};
}

void Recorder::put_when_full(const Event& event) {
  if (!options_.waits) return queue_.drop();
  while (!queue_.put(event)) {
    {
      const std::lock_guard lock(mutex_);
      if (stop_) return queue_.drop(); // the writer has stopped
      is_full_ = true;
    }
    wake_.notify_one();
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
}

/// The thread that steps does not wake the writer, which would be a system call: so the writer polls.
void Recorder::write_all() {
  std::unique_lock lock(mutex_);
  while (!stop_) {
    lock.unlock();
    with_memory([&] {
      write_waiting();
      flush();
    });
    lock.lock();
    wake_.wait_for(lock, options_.interval, [&] { return stop_ || std::exchange(is_full_, false); });
  }
}

void Recorder::write_waiting() {
  if (!good()) {
    queue_.take([](const EventQueue::Entry&) {});
    return;
  }
  const auto report = [&](std::uint64_t dropped) {
    if (dropped != reported_dropped_) format_->dropped(dropped - reported_dropped_, buffer_);
    reported_dropped_ = dropped;
  };
  queue_.take([&](const EventQueue::Entry& entry) {
    report(entry.dropped);
    format_->event(entry.event, buffer_);
    if (buffer_.size() >= full_buffer) flush();
  });
  const std::uint64_t dropped = queue_.dropped();
  if (queue_.is_empty()) report(dropped); // no event was stored behind those, which would report them
}

/// Writes the whole buffer. A pipe may be full: then this waits for its reader, in close() not for ever.
void Recorder::flush() {
  auto last = std::chrono::steady_clock::now(); // of the last progress, or before close()
  while (!write_buffer()) {
    pollfd file{file_, POLLOUT, 0};
    const bool moves = poll(&file, 1, 50) > 0;
    const auto now = std::chrono::steady_clock::now();
    const std::lock_guard lock(mutex_);
    if (moves || !stop_) last = now;
    if (now - last > patience) error_ = ETIMEDOUT;
  }
}

/// Writes as much of the buffer as the file takes at once. False: there is a rest.
bool Recorder::write_buffer() {
  if (buffer_.empty()) return true;
  const NoSignalOfWrites guard;
  std::string_view rest = buffer_;
  while (!rest.empty() && good()) {
    const ssize_t written = ::write(file_, rest.data(), rest.size());
    if (written >= 0) {
      rest.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN) {
      buffer_.erase(0, buffer_.size() - rest.size());
      return false;
    } else if (errno != EINTR) {
      error_ = errno;
    }
  }
  buffer_.clear();
  return true;
}

} // namespace director
