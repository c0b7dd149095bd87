#pragma once
// SPDX-License-Identifier: MIT
// A game of soccer with a live view, its events, and the time of each step.

#include "behaviours/soccer/player/player.hpp"
#include "behaviours/soccer/player/servos.hpp"
#include "behaviours/soccer/world/world.hpp"
#include "runtime/hosted/trace/json_lines.hpp"
#include "runtime/live/live_view.hpp"

#include <chrono>
#include <string>
#include <vector>

namespace director::tests {

class SoccerGame {
public:
  /// Null: without a view.
  explicit SoccerGame(LiveView* view) : view_(view) { events_.reserve(1 << 20); }

  /// Takes a step and shows its state.
  void step() {
    world_.step();
    const auto begin = std::chrono::steady_clock::now();
    player_.step();
    if (view_ != nullptr) view_->show(player_.behaviour());
    took.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
  }
  /// The events, as lines of a trace.
  std::vector<std::string> happened() const {
    std::vector<std::string> out(events_.size());
    for (std::size_t i = 0; i < events_.size(); ++i) append_event(events_[i], soccer::names::all(), out[i]);
    return out;
  }
  std::size_t count() const { return events_.size(); }

  std::vector<double> took; ///< microseconds, a step each

private:
  void tell(const Event& event) {
    if (view_ != nullptr) view_->tell(event);
    events_.push_back(event);
  }

  LiveView* view_;
  std::vector<Event> events_;
  sim::World world_{1};
  player::Player<player::Servos> player_{
      world_, {[](void* self, const Event& event) { static_cast<SoccerGame*>(self)->tell(event); }, this}};
};

} // namespace director::tests
