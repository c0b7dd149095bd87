#pragma once
// SPDX-License-Identifier: MIT
// Converts the engine's events to happenings of a scenario.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "compiler/play/happening.hpp"
#include "runtime/core/base/observer.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace director::compiler {

using Sink = std::function<void(const Happening&)>;

class EventConverter {
public:
  /// Keeps references to all of them. `decisions`: also why something is queued, pushed, released or set.
  EventConverter(const Model& model, const Lowered& lowered, bool decisions, const Sink& sink)
      : model_(model),
        lowered_(lowered),
        decisions_(decisions),
        sink_(sink) {}
  EventConverter(const EventConverter&) = delete;
  EventConverter& operator=(const EventConverter&) = delete;

  Observer observer(); ///< for as long as this object exists
  void begin_step(std::uint32_t step) { step_ = step; }
  void share(const Observer& events) { shared_ = events; } ///< gets every event first
  void now(Time time) { time_ = time; }                    ///< the time of events from the player, not from the engine
  void input(std::string words);
  void budget_exhausted();
  /// Of the latest runs: which groups ran, and the first of them that ran for subtask_done. Sorted by declaration.
  std::pair<std::vector<GroupId>, std::optional<GroupId>> latest() const;

private:
  static constexpr std::size_t latest_kept = 64; ///< a cycle with more runs is named in part

  void tell(const Event& event);
  void decide(const Event& event, Happening& out);
  const std::string& group(Index index) const { return model_.groups[GroupId{index}].name.value; }
  std::string why(const Event& event) const;
  std::string requester(Index edge) const;
  Happening happening(Happening::Kind kind) const;

  const Model& model_;
  const Lowered& lowered_;
  bool decisions_;
  const Sink& sink_;
  std::uint32_t step_ = 0;
  Time time_ = 0;
  Observer shared_{};
  struct Run {
    Index group = nil;
    bool after_done = false;
  };
  std::array<Run, latest_kept> runs_{}; ///< a ring
  std::size_t runs_seen_ = 0;
};

} // namespace director::compiler
