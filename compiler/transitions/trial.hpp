#pragma once
// SPDX-License-Identifier: MIT
// The text of a scenario, played on the real engine: what holds in the end, and what happened in its last steps.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "compiler/transitions/script.hpp"
#include "runtime/core/observer.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler::transitions {

/// When the engine had come to rest.
struct Rest {
  struct Held {
    std::optional<EdgeId> by; ///< nothing: nobody, or limbo
    bool granted = false;
    std::optional<ProviderId> active;
  };
  std::vector<Held> groups;               ///< by group
  std::vector<bool> running;              ///< by edge
  std::map<StateId, std::int64_t> values; ///< those that have one

  /// The edge that holds it is that one, or is below that one.
  bool is_under(const Model& model, GroupId group, EdgeId edge) const;
};

struct Trial {
  bool good = false; ///< it could be played, and came to rest
  Rest rest;
  Runs runs;                 ///< all of them
  std::vector<Event> events; ///< from the step `from` on
  std::string why;           ///< why the first group on the way does not run; empty: all do
  bool is_requested = true;  ///< somebody asks for that group
};

/// `way`: whose groups are asked about in the end.
Trial play_trial(const std::string& text, const Model& model, const Lowered& lowered, std::uint32_t from,
                 const Way& way);

} // namespace director::compiler::transitions
