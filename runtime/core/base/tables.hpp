#pragma once
// SPDX-License-Identifier: MIT
// The tables that a specification is compiled to. They are constant and may be in read-only memory; all that changes is
// in State (state.hpp). Written by compiler/lower, printed by compiler/emit, read by the engine. Terms: semantics.md,
// section 1.

#include <cstddef>
#include <cstdint>
#include <span>

namespace director {

// A namespace of what a program and the runtime share, named for the size of an Index: if they differ in it, they are
// not linked.
#ifdef DIRECTOR_SMALL_INDEX
using Index = std::uint16_t; ///< for small targets: up to 65,534 rows a table
#define DIRECTOR_INDEX_NAMESPACE with_DIRECTOR_SMALL_INDEX
#else
using Index = std::uint32_t;
#define DIRECTOR_INDEX_NAMESPACE without_DIRECTOR_SMALL_INDEX
#endif

/// A row number in a table: no microcontroller has room for more. In registers and in State an Index takes less code.
#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M'
using TableIndex = std::uint16_t;
#else
using TableIndex = Index;
#endif

inline constexpr Index nil = static_cast<Index>(-1);

/// The value of an unset state. No declared value is so low.
inline constexpr std::int32_t unset = -2147483647 - 1;

/// Microseconds since any start chosen by the caller.
using Time = std::int64_t;
inline constexpr Time never = 9223372036854775807; ///< later than any step
inline constexpr Time last_time = never - 1;       ///< a step to a later time is one to this time
inline constexpr Time first_time = -never - 1;

/// Groups that a search for a stale requester visits for one unit of work (docs/bounds.md).
inline constexpr Index walked_a_unit = 8;

/// An iterator over rows.
struct RowIterator {
  Index row;
  constexpr Index operator*() const { return row; }
  constexpr RowIterator& operator++() { return ++row, *this; }
  constexpr bool operator==(const RowIterator&) const = default;
};
struct Rows {
  RowIterator first, last;
  constexpr RowIterator begin() const { return first; }
  constexpr RowIterator end() const { return last; }
};

/// Rows [begin, end) of another table, mostly of Tables::lists.
struct Range {
  TableIndex begin = 0, end = 0;
  constexpr Index size() const { return static_cast<Index>(end - begin); }
  constexpr bool empty() const { return begin == end; }
  constexpr Rows rows() const { return {{begin}, {end}}; }
};

/// Whether `is` returns true for any element; stops at the first.
template <class All, class Is>
constexpr bool any(const All& all, const Is& is) {
  for (const auto& each : all) {
    if (is(each)) return true;
  }
  return false;
}

/// A level at which an edge may be requested.
struct Level {
  std::int32_t priority = 0;
  /// The place of the priority among those of the requester, 0 for the highest (semantics.md 4.1, rules 3 and 4).
  TableIndex urgency = 0;
  bool optional = false;
  bool apart = false;
};

/// From requester to target. Edges of root come first, then those of each group; siblings in order of declaration.
struct Edge {
  Index requester = nil;         ///< group, or nil for root
  TableIndex target = 0;         ///< group
  Range levels{};                ///< of Tables::levels; empty if it is only needed
  TableIndex need_urgency = 0;   ///< as Level::urgency, for an edge that holds its target without a request
  TableIndex cluster_offset = 0; ///< to the first edge of its cluster: other clusters never claim the same group
};

struct Provider {
  Index group = 0;
  Range when{};     ///< lists: conditions
  Range stay{};     ///< lists: conditions
  Range needs{};    ///< lists: edges from its group to the groups needed
  Range triggers{}; ///< lists: triggers that it listens to
  Range effects{};  ///< lists: conditions that its `causing` serves, ascending
  Range causing{};  ///< lists: states in its `causing`
  Range aims{};     ///< lists: if it causes, the conditions of it and of every provider in one of its plans
  Range promises{}; ///< of Tables::promises
  Time every = 0;   ///< 0: it has no period
};

struct Group {
  Range providers{};  ///< of Tables::providers, in order of preference
  Range edges{};      ///< of Tables::edges: what it may request or need
  Range requesters{}; ///< lists: edges that lead to it, ascending
  Range slots{};   ///< of Tables::plan_groups and of Assignment::plan: a plan is the provider picked for each of these
  Range listens{}; ///< of Tables::listened and of State::fired
  Range owned{};   ///< lists: states that it owns
  Range users{};   ///< lists: it, and all groups with a plan that may contain it, ascending
  bool start : 1 = false; ///< it has a start handler
  bool stop : 1 = false;
  bool simple : 1 = false;      ///< it has one provider, without needs
  bool conditional : 1 = false; ///< a provider has `when` or `stay`
  bool equals : 1 = false;      ///< two edges that lead to it may be equal
  bool deniable : 1 = false;    ///< it, or a group in one of its plans, has `equals`
  TableIndex component = 0;     ///< of Tables::components
};

/// A component: no decision in it depends on another component. Two groups are in one if one requests or needs the
/// other, or if a provider of one may be pushed for a condition of the other.
struct Component {
  Range groups{};            ///< lists: ascending
  Range edges{};             ///< lists: edges that lead to its groups, ascending; those of root come first
  Index order = 0;           ///< the first of its rows of State::order, one for each of its groups
  bool alternatives = false; ///< a group has slots
};

/// A closed interval of values.
struct Interval {
  std::int32_t low = 0, high = 0;
  constexpr bool has(std::int32_t value) const { return low <= value && value <= high; }
};

struct Condition {
  TableIndex state = 0;
  Range accepts{};    ///< of Tables::intervals: the values that satisfy it
  Range causers{};    ///< lists: providers whose `causing` serves it, ascending
  Range components{}; ///< lists: components with it in `when`, `stay` or a promise, ascending
  Range groups{};     ///< lists: groups with it in `when` or `stay`, ascending
};

struct StateVariable {
  std::int32_t initial = unset;
  Time expires = 0; ///< 0: never
  std::int32_t expires_to = unset;
  Index owner = nil; ///< the group that owns it
  bool external = false;
  Range conditions{}; ///< lists: conditions on it, ascending
};

/// A promise with a time, `within`.
struct Promise {
  Index provider = 0;
  Index condition = 0;
  Time within = 0;
  Index trigger = nil; ///< fired when it is broken; nil if no provider listens to it
};

struct Trigger {
  Range listeners{}; ///< lists: providers
};

inline namespace DIRECTOR_INDEX_NAMESPACE {

struct Tables {
  std::span<const Group> groups;
  std::span<const Provider> providers;
  std::span<const Edge> edges;
  std::span<const Level> levels;
  std::span<const Condition> conditions;
  std::span<const Interval> intervals;
  std::span<const StateVariable> states;
  std::span<const Trigger> triggers;
  std::span<const Promise> promises;
  std::span<const TableIndex> lists;
  std::span<const Component> components;
  /// Group after group: the groups with several providers among all that it needs, transitively.
  std::span<const TableIndex> plan_groups;
  std::span<const TableIndex> listened; ///< group after group: the triggers that its providers listen to
  Index root_edges = 0;                 ///< the number of edges of root
  Index most_edges = 0;                 ///< the highest number of edges of one group

  /// The first edge of its requester that may claim a group that this one may also claim, directly or through others.
  constexpr Index cluster(Index edge) const { return static_cast<Index>(edge - edges[edge].cluster_offset); }

  constexpr bool accepts(const Condition& condition, std::int32_t value) const {
    return any(intervals.subspan(condition.accepts.begin, condition.accepts.size()),
               [&](const Interval& interval) { return interval.has(value); });
  }

  constexpr std::span<const TableIndex> list(Range range) const { return {lists.data() + range.begin, range.size()}; }
};

} // namespace DIRECTOR_INDEX_NAMESPACE

} // namespace director
