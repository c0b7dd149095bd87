// Header: compiler/analysis/decisions/pass.hpp. Test: tests/property/decisions_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/decisions/pass.hpp"

#include <algorithm>

namespace director::analysis {

Pass::Pass(const Component& part, const Moment& last, Rows anew, Picks& picks, Gathered& gathered)
    : part_(part),
      last_(last),
      anew_(anew),
      picks_(picks),
      gathered_(gathered),
      unsure_(part.providers.size(), -1) {}

std::optional<Moment> Pass::run() {
  for (;;) {
    begin();
    if (!take_candidates()) return std::nullopt;
    if (!denied_in_vain()) break;
  }
  stage_ = Stage::handing_over;
  if (!hand_over()) return std::nullopt;
  stage_ = Stage::finishing;
  if (is_known()) return std::nullopt;
  return finish();
}

/// Whether this way through the pass may end here.
bool Pass::is_known() {
  if (!picks_.has_picked()) return false;
  here_.clear();
  const auto add = [&](const auto& value) { here_.append(reinterpret_cast<const char*>(&value), sizeof value); };
  add(stage_);
  add(open_);
  for (const auto* rows : {&now_.by, &now_.active, &now_.plan, &now_.flags}) add(*rows);
  for (const Rows rows : {candidates_, tried_, refused_, forgotten_, keeping_}) add(rows);
  add(standing_);
  add(asked_);
  here_.append(unsure_.begin(), unsure_.end());
  here_.append(denied_.begin(), denied_.end());
  return picks_.is_known(here_);
}

void Pass::begin() {
  now_ = last_;
  now_.by.fill(nothing);
  now_.active.fill(nothing);
  now_.plan.fill(nothing);
  now_.flags.fill(0);
  candidates_ = tried_ = refused_ = keeping_ = 0;
  denied_.clear();
  standing_.fill(-2);
  asked_.fill(0);
  for (Row edge = 0; edge < part_.roots; ++edge) {
    if (last_.level[edge] != nothing) candidates_ |= bit(edge);
  }
}

// 4.1: order between two edges.

bool Pass::Chain::below(Row ancestor) const {
  return std::find(edges.begin() + 1, edges.begin() + static_cast<std::ptrdiff_t>(size), ancestor) !=
         edges.begin() + static_cast<std::ptrdiff_t>(size);
}

const Level& Pass::level(Row edge) const {
  static const Level none{};
  if (is_limbo(edge)) return none;
  const Component::EdgeRow& row = part_.edges[edge];
  return last_.level[edge] == nothing ? row.as_need : row.levels[last_.level[edge]];
}

Pass::Chain Pass::chain_of(const By& by, Row edge) const {
  Chain out;
  out.edges[out.size++] = edge;
  for (Row from = requester(edge); from != nothing; from = requester(edge)) {
    edge = by[from];
    if (edge == nothing) return out;
    out.edges[out.size++] = edge;
    if (out.size > part_.groups.size() + 1) return out;
  }
  out.complete = !is_limbo(edge);
  return out;
}

Pass::Chain Pass::below(const Chain& holder, Row edge) {
  Chain out;
  out.complete = holder.complete;
  out.edges[out.size++] = edge;
  for (std::size_t i = 0; i < holder.size && out.size < out.edges.size(); ++i) out.edges[out.size++] = holder.edges[i];
  return out;
}

/// Rules 1 to 4: below 0 if a goes first, 0 if equal.
int Pass::compare(const Chain& a, const Chain& b) const {
  ++gathered_.steps;
  std::size_t i = a.size, j = b.size;
  while (i > 0 && j > 0 && a.edges[i - 1] == b.edges[j - 1]) --i, --j;
  if (i == 0 || j == 0) return static_cast<int>(a.size) - static_cast<int>(b.size);
  const Row at_a = a.edges[i - 1], at_b = b.edges[j - 1];
  if (is_limbo(at_a) != is_limbo(at_b)) return is_limbo(at_a) ? 1 : -1;
  bool optional_a = false, optional_b = false;
  while (i > 0) optional_a |= level(a.edges[--i]).optional;
  while (j > 0) optional_b |= level(b.edges[--j]).optional;
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
  if (compare(before_now(holder), to) != 0) return true;
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

bool Pass::denied_in_vain() {
  for (const Row group : denied_) {
    if (now_.by[group] == last_.by[group]) continue;
    forgotten_ |= bit(last_.by[group]);
    return true;
  }
  return false;
}

// 4.4: the pass.

bool Pass::alone(Row edge) const { return requester(edge) == nothing || !level(edge).shares_unit(); }

bool Pass::stale(Row group) const {
  for (;;) {
    const Row holder = now_.by[group];
    if (holder == nothing) return false;
    if (is_limbo(holder)) return true;
    if (now_.has(group, Moment::granted))
      return last_.has(group, Moment::outdated) || (anew_ & bit(holder)) != 0 || last_.by[group] != holder ||
             last_.active[group] != now_.active[group];
    group = requester(holder);
    if (group == nothing) return false;
  }
}

bool Pass::may_ask(Row from) const { return from == nothing || now_.has(from, Moment::granted) || stale(from); }

bool Pass::granted_before(Row edge) const {
  const Row group = part_.edges[edge].target;
  return last_.by[group] == edge && last_.has(group, Moment::granted);
}

/// Of those that nobody goes before one is picked: in what order they were requested is not known. Where what they may
/// come to claim has nothing in common it does not matter.
Row Pass::first_candidate() {
  std::vector<std::pair<Row, Chain>> all;
  for (Row edge = 0; edge < part_.edges.size(); ++edge) {
    if ((candidates_ & bit(edge)) != 0) all.emplace_back(edge, claimed(edge));
  }
  std::vector<Row> first;
  for (const auto& [edge, chain] : all) {
    const bool is_first = std::none_of(all.begin(), all.end(), [&, e = edge, c = &chain](const auto& other) {
      return other.first != e && before(other.second, *c);
    });
    if (!is_first) continue;
    const bool same_unit = !alone(edge) && std::any_of(first.begin(), first.end(), [&, e = edge](Row other) {
      return !alone(other) && requester(other) == requester(e);
    });
    if (!same_unit) first.push_back(edge);
  }
  if (first.empty()) return all.front().first; // "equal" is not transitive; it cannot be
  const auto below = [&](Row edge) {           // with its unit
    Rows out = 0;
    for (const auto& [other, chain] : all) {
      if (other == edge || (!alone(edge) && !alone(other) && requester(edge) == requester(other)))
        out |= part_.groups[part_.edges[other].target].below;
    }
    return out;
  };
  for (const Row edge : first) {
    const bool apart = std::all_of(first.begin(), first.end(),
                                   [&](Row other) { return other == edge || (below(edge) & below(other)) == 0; });
    if (apart) return edge;
  }
  return first[picks_.pick(first.size())];
}

std::vector<Row> Pass::unit_of(Row first) {
  if (alone(first)) return {first};
  std::vector<Row> unit, open;
  for (Row edge = 0; edge < part_.edges.size(); ++edge) {
    if ((candidates_ & bit(edge)) != 0 && !alone(edge) && requester(edge) == requester(first)) open.push_back(edge);
  }
  // Siblings: by priority, and among equals in any order.
  while (!open.empty()) {
    std::vector<std::size_t> best;
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (!best.empty() && level(open[i]).priority < level(open[best.front()]).priority) continue;
      if (!best.empty() && level(open[i]).priority > level(open[best.front()]).priority) best.clear();
      best.push_back(i);
    }
    const auto below = [&](std::size_t i) { return part_.groups[part_.edges[open[i]].target].below; };
    std::size_t at = best.size();
    for (std::size_t i = 0; i < best.size() && at == best.size(); ++i) {
      if (std::all_of(best.begin(), best.end(),
                      [&](std::size_t other) { return other == best[i] || (below(other) & below(best[i])) == 0; }))
        at = i;
    }
    if (at == best.size()) at = picks_.pick(best.size());
    unit.push_back(open[best[at]]);
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(best[at]));
  }
  return unit;
}

/// False: it may end here.
bool Pass::take_candidates() {
  for (;;) {
    for (Row edge = 0; edge < part_.edges.size(); ++edge) {
      if ((candidates_ & bit(edge)) != 0 && !may_ask(requester(edge))) candidates_ &= ~bit(edge);
    }
    if (candidates_ == 0) return true;
    if (is_known()) return false;
    const Row first = first_candidate();
    const std::vector<Row> unit = unit_of(first);
    for (const Row member : unit) candidates_ &= ~bit(member), tried_ |= bit(member);
    const Row from = requester(first);
    if (from != nothing && stale(from)) {
      for (const Row member : unit) take_below_stale(member);
    } else {
      take(unit);
    }
  }
}

void Pass::take_below_stale(Row member) {
  if (!granted_before(member)) {
    refused_ |= bit(member);
    keeping_ |= bit(member);
    return;
  }
  if (grant_alone(member)) return;
  refused_ |= bit(member);
  if (first_combination({member}, false)) keeping_ |= bit(member);
}

void Pass::take(const std::vector<Row>& unit) {
  const std::optional<Combination> combination = first_combination(unit, true);
  if (!combination) {
    refuse(unit);
  } else if (!deferred(*combination)) {
    grant(*combination);
  } else {
    for (const Row member : unit) {
      if (granted_before(member) && grant_alone(member)) continue;
      refused_ |= bit(member);
      keeping_ |= bit(member);
    }
  }
}

bool Pass::grant_alone(Row member) {
  const std::optional<Combination> found = first_combination({member}, true);
  if (found) grant(*found);
  return found.has_value();
}

void Pass::grant(const Combination& combination) {
  for (const Choice& choice : combination) {
    for (const Row provider : part_.groups[choice.group].providers) {
      if (provider > choice.provider) gathered_.passed_over[provider].first |= bit(choice.provider);
    }
    claim(choice.chain.edge(), choice.group, choice.provider, choice.plan, true);
    keeping_ |= bit(choice.chain.edge());
  }
}

void Pass::claim(Row edge, Row group, Row provider, Row plan, bool granted) {
  now_.by[group] = edge;
  now_.flags[group] = static_cast<Row>((now_.flags[group] & Moment::needed) | (granted ? Moment::granted : 0));
  now_.active[group] = provider;
  now_.plan[group] = plan;
  follow(group);
  const Component::Plan& entries = part_.providers[provider].plans[plan];
  for (const Component::Planned& entry : entries) {
    if (now_.by[entry.group] == nothing) now_.by[entry.group] = entry.edge;
    now_.flags[entry.group] |= Moment::needed;
  }
  for (const Component::Planned& entry : entries) {
    if (last_.active[entry.group] != nothing && stale(entry.group)) follow(entry.group);
  }
}

void Pass::follow(Row group) {
  for (const Row edge : part_.groups[group].edges) {
    if (last_.level[edge] != nothing && (tried_ & bit(edge)) == 0) candidates_ |= bit(edge);
  }
}

bool Pass::deferred(const Combination& combination) const {
  for (const Choice& choice : combination) {
    if (granted_before(choice.chain.edge())) continue;
    for (Row other = 0; other < part_.groups.size(); ++other) {
      if (!now_.has(other, Moment::granted) || (part_.groups[other].may_ask_for & choice.claims) == 0 || !stale(other))
        continue;
      const Chain holder = claimed(now_.by[other]);
      if (before(holder, choice.chain) && !choice.chain.below(holder.edge())) return true;
    }
  }
  return false;
}

bool Pass::hand_over() {
  open_ = 0;
  for (Row group = 0; group < part_.groups.size(); ++group) {
    if (last_.active[group] != nothing) open_ |= bit(group);
  }
  while (open_ != 0) {
    // In the old order, of which among equals nothing is known.
    std::vector<Row> first;
    for (Row group = 0; group < part_.groups.size(); ++group) {
      if ((open_ & bit(group)) == 0) continue;
      const Chain chain = before_now(last_.by[group]);
      bool is_first = true;
      for (Row other = 0; other < part_.groups.size() && is_first; ++other)
        is_first = other == group || (open_ & bit(other)) == 0 || !before(before_now(last_.by[other]), chain);
      if (is_first) first.push_back(group);
    }
    if (first.empty()) return true;
    if (is_known()) return false;
    Row group = first.front();
    if (first.size() > 1 && std::any_of(first.begin(), first.end(), [&](Row one) {
          return now_.by[one] == nothing && std::any_of(first.begin(), first.end(), [&](Row other) {
                   return other != one && now_.by[other] == nothing &&
                          (part_.groups[one].below & part_.groups[other].below) != 0;
                 });
        }))
      group = first[picks_.pick(first.size())];
    open_ &= ~bit(group);
    if (now_.by[group] != nothing) continue;
    bool heir = false;
    for (Row other = 0; other < part_.groups.size() && !heir; ++other)
      heir = now_.has(other, Moment::granted) && (part_.groups[other].may_ask_for & bit(group)) != 0 && stale(other);
    if (!heir) continue;
    const std::vector<Component::Plan>& plans = part_.providers[last_.active[group]].plans;
    const Row plan = last_.plan[group] != nothing ? last_.plan[group] : static_cast<Row>(picks_.pick(plans.size()));
    const bool is_free = std::all_of(plans[plan].begin(), plans[plan].end(),
                                     [&](const Component::Planned& entry) { return now_.by[entry.group] == nothing; });
    if (!is_free) continue;
    claim(static_cast<Row>(Moment::limbo + group), group, last_.active[group], plan, false);
    if (!take_candidates()) return false;
  }
  return true;
}

Moment Pass::finish() {
  for (Row group = 0; group < part_.groups.size(); ++group) {
    if (now_.by[group] == nothing) continue;
    if (now_.active[group] == nothing && last_.active[group] != nothing && stale(group))
      now_.active[group] = last_.active[group];
  }
  for (Row group = 0; group < part_.groups.size(); ++group) {
    const bool is_granted = now_.has(group, Moment::granted);
    const Row active = now_.active[group], holder = now_.by[group];
    const bool was_in_force = last_.has(group, Moment::in_force);
    bool news = false;
    if (active != nothing && holder != nothing && (is_granted || was_in_force)) {
      const PossiblePush* push = standing(group);
      if (push != nullptr && push->to == active && applies(push->by, claimed(holder))) {
        now_.flags[group] |= Moment::in_force;
        if (!holds(push->unmet)) news = !was_in_force || picks_.any();
      }
    }
    if (is_granted) {
      news = news || last_.active[group] != active || last_.by[group] != holder || !last_.has(group, Moment::granted) ||
             (anew_ & bit(holder)) != 0;
    } else {
      news = false;
    }
    if (news || (last_.has(group, Moment::outdated) && active != nothing)) now_.flags[group] |= Moment::outdated;
  }
  return now_;
}

} // namespace director::analysis
