// Header: runtime/core/saved/saved_rows.hpp. Test: tests/runtime/core/saved/saved_state_test.cpp.
// SPDX-License-Identifier: MIT
//
// Checks everything that the engine relies on in its own memory: it uses rows by these numbers, and follows holders,
// plans and the queue, without a check of its own. Cost: the rows, and for each group the chain of its holders and its
// plan.

#include "runtime/core/engine/engine.hpp"
#include "runtime/core/saved/saved_rows.hpp"

namespace director::saved {

namespace {

constexpr bool is_in(Index row, Range rows) { return rows.begin <= row && row < rows.end; }

class Checker {
public:
  Checker(const Engine& engine, const std::byte* from)
      : t_(engine.tables()),
        s_(engine.memory()),
        from_(from),
        at_(Shape::of(t_)),
        head_(read<HeadRow>(from, 0)) {}

  bool all() const {
    if ((head_.begun | head_.unsettled | head_.serving) > 1 || head_.now > head_.until || head_.until > last_time)
      return false;
    bool good = true;
    Layout::each_kind(Shape::of(t_), [&]<class Row>(std::size_t Layout::*kind, std::size_t count) {
      for (std::size_t i = 0; i < count && good; ++i)
        good = fits(read<Row>(from_ + at_.*kind, i), static_cast<Index>(i));
    });
    for (Index g = 0; g < t_.groups.size() && good; ++g) good = ends_at_root(g) && plan_is_complete(g);
    return good && places<GroupRow>(at_.groups, t_.groups.size(), &GroupRow::queue_place) &&
           places<ComponentRow>(at_.components, t_.components.size(), &ComponentRow::work_place);
  }

private:
  GroupRow row_of(Index group) const { return read<GroupRow>(from_ + at_.groups, group); }
  EdgeRow request(Index edge) const { return read<EdgeRow>(from_ + at_.edges, edge); }

  /// The provider is nil, or one of the group.
  bool provider_of(Index group, Index provider) const {
    return provider == nil || is_in(provider, t_.groups[group].providers);
  }

  bool fits(const EdgeRow& row, Index e) const {
    return (row.level == nil || is_in(row.level, t_.edges[e].levels)) && row.stamp <= head_.micro_step &&
           row.why <= Why::deferred &&
           (row.condition == nil ? row.why != Why::waiting : row.condition < t_.conditions.size());
  }
  bool fits(const PlanRow& row, Index slot) const { return provider_of(t_.plan_groups[slot], row.provider); }
  bool fits(const StateRow& row, Index i) const {
    const auto sets = [](const Group& group) { return group.start || group.stop || !group.owned.empty(); };
    return (row.expiry == never || t_.states[i].expires != 0) && (row.by_handler == unset || any(t_.groups, sets));
  }
  bool fits(const PromiseRow&, Index) const { return true; }       // any time is possible
  bool fits(const auto& row, Index) const { return row.set <= 1; } // EnabledRow, FiredRow
  bool fits(const ComponentRow& row, Index) const {
    return (row.bits & ~component_bits) == 0 && (row.work_place != nil) == ((row.bits & work::listed) != 0);
  }

  bool holder(Index g, Index by) const {
    return by == nil || by == t_.edges.size() + g || (by < t_.edges.size() && t_.edges[by].target == g);
  }

  bool push(Index g, const Push& push) const {
    if (push.edge == nil) return push == Push{};
    return push.edge < t_.edges.size() && push.condition < t_.conditions.size() && push.provider != nil &&
           provider_of(g, push.provider) && t_.groups[t_.edges[push.edge].target].component == t_.groups[g].component;
  }

  bool fits(const GroupRow& row, Index g) const {
    constexpr std::uint8_t flags = flag::granted | flag::needed | flag::in_force | flag::serving;
    constexpr std::uint8_t reasons = 31; // the reasons of runs
    const bool granted = (row.flags & flag::granted) != 0, pushed = (row.flags & (flag::in_force | flag::serving)) != 0;
    if ((row.flags & ~flags) != 0 || (row.pending & ~reasons) != 0 || row.done > 3 || row.done == result::failed ||
        row.stale_matters > 1)
      return false;
    if (!holder(g, row.holder) || !provider_of(g, row.active) || !provider_of(g, row.planned) || !push(g, row.push))
      return false;
    if (row.active != nil && row.holder == nil) return false;
    if (granted && (row.active == nil || row.holder >= t_.edges.size() || request(row.holder).level == nil))
      return false;
    if (row.queue_place != nil && (!granted || row.pending == 0)) return false;
    if (pushed && row.push.edge == nil) return false;
    if (row.wait != never && row.active == nil) return false;
    if (row.every != never && (row.active == nil || t_.providers[row.active].every == 0)) return false;
    if (row.data_from != nil && (row.data_from >= t_.edges.size() || t_.edges[row.data_from].target != g)) return false;
    return row.promised.provider == nil ||
           (!t_.promises.empty() && provider_of(g, row.promised.provider) && row.promised.edge < t_.edges.size());
  }

  /// Whether the chain of the group ends: at root, in limbo, or at a group that is not held.
  bool ends_at_root(Index g) const {
    for (Index steps = 0; steps <= t_.groups.size(); ++steps) {
      const Index by = row_of(g).holder;
      if (by >= t_.edges.size() || t_.edges[by].requester == nil) return true; // also where it is nil
      g = t_.edges[by].requester;
    }
    return false;
  }

  /// Whether the plan of the group is complete; it cannot have more entries than there are groups.
  bool plan_is_complete(Index g) const {
    Index provider = row_of(g).planned, end = 0;
    if (provider == nil) return true;
    for (Index next = 0;; provider = s_.reach[next++]) {
      for (const Index need : t_.list(t_.providers[provider].needs)) {
        if (end == t_.groups.size()) return false;
        s_.reach[end] = picked_in_plan(g, t_.edges[need].target);
        if (s_.reach[end++] == nil) return false;
      }
      if (next == end) return true;
    }
  }

  Index picked_in_plan(Index owner, Index group) const {
    for (const Index slot : t_.groups[owner].slots.rows()) {
      if (t_.plan_groups[slot] == group) return read<PlanRow>(from_ + at_.plan, slot).provider;
    }
    return t_.groups[group].providers.begin;
  }

  /// Whether the rows that have a place have the places from 0 on, each once.
  template <class Row>
  bool places(std::size_t begin, std::size_t count, Index Row::*place) const {
    std::size_t placed = 0, end = 0;
    for (std::size_t i = 0; i < count; ++i) s_.reach[i] = nil;
    for (std::size_t i = 0; i < count; ++i) {
      const Index at = read<Row>(from_ + begin, i).*place;
      if (at == nil) continue;
      if (at >= count || s_.reach[at] != nil) return false;
      s_.reach[at] = 0;
      ++placed;
      end = at < end ? end : at + std::size_t{1};
    }
    return placed == end;
  }

  const Tables& t_;
  const State& s_;
  const std::byte* from_;
  const Layout at_;
  const HeadRow head_;
};

} // namespace

bool is_possible(const Engine& engine, const std::byte* from) { return Checker(engine, from).all(); }

} // namespace director::saved
