// docs/semantics.md, section 4.4, Grant: a unit gets its targets, and all that their plans need.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/grant.hpp"

#include "runtime/core/arbitration/availability.hpp"
#include "runtime/core/arbitration/choices.hpp"
#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/staleness.hpp"

namespace director::arbitration {

/// To an edge whose target is flat.
void grant_plain(Context& x, Index edge, Index provider) {
  claim(x, x.t.edges[edge].target, edge);
  now_granted(x, edge, provider);
  for (const Index need : x.t.list(x.t.providers[provider].needs)) {
    const Index group = x.t.edges[need].target;
    claim(x, group, need);
    x.s.now[group].flags |= flag::needed;
    if (!x.s.now[group].granted()) x.s.now[group].planned = x.t.groups[group].providers.begin;
  }
}

namespace {

enum class Tried : std::uint8_t { granted, refused, unclear };

/// What a provider of the flat target of `edge` needs: nobody has claimed it, and it can run.
bool needs_are_free(const Context& x, Index edge, Range needs) {
  const auto is_free = [&](Index need) {
    const Index group = x.t.edges[need].target, provider = x.t.groups[group].providers.begin;
    return !taken(x, need) && x.s.enabled[provider] != 0 &&
           (!x.t.groups[group].conditional || first_false(x, provider, need) == nil);
  };
  bool all = true;
  Index& above = x.s.trial[x.t.edges[edge].target]; // the chains of what it needs go through it
  above = edge;
  for (const Index need : x.t.list(needs)) all = all && is_free(need);
  above = nil;
  return all;
}

/// The same as try_members where what is needed is simple and nothing can stand in the way but what is claimed already.
inline Tried try_plain(Context& x, Index edge, bool outdated) {
  const Index group = x.t.edges[edge].target;
  const GroupAssignment& last = x.s.last[group];
  const bool as_before = last.holder == edge && last.granted();
  const Group& row = x.t.groups[group];
  if (!row.flat || taken(x, edge)) return Tried::unclear;
  if (!as_before && (outdated || x.stale_granted != 0)) return Tried::unclear;
  if (x.disputed) return Tried::unclear;
  for (Index place = 0; place != row.providers.size(); ++place) {
    const Index p = preferred(x, group, place, edge);
    if (x.s.enabled[p] == 0 || (outdated && p != last.active)) continue;
    if (row.conditional && first_false(x, p, edge) != nil) continue;
    if (!row.simple && !needs_are_free(x, edge, x.t.providers[p].needs)) continue;
    grant_plain(x, edge, p);
    if ((x.s.edge_marks[edge] & mark::pushes) != 0) keep_pushes_of_plain(x, edge, p);
    return Tried::granted;
  }
  return injected(Fault::disabled_providers_run) ? Tried::unclear : Tried::refused;
}

} // namespace

/// Whatever is chosen, something of it is not available.
void block(Context& x, Index count) {
  for (Index at = 0; at < count; ++at) x.s.edge_marks[x.s.member[at].edge] |= mark::refused;
  if (injected(Fault::blocked_units_push_on)) keep_pushes(x, count);
  explain(x, count, Why::blocked);
}

/// An edge before it has its target, and what it had before is nothing: nothing else counts, and nothing differs.
void block_alone(Context& x, Index edge) {
  x.s.edge_marks[edge] |= mark::visited | mark::refused;
  x.s.queued[edge] = {Why::blocked, nil};
  if (is_followed(x)) rest_on(x, edge, trail::behind);
}

void explain(Context& x, Index count, Why why, Index condition) {
  for (Index at = 0; at < count; ++at) x.s.queued[x.s.member[at].edge] = {why, condition};
}

void decide_alone(Context& x, Index edge, bool outdated) {
  take_in_hand(x, edge);
  switch (try_plain(x, edge, outdated)) {
  case Tried::granted: return;
  case Tried::refused: return x.t.conditions.empty() ? block(x, 1) : refuse(x, 1);
  case Tried::unclear: return try_members(x, 1, outdated);
  }
}

} // namespace director::arbitration
