#pragma once
// SPDX-License-Identifier: MIT
// What viewers are sent, in order: server-sent events whose data are lines of a trace. Makes it of the queue of events
// and of moments, and says for each viewer what comes next.
//
// A viewer begins with the header of a trace, a line that says how many events it missed, and what holds now. One that
// is too slow gets those lines again, without the header. What holds and no event tells comes behind the events of its
// moment, in a message of its own, `event: standing`: without those messages the stream is a trace. The `id` of a
// message is the number of the event behind it: a browser that comes back sends the last one, and goes on there.

#include "runtime/core/inspect/why.hpp"
#include "runtime/hosted/trace/event_queue.hpp"
#include "runtime/live/backlog.hpp"
#include "runtime/live/moments.hpp"

#include <memory>
#include <optional>
#include <string>

namespace director::live {

/// How far one viewer is.
struct Place {
  std::uint64_t next = 0;     ///< the first event that it did not get
  bool begun = false;         ///< it has the header
  std::uint64_t standing = 0; ///< the last message of this kind that it got, or that it needs no more
};

class Feed {
public:
  using Text = std::shared_ptr<const std::string>;

  Feed(EventQueue& queue, Moments& moments, const Names& names, std::size_t memory);

  /// Takes what was told, and the newest moment.
  void take();
  /// The next message for a viewer there, which is then further; null: nothing new.
  Text next(Place& place);
  /// Where one who was sent the message with this `id` goes on; nothing: that is gone, and it begins anew.
  std::optional<Place> resume(const std::string& id) const;
  /// A message for who hears nothing else: the engine's time.
  Text alive() const;

  /// The newest moment; without tables in its view there is none yet. Until the next take().
  const Moment& moment() const { return *moment_; }

private:
  void finish_block(std::uint64_t end);
  const Text& standing();
  void see_standing();
  Text begin_anew(Place& place);

  EventQueue& queue_;
  Moments& moments_;
  const Names names_;
  Backlog backlog_;
  const Moment* moment_;
  std::string header_;      ///< as a message's line
  std::string text_;        ///< of the block that is being made
  std::uint64_t begin_ = 0; ///< its first event
  std::uint64_t last_ = 0;  ///< its last one
  std::uint64_t taken_ = 0; ///< from the queue, so far

  // Messages of where groups stand.
  Text standing_;                 ///< of the newest moment; null: nobody needed it yet
  std::uint64_t standing_of_ = 0; ///< the micro-step of the moment that it is of
  Text told_;                     ///< the last one that viewers get
  std::uint64_t told_before_ = 0; ///< ... before this event
  std::uint64_t told_count_ = 0;  ///< how many there were so far
  bool may_mislead_ = false;      ///< since then came an event by which a reader may take a group to run that does not
};

} // namespace director::live
