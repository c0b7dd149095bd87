#pragma once
// SPDX-License-Identifier: MIT
// Shows in a browser what a behaviour does at the moment: a small HTTP server on this computer, which sends the page
// that `directorc docs` wrote, and all events to each viewer as they happen.
//
//   director::LiveView view{rover::names::all(), {.page = "rover.html"}};
//   rover::Behaviour behaviour{mission, chassis, view.observer()};
//   std::puts(view.url().c_str()); // http://127.0.0.1:41873/3f0c.../
//   for (;;) {
//     behaviour.step(now());
//     view.show(behaviour);
//   }
//
// The thread that steps puts each event into a queue of fixed size and, if a step changed something, copies the state
// into one of three buffers, all allocated before: no lock, no memory, no system call. A thread of the view does all
// the rest, for all viewers. Nothing that viewers do, or fail to do, affects the thread that steps. docs/live.md has
// the details.

#include "runtime/core/inspect/why.hpp"
#include "runtime/hosted/trace/event_queue.hpp"
#include "runtime/live/commands.hpp"
#include "runtime/live/moments.hpp"

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

namespace director {

namespace live {
class Server;
}

/// An observer whose events are shown in a browser.
class LiveView {
public:
  /// The page, the address, and limits.
  struct Options {
    std::string page = {};      ///< the file that `directorc docs` wrote; empty: `html`
    std::string_view html = {}; ///< the page itself, of `director_add_behaviour(… PAGE)`; empty: no page, only its data
    std::string address = "127.0.0.1"; ///< of this computer; any but a loopback address gives others access
    std::uint16_t port = 0;            ///< 0: any that is free
    std::size_t queue = 65'536;        ///< events that can wait for the view's thread
    std::size_t memory = 4 << 20;      ///< bytes of events that are kept for late viewers; of all together
    std::size_t connections = 64;      ///< at a time, at least one
    // Each from a millisecond to a day.
    std::chrono::milliseconds interval{20}; ///< period of messages to viewers
    std::chrono::milliseconds patience{
        10'000}; ///< time after which a viewer that takes nothing is disconnected; for a request half of it
  };

  /// `names`: `all()` of the behaviour's `names`.
  explicit LiveView(const Names& names);
  /// The same, with options.
  LiveView(const Names& names, const Options& options);
  /// Disconnects all viewers. The behaviour must not step any more.
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

  // For the thread that steps.

  /// For the constructor of a Behaviour, which the view must outlive.
  Observer observer() {
    return {[](void* self, const Event& event) { static_cast<LiveView*>(self)->tell(event); }, this};
  }
  /// Shows the event; to be called by an observer of your own.
  void tell(const Event& event) {
    if (!queue_.put(event)) queue_.drop();
  }
  /// Shows the state after a step. Without it, viewers that connect late do not know the state before that, and `why`
  /// has no answer.
  template <class Behaviour>
  void show(const Behaviour& behaviour) {
    show(behaviour.seen().view());
  }
  /// The same for an engine without a Behaviour.
  void show(const View& view) { moments_.show(view, queue_.total()); }

  // From any thread.

  /// Allows viewers to request and cancel root tasks without data, and to set external states; otherwise they can only
  /// read. `post`: `behaviour.post()`; the behaviour must exist as long as the view, or until `forbid_commands` is
  /// called.
  template <class Post>
  void allow_commands(const Post& post) {
    allow({.request = [post](Index edge, Index level) { return post.request_row(edge, level); },
           .cancel = [post](Index edge) { return post.cancel_row(edge); },
           .cancel_all = [post] { return post.cancel_all(); },
           .set = [post](Index state, std::int32_t value) { return post.set_row(state, value); }});
  }
  /// Refuses commands from now on, as at the beginning.
  void forbid_commands() { allow({}); }

  /// Whether the server runs. If not, `error()` has the reason; all calls do as little as possible, and nothing else is
  /// affected.
  bool good() const { return error_.empty(); }
  /// A sentence: what failed, and what to do.
  const std::string& error() const { return error_; }
  /// The address with the token; empty if the server does not run.
  const std::string& url() const { return url_; }
  /// The number of viewers.
  std::size_t viewers() const;
  /// Events dropped so far: each viewer missed them.
  std::uint64_t dropped() const { return queue_.dropped(); }

private:
  void allow(live::Commands commands);

  EventQueue queue_;
  live::Moments moments_;
  std::string error_, url_;
  std::unique_ptr<live::Server> server_;
};

} // namespace director
