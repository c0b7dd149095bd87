// Header: tests/property/claims.hpp. Test: tests/property/property_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/claims.hpp"

#include "tests/oracle/order.hpp"
#include "tests/property/units.hpp"

#include <algorithm>

namespace director::property {

namespace {

using oracle::Chain;
using oracle::ConditionId;
using oracle::EdgeId;
using oracle::GroupId;
using oracle::Plan;
using oracle::ProviderId;
using Kind = Because::Kind;

class Checking {
public:
  Checking(const Because& claim, const View& view, const Snapshot& now, const Compiled& compiled,
           const oracle::Parts& parts, const oracle::Notes* notes)
      : claim_(claim),
        view_(view),
        now_(now),
        compiled_(compiled),
        parts_(parts),
        notes_(notes),
        units_(parts.model(), view, now),
        facts_(parts.model()),
        held_(parts.model().groups.size()) {
    for (const EdgeId e : model().edges.ids()) {
      if (now.requests[e.value]) facts_.request[e] = oracle::Request{*now.requests[e.value], std::nullopt, 0};
    }
    for (const GroupId g : model().groups.ids()) {
      const Snapshot::Group& row = now.groups[g.value];
      if (row.holder) held_[g] = oracle::Held{*row.holder, row.granted, row.needed, false};
    }
  }

  std::string wrong() const {
    const bool at_rest = notes_ != nullptr;
    const GroupId asked{claim_.asked};
    const Snapshot::Group& it = group(asked);
    bool requested = false;
    for (const EdgeId e : model().edges.ids())
      requested = requested || (model().edges[e].target == asked && now_.requests[e.value]);
    const bool in_limbo = it.holder && parts_.is_limbo(*it.holder);
    switch (claim_.kind) {
    case Kind::running:
      if (!it.granted) return "it does not run";
      return it.holder == EdgeId{claim_.edge} && it.active == ProviderId{claim_.provider} ? "" : "for another";
    case Kind::not_requested: return requested || it.holder ? "it is requested, or held" : "";
    case Kind::reserved: return requested || !it.needed || in_limbo ? "it is not held for a need only" : "";
    case Kind::limbo: return !in_limbo || at_rest ? "it is not in limbo" : "";
    default: break;
    }
    if (it.granted) return "it runs";
    const EdgeId edge{claim_.edge};
    if (model().edges[edge].target != asked || !now_.requests[edge.value]) return "not the edge of a request for it";
    if (!in_unit(EdgeId{claim_.member})) return "the member is not of the unit";
    switch (claim_.kind) {
    case Kind::outdated:
    case Kind::deferred: return at_rest ? "nothing is about to change" : "";
    case Kind::condition: return wrong_condition();
    case Kind::no_provider: return wrong_no_provider();
    case Kind::together: return wrong_together();
    default: return wrong_holder();
    }
  }

private:
  using Choice = std::pair<ProviderId, const Plan*>;

  const compiler::Model& model() const { return parts_.model(); }
  const Snapshot::Group& group(GroupId g) const { return now_.groups[g.value]; }
  GroupId member_target() const { return model().edges[EdgeId{claim_.member}].target; }
  Chain chain(EdgeId edge) const { return oracle::chain_of(parts_, held_, edge); }

  bool is_member(EdgeId edge) const { return units_.is_member(edge); }
  std::vector<EdgeId> unit() const { return units_.of(EdgeId{claim_.edge}); }

  /// Two chains, that of the holder from the edge with which it got its group. At the place where they part, each has
  /// the first member of its unit, which is the place of the unit.
  struct Rivals {
    Chain ours, theirs;
    EdgeId our_first{nil}, their_first{nil}; ///< the edges at which they part
    bool keeps = false;                      ///< the holder is the equal of the member itself, so it keeps its group
  };
  Rivals rivals(EdgeId member, EdgeId holder) const {
    Rivals out{chain(member), chain(granted_with(holder))};
    const auto [a, b] = std::mismatch(out.ours.edges.rbegin(), out.ours.edges.rend(), out.theirs.edges.rbegin(),
                                      out.theirs.edges.rend());
    if (a == out.ours.edges.rend() || b == out.theirs.edges.rend()) return out;
    const EdgeId ours = *a, theirs = *b;
    out.keeps = oracle::Order(parts_, facts_).equal(out.ours, chain(holder));
    if (ours == member && !parts_.is_limbo(ours) && is_member(ours) && !is_member(theirs) && !out.keeps)
      *a = units_.first_of(ours);
    if (theirs == out.theirs.edge() && !parts_.is_limbo(theirs) && is_member(theirs) && !is_member(ours))
      *b = units_.first_of(theirs);
    out.our_first = *a, out.their_first = *b;
    return out;
  }

  bool in_unit(EdgeId member) const {
    const std::vector<EdgeId> all = unit();
    return std::find(all.begin(), all.end(), member) != all.end();
  }

  /// All enabled choices for a group.
  std::vector<Choice> choices(GroupId of) const {
    std::vector<Choice> out;
    const auto enabled = [&](ProviderId p) { return view_.enabled[p.value] != 0; };
    for (const ProviderId p : model().groups[of].providers) {
      for (const Plan& plan : parts_.plans(p)) {
        if (enabled(p) &&
            std::all_of(plan.begin(), plan.end(), [&](const auto& entry) { return enabled(entry.provider); }))
          out.emplace_back(p, &plan);
      }
    }
    return out;
  }

  /// The edge of the unit with which the holder got its group: it is in the plan for that edge, or its target.
  EdgeId granted_with(EdgeId holder) const {
    while (!parts_.is_limbo(holder) && group(parts_.target(holder)).holder == holder &&
           group(parts_.target(holder)).needed)
      holder = *group(*parts_.requester(holder)).holder;
    return holder;
  }

  /// The edge above the member that was granted in one unit with the holder, so before the member was tried.
  std::optional<EdgeId> granted_above(EdgeId holder, EdgeId member) const {
    const EdgeId with = granted_with(holder);
    const Chain own = chain(member);
    for (auto edge = own.edges.begin() + 1; edge != own.edges.end(); ++edge) {
      if (*edge == with) return with;
      if (parts_.is_limbo(*edge) || parts_.is_limbo(with)) continue;
      if (parts_.requester(*edge) == parts_.requester(with) && is_member(*edge) && is_member(with)) return *edge;
    }
    return std::nullopt;
  }

  /// Whether the group is held by an edge from which a claim by `edge`, below `member`, cannot take it.
  bool in_the_way(GroupId of, EdgeId edge, EdgeId member) const {
    const std::optional<EdgeId> holder = group(of).holder;
    if (!holder || *holder == edge || parts_.is_limbo(*holder)) return false;
    if (notes_ != nullptr) {
      const std::optional<EdgeId> claimed = notes_->claimed_before.at(member)[of];
      if (claimed) return claimed != edge;
      return oracle::Order(parts_, facts_).equal(chain(*holder), chain(member));
    }
    if (granted_above(*holder, member)) return true;
    const Rivals both = rivals(member, *holder);
    const oracle::Order order(parts_, facts_);
    if (!order.equal(both.ours, both.theirs)) return order.before(both.theirs, both.ours);
    return both.keeps || units_.stands_before(both.their_first, both.our_first);
  }
  bool can_be_had(const Choice& choice, EdgeId member) const {
    if (in_the_way(parts_.target(member), member, member)) return false;
    return std::none_of(choice.second->begin(), choice.second->end(),
                        [&](const auto& entry) { return in_the_way(entry.group, entry.by, member); });
  }
  bool any_can_be_had(EdgeId member) const {
    const std::vector<Choice> all = choices(parts_.target(member));
    return std::any_of(all.begin(), all.end(), [&](const Choice& each) { return can_be_had(each, member); });
  }

  bool any_enabled(GroupId of) const {
    const auto& providers = model().groups[of].providers;
    return std::any_of(providers.begin(), providers.end(), [&](ProviderId p) { return view_.enabled[p.value] != 0; });
  }

  std::string wrong_no_provider() const {
    if (!choices(member_target()).empty()) return "there is a choice";
    return any_enabled(GroupId{claim_.group}) ? "a provider is enabled" : "";
  }

  std::string wrong_together() const {
    if (claim_.group != nil) {
      if (claim_.group != member_target().value || !any_enabled(member_target())) return "no provider is enabled";
      return choices(member_target()).empty() ? "" : "there is a choice";
    }
    for (const EdgeId member : unit()) {
      if (!any_can_be_had(member)) return "a member cannot be had alone: " + parts_.name(member);
    }
    return "";
  }

  std::string wrong_holder() const {
    const EdgeId member{claim_.member}, holder{claim_.holder};
    const GroupId what{claim_.group};
    if (any_can_be_had(member)) return "nothing is in the way";
    if (group(what).holder != holder) return "somebody else holds it";
    if (!in_the_way(what, EdgeId{nil}, member)) return "the holder got it later";
    if (claim_.kind == Kind::lost ? what != member_target() : !is_needed(what)) return "that is not what it takes";
    if (const std::optional<EdgeId> above = granted_above(holder, member)) return wrong_above(holder, *above);
    const oracle::Order order(parts_, facts_);
    const Rivals both = rivals(member, holder);
    if (order.before(both.ours, both.theirs)) return "the holder goes behind";
    const Rivalry& rivalry = claim_.rivalry;
    if (rivalry.won_by == Precedence::above) return "the holder is not above";
    if (order.before(both.theirs, both.ours) == (rivalry.won_by == Precedence::equal)) return "they are not equal";
    if (rivalry.our_first != both.our_first.value || rivalry.their_first != both.their_first.value)
      return "another member of the unit goes first";
    return wrong_rivalry(chain(member), chain(granted_with(holder)));
  }

  /// `above`: the edge above the member that was granted in one unit with the holder.
  std::string wrong_above(EdgeId holder, EdgeId above) const {
    const Rivalry& rivalry = claim_.rivalry;
    if (rivalry.won_by != Precedence::above) return "it was granted with a group above";
    const EdgeId with = granted_with(holder);
    if (above == holder) return rivalry.common == nil && rivalry.theirs == nil ? "" : "the holder is above";
    if (above == with)
      return rivalry.common == parts_.target(with).value && rivalry.theirs == nil ? "" : "a group above needs it";
    return rivalry.ours == above.value && rivalry.theirs == with.value ? "" : "it was granted with another one";
  }

  bool is_needed(GroupId what) const {
    for (const Choice& choice : choices(member_target())) {
      for (const auto& entry : *choice.second) {
        if (entry.group == what && parts_.group_of(ProviderId{claim_.provider}) == entry.needer) return true;
      }
    }
    return false;
  }

  std::string wrong_rivalry(const Chain& ours, const Chain& theirs) const {
    const Rivalry& rivalry = claim_.rivalry;
    const EdgeId a{rivalry.ours}, b{rivalry.theirs};
    const auto on = [](const Chain& chain, EdgeId edge) {
      return std::find(chain.edges.begin(), chain.edges.end(), edge) != chain.edges.end();
    };
    if (a == b || !on(ours, a) || !on(theirs, b) || on(ours, b) || on(theirs, a)) return "they do not part there";
    if (parts_.requester(a) != parts_.requester(b)) return "they have no common requester there";
    const auto common = parts_.requester(a);
    if (common ? rivalry.common != common->value : rivalry.common != nil) return "that is not the common requester";
    const auto priority = [&](EdgeId edge) -> std::int64_t { return units_.level(edge).priority; };
    if (rivalry.our_priority != priority(EdgeId{rivalry.our_first}) ||
        rivalry.their_priority != priority(EdgeId{rivalry.their_first}))
      return "other priorities";
    if (rivalry.won_by == Precedence::priority && rivalry.our_priority >= rivalry.their_priority)
      return "the priority is not higher";
    return "";
  }

  std::string wrong_condition() const {
    const ConditionId id = compiled_.lowered.condition_ids[claim_.condition];
    const compiler::Condition& condition = model().conditions[id];
    const auto& value = now_.values[condition.state.value];
    if (value && condition.accepts.contains(*value)) return "the condition holds";
    const auto has = [&](ProviderId p) {
      const auto& when = model().providers[p].when;
      return std::any_of(when.begin(), when.end(), [&](const auto& use) { return use.id == id; });
    };
    const std::vector<Choice> all = choices(member_target());
    const bool lacked = std::any_of(all.begin(), all.end(), [&](const Choice& choice) {
      return has(choice.first) || std::any_of(choice.second->begin(), choice.second->end(),
                                              [&](const auto& entry) { return has(entry.provider); });
    });
    if (!lacked || !has(ProviderId{claim_.provider})) return "nothing that it takes has that condition";
    // The first one that is pushed, or else active, or else of another group, or else of the group that waits.
    const auto likelihood = [&](ProviderId p) {
      const GroupAssignment& row = view_.assignment[parts_.group_of(p).value];
      if (parts_.group_of(p) == member_target()) return 1;
      if (row.push.edge != nil && row.push.provider == p.value) return 4;
      return row.active == p.value ? 3 : 2;
    };
    std::optional<ProviderId> expected;
    for (const ProviderId p : model().providers.ids()) {
      if (view_.enabled[p.value] == 0 || !parts_.causes(p, id)) continue;
      if (!expected || likelihood(p) > likelihood(*expected)) expected = p;
    }
    if (!expected) return claim_.causer == nil ? "" : "nobody could cause it";
    const bool right = claim_.causer == expected->value && claim_.causer_group == parts_.group_of(*expected).value;
    return right ? "" : "another could cause it";
  }

  const Because& claim_;
  const View& view_;
  const Snapshot& now_;
  const Compiled& compiled_;
  const oracle::Parts& parts_;
  const oracle::Notes* notes_;
  const Units units_;
  oracle::Facts facts_;
  oracle::Holders held_;
};

} // namespace

std::string wrong_claim(const Because& claim, const View& view, const Snapshot& now, const Compiled& compiled,
                        const oracle::Parts& parts, const oracle::Notes* notes) {
  return Checking(claim, view, now, compiled, parts, notes).wrong();
}

} // namespace director::property
