// Header: compiler/trace/recorded_events.hpp. Test: tests/compiler/cli/commands/trace_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/trace/recorded_events.hpp"

#include "compiler/trace/level_map.hpp"
#include "runtime/hosted/trace/json_lines.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace director::compiler {

namespace {

/// Why a request is not replayed.
constexpr const char* untold =
    "the level of this request is unknown: no level of the pack has the recorded name, or means the same; or the "
    "recorded one has several names";

using Kind = Event::Kind;

bool has_level(const Event& event) {
  return event.kind == Kind::ask || event.kind == Kind::keep ||
         (event.kind == Kind::input && event.input == Event::Input::request);
}

/// Whether it comes from the program, a body or a handler.
bool is_given(const Event& event) {
  switch (event.kind) {
  case Kind::ask:
  case Kind::keep:
  case Kind::assign:
  case Kind::given: return true;
  case Kind::input: return event.input >= Event::Input::request && event.input <= Event::Input::disable;
  default: return false;
  }
}

} // namespace

RecordedEvents::RecordedEvents(TraceLines& lines, const Model& model, const director::Names& names,
                               const director::Names* recorded)
    : lines_(lines),
      names_(names),
      recorded_names_(recorded == nullptr ? names : *recorded),
      is_other_(recorded != nullptr),
      maps_levels_(is_other_ && !recorded->level_uses.empty()),
      lookup_(names_),
      recorded_lookup_(recorded_names_),
      permits_(model, recorded_names_) {}

const RecordedEvent* RecordedEvents::ahead(std::size_t places) {
  while (waiting_.size() <= places) {
    std::optional<TraceLine> line = lines_.next();
    if (!line) return nullptr;
    RecordedEvent recorded;
    recorded.line = line->number;
    recorded.text = std::move(line->text);
    recorded.dropped = line->dropped;
    if (line->dropped == 0) {
      Lookup::Found found = maps_levels_ ? lookup_.event_without_level(line->json) : lookup_.event(line->json);
      recorded.was = is_other_ ? recorded_lookup_.event(line->json) : found;
      recorded.event = found.event;
      recorded.problem = std::move(found.problem);
      if (maps_levels_ && recorded.problem.empty()) find_level(recorded);
      if (recorded.was.problem.empty()) judge(recorded);
      const bool is_valid = recorded.problem.empty();
      bool skips = is_valid && (recorded.event.kind == Kind::exhausted || recorded.event.kind == Kind::lost);
      if (skips) {
        recorded.problem = damage_of(recorded);
        skips = recorded.problem.empty();
      }
      if (recorded.problem.empty() && (recorded.event.kind == Kind::exhausted || recorded.event.kind == Kind::fault))
        early_ends_.push_back(recorded.event);
      if (skips) continue;
    }
    waiting_.push_back(std::move(recorded));
  }
  return &waiting_[places];
}

void RecordedEvents::judge(RecordedEvent& recorded) {
  if (std::optional<Permits::Refusal> refusal = permits_.refusal(recorded.was.event)) {
    recorded.problem = std::move(refusal->why);
    recorded.help = std::move(refusal->help);
    recorded.is_impossible = true;
  } else {
    recorded.is_impossible = !recorded.problem.empty() && is_given(recorded.was.event);
  }
}

bool RecordedEvents::leaves_out_too_much() {
  std::vector<Event> requests;
  for (std::size_t i = 1;; ++i) {
    const RecordedEvent* const each = ahead(i);
    if (each == nullptr || each->dropped != 0 || !each->was.problem.empty()) return false; // there may be more
    const Event& event = each->was.event;
    if (event.micro_step != ahead(0)->was.event.micro_step) break;
    if (event.kind == Kind::ask || event.kind == Kind::keep) requests.push_back(event);
  }
  std::optional<Permits::Refusal> refusal = permits_.left_out(ahead(0)->was.event, requests);
  if (!refusal) return false;
  waiting_.front().problem = std::move(refusal->why);
  waiting_.front().help = std::move(refusal->help);
  waiting_.front().is_impossible = true;
  return true;
}

void RecordedEvents::find_level(RecordedEvent& recorded) {
  if (recorded.event.kind == Kind::answer) answer_ = recorded.was.event;
  if (!has_level(recorded.event)) return;
  recorded.problem = recorded.was.problem;
  if (!recorded.problem.empty()) return;
  recorded.event.level = same_level(recorded_names_, recorded.was.event, answer_, names_, recorded.event.edge);
  if (recorded.event.level == nil) recorded.problem = untold;
}

bool RecordedEvents::bring_forward(const std::string& line) {
  for (std::size_t i = 0; const RecordedEvent* const each = ahead(i); ++i) {
    const Kind kind = each->was.event.kind;
    const bool is_request = kind == Kind::ask || kind == Kind::keep || kind == Kind::withdraw;
    if (!is_request || each->dropped != 0 || (!each->problem.empty() && !each->is_impossible)) break;
    if (!each->is_impossible && line != expected(*each)) continue;
    const auto at = waiting_.begin() + static_cast<std::ptrdiff_t>(i);
    std::rotate(waiting_.begin(), at, at + 1);
    return true;
  }
  return false;
}

std::string RecordedEvents::expected(const RecordedEvent& recorded) const {
  if (!maps_levels_ || !recorded.problem.empty() || !has_level(recorded.event)) return recorded.text;
  std::string out;
  append_event(recorded.event, names_, out);
  return out;
}

std::string RecordedEvents::damage_of(const RecordedEvent& recorded) const {
  if (!recorded.was.problem.empty()) return recorded.was.problem;
  std::string written;
  append_event(recorded.was.event, recorded_names_, written);
  return written == recorded.text ? "" : "a recorder would have written it as " + written;
}

} // namespace director::compiler
