#pragma once
// SPDX-License-Identifier: MIT
// Shows in a browser what a behaviour does while it does it: a small HTTP server on this computer, which sends the page
// that `directorc docs` wrote, and to each that looks all events as they happen.
//
//   director::LiveView view{rover::names::all(), {.page = "rover.html"}};
//   rover::Behaviour behaviour{mission, chassis, view.observer()};
//   std::puts(view.url().c_str()); // http://127.0.0.1:41873/3f0c.../
//   for (;;) {
//     behaviour.step(now());
//     view.show(behaviour);
//   }
//
// The thread that steps puts each event into a queue of fixed size and, where a step changed something, copies what
// holds now into one of three buffers, all taken from the heap before: no lock, no memory, no system call. A thread of
// the view's own does all the rest, for all viewers. Nothing that viewers do, or leave undone, reaches the thread that
// steps. docs/live.md has the whole.

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

/// An observer whose events people see in a browser.
class LiveView {
public:
  /// What is shown, where, and within which bounds.
  struct Options {
    std::string page = {}; ///< the file that `directorc docs` wrote; empty: `html`
    std::string_view html =
        {}; ///< that page itself, as director_embed_page has it; empty: there is no page, only what it reads
    std::string address = "127.0.0.1"; ///< of this computer; another one than of loopback lets others in
    std::uint16_t port = 0;            ///< 0: any that is free
    std::size_t queue = 65'536;        ///< events that can wait for the view's thread
    std::size_t memory = 4 << 20; ///< bytes of events that are kept for viewers who are late; together, not for each
    std::size_t connections = 64; ///< at a time
    // Each from a millisecond to a day.
    std::chrono::milliseconds interval{20}; ///< how often viewers are told
    std::chrono::milliseconds patience{
        10'000}; ///< a viewer who takes nothing for so long is let go; a request gets half of it
  };

  /// `names`: `all()` of the behaviour's `names`.
  explicit LiveView(const Names& names);
  /// The same, with options.
  LiveView(const Names& names, const Options& options);
  /// Lets all viewers go. The behaviour must not step any more.
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

  // For the thread that steps.

  /// For the constructor of a Behaviour, which the view must outlive.
  Observer observer() {
    return {[](void* self, const Event& event) { static_cast<LiveView*>(self)->tell(event); }, this};
  }
  /// Shows the event; what an observer of your own may do besides.
  void tell(const Event& event) {
    if (!queue_.put(event)) queue_.drop();
  }
  /// After a step: what holds now. Without it viewers who come late know of what happened before only what happens
  /// again, and `why` has no answer.
  template <class Behaviour>
  void show(const Behaviour& behaviour) {
    show(behaviour.seen().view());
  }
  /// By number.
  void show(const View& view) { moments_.show(view, queue_.told()); }

  // From any thread.

  /// Lets viewers request and cancel root tasks that have no data, and set external states. Without it they only look.
  /// `post`: `behaviour.post()`; the behaviour must live as long as the view does, or `forbid_commands` be called
  /// before.
  template <class Post>
  void allow_commands(const Post& post) {
    allow({.request = [post](Index edge, Index level) { return post.request_row(edge, level); },
           .cancel = [post](Index edge) { return post.cancel_row(edge); },
           .cancel_all = [post] { return post.cancel_all(); },
           .set = [post](Index state, std::int32_t value) { return post.set_row(state, value); }});
  }
  /// Commands are refused from now on, as they were in the beginning.
  void forbid_commands() { allow({}); }

  /// It can be looked at. False: `error()` says why not; all calls do as little as they can, and nothing else is wrong.
  bool good() const { return error_.empty(); }
  /// In words: what could not be done, and what to do.
  const std::string& error() const { return error_; }
  /// Where to look, with the token that lets in; empty where it is not good.
  const std::string& url() const { return url_; }
  /// Who looks now.
  std::size_t viewers() const;
  /// Events that found the queue full, so far: each viewer missed them.
  std::uint64_t dropped() const { return queue_.dropped(); }

private:
  void allow(live::Commands commands);

  EventQueue queue_;
  live::Moments moments_;
  std::string error_, url_;
  std::unique_ptr<live::Server> server_;
};

} // namespace director
