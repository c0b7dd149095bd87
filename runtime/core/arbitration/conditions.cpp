// docs/semantics.md, section 4.3: the conditions of a provider.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/choices.hpp"
#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/arbitration/push.hpp"

namespace director::arbitration {

/// It was active for its granted group after the last pass, and all of its `stay` holds: then its `when` does not
/// count.
bool stays(const Context& x, Index provider) {
  const Provider& row = x.t.providers[provider];
  if (row.stay.empty() || injected(Fault::stay_is_ignored)) return false;
  x.depends_on_last = true;
  if (x.s.last[row.group].active != provider || (x.s.last[row.group].flags & flag::granted) == 0) return false;
  for (const Index condition : x.t.list(row.stay)) {
    if (!holds(x, condition)) return false;
  }
  return true;
}

/// Held in this provider on purpose: conditions on states that it causes itself do not count.
bool waived(const Context& x, Index provider, Index condition, Index edge) {
  const Index group = x.t.providers[provider].group;
  const Push& push = x.s.now[group].push;
  if (injected(Fault::nothing_is_waived)) return false;
  if (push.edge == nil || push.provider != provider) return false;
  x.depends_on_last = true;
  if ((x.s.last[group].flags & flag::in_force) == 0 || x.s.last[group].push.provider != provider) return false;
  for (const Index state : x.t.list(x.t.providers[provider].causing)) {
    if (state == x.t.conditions[condition].state) return applies(x, push, edge);
  }
  return false;
}

Index find_false(const Context& x, Index provider, Index edge) {
  if (stays(x, provider)) return nil;
  for (const Index condition : x.t.list(x.t.providers[provider].when)) {
    if (!holds(x, condition) && !waived(x, provider, condition, edge)) return condition;
  }
  return nil;
}

} // namespace director::arbitration
