// Header: runtime/live/feed.hpp. Test: tests/runtime/live/feed_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/live/feed.hpp"

#include "runtime/hosted/trace/json_lines.hpp"
#include "runtime/hosted/trace/json_text.hpp"
#include "runtime/hosted/trace/run_ends.hpp"
#include "runtime/live/moment_lines.hpp"

#include <charconv>
#include <string_view>
#include <utility>

namespace director::live {

namespace {

constexpr std::size_t most_of_block = 64 << 10; ///< bytes; a viewer that does not read keeps one block

/// The end of a message, with the event behind it.
void append_end(std::uint64_t event, std::string& out) {
  out += "id: ";
  json::append_number(event, out);
  out += "\n\n";
}

/// Lines, each with its end, as lines of a message.
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
      told_(standing_message("[]")) {
  header_ = "data: ";
  append_header(names, "", header_);
  header_ += '\n';
}

void Feed::take() {
  moment_ = &moments_.look(); // before the events, so that all that were told before it are among them
  if (moment_->view.micro_step != standing_of_) standing_ = nullptr;
  const std::uint64_t cut = moment_->told;
  queue_.take([&](const EventQueue::Entry& entry) {
    const std::uint64_t number = taken_ + entry.dropped;
    if (number == cut) see_standing();
    if (number != begin_ && text_.empty()) begin_ = number; // some were dropped
    if (!text_.empty() && (number == cut || text_.size() >= most_of_block || number != last_ + 1)) {
      finish_block(last_ + 1);
      begin_ = number;
    }
    text_ += "data: ";
    append_event(entry.event, names_, text_);
    text_ += '\n';
    last_ = number;
    may_mislead_ = may_mislead_ || ends_hold(entry.event) || ends_request(entry.event);
    ++taken_;
  });
  see_standing();
  if (!text_.empty()) finish_block(last_ + 1);
}

const Feed::Text& Feed::standing() {
  if (standing_ != nullptr) return standing_;
  std::string text;
  append_standing(moment_->view, names_, text);
  standing_of_ = moment_->view.micro_step;
  return standing_ = standing_message(text);
}

/// Only where the events are those before the moment: behind later ones it would be untrue. The same again is told
/// where a reader may have come to think otherwise.
void Feed::see_standing() {
  const std::uint64_t at = text_.empty() ? begin_ : last_ + 1;
  if (moment_->view.tables == nullptr || moment_->told != at) return;
  if (!std::exchange(may_mislead_, false) && *standing() == *told_) return;
  told_ = standing();
  told_before_ = at;
  ++told_count_;
}

void Feed::finish_block(std::uint64_t end) {
  append_end(end, text_);
  backlog_.add({begin_, end, std::make_shared<const std::string>(std::move(text_))});
  text_.clear();
  begin_ = end;
}

Feed::Text Feed::next(Place& place) {
  if (place.begun) {
    if (place.next == told_before_ && std::exchange(place.standing, told_count_) != told_count_) return told_;
    if (const Block* const block = backlog_.at(place.next)) {
      place.next = block->end;
      return block->text;
    }
    if (place.next >= backlog_.end()) return nullptr;
  }
  return begin_anew(place);
}

/// From a moment that is newer than what the viewer knows. Where the program shows none, from the oldest event that is
/// kept.
Feed::Text Feed::begin_anew(Place& place) {
  std::uint64_t from = moment_->told;
  const bool shown = moment_->view.tables != nullptr && from >= backlog_.begin();
  if (shown) {
    if (!backlog_.continues_at(from) || (place.begun && from <= place.next)) return nullptr; // a newer one comes soon
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
  place = {from, true, told_count_};
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
