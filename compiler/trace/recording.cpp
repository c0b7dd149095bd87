// Header: compiler/trace/recording.hpp. Test: tests/compiler/trace/recording_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/trace/recording.hpp"

#include "runtime/hosted/trace/json_lines.hpp"

#include <algorithm>

namespace director::compiler {

namespace {

using Kind = Event::Kind;

bool is_left_out(const Event& event) {
  switch (event.kind) {
  case Kind::wait:
  case Kind::answer:
  case Kind::assign: return true;
  case Kind::input:
    return event.input == Event::Input::wait || event.input == Event::Input::within ||
           event.input == Event::Input::every || event.input == Event::Input::expire;
  default: return false;
  }
}

void put(std::uint64_t number, std::string& out) {
  constexpr std::uint64_t low = 127, more = 128;
  for (; number > low; number >>= 7) out += static_cast<char>((number & low) | more);
  out += static_cast<char>(number);
}

} // namespace

Recording::Recording(const director::Names& names, Waits waits, std::string why_ends)
    : names_(names),
      waits_(std::move(waits)),
      why_ends_(std::move(why_ends)) {}

void Recording::event(const Event& event, std::string&) {
  ++line_;
  if (!is_left_out(event)) {
    Event timeless = event;
    timeless.time = timeless.until = 0;
    timeless.micro_step = 0;
    timeless.due = never;
    std::string shape;
    append_event(timeless, names_, shape);
    constexpr std::string_view times = R"("t":0,"n":0,)";
    shape.replace(1, times.size(), begins(event));
    add(event.time, std::move(shape));
  }
  add_derived();
  add_changes();
}

/// Of an event that is not left out: what its shape says about it.
std::string_view Recording::begins(const Event& event) {
  const bool is_usual = event.kind == Kind::run || event.kind == Kind::input;
  const bool is_known = micro_step_.has_value(), begins = micro_step_ != event.micro_step;
  micro_step_ = event.micro_step;
  if (!is_known || begins == is_usual) return {};
  return begins ? R"("begins":true,)" : R"("begins":false,)";
}

void Recording::dropped(std::uint64_t count, std::string&) {
  ++line_;
  micro_step_.reset();
  std::string shape;
  append_dropped(count, shape);
  add(now_, std::move(shape));
}

/// A timer that is due before an input is served after it: it has the input's time.
void Recording::add(Time time, std::string shape) {
  if (events_ == 0) begins_ = now_ = time;
  const Time before = now_;
  now_ = std::max(now_, time);
  put(static_cast<std::uint64_t>(now_) - static_cast<std::uint64_t>(before), times_);
  const auto [at, is_new] = shape_of_.try_emplace(shape, shapes_.size());
  if (is_new) shapes_.push_back(std::move(shape));
  put(at->second, places_);
  ++events_;
}

/// After the event in their line.
void Recording::add_derived() {
  add_derived("held", waits_.held, held_);
  add_derived("stays", waits_.stays, stays_);
  add_derived("without_effect", waits_.without_effect, without_effect_);
  add_derived("in_force", waits_.in_force, in_force_);
}

void Recording::add_derived(const char* event, const std::vector<Waits::Held>& all, std::size_t& next) {
  for (; next < all.size() && all[next].line == line_; ++next) {
    const char* const group = names_.group(names_.self, all[next].group);
    add(now_, to_line(Json::object({{"event", Json::text(event)}, {"group", Json::text(group)}})));
  }
}

/// From the event in their line, or the one before it.
void Recording::add_changes() {
  if (line_ <= waits_.last_line) why_until_ = events_;
  for (; changes_ < waits_.changes.size() && waits_.changes[changes_].line <= line_; ++changes_) {
    const Waits::Change& change = waits_.changes[changes_];
    const std::size_t event = events_ == 0 ? 0 : events_ - 1;
    put(event - change_event_, change_events_);
    change_event_ = event;
    put(change.group, change_groups_);
    put(change.text, change_answers_);
  }
}

std::string Recording::bytes(const Json& header) const {
  Json shapes = Json::list({});
  for (const std::string& shape : shapes_) shapes.add(parse_json(shape).value_or(Json{}));
  Json held = Json::list({});
  for (const Waits::Blocker& blocker : waits_.blockers) {
    held.add(blocker.group == nil ? Json{}
                                  : Json::object({{"group", Json::text(names_.group(names_.self, blocker.group))},
                                                  {"by", Json::text(names_.edge(names_.self, blocker.edge))}}));
  }
  Json head = Json::object({{"header", header},
                            {"shapes", std::move(shapes)},
                            {"texts", Json::texts(waits_.texts)},
                            {"held", std::move(held)},
                            {"begins", Json::number(begins_)},
                            {"events", Json::count(events_)},
                            {"changes", Json::count(changes_)},
                            {"why_until", Json::count(why_until_)}});
  if (!why_ends_.empty()) head.add("why_ends", Json::text(why_ends_));
  const std::string text = to_line(head);
  std::string out;
  for (int bits = 0; bits < 32; bits += 8) out += static_cast<char>(text.size() >> bits & 0xff);
  return out + text + times_ + places_ + change_events_ + change_groups_ + change_answers_;
}

} // namespace director::compiler
