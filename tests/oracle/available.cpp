// Header: tests/oracle/pass.hpp. Test: tests/oracle/conformance_test.cpp.
// SPDX-License-Identifier: MIT
// semantics.md, 4.2: what is available.
#include "tests/oracle/pass.hpp"

#include <algorithm>

namespace director::oracle {

bool Pass::available(GroupId group, const Chain& to) {
  if (const auto& claim = now_.held[group]) return claim->by == to.edge();
  const auto& held = last_.held[group];
  if (!held) return true;
  // Equals never take from each other.
  const EdgeId f = held->by;
  if (f == to.edge() || !alive(f) || refused_.contains(f) || forgotten_.contains(f)) return true;
  if (!order_.equal(previous_chain(f), to)) return true;
  ++notes_.denials;
  const Denial denial{group, f};
  if (std::find(denials_.begin(), denials_.end(), denial) == denials_.end()) denials_.push_back(denial);
  return false;
}

bool Pass::alive(EdgeId edge) const {
  if (parts_.is_limbo(edge)) return false;
  const bool needed = last_.held_by(edge, parts_.target(edge)) && last_.held[parts_.target(edge)]->needed;
  if (!facts_.request[edge] && !needed) return false;
  const std::optional<GroupId> requester = parts_.requester(edge);
  return !requester || (last_.held[*requester] && alive(last_.held[*requester]->by));
}

std::optional<EdgeId> Pass::wrongly_denied() const {
  for (const auto& [group, holder] : denials_) {
    if (!now_.held_by(holder, group)) return holder;
  }
  return std::nullopt;
}

} // namespace director::oracle
