// Door: runtime/core/engine.hpp. Test: tests/runtime/core/recall_test.cpp.
// SPDX-License-Identifier: MIT
//
// What a component decides: recalled from what it decided before, or found by a pass. Of the situation everything
// counts that a pass reads and that is not a part of how things stand: levels, what is asked for anew, reasons that
// outdate orders, conditions, and which of two siblings of one urgency was asked for first. All but the last is kept as
// bytes by whoever changes it (notes.hpp). When a provider is enabled or disabled, everything is forgotten, as that is
// rare.

#include "runtime/core/decision.hpp"
#include "runtime/core/notes.hpp"
#include "runtime/core/retrace.hpp"

namespace director {

/// True if what is decided is another decision.
bool Engine::settle(Index component, bool& any_stops) {
  const Recall::Part known = recall_.part(component);
  if (!known) return settle_by_pass(component, any_stops);
  Recall::Head& head = known.head();
  if (head.rest != 0) {
    --head.rest;
    return settle_by_pass(component, any_stops);
  }
  const bool all_told = told(component, known);
  const Recall::Move* const move = all_told ? known.find() : nullptr;
  if (move != nullptr) {
    note_recalled(known, *move);
    recall_decision((move->bits & moved::on_last) != 0, (move->bits & moved::on_stale) != 0);
    read(component, known.row(move->to));
    return changed(component, any_stops);
  }
  const bool other = settle_by_pass(component, any_stops);
  if (all_told) {
    learn(component, known);
  } else {
    known.current() = Recall::unknown;
  }
  return other;
}

bool Engine::settle_by_pass(Index component, bool& any_stops) {
  ++passes_;
  decide(component);
  return changed(component, any_stops);
}

/// Of siblings of one urgency; where they were asked for in another order than they are declared, the situation's bytes
/// do not tell it.
Recall::Ties Engine::find_order(Index component) const {
  Index requester = nil;
  std::uint64_t before = 0;
  for (const Index e : t_.list(t_.components[component].edges)) {
    const Requested& request = s_.request[e];
    if (request.ties == 0 || request.level == nil) continue;
    const Index from = t_.edges[e].requester;
    if (from != requester) before = 0;
    requester = from;
    if (request.stamp < before) return Recall::Ties::out_of_order;
    before = request.stamp;
  }
  return Recall::Ties::in_order;
}

/// Others were touched than those that the situation tells: they have their places among these.
void Engine::give_and_join(Index component, const Recall::Effect* row, const Recall::Move& move) {
  Counters& c = *s_.counters;
  bring_order(component);
  Index count = 0;
  row = each_row(row, move.gives, [&](const Recall::Effect& it) {
    note_outdated(it, note_effect(it));
    s_.sorted[count++] = static_cast<Index>(it.where);
  });
  each_row(row, move.passed, [&](const Recall::Effect& it) { untouch(static_cast<Index>(it.where)); });
  for (Index i = 0; i < c.touched_count; ++i) {
    const Index group = s_.touched[i];
    if ((s_.turn[group].places & place::touched) == 0) continue;
    untouch(group);
    if (!granted(group)) continue;
    bring_order(s_.turn[group].component);
    note_given(group, s_.last[group].holder, 0);
    s_.sorted[count++] = group;
  }
  c.touched_count = 0;
  sort_by_place({s_.sorted, count}, Along::last);
  for (Index i = 0; i < count; ++i) enqueue(s_.sorted[i]);
}

/// Start handlers are called, and periods end or begin, before the groups stand where they will.
void Engine::begin_groups(Index component, const Recall::Part& known, const Recall::Move& move) {
  const Decision decision(known.row(move.to), t_.components[component]);
  const std::span<const Index> groups = t_.list(t_.components[component].groups);
  const Recall::Effect* const gives = known.effects(move) + move.stops + move.words + move.leaves;
  each_row(gives, move.gives, [&](const Recall::Effect& it) {
    const auto group = static_cast<Index>(it.where);
    if ((it.value & Recall::Effect::begins) != 0) begin(group, decision.standing(place_of(group, groups)));
  });
}

/// What an observer is told of a decision before it is acted on.
void Engine::foretell(Index component, const Index* rows) {
  if (!observed()) return;
  const Component& row = t_.components[component];
  const Decision decision(rows, row);
  remember_queued(component);
  read_standings(row, decision);
  report_decisions(component);
}

/// Where all stand, and why edges are queued.
void Engine::read_standings(const Component& row, const Decision& decision) {
  std::size_t place = 0;
  for (const Index g : t_.list(row.groups)) s_.now[g] = decision.standing(place++);
  place = 0;
  for (const Index e : t_.list(row.edges)) s_.queued[e] = decision.queued(place++);
}

/// After a pass over a situation that the question tells, and that no move is known in.
void Engine::learn(Index component, const Recall::Part& known) {
  if (known.full()) {
    known.make_room();
    if (known.head().rest != 0 && !planted(Fault::a_rest_is_overlooked)) return; // what stands by then is not known
  }
  const std::uint8_t from = known.current();
  write(component, known.spare());
  const std::uint8_t to = known.number_spare();
  if (from != Recall::unknown) {
    Recall::Move& move = known.add(to);
    if (depends_on_last()) move.bits |= moved::on_last;
    if (depends_on_stale()) move.bits |= moved::on_stale;
  }
  known.current() = to;
}

/// A decision, as rows.
void Engine::write(Index component, Index* to) const {
  const Component& row = t_.components[component];
  Recall::Word counting = 0;
  std::size_t at = 0;
  for (const Index g : t_.list(row.groups)) {
    const Standing& now = s_.now[g];
    for (const Index part :
         {now.holder, now.active, now.planned, now.flags, now.push.edge, now.push.provider, now.push.condition})
      *to++ = part;
    counting |= Recall::Word{s_.turn[g].counts != 0} << at++;
  }
  for (std::size_t i = 0; i < count_rows; ++i) *to++ = static_cast<Index>(counting >> 16 * i & 0xffff);
  for (const Index e : t_.list(row.edges)) {
    *to++ = static_cast<Index>(s_.queued[e].why);
    *to++ = s_.queued[e].condition;
  }
  const Index count = s_.next_count[component];
  *to++ = count;
  for (Index i = 0; i < row.groups.size(); ++i) *to++ = i < count ? s_.next_order[row.order + i] : nil;
  for (const Index g : t_.list(row.groups)) {
    const Range slots = t_.groups[g].slots;
    for (Index slot = slots.begin; slot != slots.end; ++slot) *to++ = s_.now.plan[slot];
  }
}

/// What was written down, as a pass would leave it. What a pass writes besides is used by nobody.
void Engine::read(Index component, const Index* rows) {
  const Component& row = t_.components[component];
  const Decision decision(rows, row);
  read_standings(row, decision);
  std::size_t place = 0;
  for (const Index g : t_.list(row.groups)) s_.turn[g].counts = decision.counts(place++) ? 1 : 0;
  read_order(component, decision);
  const Index* plan = decision.plans();
  for (const Index g : t_.list(row.groups)) {
    const Range slots = t_.groups[g].slots;
    for (Index slot = slots.begin; slot != slots.end; ++slot) s_.now.plan[slot] = *plan++;
  }
}

void Engine::read_order(Index component, const Decision& decision) {
  if (planted(Fault::the_order_stays)) return;
  const std::span<const Index> order = decision.order();
  s_.next_count[component] = static_cast<Index>(order.size());
  for (Index i = 0; i < order.size(); ++i) {
    s_.next_order[t_.components[component].order + i] = order[i];
    s_.place[order[i]] = i;
  }
}

void Engine::bring_order_that_stands(Index component) {
  s_.component[component] &= static_cast<std::uint8_t>(~work::order_behind);
  const Recall::Part known = recall_.part(component);
  read_order(component, Decision(known.row(known.current()), t_.components[component]));
  adopt_order(component);
}

void Engine::forget_decisions(Index component) {
  bring_order(component);
  const Recall::Part known = recall_.part(component);
  if (known && !planted(Fault::enabling_is_overlooked)) known.forget();
}

/// Of what the component is made of: where the situation has its bytes.
void Engine::note_places(Index component) {
  const Recall::Part known = recall_.part(component);
  if (!known) return;
  Index place = recall_.edges_at(component);
  for (const Index e : t_.list(t_.components[component].edges)) s_.request[e].situation = place++;
  for (const Index g : t_.list(t_.components[component].groups)) s_.turn[g].situation = place++;
  note_ties(component, known);
}

/// Edges of one requester stand together in the tables, and those of root come first.
void Engine::note_ties(Index component, const Recall::Part& known) {
  const std::span<const Index> edges = t_.list(t_.components[component].edges);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& one = t_.edges[edges[i]];
    for (std::size_t j = i + 1; j < edges.size() && t_.edges[edges[j]].requester == one.requester; ++j) {
      if (!Recall::can_tie(t_, one, t_.edges[edges[j]])) continue;
      s_.request[edges[i]].ties = s_.request[edges[j]].ties = 1;
      known.head().ties = Recall::Ties::unknown;
    }
  }
}

void Engine::note_condition(Index condition) {
  if (!recall_.on() || planted(Fault::conditions_are_overlooked)) return;
  const std::uint8_t bit = holds(condition) ? 1 : 0;
  const std::uint32_t place = recall_.condition(condition);
  if (place != Recall::several) {
    recall_.byte(place) = bit;
    return;
  }
  for (const Index component : t_.list(t_.conditions[condition].components)) {
    const Recall::Part known = recall_.part(component);
    if (!known) continue;
    const Component& row = t_.components[component];
    std::uint8_t* at = known.bytes() + row.edges.size() + row.groups.size();
    for (const Index each : t_.list(row.conditions)) {
      if (each == condition) *at = bit;
      ++at;
    }
  }
}

} // namespace director
