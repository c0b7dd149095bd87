#pragma once
// SPDX-License-Identifier: MIT
// All mutable memory of the engine: one block of bytes, owned by the caller, whose size follows from the tables. It
// begins with the decision state: everything that the next decision depends on, trivially copyable, so that two blocks
// with equal decision bytes behave alike. Behind it is the scratch memory of passes.

#include "runtime/core/base/tables.hpp"
#include "runtime/core/base/words.hpp"

#include <array>
#include <bit>

namespace director {

/// The numbers of rows, from which the size of the memory follows.
struct Shape {
  std::size_t groups = 0, providers = 0, edges = 0, conditions = 0, states = 0, promises = 0;
  std::size_t plan_slots = 0, listen_slots = 0, most_edges = 0, components = 0;
  std::size_t lacking = 0;  ///< the most conditions that may be false in one combination of choices
  std::size_t pushable = 0; ///< groups with a provider that has `causing`
  /// If there are several components: the most requests that can change in one micro-step.
  std::size_t altered = 0;

  constexpr std::size_t timers() const { return states + 2 * groups + promises; }

  static constexpr Shape of(const Tables& t) {
    Shape n{t.groups.size(),   t.providers.size(),   t.edges.size(),    t.conditions.size(), t.states.size(),
            t.promises.size(), t.plan_groups.size(), t.listened.size(), t.most_edges,        t.components.size()};
    for (const Group& group : t.groups) {
      Index most = 0;
      for (const Index p : group.providers.rows()) {
        if (t.providers[p].when.size() > most) most = t.providers[p].when.size();
      }
      n.lacking += most;
      n.pushable += any(group.providers.rows(), [&](Index p) { return !t.providers[p].causing.empty(); }) ? 1U : 0U;
    }
    if (n.components > 1) n.altered = t.root_edges > n.most_edges ? t.root_edges : n.most_edges;
    return n;
  }
};

/// Bits of GroupAssignment::flags.
namespace flag {
inline constexpr Index granted = 1;  ///< it was granted as the target of a unit in the last pass
inline constexpr Index needed = 2;   ///< its holder claimed it for a plan
inline constexpr Index in_force = 4; ///< its provider is active because of the push on it
inline constexpr Index serving = 8;  ///< and the condition of the push is false
} // namespace flag

/// Bits of State::component, for the next arbitration.
namespace work {
inline constexpr std::uint8_t changed = 1;       ///< a request, value or flag that it depends on has changed
inline constexpr std::uint8_t unsettled = 2;     ///< a pass over the last result may decide differently
inline constexpr std::uint8_t stale_matters = 4; ///< decisions of the last pass depended on which groups are stale
inline constexpr std::uint8_t decided = 16;      ///< it was decided in this micro-step
inline constexpr std::uint8_t reordered = 32;    ///< the order of its edges of root may have changed
inline constexpr std::uint8_t pushes = 64;       ///< with `decided`: it has pushes, or had them before
inline constexpr std::uint8_t kept = stale_matters | reordered;       ///< bits that stay when it need not be decided
inline constexpr std::uint8_t listed = changed | unsettled | decided; ///< with any of them it is listed in State::work
} // namespace work

/// Bits of RunQueueEntry::pending, as Reason.
namespace reason {
inline constexpr auto new_task = static_cast<std::uint8_t>(Reason::new_task);
inline constexpr auto pushed = static_cast<std::uint8_t>(Reason::pushed);
inline constexpr auto makes_stale = static_cast<std::uint8_t>(new_task | pushed); ///< of a granted group
} // namespace reason

/// Bits of RunQueueEntry::done.
namespace result {
inline constexpr std::uint8_t done = 1;
inline constexpr std::uint8_t failed = 2; ///< with `done`
} // namespace result

/// Bits of RunQueueEntry::flags.
namespace group_flag {
inline constexpr std::uint8_t queue = 1;     ///< it is in the run queue
inline constexpr std::uint8_t touched = 2;   ///< it is listed in State::touched
inline constexpr std::uint8_t lifecycle = 4; ///< it owns states, or has a handler or a period
} // namespace group_flag

/// A byte of bits. It is no `char`, which may alias anything: after a write, all pointers would be read again.
class Bits {
public:
  constexpr operator std::uint8_t() const { return static_cast<std::uint8_t>(raw_); }
  constexpr Bits& operator=(std::uint8_t bits) {
    raw_ = static_cast<Raw>(bits);
    return *this;
  }
  constexpr Bits& operator|=(std::uint8_t bits) { return *this = static_cast<std::uint8_t>(*this | bits); }
  constexpr Bits& operator&=(std::uint8_t bits) { return *this = static_cast<std::uint8_t>(*this & bits); }
  constexpr void remove(std::uint8_t bits) { *this &= static_cast<std::uint8_t>(~bits); }
  constexpr bool has(std::uint8_t bits) const { return (*this & bits) != 0; } ///< whether any of them is set

private:
  enum class Raw : std::uint8_t {};
  Raw raw_{};
};

/// A push of the group in this row, and the unmet condition that it was made for. No push: edge == nil.
struct Push {
  Index edge = nil, provider = nil, condition = nil;
  constexpr bool operator==(const Push&) const = default;
};

/// Why an edge is queued, and the first false condition if it waits for one.
struct Queued {
  Why why = Why::none;
  Index condition = nil;
  constexpr bool operator==(const Queued&) const = default;
};

/// The assignment of one group, stored together, because passes and comparisons go from group to group.
struct GroupAssignment {
  Index holder = nil;  ///< edge that controls it; edges.size() + group: limbo; nil: none
  Index active = nil;  ///< active provider; nil: it is not live
  Index planned = nil; ///< provider of its plan; nil: it has no plan
  Index flags = 0;     ///< bits of `flag`
  Push push{};
  constexpr bool granted() const { return (flags & flag::granted) != 0; }
  constexpr bool needed() const { return (flags & flag::needed) != 0; }
  constexpr bool in_force() const { return (flags & flag::in_force) != 0; }
  constexpr bool serving() const { return (flags & flag::serving) != 0; }
  constexpr bool operator==(const GroupAssignment&) const = default;
  /// Whether it differs in what semantics.md calls a change, after which arbitration is repeated at rest.
  constexpr bool decides_otherwise_than(const GroupAssignment& last) const {
    return holder != last.holder || active != last.active || granted() != last.granted() || push != last.push;
  }
  constexpr bool stops_after(const GroupAssignment& last) const { return last.active != nil && active == nil; }
};

/// The request through an edge.
struct Requested {
  std::uint64_t stamp = 0; ///< micro-step in which it became requested or changed its level
  Index level = nil;       ///< of Tables::levels; nil: it is not requested
  Index target = 0;        ///< as Edge::target
};

/// The place of a group in the run queue, its reasons to run, and its component, used by most micro-steps.
struct RunQueueEntry {
  Index runs_after = nil;  ///< the group before it in the queue; nil
  Index runs_before = nil; ///< the group behind it; nil
  Index component = 0;     ///< as Group::component
  Bits stale_matters{};    ///< 1: a decision of the last pass depends on whether it is stale
  Bits flags{};            ///< bits of `group_flag`
  Bits pending{};          ///< bits of Reason
  Bits done{};             ///< bits of `result`
};

/// The push because of which the promises of a provider run.
struct Promised {
  Index edge = nil;     ///< the pusher
  Index provider = nil; ///< nil: no promise runs
};

/// An assignment: the result of a pass. The last one is a part of the decision state; a pass builds another.
struct Assignment {
  GroupAssignment* group = nullptr;
  Index* plan = nullptr; ///< slot: provider picked in the plan of the slot's owner; nil: the group is not in the plan
  GroupAssignment& operator[](Index g) const { return group[g]; }
};

/// The value of a state.
struct StateValue {
  std::int32_t value = unset;
  Interval unchanged{.low = 0, .high = -1}; ///< around the value: in it, no condition flips
  std::int32_t staged = unset; ///< set by the running body, or by handlers in the last act; unset: not set
};

/// An entry of a plan in construction: a group.
struct PlanEntry {
  Index group;
  Index need;     ///< the edge by which it is needed
  Index choice;   ///< place of its provider in the order of preference
  Index provider; ///< its provider
  Index parent;   ///< entry that needs it; nil: the provider of the plan
  Index place;    ///< place of the need in the list of the provider that needs it
};

/// An edge of the current unit, and the choice for its target.
struct TriedMember {
  Index edge;
  Index choice;      ///< place of the provider in the order of preference
  Index provider;    ///< that provider
  Index entries_end; ///< one past the last entry of its plan
};

/// A false condition, and the member of the unit that waits for it.
struct UnmetCondition {
  Index member, condition;
};

/// The request of the running body through an edge.
struct Staged {
  Index level = nil; ///< nil: no request
  bool keep = false; ///< a request of that level is kept
};

struct Counters {
  Time now = 0;                  ///< the engine's time: that of the input or timer being served
  Time until = 0;                ///< the time that `step` was given last
  Time next_due = never;         ///< time of the first timer that is due
  Time quiet_until = first_time; ///< a step before this time has nothing to do without an input; first_time: unknown
  std::uint64_t micro_step = 0;  ///< micro-steps taken
  Index queue_first = nil;       ///< the group that runs next; nil: none
  Index queue_last = nil;        ///< the last group in the queue
  Index work_count = 0;          ///< rows of State::work in use
  Index touched_count = 0;       ///< rows of State::touched in use; 0 between micro-steps
  Index staged_count = 0;        ///< rows of State::staged in use; between micro-steps set by handlers: the next input
  Index anew_count = 0;          ///< rows of State::renewed in use; 0 between micro-steps
  bool begun = false;            ///< the first step was taken
  bool unsettled = false;        ///< the last arbitration changed something
  bool serving = false;          ///< timers that are due at `now` are being served
};

struct State {
  // The decision state.
  Counters* counters = nullptr;
  Requested* request = nullptr;           ///< edge
  Time* due = nullptr;                    ///< timer (Timers): when it is due; never
  Index* soonest = nullptr;               ///< a tree over timers: the one that is due first
  StateValue* values = nullptr;           ///< state
  Index* staged = nullptr;                ///< states with a staged value
  Assignment last;                        ///< the last assignment
  Index* order = nullptr;                 ///< component after component: its groups that are held, in order
  Index* order_count = nullptr;           ///< component: the number of these
  Index* place = nullptr;                 ///< group that is held: its place in that order
  Index* first_root = nullptr;            ///< component: its first edge of root, in order; nil
  Index* next_root = nullptr;             ///< edge of root: the next one of its component; nil
  RunQueueEntry* run_queue = nullptr;     ///< group
  Index* data_from = nullptr;             ///< group: edge whose slot has its data; nil: its own slot
  Promised* promised = nullptr;           ///< group; no rows if there are no promises
  Index* work = nullptr;                  ///< components with a bit of work::listed
  Bits* component = nullptr;              ///< component: bits of `work`
  Bits* enabled = nullptr;                ///< provider
  Bits* truth = nullptr;                  ///< condition: whether it holds
  Bits* fired = nullptr;                  ///< listening slot (Group::listens): whether the trigger fired

  // Scratch memory of one pass, commit or act.
  Assignment now;                    ///< the assignment of this pass
  Bits* edge_marks = nullptr;        ///< edge: bits of `mark`
  Bits* edge_trail = nullptr;        ///< edge: bits of `trail`, from pass to pass
  Queued* queued = nullptr;          ///< edge: why it is queued, by the last pass; see View::queued
  Queued* last_queued = nullptr;     ///< edge: why it was queued before this pass, for an observer
  Bits* anew = nullptr;              ///< edge: 1: it was requested anew in this micro-step
  Index* renewed = nullptr;          ///< edges that were requested anew
  Index* candidate = nullptr;        ///< stack of the walk, the next edge last; optional edges at the end
  Index* reached = nullptr;          ///< edges with trail::reached
  Index* next_rerequested = nullptr; ///< such an edge: the next one of its component; nil
  Bits* group_marks = nullptr;       ///< group: bits of `mark`
  Bits* group_trail = nullptr;       ///< group: likewise
  Index* trial = nullptr;            ///< group: edge that would claim it in the current combination
  PlanEntry* entry = nullptr;        ///< plans of the current members; at most one entry for each group
  Index* reach = nullptr;            ///< groups: work list of a search, or of the act
  Index* denied = nullptr;           ///< groups in the order in which they were denied because of their holder
  Index* touched = nullptr;          ///< groups that got a reason to run since the last act
  Index* next_order = nullptr;       ///< as `order`
  Index* extent = nullptr;           ///< claimed group: the number of groups that it and all below it are
  Index* differing = nullptr;        ///< groups whose assignment differs
  Index* next_flipped = nullptr;     ///< group with trail::flipped: the next one of its component; nil
  TableIndex* opened = nullptr;      ///< as `order`: groups that this pass has opened
  Index* news = nullptr;             ///< as `order`: groups that the next pass has to examine
  Index* pushed = nullptr;           ///< as `order`: groups with a push, in the last assignment or in this one
  Index* next_count = nullptr;       ///< as `order_count`
  Index* first_moved = nullptr;      ///< component: the first place at which that order differs
  Index* rerequested = nullptr;      ///< component: the first edge with trail::changed; nil
  Index* flipped = nullptr;          ///< component: the first group with trail::flipped; nil
  Index* news_count = nullptr;       ///< component: rows of `news` in use; nil: the last pass is unknown
  Index* on_last = nullptr;          ///< component: how many edges have trail::on_last
  Index* pushed_count = nullptr;     ///< component: rows of `pushed` in use
  Index* unit = nullptr;             ///< most_edges + 1: edges that are tried together
  TriedMember* member = nullptr;     ///< the current members
  Staged* staged_request = nullptr;  ///< edge of the running group, by its place among them
  UnmetCondition* unmet = nullptr;   ///< false conditions of the current combination
  Push* own = nullptr;               ///< row of State::pushed of the component: pushes of the current unit
  Push* first = nullptr;             ///< likewise: new pushes of the current unit
  Bits* condition_marks = nullptr;   ///< condition: bits of `mark`
  Index* lacked = nullptr;           ///< conditions that the searched chain may have to make true
  std::uint64_t* cost = nullptr;     ///< condition: length of the shortest chain of pushes that makes it true
  Index* cost_at = nullptr;          ///< condition: first provider of that chain
  Index* cost_plan = nullptr;        ///< condition: number of its plan
  Index* cost_next = nullptr;        ///< condition: the first condition that the chain lacks; nil: none
  Index* causers = nullptr;          ///< providers that cause one of these conditions, and can be pushed
  Bits* provider_marks = nullptr;    ///< provider: bits of `mark`
  Requested* before = nullptr;       ///< requests before this micro-step changed them; target: the edge
  std::byte* end = nullptr;          ///< end of the block

  /// Calls visit(pointer to member, count) for every array in order; `scratch()` behind the decision state.
  template <class Self, class Visit, class Scratch>
  static constexpr void each(Self& s, const Shape& n, Visit&& visit, Scratch&& scratch) {
    const auto rows = [&](std::size_t count, auto&... pointers) { (visit(pointers, count), ...); };
    rows(1, s.counters), rows(n.edges, s.request);
    rows(n.timers(), s.due, s.soonest);
    rows(n.states, s.values, s.staged);
    rows(n.groups, s.last.group), rows(n.plan_slots, s.last.plan);
    rows(n.groups, s.order), rows(n.components, s.order_count), rows(n.groups, s.place);
    rows(n.components, s.first_root), rows(n.edges, s.next_root);
    rows(n.groups, s.run_queue, s.data_from), rows(n.promises == 0 ? 0 : n.groups, s.promised);
    rows(n.components, s.work, s.component), rows(n.providers, s.enabled), rows(n.conditions, s.truth);
    rows(n.listen_slots, s.fired);
    scratch();
    rows(n.groups, s.now.group), rows(n.plan_slots, s.now.plan);
    rows(n.edges, s.edge_marks, s.edge_trail, s.queued, s.last_queued, s.anew, s.renewed, s.candidate, s.reached,
         s.next_rerequested);
    rows(n.groups, s.group_marks, s.group_trail, s.trial, s.entry, s.reach, s.denied, s.touched, s.next_order, s.extent,
         s.differing, s.next_flipped, s.opened, s.news, s.pushed);
    rows(n.components, s.next_count, s.first_moved, s.rerequested, s.flipped, s.news_count, s.on_last, s.pushed_count);
    rows(n.most_edges + 1, s.unit, s.member, s.staged_request), rows(n.lacking, s.unmet);
    rows(n.pushable, s.own, s.first);
    rows(n.conditions, s.condition_marks, s.lacked, s.cost, s.cost_at, s.cost_plan, s.cost_next);
    rows(n.providers, s.causers, s.provider_marks), rows(n.altered, s.before);
  }

  static constexpr std::size_t arrays = 68;

  /// The best alignment of the block, a cache line; it must be aligned to 8. Small machines have no cache.
  static constexpr std::size_t alignment = sizeof(Index) < 4 ? 8 : 64;

  /// The offset of each array, and of the end of the block.
  struct Layout {
    std::array<std::uint32_t, arrays + 1> begin{};
    std::size_t decision = 0; ///< bytes of the decision state
    constexpr std::size_t bytes() const { return begin[arrays]; }
  };
  static constexpr Layout layout(const Shape& shape);
  static constexpr std::size_t decision_bytes(const Shape& shape) { return layout(shape).decision; }
  static constexpr std::size_t bytes(const Shape& shape) { return layout(shape).bytes(); }

  /// The arrays of a block with these offsets, of Layout::begin. Nothing is written.
  template <class Offset>
  static State in(std::byte* memory, const std::array<Offset, arrays + 1>& begin);

private:
  static constexpr std::size_t aligned(std::size_t at, std::size_t to) { return (at + to - 1) / to * to; }
};

constexpr State::Layout State::layout(const Shape& shape) {
  Layout out;
  State none;
  std::size_t at = 0, row = 0;
  each(
      none, shape,
      [&]<class T>(T*&, std::size_t count) {
        constexpr std::size_t even = sizeof(T) & (~sizeof(T) + 1); // the largest power of 2 that divides the size
        at = aligned(at, even < alignment ? even : alignment);
        out.begin[row++] = static_cast<std::uint32_t>(at);
        at += count * sizeof(T);
      },
      [&] { out.decision = at = aligned(at, 8); });
  out.begin[row] = static_cast<std::uint32_t>(aligned(at, 8));
  return out;
}

/// A State consists of pointers only, in the order of the layout.
template <class Offset>
State State::in(std::byte* memory, const std::array<Offset, arrays + 1>& begin) {
  std::array<std::byte*, arrays + 1> out;
  static_assert(sizeof(State) == sizeof(out));
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = memory + begin[i];
  return std::bit_cast<State>(out);
}

} // namespace director
