// Header: compiler/analysis/decisions/pass.hpp. Test: tests/property/decisions_test.cpp.
// SPDX-License-Identifier: MIT
// semantics.md, 4.1 and 4.2: which of two edges goes first, what is available for one, and so the order in which the
// candidates are taken.
#include "compiler/analysis/decisions/pass.hpp"

#include <algorithm>

namespace director::analysis {

// 4.1: order between two edges.

bool Pass::Chain::below(Row ancestor) const {
  const auto* const self = edges.begin() + (size - 1);
  return std::find(edges.begin(), self, ancestor) != self;
}

const Level& Pass::level(Row edge) const {
  static const Level none{};
  if (is_limbo(edge)) return none;
  const Component::EdgeRow& row = part_.edges[edge];
  return last_.level[edge] == nothing ? row.as_need : row.levels[last_.level[edge]];
}

Pass::Chain Pass::below(const Chain& holder, Row edge) {
  Chain out = holder;
  if (out.size < out.edges.size()) out.edges[out.size++] = edge;
  return out;
}

Pass::Chain Pass::chain_of(const ChainBy& holders, Row edge) const {
  const Row from = requester(edge);
  if (from != nothing) return below(holders[from], edge);
  Chain out = below({}, edge);
  out.complete = !is_limbo(edge);
  return out;
}

Pass::Chain Pass::last_holder(Row group) const {
  const Row edge = last_.by[group];
  if (edge == nothing) return {};
  const Row from = requester(edge);
  return from == nothing ? chain_of(last_holders_, edge) : below(last_holder(from), edge);
}

/// Rules 1 to 4: below 0 if a goes first, 0 if equal.
int Pass::compare(const Chain& a, const Chain& b) const {
  ++gathered_.steps;
  std::size_t i = 0;
  while (i < a.size && i < b.size && a.edges[i] == b.edges[i]) ++i;
  if (i == a.size || i == b.size) return a.size < b.size ? -1 : a.size > b.size ? 1 : 0;
  const Row at_a = a.edges[i], at_b = b.edges[i];
  if (is_limbo(at_a) != is_limbo(at_b)) return is_limbo(at_a) ? 1 : -1;
  const auto is_optional = [&](const Chain& chain) {
    return std::any_of(chain.edges.begin() + i, chain.edges.begin() + chain.size,
                       [&](Row edge) { return level(edge).optional; });
  };
  const bool optional_a = is_optional(a), optional_b = is_optional(b);
  if (optional_a != optional_b) return optional_a ? 1 : -1;
  const std::int32_t of_a = level(at_a).priority, of_b = level(at_b).priority;
  return of_a > of_b ? -1 : of_a < of_b ? 1 : 0;
}

// 4.2: what is available.

bool Pass::available(Row group, const Chain& to) {
  if (now_.by[group] != nothing) return now_.by[group] == to.edge();
  const Row holder = last_.by[group];
  if (holder == nothing || holder == to.edge() || is_limbo(holder) || !alive(holder)) return true;
  if ((refused_ & bit(holder)) != 0 || (forgotten_ & bit(holder)) != 0) return true;
  if (compare(last_holders_[group], to) != 0) return true;
  if (std::find(denied_.begin(), denied_.end(), group) == denied_.end()) denied_.push_back(group);
  return false;
}

bool Pass::alive(Row edge) const {
  for (std::size_t steps = 0; steps <= part_.groups.size(); ++steps) {
    if (is_limbo(edge)) return false;
    const Row group = part_.edges[edge].target;
    const bool is_needed = last_.by[group] == edge && last_.has(group, Moment::needed);
    if (last_.level[edge] == nothing && !is_needed) return false;
    const Row from = requester(edge);
    if (from == nothing) return true;
    edge = last_.by[from];
    if (edge == nothing) return false;
  }
  return false;
}

// 4.4: the order in which candidates are taken.

bool Pass::alone(Row edge) const { return requester(edge) == nothing || !level(edge).shares_unit(); }

bool Pass::shares_unit(Row edge, Row other) const {
  return edge == other || (!alone(edge) && !alone(other) && requester(edge) == requester(other));
}

/// Picks one of the candidates that no other goes before: the order of their requests is unknown. It is irrelevant for
/// one that has no possible claims in common with any candidate that may be taken before it.
Row Pass::first_candidate() {
  Few<Chain, Component::most_edges> all;
  for (const Row edge : each(candidates_)) all.push_back(claimed(edge));
  Edges first;
  for (const Chain& chain : all) {
    const Row edge = chain.edge();
    const bool is_first = std::none_of(
        all.begin(), all.end(), [&](const Chain& other) { return other.edge() != edge && before(other, chain); });
    if (!is_first) continue;
    const bool is_known = std::any_of(first.begin(), first.end(), [&](Row other) { return shares_unit(edge, other); });
    if (!is_known) first.push_back(edge);
  }
  if (first.empty()) return all.front().edge(); // "equal" is not transitive; this cannot happen
  const auto below = [&](Row edge) {            // with its unit
    Rows out = 0;
    for (const Row other : each(candidates_)) {
      if (shares_unit(edge, other)) out |= part_.groups[part_.edges[other].target].below;
    }
    return out;
  };
  for (const Row edge : first) {
    const bool apart = std::all_of(all.begin(), all.end(), [&](const Chain& other) {
      return shares_unit(edge, other.edge()) || (below(edge) & below(other.edge())) == 0 ||
             before(claimed(edge), other);
    });
    if (apart) return edge;
  }
  return first[picks_.pick(first.size())];
}

Pass::Unit Pass::unit_of(Row first) {
  if (alone(first)) return {first};
  Unit unit, open;
  for (const Row edge : each(candidates_)) {
    if (!alone(edge) && requester(edge) == requester(first)) open.push_back(edge);
  }
  // Siblings: by priority, and equals in any order.
  while (!open.empty()) {
    Groups best; // of those that are open
    for (Row i = 0; i < open.size(); ++i) {
      if (!best.empty() && level(open[i]).priority < level(open[best.front()]).priority) continue;
      if (!best.empty() && level(open[i]).priority > level(open[best.front()]).priority) best.clear();
      best.push_back(i);
    }
    const auto below = [&](Row i) { return part_.groups[part_.edges[open[i]].target].below; };
    std::size_t at = best.size();
    for (std::size_t i = 0; i < best.size() && at == best.size(); ++i) {
      if (std::all_of(best.begin(), best.end(),
                      [&](Row other) { return other == best[i] || (below(other) & below(best[i])) == 0; }))
        at = i;
    }
    if (at == best.size()) at = picks_.pick(best.size());
    unit.push_back(open[best[at]]);
    open.erase(open.begin() + best[at]);
  }
  return unit;
}

} // namespace director::analysis
