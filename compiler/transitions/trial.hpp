#pragma once
// SPDX-License-Identifier: MIT
// Plays the text of a scenario on the real engine: the final state, and the events of its last steps.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "compiler/transitions/script.hpp"
#include "runtime/core/observer.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace director::compiler::transitions {

/// The state when the engine was at rest.
struct Rest {
  struct Held {
    std::optional<EdgeId> by; ///< empty: none, or limbo
    bool granted = false;
    std::optional<ProviderId> active;
  };
  std::vector<Held> groups;               ///< by group
  std::vector<bool> running;              ///< by edge
  std::vector<bool> requested;            ///< by edge
  std::vector<bool> blocked;              ///< by edge: requested, and others hold what it needs
  std::map<StateId, std::int64_t> values; ///< those that have one

  /// Whether the edge that holds it is that one, or is below that one.
  bool is_under(const Model& model, GroupId group, EdgeId edge) const;
  /// Whether it is that group, or runs for it, or for what that one requests, and so on.
  bool is_for(const Model& model, GroupId group, GroupId above) const;
};

/// A body sets a state.
struct SetState {
  ProviderId by{};
  StateId state{};
  std::int64_t value = 0;
};

struct Trial {
  bool good = false;          ///< it could be played, and came to rest
  bool endless = false;       ///< it did not come to rest
  std::vector<GroupId> round; ///< then: the groups that ran again and again, in order
  Rest rest;
  Runs runs;                 ///< all of them
  std::vector<Event> events; ///< from the step `from` on
  std::string why;           ///< why the first group of the chain does not run; empty: all do
  bool is_requested = true;  ///< then: something requests the last group of the chain
  std::uint64_t work = 0;    ///< of the engine
};

/// Those of the events, in order.
std::vector<SetState> set_states_of(std::span<const Event> events);

/// Whether the group stopped in one of its events.
bool has_stopped(const Trial& trial, GroupId group);

/// `way`: the chain whose groups are examined at the end.
Trial play_trial(const std::string& text, const Model& model, const Lowered& lowered, std::uint32_t from,
                 const Way& way);

} // namespace director::compiler::transitions
