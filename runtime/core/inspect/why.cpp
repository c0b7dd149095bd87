// docs/semantics.md, section 4: explains why a group runs or does not.
// SPDX-License-Identifier: MIT
//
// The last pass has noted for each request why it was refused; here the group and the edge in the way are found.
// Holders are read after the pass, when a weaker request may have got what was left: a holder is in the way only if it
// goes before the request, is its equal, or was granted together with something above the request.

#include "runtime/core/inspect/why.hpp"

#include "runtime/core/arbitration/order.hpp"

namespace director {

namespace {

using Kind = Because::Kind;

class Explainer {
public:
  explicit Explainer(const View& view) : v_(view), t_(*view.tables) {}

  Because about(Index group) {
    Because out{.asked = group, .holder = v_.holder(group)};
    if (v_.granted(group)) {
      out.kind = Kind::running;
      out.edge = out.member = out.holder;
      out.provider = v_.assignment[group].active;
      return out;
    }
    out.edge = out.member = first_request(group);
    if (v_.is_limbo(out.holder)) {
      out.kind = Kind::limbo;
    } else if (out.edge != nil) {
      explain(out);
    } else if (out.holder != nil) {
      out.kind = Kind::reserved;
    }
    return out;
  }

  Because about_request(Index edge) {
    Because out{.asked = target(edge), .edge = edge, .member = edge};
    explain(out);
    return out;
  }

  bool stands_in_the_way(Index holder, Index edge) const {
    Rivalry rivalry;
    return !v_.is_limbo(holder) && goes_first(holder, edge, rivalry);
  }

private:
  /// One group of a choice in construction: the target, then needs, depth first.
  struct Entry {
    Index edge = nil; ///< edge that would claim it
    Index provider = nil;
    const Entry* needer = nullptr; ///< null: it is the target
    Index place = 0;               ///< of the need among those of its needer
    const Entry* before = nullptr; ///< the entry made before this one
  };

  Index target(Index edge) const { return t_.edges[edge].target; }
  Index requester(Index edge) const { return v_.is_limbo(edge) ? nil : t_.edges[edge].requester; }
  Index above(Index edge) const {
    const Index group = requester(edge);
    return group == nil ? nil : v_.holder(group);
  }
  bool optional(Index edge) const {
    return !v_.is_limbo(edge) && v_.requested(edge) && t_.levels[v_.request[edge].level].optional;
  }
  Index length(Index edge) const {
    Index count = 0;
    for (; edge != nil; edge = above(edge)) ++count;
    return count;
  }
  Index urgency(Index edge) const { return arbitration::urgency(t_, edge, v_.request[edge].level); }

  /// The edge with which the holder got its group: the one that it is a need of, or itself.
  Index granted_with(Index holder) const {
    while (!v_.is_limbo(holder) && v_.holder(target(holder)) == holder && v_.assignment[target(holder)].needed() &&
           above(holder) != nil) // nil: only in a crafted state that was loaded
      holder = above(holder);
    return holder;
  }

  /// Whether `theirs` is above `ours`, or was granted together with an edge above, as a need or in one unit: it has its
  /// group before anything below that edge is tried, whatever its rank.
  bool is_claimed_above(Index theirs, Index ours, Rivalry& out) const {
    const Index with = granted_with(theirs);
    for (Index edge = above(ours); edge != nil && !v_.is_limbo(edge); edge = above(edge)) {
      if (edge == with) {
        out.common = edge == theirs ? nil : target(edge);
      } else if (!v_.is_limbo(with) && requester(edge) == requester(with) && in_unit(edge) && in_unit(with)) {
        out.common = requester(edge);
        out.ours = edge, out.theirs = with;
      } else {
        continue;
      }
      out.won_by = Precedence::above;
      return true;
    }
    return false;
  }

  /// Whether `theirs` goes before `ours` by rules 1 to 4 of the order, is its equal and was there first, or was claimed
  /// before `ours` was tried.
  bool goes_first(Index theirs, Index ours, Rivalry& out) const {
    using arbitration::Chains, arbitration::Parting, arbitration::Place, arbitration::Verdict;
    out = {};
    if (is_claimed_above(theirs, ours, out)) return true;
    const Index with = granted_with(theirs);
    const auto [at_ours, at_theirs] = arbitration::parting(
        {ours, Chains::previous}, {with, Chains::previous}, length(ours), length(with),
        [&](Place place) { return above(place.edge); }, [&](Index edge) { return optional(edge); });
    if (at_ours.edge == nil) return false; // it is above
    out.ours = at_ours.edge, out.theirs = at_theirs.edge;
    out.common = requester(out.ours);
    if (v_.is_limbo(out.ours) || v_.is_limbo(out.theirs)) { // limbo goes after everything, and no message mentions it
      out.won_by = Precedence::optional;
      return v_.is_limbo(out.ours);
    }
    // A unit has the place of its first member; but a holder that is the equal of the member itself keeps its group.
    const bool holds = v_.holder(target(theirs)) == theirs;
    arbitration::Side whole = at_theirs;
    for (Index edge = theirs; edge != with; edge = above(edge)) whole.optional = whole.optional || optional(edge);
    const bool keeps =
        holds && arbitration::compare_ranks(at_ours, whole, urgency(out.ours), urgency(out.theirs)).order == 0;
    out.our_first = ours == out.ours && !keeps ? first_of_unit(out.ours, out.theirs) : out.ours;
    out.their_first = with == out.theirs ? first_of_unit(out.theirs, out.ours) : out.theirs;
    out.our_priority = v_.priority(out.our_first);
    out.their_priority = v_.priority(out.their_first);
    const Verdict verdict =
        arbitration::compare_ranks(at_ours, at_theirs, urgency(out.our_first), urgency(out.their_first));
    out.won_by = verdict.by;
    return verdict.order > 0 || (verdict.order == 0 && (keeps || !holds || is_older(out.their_first, out.our_first)));
  }

  /// Rule 5. An edge that holds its target without a request is younger than every request.
  bool is_older(Index ours, Index theirs) const {
    if (v_.requested(ours) != v_.requested(theirs)) return v_.requested(ours);
    if (v_.request[ours].stamp != v_.request[theirs].stamp) return v_.request[ours].stamp < v_.request[theirs].stamp;
    return ours < theirs;
  }

  /// The request for a group that goes first.
  Index first_request(Index group) const {
    Index first = nil;
    for (const Index edge : t_.list(t_.groups[group].requesters)) {
      if (!v_.requested(edge)) continue;
      Rivalry rivalry;
      if (first == nil || !goes_first(first, edge, rivalry) ||
          (rivalry.won_by == Precedence::equal && is_older(rivalry.our_first, rivalry.their_first)))
        first = edge;
    }
    return first;
  }

  bool alone(Index edge) const {
    const Level& level = t_.levels[v_.request[edge].level];
    return requester(edge) == nil || level.optional || level.apart;
  }

  bool in_unit(Index edge) const { return v_.requested(edge) && !alone(edge); }

  /// The edge that orders the sibling: the first member of its unit if the rival is outside of it, else the sibling.
  Index first_of_unit(Index sibling, Index rival) const {
    if (!in_unit(sibling) || in_unit(rival)) return sibling;
    Index first = nil;
    for (const Index e : t_.groups[requester(sibling)].edges.rows()) {
      if (!in_unit(e)) continue;
      const bool older = first != nil && is_older(e, first);
      if (first == nil || urgency(e) < urgency(first) || (urgency(e) == urgency(first) && older)) first = e;
    }
    return first;
  }

  /// Calls found(member) for the request, then the others of its unit, until it returns true: `out.member`.
  template <class Found>
  bool any_member(Because& out, Found found) const {
    if (found(out.edge)) return true;
    const Range siblings = alone(out.edge) ? Range{} : t_.groups[requester(out.edge)].edges;
    Index& e = out.member;
    for (e = siblings.begin; e != siblings.end; ++e) {
      if (e != out.edge && in_unit(e) && found(e)) return true;
    }
    out.member = out.edge;
    return false;
  }

  /// Whether the requests of the group may change: it, or the first one above it that is granted, is about to run for a
  /// new task or is not held, or a group above it is in limbo, below which no rule of the order is worth explaining.
  bool requests_may_change(Index group) const {
    for (bool granted = false; group != nil; group = requester(v_.holder(group))) {
      const Index holder = v_.holder(group);
      if (holder == nil) return !granted;
      if (v_.is_limbo(holder)) return true;
      if (!granted && v_.granted(group) && v_.run_queue[group].pending.has(reason::makes_stale)) return true;
      granted = granted || v_.granted(group);
    }
    return false;
  }

  void explain(Because& out) {
    const Queued queued = v_.queued(out.edge);
    out.kind = Kind::outdated;
    if (requests_may_change(requester(out.edge))) return;
    switch (queued.why) {
    case Why::waiting: return waits(out, queued.condition);
    case Why::deferred: out.kind = Kind::deferred; return;
    case Why::blocked: return blocked(out);
    case Why::outdated:
    case Why::none: return;
    }
  }

  void waits(Because& out, Index condition) {
    out.kind = Kind::condition;
    out.condition = condition;
    // The choice that waits is the first one that was available; by now another one may be.
    for (const bool available : {true, false}) {
      if (any_member(out, [&](Index member) { return has_condition(member, condition, available, out.provider); }))
        break;
    }
    out.group = target(out.member);
    int best = 0; // the likeliest is pushed, is active, may become active, or is a provider of the group itself
    for (const Index causer : causers(t_, condition)) {
      const Index group = t_.providers[causer].group;
      const GroupAssignment& row = v_.assignment[group];
      const bool pushed = row.push.edge != nil && row.push.provider == causer;
      const int likely = group == out.group ? 1 : pushed ? 4 : row.active == causer ? 3 : 2;
      if (likely <= best || v_.enabled[causer] == 0) continue;
      best = likely;
      out.causer = causer;
      out.causer_group = group;
    }
  }

  /// Finds the provider that has the condition in a choice. `available`: in the first one whose groups are available.
  bool has_condition(Index member, Index condition, bool available, Index& provider) const {
    const auto accept = [&](const Entry& entry) {
      return !available || (!held(entry, member) && !is_of_another(entry, member));
    };
    const auto look = [&](const Entry& last) {
      for (const Entry* entry = &last; entry != nullptr; entry = entry->before) {
        const auto when = t_.list(t_.providers[entry->provider].when);
        if (any(when, [&](Index each) { return each == condition; })) provider = entry->provider;
      }
      return available || provider != nil;
    };
    return any_choice({.edge = member}, accept, look) && provider != nil;
  }

  /// Whether the group of the entry is held by an edge that is in the way of the member.
  bool held(const Entry& entry, Index member) const {
    const Index holder = v_.holder(target(entry.edge));
    return holder != nil && holder != entry.edge && stands_in_the_way(holder, member);
  }

  /// Whether the group of the entry is the target of another member of the unit.
  bool is_of_another(const Entry& entry, Index member) const {
    return !alone(member) && any(t_.groups[requester(member)].edges.rows(),
                                 [&](Index e) { return e != member && in_unit(e) && target(e) == target(entry.edge); });
  }

  void blocked(Because& out) {
    if (any_member(out, [&](Index member) { return !has_choice(member, out.group); })) {
      out.kind = any_enabled(out.group) ? Kind::together : Kind::no_provider;
      return;
    }
    if (!any_member(out, [&](Index member) { return is_held(member, out.group, out.provider); })) {
      out.kind = Kind::together;
      out.group = out.provider = nil;
      return;
    }
    out.kind = out.provider == nil ? Kind::lost : Kind::need_held;
    out.holder = v_.holder(out.group);
    goes_first(out.holder, out.member, out.rivalry);
  }

  /// Tries the choices for the target of a member, with enabled providers only, in order; an entry that is not accepted
  /// is not extended. True as soon as found(last entry) is true for a complete one. Recursive, once for each group of a
  /// choice: the entries are on the stack.
  template <class Accept, class Found>
  bool any_choice(Entry entry, const Accept& accept, const Found& found) const {
    const Range providers = t_.groups[target(entry.edge)].providers;
    for (entry.provider = providers.begin; entry.provider != providers.end; ++entry.provider) {
      if (v_.enabled[entry.provider] != 0 && accept(entry) && any_extension(entry, accept, found)) return true;
    }
    return false;
  }

  template <class Accept, class Found>
  bool any_extension(const Entry& last, const Accept& accept, const Found& found) const {
    Entry next{.needer = &last, .before = &last};
    while (next.place >= t_.providers[next.needer->provider].needs.size()) {
      next.place = static_cast<Index>(next.needer->place + 1);
      next.needer = next.needer->needer;
      if (next.needer == nullptr) return found(last);
    }
    next.edge = t_.list(t_.providers[next.needer->provider].needs)[next.place];
    for (const Entry* entry = &last; entry != nullptr; entry = entry->before) {
      if (target(entry->edge) == target(next.edge)) return false; // it cannot be held for two needs
    }
    return any_choice(next, accept, found);
  }

  bool any_enabled(Index group) const {
    return any(t_.groups[group].providers.rows(), [&](Index provider) { return v_.enabled[provider] != 0; });
  }

  /// Whether the member has a choice. If not, `lacks` is the first group without an enabled provider, or the target.
  bool has_choice(Index member, Index& lacks) const {
    lacks = target(member);
    const auto accept = [&](const Entry& entry) {
      for (const Index need : t_.list(t_.providers[entry.provider].needs)) {
        if (!any_enabled(target(need)) && lacks == target(member)) lacks = target(need);
      }
      return true;
    };
    return any_choice({.edge = member}, accept, [](const Entry&) { return true; });
  }

  /// Whether every choice has a held group: that of the first choice, and the provider that needs it (nil: the target).
  bool is_held(Index member, Index& group, Index& provider) const {
    group = provider = nil;
    const auto accept = [&](const Entry& entry) { return group == nil || !held(entry, member); };
    const auto found = [&](const Entry& last) {
      const Entry* first = nullptr;
      for (const Entry* entry = &last; entry != nullptr; entry = entry->before) {
        if (held(*entry, member)) first = entry;
      }
      if (first == nullptr) return true;
      group = target(first->edge);
      provider = first->needer == nullptr ? nil : first->needer->provider;
      return false;
    };
    return !any_choice({.edge = member}, accept, found);
  }

  const View& v_;
  const Tables& t_;
};

} // namespace

Because why(const View& view, Index group) { return Explainer(view).about(group); }

Because why_refused(const View& view, Index edge) { return Explainer(view).about_request(edge); }

bool stands_in_the_way(const View& view, Index holder, Index edge) {
  return Explainer(view).stands_in_the_way(holder, edge);
}

} // namespace director
