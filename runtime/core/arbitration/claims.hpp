#pragma once
// SPDX-License-Identifier: MIT
// Who has claimed each group so far in the pass in hand, who held it before, and the chains of holders up to root.
// docs/semantics.md, section 4.1.

#include "runtime/core/arbitration/context.hpp"
#include "runtime/core/base/marks.hpp"

namespace director::arbitration {

/// Which holders a chain is read along: those of this pass (and of the combination in hand), or of the last one.
enum class Chains : std::uint8_t { current, previous };

struct Place {
  Index edge;
  Chains along;
};

struct Chain {
  Index length = 0;
  Index top = nil; ///< its edge of root or limbo; nil where the chain does not reach that far
};

bool is_passed(const Context& x, Index group);
Chain chain(const Context& x, Place place);
bool in_chain(const Context& x, Index edge, Place of);

inline bool is_limbo(const Context& x, Index edge) { return edge >= x.t.edges.size(); }

inline Index target(const Context& x, Index edge) {
  return is_limbo(x, edge) ? static_cast<Index>(edge - x.t.edges.size()) : x.t.edges[edge].target;
}

inline Index requester(const Context& x, Index edge) { return is_limbo(x, edge) ? nil : x.t.edges[edge].requester; }

inline bool requested(const Context& x, Index edge) { return !is_limbo(x, edge) && x.s.request[edge].level != nil; }

inline bool optional(const Context& x, Index edge) {
  return requested(x, edge) && x.t.levels[x.s.request[edge].level].optional;
}

inline Index urgency(const Context& x, Index edge) {
  if (is_limbo(x, edge)) return 0;
  return x.s.request[edge].level == nil ? x.t.edges[edge].need_urgency : x.t.levels[x.s.request[edge].level].urgency;
}

inline Index requester_of_holder(const Context& x, const GroupAssignment& assignment) {
  return assignment.holder == nil ? nil : requester(x, assignment.holder);
}

/// Whether the condition is true.
inline bool holds(const Context& x, Index condition) { return x.s.truth[condition] != 0; }

/// This pass looks at the group; otherwise it stands as in the last one.
inline bool is_opened(const Context& x, Index group) { return (x.s.group_trail[group] & trail::opened) != 0; }

/// The edge that has claimed the group so far. One that the pass in hand has not opened stands as in the last pass, and
/// counts from where the walk passes it.
inline Index holder_now(const Context& x, Index group) {
  const Index holder = x.s.now[group].holder;
  return holder == nil || !x.walking || is_opened(x, group) || is_passed(x, group) ? holder : nil;
}

/// In this pass; root always is.
inline bool claimed(const Context& x, Index group) { return group == nil || holder_now(x, group) != nil; }

/// An edge before it has its target.
inline bool taken(const Context& x, Index edge) {
  const Index holder = holder_now(x, target(x, edge));
  return holder != nil && holder != edge;
}

/// Its target was granted to it before this pass.
inline bool runs_for_now(const Context& x, Index edge) {
  const GroupAssignment& last = x.s.last[target(x, edge)];
  return last.holder == edge && last.granted();
}

/// The edge that controls the requester of this one. A claim counts before a trial: a plan in hand may name a group
/// that is claimed already, even one above it; it cannot be chosen, but it must not bend the chains.
inline Index above(const Context& x, Place place) {
  const Index group = requester(x, place.edge);
  if (group == nil) return nil;
  if (place.along == Chains::previous) return x.s.last[group].holder;
  const Index holder = holder_now(x, group);
  return holder != nil ? holder : x.s.trial[group];
}

} // namespace director::arbitration
