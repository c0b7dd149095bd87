// Door: runtime/core/engine.hpp. Test: tests/runtime/core/recall_test.cpp.
//
// What a component decides: recalled from what it decided before, or found by a pass. Of the situation everything
// counts that a pass reads and that is not a part of how things stand: levels, what is asked for anew, reasons that
// outdate orders, conditions, and which of two siblings of one urgency was asked for first. When a provider is enabled
// or disabled, everything is forgotten, as that is rare.

#include "runtime/core/notes.hpp"

#include <bit>

namespace director {

namespace {
// A decision is written down as the groups' standings, a bit for each whose outdated orders counted, why each edge is
// queued, the order, and the plans.
constexpr std::size_t standing_rows = 7;
constexpr std::size_t count_rows = 4; ///< of 16 bits
constexpr std::size_t why_rows = 2;

Standing standing(const Index* decision, std::size_t place = 0) {
  const Index* const row = decision + standing_rows * place;
  return {row[0], row[1], row[2], row[3], {row[4], row[5], row[6]}};
}

/// Calls visit(place) for each bit.
template <class Visit>
DIRECTOR_INLINE void each_bit(Recall::Word bits, Visit&& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}
} // namespace

/// Completes the situation. False: its bytes do not tell all of it.
DIRECTOR_INLINE bool Engine::ask(Index component, const Recall::Part& known) {
  const Component& row = t_.components[component];
  std::uint8_t* at = known.bytes() + row.edges.size();
  const Bits* const pending = s_.pending;
  for (const Index g : t_.list(row.groups))
    *at++ = planted(Fault::reasons_are_overlooked) ? std::uint8_t{0} : pending[g] & reason::outdating;
  return !known.head().ties || in_order(component, known);
}

DIRECTOR_INLINE void Engine::note_recalled(const Recall::Part& known, const Recall::Move& move) {
  ++recalled_;
  Recall::Head& head = known.head();
  if (head.used != 0xff) ++head.used;
  head.current = move.to;
}

/// True if what is decided is another decision.
bool Engine::settle(Index component, bool& any_stops) {
  const Recall::Part known = recall_.part(component);
  if (!known) return settle_by_pass(component, any_stops);
  Recall::Head& head = known.head();
  if (head.rest != 0) {
    --head.rest;
    return settle_by_pass(component, any_stops);
  }
  const bool told = ask(component, known);
  Recall::Move* const move = told && head.current != Recall::unknown ? known.find() : nullptr;
  if (move != nullptr) {
    if (!move->compared) compare(component, known, *move);
    any_stops = any_stops || (move->bits & moved::stops) != 0;
    note_recalled(known, *move);
    recall_decision((move->bits & moved::on_last) != 0, (move->bits & moved::on_stale) != 0);
    return go(component, *move, known.row(move->to));
  }
  const bool other = settle_by_pass(component, any_stops);
  if (told) {
    learn(component, known);
  } else {
    head.current = Recall::unknown;
  }
  return other;
}

bool Engine::settle_by_pass(Index component, bool& any_stops) {
  ++passes_;
  decide(component);
  return changed(component, any_stops);
}

/// Siblings of one urgency were asked for in the order in which they are declared; else the situation's bytes do not
/// tell it.
bool Engine::in_order(Index component, const Recall::Part& known) const {
  const std::span<const Index> edges = t_.list(t_.components[component].edges);
  const std::uint8_t* const asked_for = known.bytes();
  const Recall::Word* ties = known.ties();
  Index requester = nil;
  std::uint64_t before = 0;
  for (std::size_t begin = 0; begin < edges.size(); begin += 64, ++ties) {
    for (Recall::Word bits = *ties; bits != 0; bits &= bits - 1) {
      const std::size_t place = begin + static_cast<std::size_t>(std::countr_zero(bits));
      if (asked_for[place] == 0) continue;
      const Index e = edges[place], from = t_.edges[e].requester;
      if (from != requester) before = 0;
      requester = from;
      if (s_.stamp[e] < before) return false;
      before = s_.stamp[e];
    }
  }
  return true;
}

/// What a move changes besides where groups stand: whose outdated orders count, and why edges are queued.
DIRECTOR_INLINE void Engine::note_move(Index component, const Recall::Move& move, const Index* at) {
  const Component& row = t_.components[component];
  const std::span<const Index> groups = t_.list(row.groups), edges = t_.list(row.edges);
  each_bit(move.difference.counts, [&](std::size_t place) {
    Bits& places = s_.turn[groups[place]].places;
    places = places ^ place::counts;
  });
  at += standing_rows * groups.size() + count_rows;
  for (std::size_t begin = 0; begin < edges.size(); begin += 64) {
    each_bit(move.difference.edges, [&](std::size_t bit) {
      const std::size_t place = begin + bit;
      if (place < edges.size())
        s_.queued[edges[place]] = {static_cast<Why>(at[why_rows * place]), at[why_rows * place + 1]};
    });
  }
  if ((move.bits & moved::other_decision) != 0) s_.counters->unsettled = true;
}

/// The order and the plans of a decision, as far as `bits` (of `moved`) name them.
DIRECTOR_INLINE void Engine::recall_order(Index component, std::uint8_t bits, const Index* at, Index& count,
                                          Index* order, Index* plan) {
  const Component& row = t_.components[component];
  const std::span<const Index> groups = t_.list(row.groups);
  at += standing_rows * groups.size() + count_rows + why_rows * row.edges.size();
  if ((bits & moved::other_order) != 0 && !planted(Fault::the_order_stays)) {
    count = at[0];
    for (Index i = 0; i < count; ++i) {
      order[i] = at[1 + i];
      s_.place[order[i]] = i;
    }
  }
  if ((bits & moved::other_plans) == 0) return;
  at += 1 + groups.size();
  for (const Index g : groups) {
    const Range slots = t_.groups[g].slots;
    for (Index slot = slots.begin; slot != slots.end; ++slot) plan[slot] = *at++;
  }
}

/// To another decision, as a pass and changed() would leave it. What a pass writes besides is used by nobody. True if
/// it is another one.
bool Engine::go(Index component, const Recall::Move& move, const Index* at) {
  const Component& row = t_.components[component];
  const std::span<const Index> groups = t_.list(row.groups);
  each_bit(move.difference.groups, [&](std::size_t place) {
    const Index group = groups[place];
    s_.now[group] = standing(at, place);
    s_.group_marks[group] |= mark::differs;
    s_.differing[differing_++] = group;
  });
  note_move(component, move, at);
  recall_order(component, moved::other_order | moved::other_plans, at, s_.next_count[component],
               s_.next_order + row.order, s_.now.plan);
  return move.difference.groups != 0;
}

/// The same, where every group stands as before.
DIRECTOR_INLINE void Engine::stay(Index component, const Recall::Move& move, const Index* at) {
  if (observed()) remember_queued(component);
  note_move(component, move, at);
  recall_order(component, move.bits, at, s_.order_count[component], s_.order + t_.components[component].order,
               s_.last.plan);
  if (observed()) report_queued(component);
}

/// The same, and acting on it, as act() would: what is known of that saves looking for it.
DIRECTOR_INLINE void Engine::follow(Index component, const Recall::Move& move, const Index* at) {
  const Component& row = t_.components[component];
  const std::span<const Index> groups = t_.list(row.groups);
  if (observed()) remember_queued(component);
  note_move(component, move, at);
  if (observed()) {
    for (std::size_t i = 0; i < groups.size(); ++i) s_.now[groups[i]] = standing(at, i);
    report_decisions(component);
  }
  const Recall::Acts& acts = move.acts;
  for (std::size_t i = 0; i < acts.stops; ++i) stop_group(groups[acts.group[i]]);
  const std::size_t end = std::size_t{acts.stops} + acts.gives;
  if ((move.bits & moved::begins) != 0) {
    for (std::size_t i = acts.stops; i < end; ++i) {
      const std::size_t place = acts.group[i];
      if ((acts.reasons[i] & Recall::Acts::begins) != 0) begin(groups[place], standing(at, place));
    }
  }
  each_bit(move.difference.groups, [&](std::size_t place) {
    Standing& last = s_.last[groups[place]];
    last = standing(at, place);
    if (!last.granted()) leave_queue(groups[place]);
  });
  recall_order(component, move.bits, at, s_.order_count[component], s_.order + row.order, s_.last.plan);
  Index count = 0;
  for (std::size_t i = acts.stops; i < end; ++i) {
    const Index group = s_.sorted[count++] = groups[acts.group[i]];
    note_given(group, s_.last[group].holder, acts.reasons[i] & static_cast<std::uint8_t>(~Recall::Acts::begins));
  }
  if (s_.counters->touched_count != 0) count = join_touched(count);
  for (Index i = 0; i < count; ++i) enqueue(s_.sorted[i]);
}

/// As arbitrate(), where only one component is to be decided, it was in this situation before, and what followed is
/// written down. False: nothing was done.
bool Engine::retrace() {
  const Index component = s_.work[0];
  const Recall::Part known = recall_.part(component);
  if (!known || known.head().rest != 0 || known.head().current == Recall::unknown ||
      !needs_pass(s_.component[component]))
    return false;
  note_asked(true);
  const Recall::Move* const found = ask(component, known) ? known.find() : nullptr;
  note_asked(false);
  if (found == nullptr || found->acts.gives == Recall::unknown) return false;
  const Recall::Move& move = *found;
  note_recalled(known, move);
  const bool other = move.difference.groups != 0;
  const std::uint8_t left =
      settled_bits(component, other, (move.bits & moved::on_last) != 0, (move.bits & moved::on_stale) != 0);
  const bool again = needs_pass(left);
  s_.component[component] = again ? left | work::listed : left;
  s_.counters->work_count = again ? 1 : 0;
  const Index* const at = known.row(move.to);
  if (other) {
    follow(component, move, at);
  } else {
    if (move.to != move.from) stay(component, move, at);
    if (s_.counters->touched_count != 0) act_on_touched();
  }
  keep_promises_in(component);
  return true;
}

/// To those of State::sorted that stand elsewhere, those that can have a new reason to run where they stood. Returns
/// how many they are.
Index Engine::join_touched(Index given) {
  Counters& c = *s_.counters;
  Index count = given;
  const auto joined = [&](Index group) {
    Index i = 0;
    while (i < given && s_.sorted[i] != group) ++i;
    return i != given;
  };
  for (Index i = 0; i < c.touched_count; ++i) {
    const Index group = s_.touched[i];
    untouch(group);
    if (!granted(group) || joined(group) || planted(Fault::who_stands_as_before_is_overlooked)) continue;
    note_given(group, s_.last[group].holder, 0);
    s_.sorted[count++] = group;
  }
  c.touched_count = 0;
  if (count != given) sort_by_place({s_.sorted, count}, Along::last);
  return count;
}

/// After a pass over a situation that the question tells, and that no move is known in.
void Engine::learn(Index component, const Recall::Part& known) {
  Recall::Head& head = known.head();
  if (known.full()) {
    known.make_room();
    if (head.rest != 0 && !planted(Fault::a_rest_is_overlooked)) return; // what stands by then is not known
  }
  const std::uint8_t from = head.current;
  write(component, known.spare());
  head.current = known.number_spare();
  if (from == Recall::unknown) return;
  Recall::Move& move = known.add(from, head.current);
  if (depends_on_last()) move.bits |= moved::on_last;
  if (depends_on_stale()) move.bits |= moved::on_stale;
}

/// The two decisions of a move. Only what is recalled has to be compared.
void Engine::compare(Index component, const Recall::Part& known, Recall::Move& move) const {
  const Component& row = t_.components[component];
  const std::span<const Index> groups = t_.list(row.groups);
  const Index *from = known.row(move.from), *to = known.row(move.to);
  Recall::Difference& out = move.difference;
  move.compared = true;
  const auto differ = [&](std::size_t count) {
    bool any = false;
    for (std::size_t i = 0; i < count; ++i) any = *from++ != *to++ || any;
    return any;
  };
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Standing last = standing(from), now = standing(to);
    if (now.decides_otherwise_than(last)) move.bits |= moved::other_decision;
    if (now.stops_after(last)) move.bits |= moved::stops;
    if (differ(standing_rows)) out.groups |= Recall::Word{1} << i;
  }
  for (std::size_t i = 0; i < count_rows; ++i) out.counts |= (Recall::Word{*from++} ^ Recall::Word{*to++}) << 16 * i;
  for (std::size_t i = 0; i < row.edges.size(); ++i) {
    if (differ(why_rows)) out.edges |= Recall::Word{1} << i % 64;
  }
  if (differ(1 + groups.size())) move.bits |= moved::other_order;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (!differ(t_.groups[groups[i]].slots.size())) continue;
    out.groups |= Recall::Word{1} << i;
    move.bits |= moved::other_plans;
  }
  foresee(component, known, move);
}

/// What act() would do about the difference. The order stands in a decision behind why each edge is queued.
void Engine::foresee(Index component, const Recall::Part& known, Recall::Move& move) const {
  const Component& row = t_.components[component];
  const std::span<const Index> groups = t_.list(row.groups);
  const Index *const from = known.row(move.from), *const to = known.row(move.to);
  const std::size_t order = standing_rows * groups.size() + count_rows + why_rows * row.edges.size();
  Recall::Acts acts;
  std::size_t count = 0;
  bool room = true;
  const auto each_that = [&](const Index* decision, auto&& does) {
    for (Index i = 0; i < decision[order]; ++i) {
      std::uint8_t place = 0;
      while (groups[place] != decision[order + 1 + i]) ++place;
      if ((move.difference.groups >> place & 1) == 0) continue;
      const Standing last = standing(from, place), now = standing(to, place);
      if (!does(last, now)) continue;
      room = room && count < Recall::Acts::most;
      if (!room) return;
      acts.group[count] = place;
      acts.reasons[count] = reasons(last, now);
      if (takes_more(groups[place], last, now) && !planted(Fault::handlers_are_overlooked)) {
        acts.reasons[count] |= Recall::Acts::begins;
        move.bits |= moved::begins;
      }
      ++count;
    }
  };
  each_that(from, [](const Standing& last, const Standing& now) { return now.stops_after(last); });
  acts.stops = static_cast<std::uint8_t>(count);
  each_that(to, [](const Standing&, const Standing& now) { return now.granted(); });
  acts.gives = static_cast<std::uint8_t>(count - acts.stops);
  if (room) move.acts = acts;
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
    counting |= Recall::Word{(s_.turn[g].places & place::counts) != 0} << at++;
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

void Engine::forget_decisions(Index component) {
  const Recall::Part known = recall_.part(component);
  if (known && !planted(Fault::enabling_is_overlooked)) known.forget();
}

void Engine::note_condition(Index condition) {
  if (!recall_.on() || planted(Fault::conditions_are_overlooked)) return;
  for (const Index component : t_.list(t_.conditions[condition].components)) {
    const Recall::Part known = recall_.part(component);
    if (!known) continue;
    const Component& row = t_.components[component];
    std::uint8_t* at = known.bytes() + row.edges.size() + row.groups.size();
    for (const Index each : t_.list(row.conditions)) {
      if (each == condition) *at = holds(condition) ? 1 : 0;
      ++at;
    }
  }
}

} // namespace director
