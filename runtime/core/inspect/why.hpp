#pragma once
// SPDX-License-Identifier: MIT
// Why does this group not run? Found from the tables and from what holds, without memory of its own. It tells of the
// request that would be granted first, and of the first thing that keeps it: where there are alternatives, there may be
// more in the way than what is told. In words for people, where names are compiled in: why_text.cpp.

#include "runtime/core/inspect/view.hpp"

namespace director {

/// Where the chains of requesters of two rivals part.
struct Rivalry {
  Precedence won_by = Precedence::equal; ///< the rule that decided
  Index common = nil;                    ///< the closest common requester, a group; nil: the program
  Index ours = nil;                ///< the edges of that requester that lead to the two; nil with Precedence::above
  Index theirs = nil;              ///< likewise, of the rival
  Index our_first = nil;           ///< by whose priority `ours` goes: its own, or that of the first member of its unit
  Index their_first = nil;         ///< likewise
  std::int32_t our_priority = 0;   ///< of `our_first`
  std::int32_t their_priority = 0; ///< of `their_first`
  /// All members are the same.
  constexpr bool operator==(const Rivalry&) const = default;
};

/// Why a group does not run. Which members count depends on `kind`; the others are `nil`.
struct Because {
  /// What keeps it.
  enum class Kind : std::uint8_t {
    running,       ///< it does run: for `edge`, in `provider`
    not_requested, ///< neither the program nor a group that is live asks for it
    no_provider,   ///< no provider of `group` is enabled (or what all of its providers need has none)
    lost,          ///< `group`, the target of `member`, is held by `holder`, which goes first: `rivalry`
    need_held,     ///< likewise, where `group` is something that `provider` of that target needs
    together,      ///< what one unit asks for cannot be had together: its members need the same
    condition, ///< `condition` is false; `causer` could make it true, by a push or else (nil: nobody who is enabled)
    outdated,  ///< its requester, or one above, has not run yet since its own task changed, or is only kept for an heir
    deferred,  ///< somebody stronger is about to run, and may ask for what it needs
    reserved,  ///< it is held for `holder`, whose requester needs it and did not ask for it yet
    limbo,     ///< its requester is gone; it is kept for who is about to ask for it
  };
  Kind kind = Kind::not_requested; ///< says which of the others count
  Index asked = nil;               ///< the group that this is about
  Index edge = nil;                ///< the request that it is about; nil: there is none
  Index member = nil;    ///< of that request's unit (all or nothing), the edge that cannot be granted; often `edge`
  Index group = nil;     ///< what is in the way, or lacks
  Index provider = nil;  ///< running: the active one; need_held: that which has the need; condition: that which waits
  Index holder = nil;    ///< edge that holds `group`
  Index condition = nil; ///< the first that is false
  Index causer = nil;    ///< the first enabled provider that promises it
  Index causer_group = nil; ///< of `causer`
  Rivalry rivalry{};        ///< who goes first of the request and `holder`, and why
  /// All members are the same.
  constexpr bool operator==(const Because&) const = default;
};

/// By number; generated code has `behaviour.why<Task>()`.
Because why(const View& view, Index group);

/// What edge `holder` holds is in the way of the request `edge`: it goes before it, or is its equal.
bool stands_in_the_way(const View& view, Index holder, Index edge);

/// What rows are called. `self` is given back to each function. For `why` alone the first four are enough.
struct Names {
  const void* self = nullptr;                                                         ///< given to each function
  const char* (*group)(const void* self, Index row) = nullptr;                        ///< `Walk`
  const char* (*provider)(const void* self, Index row) = nullptr;                     ///< without its group
  const char* (*edge)(const void* self, Index row) = nullptr;                         ///< `root>Walk`
  const char* (*condition)(const void* self, Index row) = nullptr;                    ///< `Stability == standing`
  const char* (*state)(const void* self, Index row) = nullptr;                        ///< `Stability`
  const char* (*value)(const void* self, Index state, std::int32_t number) = nullptr; ///< empty for a number of a range
  const char* (*trigger)(const void* self, Index row) = nullptr;                      ///< `Sensors`
  const char* (*level)(const void* self, Index row) = nullptr; ///< empty for the first of a task; may be null
  const Tables* tables = nullptr;                              ///< whose rows they are; only recorders ask
  const char* behaviour = nullptr;                             ///< what it is called; likewise
};

/// One line without an end of line, such as `Kick waits (root>Kick): until Stability == standing, which Walk.halting
/// could cause`. Written into `buffer`, which it returns; cut off where that is too small (at least one byte).
const char* to_text(const Because& because, const Names& names, std::span<char> buffer);

/// All providers that promise a condition, enabled or not.
inline std::span<const TableIndex> causers(const Tables& tables, Index condition) {
  return tables.list(tables.conditions[condition].causers);
}

} // namespace director
