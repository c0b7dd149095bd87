#pragma once
// SPDX-License-Identifier: MIT
// The messages to viewers, in order: server-sent events whose data are lines of a trace. They are made from the queue
// of events and from moments; for each viewer it has the next message.
//
// A viewer first gets the header of a trace, a line with the number of events that it missed, and the current state.
// One that is too slow gets those lines again, without the header. State that no event reports comes behind the events
// of its moment, in a message of its own, `event: standing`: without those messages the stream is a trace. The `id` of
// a message is the number of the event behind it: a browser that reconnects sends the last one, and continues there.

#include "runtime/core/inspect/why.hpp"
#include "runtime/hosted/trace/event_queue.hpp"
#include "runtime/live/backlog.hpp"
#include "runtime/live/moments.hpp"

#include <memory>
#include <optional>
#include <string>

namespace director::live {

/// The place of one viewer.
struct Place {
  std::uint64_t next = 0;     ///< the first event that it did not get
  bool begun = false;         ///< it has got the header
  std::uint64_t standing = 0; ///< the last message of this kind that it got, or does not need
};

class Feed {
public:
  using Text = std::shared_ptr<const std::string>;

  Feed(EventQueue& queue, Moments& moments, const Names& names, std::size_t memory);

  /// Takes the waiting events, and the newest moment. Without memory for them they are dropped, with all that is kept.
  void take();
  /// The next message for a viewer at this place, which is advanced; null: nothing new.
  Text next(Place& place);
  /// The place behind the message with this `id`; nothing: it is gone, and the viewer begins again.
  std::optional<Place> resume(const std::string& id) const;
  /// A message for viewers without other messages: the engine's time.
  Text alive() const;

  /// The newest moment, valid until the next take(); without tables in its view there is none yet.
  const Moment& moment() const { return *moment_; }
  /// The time up to which that moment lasted, as far as it was shown: the engine's time, or the last one before
  /// something newer was shown.
  Time until() const { return moments_.until(); }

private:
  void take_all();
  void finish_block(std::uint64_t end);
  const Text& standing();
  void see_standing();
  Text begin_anew(Place& place);

  EventQueue& queue_;
  Moments& moments_;
  const Names names_;
  Backlog backlog_;
  const Moment* moment_;
  std::string header_;      ///< as a line of a message
  std::string text_;        ///< of the block in construction
  std::uint64_t begin_ = 0; ///< its first event
  std::uint64_t last_ = 0;  ///< its last one
  std::uint64_t taken_ = 0; ///< from the queue, so far

  // Messages of standing groups.
  Text standing_;                     ///< of the newest moment; null: not needed yet
  std::uint64_t standing_of_ = 0;     ///< the micro-step of its moment
  std::uint64_t standing_passes_ = 0; ///< the passes before that moment
  std::uint64_t standing_after_ = 0;  ///< the events before that moment
  Text shown_;                        ///< the last one for viewers
  std::uint64_t shown_before_ = 0;    ///< the event behind it
  std::uint64_t shown_count_ = 0;     ///< the number of such messages so far
  bool may_mislead_ = false; ///< since then there was an event after which a reader may wrongly take a group to run
};

} // namespace director::live
