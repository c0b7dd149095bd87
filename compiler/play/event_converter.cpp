// Header: compiler/play/event_converter.hpp. Test: tests/compiler/play/play_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/event_converter.hpp"

#include "runtime/core/api/event_names.hpp"

#include <algorithm>

namespace director::compiler {

Observer EventConverter::observer() {
  return {[](void* self, const Event& event) { static_cast<EventConverter*>(self)->tell(event); }, this};
}

Happening EventConverter::happening(Happening::Kind kind) const {
  Happening out;
  out.kind = kind;
  out.step = step_;
  out.time = time_;
  return out;
}

void EventConverter::input(std::string words) {
  Happening out = happening(Happening::Kind::input);
  out.words = std::move(words);
  sink_(out);
}

void EventConverter::budget_exhausted() { sink_(happening(Happening::Kind::budget_exhausted)); }

std::pair<std::vector<GroupId>, std::optional<GroupId>> EventConverter::latest() const {
  std::pair<std::vector<GroupId>, std::optional<GroupId>> out;
  const auto end = runs_.begin() + static_cast<std::ptrdiff_t>(std::min(runs_seen_, latest_kept));
  for (auto run = runs_.begin(); run != end; ++run) {
    const GroupId group{run->group};
    out.first.push_back(group);
    if (run->after_done && (!out.second || group < *out.second)) out.second = group;
  }
  std::sort(out.first.begin(), out.first.end());
  out.first.erase(std::unique(out.first.begin(), out.first.end()), out.first.end());
  return out;
}

std::string EventConverter::requester(Index edge) const {
  const Index from = lowered_.edges[edge].requester;
  return from == nil ? "root" : group(from);
}

std::string EventConverter::why(const Event& event) const {
  if (event.why == Why::waiting && event.condition != nil)
    return "waiting for " + model_.conditions[lowered_.condition_ids[event.condition]].text;
  return name_of(event.why);
}

void EventConverter::tell(const Event& event) {
  using Kind = Happening::Kind;
  if (shared_.tell != nullptr) shared_.tell(shared_.self, event);
  Happening out = happening(Kind::run);
  out.time = event.time;
  if (event.group != nil) out.group = group(event.group);
  if (event.provider != nil) out.provider = model_.providers[ProviderId{event.provider}].name;
  switch (event.kind) {
  case Event::Kind::run:
    runs_[runs_seen_++ % latest_kept] = {event.group, event.reasons.has(Reason::subtask_done)};
    for (const Reason each : all_reasons) {
      if (event.reasons.has(each)) out.reasons.emplace_back(name_of(each));
    }
    break;
  case Event::Kind::start: out.kind = Kind::start; break;
  case Event::Kind::stop: out.kind = Kind::stop; break;
  case Event::Kind::done: out.kind = Kind::done; break;
  case Event::Kind::failed: out.kind = Kind::failed; break;
  case Event::Kind::broken: out.kind = Kind::broken; break;
  case Event::Kind::queue:
  case Event::Kind::push:
  case Event::Kind::release:
  case Event::Kind::set:
    if (!decisions_) return;
    decide(event, out);
    break;
  case Event::Kind::input:
  case Event::Kind::grant:
  case Event::Kind::lose:
  case Event::Kind::refused:
  case Event::Kind::fault:
  case Event::Kind::exhausted:
  case Event::Kind::ask:
  case Event::Kind::keep:
  case Event::Kind::withdraw:
  case Event::Kind::wait:
  case Event::Kind::answer:
  case Event::Kind::assign:
  case Event::Kind::begin:
  case Event::Kind::given:
  case Event::Kind::lost: return; // the page's format has no such event, or the player reports it
  }
  sink_(out);
}

void EventConverter::decide(const Event& event, Happening& out) {
  using Kind = Happening::Kind;
  switch (event.kind) {
  case Event::Kind::queue:
    out.kind = Kind::queue;
    out.from = requester(event.edge);
    out.words = why(event);
    return;
  case Event::Kind::push:
    out.kind = Kind::push;
    out.from = requester(event.edge);
    out.words = group(lowered_.edges[event.edge].target);
    return;
  case Event::Kind::release: out.kind = Kind::release; return;
  default: break;
  }
  const State& state = model_.states[StateId{event.state}];
  out.kind = Kind::set;
  out.state = state.name.value;
  out.is_number = state.is_range;
  if (event.value != unset) out.value = state.value_text(event.value);
}

} // namespace director::compiler
