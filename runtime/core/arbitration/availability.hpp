#pragma once
// SPDX-License-Identifier: MIT
// Which groups are available to an edge. docs/semantics.md, section 4.2.

#include "runtime/core/arbitration/context.hpp"
#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/base/inline.hpp"
#include "runtime/core/base/parts.hpp"

namespace director::arbitration {

DIRECTOR_PART bool kept_by_equal(Context& x, Index group, Index edge, bool record);
DIRECTOR_PART bool denied_in_vain(Context& x);

DIRECTOR_ONE_COPY inline bool available(Context& x, Index group, Index edge, bool record) {
  const Index claimant = holder_now(x, group);
  if (claimant != nil) return claimant == edge;
  const Index before = x.s.last[group].holder;
  return before == nil || before == edge || is_limbo(x, before) || !x.t.groups[group].equals ||
         !kept_by_equal(x, group, edge, record);
}

} // namespace director::arbitration
