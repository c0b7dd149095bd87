// Header: runtime/live/feed.hpp. Test: tests/runtime/live/feed_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/live/feed.hpp"

#include "runtime/hosted/trace/json_lines.hpp"
#include "runtime/hosted/trace/json_text.hpp"
#include "runtime/hosted/trace/run_ends.hpp"
#include "runtime/live/moment_lines.hpp"

#include <charconv>
#include <new>
#include <string_view>
#include <utility>

namespace director::live {

namespace {

constexpr std::size_t most_of_block = 64 << 10; ///< bytes; a viewer that does not read keeps one block in memory

/// The end of a message, with the number of the event behind it.
void append_end(std::uint64_t event, std::string& out) {
  out += "id: ";
  json::append_number(event, out);
  out += "\n\n";
}

/// Makes complete lines the data lines of a message.
void append_data(std::string_view lines, std::string& out) {
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n') + 1;
    out += "data: ";
    out += lines.substr(0, end);
    lines.remove_prefix(end);
  }
}

Feed::Text standing_message(std::string_view standing) {
  std::string out = "event: standing\ndata: ";
  out += standing;
  out += "\n\n";
  return std::make_shared<const std::string>(std::move(out));
}

} // namespace

Feed::Feed(EventQueue& queue, Moments& moments, const Names& names, std::size_t memory)
    : queue_(queue),
      moments_(moments),
      names_(names),
      backlog_(memory),
      moment_(&moments.look()),
      shown_(standing_message("[]")) {
  header_ = "data: ";
  append_header(names, "", header_);
  header_ += '\n';
}

void Feed::take() {
  try {
    take_all();
  } catch (const std::bad_alloc&) {
    text_ = std::string();
    backlog_.clear();
    may_mislead_ = true;
  }
}

void Feed::take_all() {
  moment_ = &moments_.look(); // before the events, so that these include all events before the moment
  if (moment_->view.micro_step != standing_of_ || moment_->view.passes != standing_passes_ ||
      moment_->events != standing_after_)
    standing_ = nullptr;
  const std::uint64_t cut = moment_->events;
  queue_.take([&](const EventQueue::Entry& entry) {
    const std::uint64_t number = taken_++ + entry.dropped;
    if (number == cut) see_standing();
    if (number != begin_ && text_.empty()) begin_ = number; // events were dropped
    if (!text_.empty() && (number == cut || text_.size() >= most_of_block || number != last_ + 1)) {
      finish_block(last_ + 1);
      begin_ = number;
    }
    text_ += "data: ";
    append_event(entry.event, names_, text_);
    text_ += '\n';
    last_ = number;
    may_mislead_ = may_mislead_ || ends_hold(entry.event) || ends_request(entry.event);
  });
  see_standing();
  if (!text_.empty()) finish_block(last_ + 1);
  // The queue had all events before the moment that were not dropped.
  if (moment_->view.tables == nullptr || moment_->events <= begin_) return;
  backlog_.skip_to(begin_ = moment_->events);
  see_standing();
}

const Feed::Text& Feed::standing() {
  if (standing_ != nullptr) return standing_;
  std::string text;
  append_standing(moment_->view, names_, text);
  standing_of_ = moment_->view.micro_step;
  standing_passes_ = moment_->view.passes;
  standing_after_ = moment_->events;
  return standing_ = standing_message(text);
}

/// Makes a message of the standing groups, only if no event is behind the moment, since it would be wrong then. It is
/// repeated if an event may have misled a reader.
void Feed::see_standing() {
  const std::uint64_t at = text_.empty() ? begin_ : last_ + 1;
  if (moment_->view.tables == nullptr || moment_->events != at) return;
  if (!std::exchange(may_mislead_, false) && *standing() == *shown_) return;
  shown_ = standing();
  shown_before_ = at;
  ++shown_count_;
}

void Feed::finish_block(std::uint64_t end) {
  append_end(end, text_);
  backlog_.add({begin_, end, std::make_shared<const std::string>(std::move(text_))});
  text_.clear();
  begin_ = end;
}

Feed::Text Feed::next(Place& place) {
  if (place.begun) {
    if (place.next == shown_before_ && std::exchange(place.standing, shown_count_) != shown_count_) return shown_;
    if (const Block* const block = backlog_.at(place.next)) {
      place.next = block->end;
      return block->text;
    }
    if (place.next >= backlog_.end()) return nullptr;
  }
  return begin_anew(place);
}

/// Begins with a moment that is newer than the viewer's. If the program shows none, with the oldest event that is kept.
Feed::Text Feed::begin_anew(Place& place) {
  std::uint64_t from = moment_->events;
  const bool shown = moment_->view.tables != nullptr && from >= backlog_.begin();
  if (shown) {
    if (!backlog_.continues_at(from) || (place.begun && from <= place.next))
      return nullptr; // a newer moment comes soon
  } else {
    const Block* const block = backlog_.from(place.next);
    from = block == nullptr ? backlog_.end() : block->begin;
  }
  std::string lines;
  if (from != place.next) {
    append_dropped(from - place.next, lines);
    lines += '\n';
  }
  if (shown) append_moment(moment_->view, names_, lines);
  std::string out = place.begun ? "" : header_;
  append_data(lines, out);
  append_end(from, out);
  if (shown) out += *standing();
  place = {from, true, shown_count_};
  return std::make_shared<const std::string>(std::move(out));
}

std::optional<Place> Feed::resume(const std::string& id) const {
  std::uint64_t event = 0;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), event);
  if (error != std::errc{} || end != id.data() + id.size() || !backlog_.continues_at(event)) return std::nullopt;
  return Place{event, true};
}

Feed::Text Feed::alive() const {
  std::string out = "event: alive\ndata: ";
  json::append_number(moments_.now(), out);
  out += "\n\n";
  return std::make_shared<const std::string>(std::move(out));
}

} // namespace director::live
