#pragma once
// SPDX-License-Identifier: MIT
// One record of what the outside says to a behaviour; an input takes one or more of them.

#include "runtime/core/base/tables.hpp"

namespace director {

/// How many requests of one root task with data can wait in the inbox at once. One more goes by OverflowSlots.
inline constexpr Index waiting_requests = 4;

struct Input {
  enum class Kind : std::uint8_t { request, cancel, set, fire, enable, disable };
  Kind kind = Kind::set;
  bool more = false;  ///< the next record belongs to the same input (request and set)
  Index thing = 0;    ///< root edge, state, trigger or provider; nil: cancel of all root edges
  Index handle = nil; ///< request: where its data wait: up to waiting_requests in the inbox, from there on in a place
                      ///< of OverflowSlots; nil: it has none
  std::int32_t value = 0; ///< set: the value; request: the level, of Tables::levels
  Index level() const { return static_cast<Index>(value); }
  void set_level(Index level) { value = static_cast<std::int32_t>(level); }
};

} // namespace director
