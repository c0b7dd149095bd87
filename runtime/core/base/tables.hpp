#pragma once
// SPDX-License-Identifier: MIT
// The tables that a specification is compiled to. They never change while a behaviour runs and may lie in read-only
// memory; all of what changes is in State (state.hpp). Written by compiler/lower, printed by compiler/emit, read by the
// engine. Terms: semantics.md, section 1.

#include <cstddef>
#include <cstdint>
#include <span>

namespace director {

#ifdef DIRECTOR_SMALL_INDEX
using Index = std::uint16_t; ///< for small targets: up to 65,534 rows a table
#else
using Index = std::uint32_t;
#endif

/// A row where it stands in a table: no microcontroller has room for more rows than this counts. In registers and in
/// what changes an Index takes less code.
#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M'
using TableIndex = std::uint16_t;
#else
using TableIndex = Index;
#endif

inline constexpr Index nil = static_cast<Index>(-1);

/// The value of a state without a value. No declared value is that small.
inline constexpr std::int32_t unset = -2147483647 - 1;

/// Microseconds since any start that the caller chose.
using Time = std::int64_t;
inline constexpr Time never = 9223372036854775807; ///< no step goes so far
inline constexpr Time last_time = never - 1;       ///< what a step to a later time stands for
inline constexpr Time first_time = -never - 1;

/// To go from row to row.
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

/// One of them is so; they are looked at up to the first that is.
template <class All, class Is>
constexpr bool any(const All& all, const Is& is) {
  for (const auto& each : all) {
    if (is(each)) return true;
  }
  return false;
}

/// One static way in which an edge is requested.
struct Level {
  std::int32_t priority = 0;
  /// The static priority table: the place of the priority among those of the requester, 0 the highest. Rules 3 and 4 of
  /// semantics.md 4.1 compare `optional` and this.
  TableIndex urgency = 0;
  bool optional = false;
  bool apart = false;
};

/// requester -> target. Edges of root come first, then those of each group; among siblings in order of declaration.
struct Edge {
  Index requester = nil;         ///< group, or nil for root
  TableIndex target = 0;         ///< group
  Range levels{};                ///< of Tables::levels; empty where it is needed only
  TableIndex need_urgency = 0;   ///< as Level::urgency: of an edge that holds without a request
  TableIndex cluster_offset = 0; ///< its cluster begins so many edges before it; edges of two clusters never claim the
                                 ///< same group
};

struct Provider {
  Index group = 0;
  Range when{};     ///< lists: conditions
  Range stay{};     ///< lists: conditions
  Range needs{};    ///< lists: edges from its group to the groups needed
  Range triggers{}; ///< lists: triggers that it listens to
  Range effects{};  ///< lists: conditions that its `causing` satisfies, ascending
  Range causing{};  ///< lists: states that its `causing` is about
  Range aims{}; ///< lists: conditions in `when` or `stay` of it and of every provider in one of its plans; if it causes
  Range promises{}; ///< of Tables::promises
  Time every = 0;   ///< 0: it does not ask for that
};

struct Group {
  Range providers{};  ///< of Tables::providers, in order of preference
  Range edges{};      ///< of Tables::edges: what it may request or need
  Range requesters{}; ///< lists: edges that lead to it, ascending
  Range slots{};   ///< of Tables::plan_groups and of Assignment::plan: a plan is the provider picked for each of these
  Range listens{}; ///< of Tables::listened and of State::fired
  Range owned{};   ///< lists: states that belong to it
  Range users{};   ///< lists: it and all groups one of whose plans may contain it, ascending
  bool start : 1 = false; ///< has such a handler
  bool stop : 1 = false;
  bool simple : 1 = false;      ///< it has one provider, which needs nothing
  bool conditional : 1 = false; ///< a provider has `when` or `stay`
  bool equals : 1 = false;      ///< two edges that lead to it may be equal
  bool deniable : 1 = false;    ///< it, or a group in one of its plans, has `equals`
  TableIndex component = 0;     ///< of Tables::components

  /// It and all that it needs, transitively, have one provider each.
  constexpr bool single_choice() const { return providers.size() == 1 && slots.empty(); }
};

/// Groups that can have to do with each other: what happens in one component never changes a decision in another. Two
/// groups are in one if one requests or needs the other, or if a provider of one may be pushed for a condition of the
/// other.
struct Component {
  Range groups{};            ///< lists: ascending
  Range edges{};             ///< lists: that lead to its groups, ascending; those of root come first
  Index order = 0;           ///< where its rows of State::order begin; there are as many as it has groups
  bool alternatives = false; ///< a group has slots
};

/// Values that satisfy: any of these closed intervals.
struct Interval {
  std::int32_t low = 0, high = 0;
};

struct Condition {
  TableIndex state = 0;
  Range accepts{};    ///< of Tables::intervals
  Range causers{};    ///< lists: providers whose `causing` satisfies it, ascending
  Range components{}; ///< lists: components in which it counts, in `when`, `stay` or a promise, ascending
  Range groups{};     ///< lists: groups in whose `when` or `stay` it stands, ascending
};

struct StateVariable {
  std::int32_t initial = unset;
  Time expires = 0; ///< 0: never
  std::int32_t expires_to = unset;
  Index owner = nil; ///< the group that it belongs to
  bool external = false;
  Range conditions{}; ///< lists: conditions on it, ascending
};

/// A `causing` with `within`.
struct Promise {
  Index provider = 0;
  Index condition = 0;
  Time within = 0;
  Index trigger = nil; ///< fired when it is broken; nil where nobody listens
};

struct Trigger {
  Range listeners{}; ///< lists: providers
};

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
  std::span<const TableIndex> plan_groups; ///< group after group, the groups with more than one provider among all that
                                           ///< it needs, transitively
  std::span<const TableIndex> listened;    ///< group after group, the triggers that any of its providers listens to
  Index root_edges = 0;                    ///< how many edges are of root
  Index most_edges = 0;                    ///< the most edges of one group

  /// The first edge of its requester that may claim a group that this one may claim, directly or by way of others.
  constexpr Index cluster(Index edge) const { return static_cast<Index>(edge - edges[edge].cluster_offset); }

  constexpr std::span<const TableIndex> list(Range range) const { return {lists.data() + range.begin, range.size()}; }
};

} // namespace director
