#pragma once
// SPDX-License-Identifier: MIT
// What is known of a component at one time: less than the engine's state. It leaves out the order of requests, runs
// that wait for reasons other than a new task or a push, done answers, timers, and the pushes in force.

#include "compiler/analysis/decisions/component.hpp"

#include <array>
#include <cstdint>

namespace director::analysis {

struct Moment {
  static constexpr Row limbo = 128;                                        ///< holder in limbo; added to the group
  static constexpr Row granted = 1,                                        ///< granted by a request
      needed = 2,                                                          ///< claimed for a plan
      outdated = 4,                                                        ///< a new task, or a push, waits for its run
      in_force = 8;                                                        ///< its provider runs because of a push
  std::array<Row, Component::most_groups> by{}, active{}, plan{}, flags{}; ///< by: an edge, limbo, or nothing
  std::array<Row, Component::most_edges> level{};                          ///< nothing: not requested
  std::array<Row, Component::most_states> value{}, given{}; ///< given: set by handlers, and applied before anything
                                                            ///< else
  std::uint32_t open = 0; ///< further inputs may come before a run; a word, so that there is no padding

  bool has(std::size_t group, Row flag) const { return (flags[group] & flag) != 0; }
  bool is_given() const {
    for (const Row each : given) {
      if (each != nothing) return true;
    }
    return false;
  }
  bool operator==(const Moment&) const = default;
};

} // namespace director::analysis
