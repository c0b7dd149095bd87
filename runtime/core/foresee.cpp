// Door: runtime/core/engine.hpp. Test: tests/runtime/core/recall_test.cpp.
// SPDX-License-Identifier: MIT
//
// What acting on a move between two decisions comes to, written down row by row, so that retrace.hpp need not look for
// what differs.

#include "runtime/core/decision.hpp"
#include "runtime/core/notes.hpp"

#include <bit>

namespace director {

namespace {
/// Calls visit(place) for each bit.
template <class Visit>
void each_bit(Recall::Word bits, Visit&& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}
} // namespace

/// Writes down the effects of a move.
class Engine::Foresight {
public:
  Foresight(const Engine& engine, Index component, const Recall::Part& known, Recall::Move& move)
      : t_(engine.t_),
        s_(engine.s_),
        row_(t_.components[component]),
        groups_(t_.list(row_.groups)),
        known_(known),
        move_(move),
        from_(known.row(Recall::Part::from(move)), row_),
        to_(known.row(move.to), row_),
        effects_(known.begin_effects(move)) {
    for (std::size_t place = 0; place < groups_.size(); ++place) {
      if (!from_.standing(place).same(to_.standing(place))) other_ |= Recall::Word{1} << place;
      bool asked = false;
      for (const Index e : t_.list(t_.groups[groups_[place]].requesters)) asked = asked || s_.request[e].anew != 0;
      if (asked) asked_ |= Recall::Word{1} << place;
    }
    other_ |= other_plans();
  }
  bool write(const Engine& engine);

private:
  Recall::Word other_plans() const;
  void add(std::uint8_t& count, std::size_t where, Index value = 0) {
    const Recall::Head& head = known_.head();
    room_ = room_ && head.effects + count_ != head.room && count != 0xff;
    if (!room_) return;
    effects_[count_++] = {static_cast<std::uint32_t>(where), value};
    ++count;
  }
  template <class T>
  void add_word(const T& in_state, Index last, Index now) {
    static_assert(sizeof(T) == sizeof(Index));
    if (last == now) return;
    const auto* const at = reinterpret_cast<const std::byte*>(&in_state);
    add(move_.words, static_cast<std::size_t>(at - reinterpret_cast<const std::byte*>(s_.counters)), now);
  }
  void add_standings();
  bool reorders() const;
  void add_plans();
  void add_gives(const Engine& engine);

  const Tables& t_;
  const State& s_;
  const Component& row_;
  std::span<const Index> groups_;
  const Recall::Part& known_;
  Recall::Move& move_;
  Decision from_, to_;
  Recall::Effect* effects_;
  std::size_t count_ = 0;              ///< of them
  Recall::Word other_ = 0, asked_ = 0; ///< a bit for each group: it stands elsewhere; it is asked for anew
  bool room_ = true;
};

/// Writes down what acting on a move comes to, in the situation in which it is made. Only what is recalled has to be
/// compared. False: there is no room for it.
[[gnu::noinline]] bool Engine::foresee(Index component, const Recall::Part& known, Recall::Move& move) const {
  return (move.bits & moved::too_long) == 0 && Foresight(*this, component, known, move).write(*this);
}

bool Engine::Foresight::write(const Engine& engine) {
  for (const Index group : from_.order()) {
    const std::size_t place = place_of(group, groups_);
    if (to_.standing(place).stops_after(from_.standing(place))) add(move_.stops, group);
  }
  add_standings();
  add_plans();
  for (std::size_t place = 0; place < groups_.size(); ++place)
    add_word(s_.turn[groups_[place]].counts, from_.counts(place) ? 1 : 0, to_.counts(place) ? 1 : 0);
  each_bit(planted(Fault::who_leaves_stays_queued) ? 0 : other_, [&](std::size_t place) {
    if (from_.standing(place).granted() && !to_.standing(place).granted()) add(move_.leaves, groups_[place]);
  });
  add_gives(engine);

  move_.component = left_over(other_ != 0, (move_.bits & moved::on_last) != 0, (move_.bits & moved::on_stale) != 0);
  if (needs_pass(move_.component)) move_.component |= work::listed;
  if (reorders()) move_.component |= work::order_behind;
  move_.bits |= room_ ? moved::foreseen : moved::too_long;
  if (move_.stops != 0 || (move_.bits & moved::begins) != 0 || move_.leaves != 0 || move_.passed != 0)
    move_.bits |= moved::rare;
  if (!room_) return false;
  Recall::Head& head = known_.head();
  head.effects = static_cast<std::uint16_t>(head.effects + count_);
  head.end = static_cast<std::uint16_t>(head.end + count_);
  return true;
}

Recall::Word Engine::Foresight::other_plans() const {
  Recall::Word other = 0;
  const Index *from = from_.plans(), *to = to_.plans();
  for (std::size_t place = 0; place < groups_.size(); ++place) {
    for (std::size_t left = t_.groups[groups_[place]].slots.size(); left != 0; --left) {
      if (*from++ != *to++) other |= Recall::Word{1} << place;
    }
  }
  return other;
}

void Engine::Foresight::add_standings() {
  each_bit(other_, [&](std::size_t place) {
    const Standing& standing = s_.last[groups_[place]];
    const Index *const last = from_.standing_row(place), *const now = to_.standing_row(place);
    const Index* const rows[standing_rows] = {&standing.holder,        &standing.active,    &standing.planned,
                                              &standing.flags,         &standing.push.edge, &standing.push.provider,
                                              &standing.push.condition};
    for (std::size_t i = 0; i < standing_rows; ++i) add_word(*rows[i], last[i], now[i]);
    if (to_.standing(place).decides_otherwise_than(from_.standing(place))) move_.bits |= moved::other_decision;
  });
}

bool Engine::Foresight::reorders() const {
  const std::span<const Index> from = from_.order(), to = to_.order();
  bool other = from.size() != to.size();
  for (std::size_t i = 0; !other && i < to.size(); ++i) other = from[i] != to[i];
  return other;
}

void Engine::Foresight::add_plans() {
  const Index *from = from_.plans(), *to = to_.plans();
  for (const Index g : groups_) {
    const Range slots = t_.groups[g].slots;
    for (Index slot = slots.begin; slot != slots.end; ++slot) add_word(s_.last.plan[slot], *from++, *to++);
  }
}

void Engine::Foresight::add_gives(const Engine& engine) {
  for (const Index group : to_.order()) {
    const std::size_t place = place_of(group, groups_);
    const Standing last = from_.standing(place), now = to_.standing(place);
    const bool other = (other_ >> place & 1) != 0;
    if (!now.granted() || ((other_ | asked_) >> place & 1) == 0) continue;
    if (!other && planted(Fault::who_stands_as_before_is_overlooked)) continue;
    Index value = s_.request[now.holder].anew != 0 ? reason::new_task : 0;
    if (other) value |= reasons(last, now);
    if (other_ == 0) value |= Recall::Effect::again;
    if (other && engine.takes_more(group, last, now) && !planted(Fault::handlers_are_overlooked)) {
      value |= Recall::Effect::begins;
      move_.bits |= moved::begins;
    }
    add(move_.gives, group, value);
  }
  each_bit(asked_, [&](std::size_t place) {
    ++move_.asked;
    const bool overlooked = planted(Fault::who_stands_as_before_is_overlooked) && (other_ >> place & 1) == 0;
    if (!to_.standing(place).granted() || overlooked) add(move_.passed, groups_[place]);
  });
}

} // namespace director
