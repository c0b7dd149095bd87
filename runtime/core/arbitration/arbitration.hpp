#pragma once
// SPDX-License-Identifier: MIT
// Arbitration: from requests, state values, enabled flags, pending reasons and the last assignment to a new assignment,
// over one component of the tables: what is decided in one never depends on another.
//
// The pass of semantics.md 4 is greedy along the order of edges: the first candidate takes what it needs, and nobody
// behind it can change that. So one sweep decides, and only the rule that equals never take from each other can ask for
// a repetition. A sweep goes along the order as the last one did and decides a unit again only where something reaches
// it that is another than last time (reach.cpp); groups that hold nothing of that are passed by, each with all below it
// (trail.cpp). What comes out equals the pass from nothing. Cost: some work for each edge of root and for each edge of a
// group that is looked at, and for each unit reached providers and plans tried, each compared along its chain of holders.
//
// While it decides, a pass notes what its result may depend on besides requests, values and flags: on the assignment
// before (then it has to be repeated on its own result), and on whose orders are outdated (then again when that
// changes). Where neither is so, nothing has to be decided until an input of the component changes: most micro-steps
// are of that kind, since a task that is asked for again changes no input of arbitration.

#include "runtime/core/base/marks.hpp"
#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director {

class Pass : public Order {
public:
  using Order::Order;

  /// Reads State's decision part; writes `now`, `next_order`, `next_count` and `queued` of the
  /// component.
  void decide(Index component);

  /// The next pass over each component begins from nothing: the last assignment is not that of its last pass.
  void forget_trail() {
    for (Index c = 0; c < t_.components.size(); ++c) s_.news_count[c] = nil;
    for (Index g = 0; g < t_.groups.size(); ++g) s_.now[g] = s_.last[g];
    for (Index slot = 0; slot < t_.plan_groups.size(); ++slot) s_.now.plan[slot] = s_.last.plan[slot];
  }
  /// A component of at most so many groups is decided whole. To find out what a change reaches costs more there.
  void set_most_decided_whole(Index groups) {
    most_decided_whole_ = groups;
    forget_trail();
  }
  std::uint64_t decided() const { return decided_; } ///< units so far, again where a pass is repeated
  /// So far: groups placed, units decided, and choices and plans tried, those of searches for pushes among them.
  std::uint64_t work() const { return work_; }

  /// Writes State::traits and component_traits, which follow from the tables. Once, before the first pass.
  void find_traits();

  /// The groups that the pass that was made last looked at: all others stand as they stood.
  std::span<const Index> opened() const {
    return whole_ ? t_.list(c_.groups) : std::span<const Index>{s_.opened + c_.order, opened_count_};
  }
  /// Notes of it what the next one has to know.
  void end_trail();
  /// A plan of some group may pick one provider or another.
  bool alternatives(Index component) const { return (s_.component_traits[component] & trait::alternatives) != 0; }
  /// The result may be another one when it is the last assignment itself.
  bool depends_on_last() const { return depends_on_last_; }
  /// The result may be another one when other groups are stale.
  bool depends_on_stale() const { return depends_on_stale_; }

protected:
  bool holds(Index condition) const { return s_.truth[condition] != 0; }
  void touch_group(Index group);

  Index flipped_count_ = 0;     ///< rows of State::flipped in use
  Index rerequested_count_ = 0; ///< rows of State::rerequested in use

private:
  bool can_be_equal(const Component& row);

  // choose.cpp: sections 4.2 and 4.3
  bool alive(Index edge) const;
  bool available(Index group, Index edge, bool record) {
    const Index claimant = holder_now(group);
    if (claimant != nil) return claimant == edge;
    const Index before = s_.last[group].holder;
    return before == nil || before == edge || is_limbo(before) || !kept_by_equal(group, edge, record);
  }
  bool kept_by_equal(Index group, Index edge, bool record);
  bool applies(const Push& push, Index edge) const;
  Index pushed_first(Index group, Index edge) const;
  Index preferred(Index group, Index place, Index edge) const;
  bool stays(Index provider) const;
  bool waived(Index provider, Index condition, Index edge) const;
  Index first_false(Index provider, Index edge) const;
  bool may_deny(Index group, Index edge, Index member) const;
  bool may_be_denied(Index member);
  void take_in_hand(Index member);
  bool disputed(Index member) const;
  bool choose_flat(bool with_conditions);
  bool take_needs(Index provider, bool with_conditions);
  bool combine(Index count, bool with_conditions);
  bool each_has_choice(Index from, Index count, bool with_conditions, bool record);
  void sort_by_cluster(Index count);
  bool next_choice(Index at, bool fresh, bool with_conditions, bool record);
  bool plan_fits(Index at, bool with_conditions, bool record, Index& keep);
  bool plan_as_it_is(Index at) const;
  bool search_plan(Index provider, Index begin, Index& end, bool fresh, bool by_declaration);
  void drop_entries(Index begin, Index end);
  void leave_combination(Index count);
  Index entries_begin(Index at) const { return at == 0 ? Index{0} : s_.member_entries[at - 1]; }
  Index slot_of(Index owner, Index group) const;

  // pass.cpp: section 4.4
  void begin_sweep();
  void sweep_again();
  bool denied_in_vain();
  Index stale_source(Index group) const;
  bool stale(Index group) const { return stale_source(group) != current; }
  bool stale_requester(Index edge) const;
  bool any_new(Index count) const;
  /// Its target was granted to it before this pass.
  bool runs_for_now(Index edge) const {
    const GroupAssignment& last = s_.last[target(edge)];
    return last.holder == edge && last.granted();
  }

  // trail.cpp: what is looked at. reach.cpp: what is decided again
  template <class ComponentOf, class Take>
  void take_own(Index* list, Index& count, ComponentOf&& component_of, Take&& take);
  void begin_trail();
  void open_all();
  void clear(Index group);
  void open(Index group);
  void mark_pushers();
  template <class Visit>
  void each_user_edge(Index group, Visit&& visit);
  void take_up(Index edge, bool with_siblings);
  void take_up_last(Index group);
  void reach_edge(Index edge);
  bool has_to_be_looked_at(Index group) const;
  bool is_outdated(Index group) const { return (s_.group_marks[group] & mark::outdated) != 0; }
  bool outdates(Index group) const;
  bool can_stand(Index group) const;
  bool waits(Index group) const;
  void open_waiting();
  void disturb();
  void clear_marks();
  void reach(Index group);
  void move(Index group);
  void reach_pushes_of(Index edge);
  /// Nothing that the decision about it looks at is another than in the last pass.
  bool stands(Index edge) const {
    if (whole_) return false;
    const std::uint8_t bits = s_.edge_trail[edge];
    const bool searches = (bits & trail::waits) != 0 && disturbed_ && !injected(Fault::who_waits_is_overlooked);
    return (bits & (trail::reached | trail::on_stale)) == 0 && !searches;
  }
  void repeat(Index edge);
  void repeat_grant(Index edge);
  void begin_decision(Index count);
  void begin_followed(Index count);
  void rest_on(Index edge, std::uint8_t bits);
  void end_decision(Index count) {
    if (is_followed()) compare_with_last(count);
  }
  bool is_followed() const { return c_.groups.size() > most_decided_whole_; }
  void compare_with_last(Index count);
  void compare_member(Index edge);
  void compare_claim(Index group);

  // units.cpp: what becomes of a unit
  bool try_simple(Index count);
  void try_members(Index count, bool outdated);
  /// An edge before it has its target.
  bool taken(Index edge) const {
    const Index holder = holder_now(target(edge));
    return holder != nil && holder != edge;
  }
  bool premature(Index count);
  bool reached_from_stale(Index found, Index edge);
  void defer(Index count);
  void grant(Index count);
  void claim(Index group, Index edge);
  void now_granted(Index edge, Index provider);
  void keep_own_pushes(Index count);
  bool pushes(Index count) const;
  void plan_for(Index owner, Index provider, Index begin, Index end);
  void claim_plan(Index begin, Index end);
  void block(Index count);
  void block_alone(Index edge);
  void refuse(Index count);
  void explain(Index count, Why why, Index condition = nil);

  // walk.cpp: who is tried next
  void sort_roots();
  void sweep();
  void sweep_below(Index group);
  void sweep_optional(Index root);
  void walk_on();
  void visit_root(Index edge);
  void visit(Index edge, std::uint8_t marks);
  void place(Index group);
  void put(Index group, Index at);
  void pass(Index group);
  void leave_to(Index group);
  void look_ahead(Index group);
  bool look_ahead_to(Index edge, Index base);
  void try_unit(Index edge, bool outdated);
  bool runs_on(Index edge) const;
  void try_alone(Index edge, bool outdated);
  void decide_alone(Index edge, bool outdated);
  enum class Tried : std::uint8_t { granted, refused, unclear };
  Tried try_plain(Index edge, bool outdated);
  bool needs_are_free(Index edge, Range needs) const;
  void grant_plain(Index edge, Index provider);
  void keep_pushes_of_plain(Index edge, Index provider);
  void postpone(Index edge);
  Index first_of_heap();
  Index& heap_at(Index at) { return s_.candidate[t_.edges.size() - 1 - at]; }
  /// Of two candidates: their requesters are claimed or root.
  bool goes_first(Index a, Index b) const {
    return (lineage_is_valid_ ? compare_claimed(a, b, true) : compare({a, Chains::current}, {b, Chains::current}, true)) < 0;
  }

  // finish.cpp: section 4.4, Hand-over, and what follows from the claims
  void hand_over();
  void hand_over(Index group);
  Index entries_of(Index group, const Assignment& of);
  void finish();
  void finish_pushes();
  bool asked_for(Index group) const;

  // push.cpp: the pushes of a unit
  bool in_unit(Index edge, Index count) const;
  Index collect_unmet(Index count);
  std::span<const Index> pushed_groups() const { return {s_.pushed + c_.order, pushed_count_}; }
  void list_push(Index group);
  void set_push(Index group, const Push& push);
  void keep_pushes(Index count);
  void keep_serving_pushes(Index count);
  void want(Range conditions, std::uint8_t bits);
  bool satisfies(Index provider, Index condition) const;
  bool somebody_satisfies(Index condition) const;
  void push_for(Index count, Index unmet);
  bool find_chain(Index condition, Index member, Push& out);
  bool relax(Index provider);
  bool can_be_pushed(Index provider, Index member) const;
  bool goes_before(Index member, Index edge) const;

  static constexpr Index current = static_cast<Index>(nil - 1); ///< instead of a group: nobody's orders are outdated

  Component c_; ///< the one in hand
  Index component_ = 0;
  Index ahead_ = 0;     ///< edges that the walk has before it
  Index postponed_ = 0; ///< and those that are optional
  Index placed_ = 0;    ///< groups that are claimed and come before it
  Index inherited_ = 0; ///< those of them that were held before
  Index denied_ = 0, stale_granted_ = 0;
  bool equals_ = false;  ///< edges may be equal
  bool disputed_ = false; ///< an equal may stand in the way of the one member in hand, whose target is flat
  bool pushed_ = false;  ///< there were pushes in the last assignment
  bool pushing_ = false; ///< there are in this one
  Index most_decided_whole_ = 16;
  bool whole_ = false;     ///< all of it is decided
  bool disturbed_ = false; ///< something is, or may be, another than in the last pass
  bool on_last_ = false, on_stale_ = false; ///< of the units decided before the one in hand
  Index first_moved_ = nil;     ///< the first place in the order that another group has than before
  Index limbo_ = 0;             ///< from this place on the groups of the order are in limbo, or below such a one
  Index top_ = nil;             ///< the group that was placed last, or one above it
  Index opened_count_ = 0;      ///< rows of State::opened in use
  Index reached_count_ = 0;     ///< rows of State::reached in use
  Index kept_count_ = 0;        ///< rows of State::news that were left alone when the pass began
  Index stale_kept_ = 0;        ///< those of them whose orders are outdated
  Index pushed_count_ = 0;      ///< rows of State::pushed in use
  std::uint64_t decided_ = 0; ///< units
  std::uint64_t work_ = 0;
  mutable bool depends_on_last_ = false, depends_on_stale_ = false;
};

/// For this very edge, or for the first time.
inline void Pass::claim(Index group, Index edge) {
  if (!is_opened(group)) open(group);
  GroupAssignment& now = s_.now[group];
  if (now.holder != nil) return; // for this very edge
  now.holder = edge;
  if (!lineage_is_valid_) return;
  const Index from = requester(edge);
  if (from == nil) {
    s_.lineage[group] = {1, edge, optional(edge)};
  } else {
    const Lineage& above = s_.lineage[from];
    s_.lineage[group] = {static_cast<Index>(above.depth + 1), above.top, above.optional || optional(edge)};
  }
}

/// What is decided about the group in this pass: nothing yet.
inline void Pass::clear(Index group) {
  s_.now[group] = GroupAssignment{};
  s_.run_queue[group].counts = 0;
  const Range slots = alternatives(component_) ? t_.groups[group].slots : Range{};
  for (Index slot = slots.begin; slot != slots.end; ++slot) s_.now.plan[slot] = nil;
}

/// In the new order.
inline void Pass::put(Index group, Index at) {
  if (at < first_moved_ && (at >= s_.order_count[component_] || s_.order[c_.order + at] != group)) first_moved_ = at;
  s_.next_order[c_.order + at] = group;
  s_.place[group] = at;
}

/// The target of an edge, which is claimed, runs in the provider chosen.
inline void Pass::now_granted(Index edge, Index provider) {
  const Index group = t_.edges[edge].target;
  GroupAssignment& now = s_.now[group];
  const GroupAssignment& last = s_.last[group];
  now.active = now.planned = provider;
  now.flags |= flag::granted;
  if ((s_.run_queue[group].pending & reason::outdating) == 0 && s_.request[edge].anew == 0 && edge == last.holder &&
      provider == last.active)
    return;
  s_.group_marks[group] |= mark::outdated;
  ++stale_granted_;
}

inline void Pass::begin_decision(Index count) {
  ++decided_;
  ++work_;
  for (Index at = 0; at < count; ++at) {
    s_.edge_marks[s_.unit[at]] |= mark::visited;
    s_.queued[s_.unit[at]] = Queued{};
  }
  if (is_followed()) begin_followed(count);
}

} // namespace director
