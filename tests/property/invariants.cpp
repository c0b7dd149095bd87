// Header: tests/property/invariants.hpp. Test: tests/property/property_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/invariants.hpp"

#include "tests/oracle/order.hpp"

#include <algorithm>

namespace director::property {

namespace {

using oracle::EdgeId;
using oracle::GroupId;

class Looking {
public:
  Looking(const Snapshot& now, const oracle::Parts& parts)
      : now_(now),
        parts_(parts),
        facts_(parts.model()),
        held_(parts.model().groups.size()) {
    for (const EdgeId e : model().edges.ids()) {
      if (now.requests[e.value]) facts_.request[e] = oracle::Request{*now.requests[e.value], std::nullopt, 0};
    }
    for (const GroupId g : model().groups.ids()) {
      if (group(g).holder) held_[g] = oracle::Held{*group(g).holder, group(g).granted, group(g).needed, false};
    }
  }

  std::string all(bool at_rest) const {
    for (const GroupId g : model().groups.ids()) {
      std::string wrong = control(g);
      if (wrong.empty()) wrong = needs(g);
      if (wrong.empty()) wrong = push(g);
      if (wrong.empty() && at_rest) wrong = rest(g);
      if (!wrong.empty()) return name(g) + ": " + wrong;
    }
    return queue(at_rest);
  }

private:
  const compiler::Model& model() const { return parts_.model(); }
  const Snapshot::Group& group(GroupId g) const { return now_.groups[g.value]; }
  const std::string& name(GroupId g) const { return model().groups[g].name.value; }

  /// The holder is an edge that leads here, whose requester is in control itself; and it has a reason to hold.
  std::string control(GroupId g) const {
    const Snapshot::Group& it = group(g);
    if (!it.holder) {
      if (it.active) return "runs, and nobody holds it";
      return it.granted || it.needed ? "is granted or needed, and nobody holds it" : "";
    }
    if (parts_.target(*it.holder) != g) return "is held by an edge that leads elsewhere";
    if (it.granted && !it.active) return "is granted and has no provider";
    if (it.active && parts_.group_of(*it.active) != g) return "runs a provider of another group";
    if (parts_.is_limbo(*it.holder)) return it.granted ? "is granted to limbo" : "";
    const std::optional<GroupId> requester = parts_.requester(*it.holder);
    if (requester && !group(*requester).holder) return "is held for " + name(*requester) + ", which nobody holds";
    const bool requested = now_.requests[it.holder->value].has_value();
    if (it.granted && !requested) return "is granted to an edge without a request";
    if (!requested && !it.needed) return "is neither requested nor needed";
    if (!it.needed && requester && !group(*requester).active)
      return "is held for " + name(*requester) + ", which is not live";
    return "";
  }

  /// A granted group controls its whole plan: nothing of it is held otherwise.
  std::string needs(GroupId g) const {
    if (!group(g).granted) return "";
    for (const auto& need : model().providers[*group(g).active].needs) {
      const Snapshot::Group& needed = group(need.id);
      const bool ours = needed.holder && parts_.requester(*needed.holder) == g;
      if (!ours || !needed.needed) return "runs without what it needs: " + name(need.id);
    }
    return "";
  }

  /// A pusher goes before the group that it pushes.
  std::string push(GroupId g) const {
    const Snapshot::Group& it = group(g);
    if (!it.push) return it.in_force ? "has no push, and it is in force" : "";
    if (!now_.requests[it.push->by.value]) return "is pushed by an edge without a request";
    if (parts_.group_of(it.push->to) != g) return "is pushed to a provider of another group";
    if (!it.in_force) return "";
    if (it.active != it.push->to) return "has a push in force and runs another provider";
    const oracle::Chain pusher = oracle::chain_of(parts_, held_, it.push->by);
    const oracle::Chain pushed = oracle::chain_of(parts_, held_, *it.holder);
    if (!oracle::Order(parts_, facts_).before(pusher, pushed)) return "is pushed by what does not go before it";
    return pushed.below(it.push->by) ? "is pushed by what is above it" : "";
  }

  /// No run waits, no group is in limbo, and units are granted whole.
  std::string rest(GroupId g) const {
    const Snapshot::Group& it = group(g);
    if (!it.pending.empty()) return "rests with something pending";
    if (it.holder && parts_.is_limbo(*it.holder)) return "rests in limbo";
    if (!it.granted) return it.active ? "rests, is live and not granted" : "";
    std::size_t members = 0, granted = 0;
    for (const EdgeId e : model().groups[g].edges) {
      if (!now_.requests[e.value]) continue;
      const oracle::Level& level = model().edges[e].levels[*now_.requests[e.value]];
      if (!level.shares_unit()) continue;
      ++members;
      const Snapshot::Group& target = group(parts_.target(e));
      if (target.granted && target.holder == e) ++granted;
    }
    return granted != 0 && granted != members ? "has a part of its unit" : "";
  }

  std::string queue(bool at_rest) const {
    if (at_rest && !now_.queue.empty()) return "it rests, and there are runs to do";
    for (std::size_t i = 0; i < now_.queue.size(); ++i) {
      const GroupId g = now_.queue[i];
      if (std::find(now_.queue.begin(), now_.queue.begin() + static_cast<std::ptrdiff_t>(i), g) !=
          now_.queue.begin() + static_cast<std::ptrdiff_t>(i))
        return name(g) + " is in the run queue twice";
      if (!group(g).granted) return name(g) + " is in the run queue and not granted";
      if (group(g).pending.empty()) return name(g) + " is in the run queue for nothing";
    }
    return "";
  }

  const Snapshot& now_;
  const oracle::Parts& parts_;
  oracle::Facts facts_;
  oracle::Holders held_;
};

} // namespace

std::string broken_invariant(const Snapshot& now, const oracle::Parts& parts, bool at_rest) {
  return Looking(now, parts).all(at_rest);
}

} // namespace director::property
