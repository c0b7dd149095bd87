#pragma once
// SPDX-License-Identifier: MIT
// A courier with moments and events under control of a test.

#include "runtime/hosted/trace/event_queue.hpp"
#include "runtime/hosted/trace/json_lines.hpp"
#include "runtime/live/moments.hpp"
#include "tests/system/api/office.hpp"

#include <chrono>
#include <string>
#include <vector>

namespace director::tests {

struct CourierMoments {
  explicit CourierMoments(std::size_t size) : queue(size), moments(*names.tables) {}

  /// Adds events, any number of them.
  void add_events() {
    Event event;
    event.kind = Event::Kind::exhausted;
    event.time = event.until = static_cast<Time>(happened.size());
    happened.emplace_back();
    append_event(event, names, happened.back());
    if (!queue.put(event)) queue.drop();
  }
  void add_events(int count) {
    for (int i = 0; i < count; ++i) add_events();
  }
  /// Shows the state, in another micro-step than the last time.
  void show() {
    (void)behaviour.fire<courier::Bell>();
    behaviour.step(std::chrono::milliseconds(0));
    moments.show(behaviour.seen().view(), queue.total());
  }

  Names names = courier::names::all();
  EventQueue queue;
  live::Moments moments;
  std::vector<std::string> happened; ///< the events, as lines of a trace
  Plans plans;
  Skills skills;
  courier::Behaviour behaviour{plans, skills};
};

} // namespace director::tests
