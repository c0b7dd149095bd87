#pragma once
// SPDX-License-Identifier: MIT
// Explains why a group does not run, from the tables and the state, without memory of its own. The explanation is about
// the request that would be granted first, and the first thing in its way; if there are alternatives, there may be
// more. As a sentence, if names are compiled in: why_text.cpp.

#include "runtime/core/inspect/view.hpp"

namespace director {

/// The place at which the chains of two rival edges part.
struct Rivalry {
  /// The rule that decided. `above`: the rival is above, or was granted together with something above, before the
  /// request could be.
  Precedence won_by = Precedence::equal;
  /// The closest common requester, a group; nil: the program. With `above`: nil if the rival itself is above.
  Index common = nil;
  /// The edges of that requester that lead to the two. With `above`: those that were granted together in one unit; nil
  /// if `common` needs what the rival holds, or the rival itself is above.
  Index ours = nil;
  Index theirs = nil;              ///< likewise, for the rival
  Index our_first = nil;           ///< the edge that gives `ours` its priority: itself, or the first member of its unit
  Index their_first = nil;         ///< likewise
  std::int32_t our_priority = 0;   ///< of `our_first`
  std::int32_t their_priority = 0; ///< of `their_first`
  /// All members are the same.
  constexpr bool operator==(const Rivalry&) const = default;
};

/// Why a group does not run. The members that count depend on `kind`; the others are `nil`.
struct Because {
  /// The cause.
  enum class Kind : std::uint8_t {
    running,       ///< it runs: for `edge`, in `provider`
    not_requested, ///< neither the program nor a live group requests it
    no_provider,   ///< no provider of `group` is enabled
    lost,          ///< `group`, the target of `member`, is held by `holder`, which goes first: `rivalry`
    need_held,     ///< likewise, but `group` is needed by `provider`, a provider of that target
    together,      ///< the members of one unit need the same group; or, with `group`, the target of `member`, so do the
                   ///< needs of all its choices that are left with what is disabled
    condition,     ///< `condition` is false; `causer` promises it (nil: no enabled provider does)
    outdated,      ///< its requester, or a group above, is stale, or in limbo
    deferred,      ///< a stronger stale group is about to run, and may request what it needs
    reserved,      ///< it is held as a need, by `holder`, and is not requested
    limbo,         ///< it is kept for a stale group that may still request it
  };
  Kind kind = Kind::not_requested; ///< the other members that count depend on it
  Index asked = nil;               ///< the group in question
  Index edge = nil;                ///< the request in question; nil: there is none
  Index member = nil;              ///< the member of that request's unit that cannot be granted; often `edge`
  Index group = nil;               ///< the group in the way, or without a provider
  Index provider = nil;            ///< the active one, or the one with the need or the condition
  Index holder = nil;              ///< the edge that holds `group`
  Index condition = nil;           ///< the first false condition
  Index causer = nil;              ///< the first enabled provider that promises `condition`
  Index causer_group = nil;        ///< the group of `causer`
  Rivalry rivalry{};               ///< why `holder` goes before the request
  /// All members are the same.
  constexpr bool operator==(const Because&) const = default;
};

/// By number; generated code has `behaviour.why<Task>()`.
Because why(const View& view, Index group);

/// Why a request is not granted: an edge that is requested, and whose target may run for another edge.
Because why_refused(const View& view, Index edge);

/// Whether edge `holder` goes before the request `edge`, or is its equal, so that what it holds is in the way.
bool stands_in_the_way(const View& view, Index holder, Index edge);

/// A task of a pack, or of root, at one of its levels: how a body or the program names that level.
struct LevelUse {
  Index edge = nil;           ///< to the task
  Index level = nil;          ///< of Tables::levels
  Index provider = nil;       ///< that requests it; nil: the program
  std::uint16_t pack = 0;     ///< its place among those of `provider`
  const char* pack_name = ""; ///< empty for `tasks`
  const char* name = "";      ///< of the level; empty if it is written without one
};

/// The names of rows. `self` is the first argument of each function. `why` uses only the first four functions.
struct Names {
  const void* self = nullptr;                                      ///< the first argument of each function
  const char* (*group)(const void* self, Index row) = nullptr;     ///< `Walk`
  const char* (*provider)(const void* self, Index row) = nullptr;  ///< without its group
  const char* (*edge)(const void* self, Index row) = nullptr;      ///< `root>Walk`
  const char* (*condition)(const void* self, Index row) = nullptr; ///< `Stability == standing`
  const char* (*state)(const void* self, Index row) = nullptr;     ///< `Stability`
  const char* (*value)(const void* self, Index state, std::int32_t number) = nullptr; ///< empty for a number of a range
  const char* (*trigger)(const void* self, Index row) = nullptr;                      ///< `Sensors`
  const char* (*level)(const void* self, Index row) = nullptr; ///< empty for the first of a task in a pack; may be null
  const Tables* tables = nullptr;                              ///< the tables of these rows; only for recorders
  const char* behaviour = nullptr;                             ///< its name; only for recorders
  std::span<const LevelUse> level_uses{}; ///< in the order in which they are written; only for recorders
};

/// Writes one line without an end of line, such as `Kick waits (root>Kick): until Stability == standing, which
/// Walk.halting could cause`, into `buffer`, which it returns; cut off if that is too small, and "" if it has no byte.
const char* to_text(const Because& because, const Names& names, std::span<char> buffer);

/// All providers that promise a condition, enabled or not.
inline std::span<const TableIndex> causers(const Tables& tables, Index condition) {
  return tables.list(tables.conditions[condition].causers);
}

} // namespace director
