// Door: runtime/core/recall.hpp. Test: tests/runtime/core/recall_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/core/recall.hpp"

namespace director {

static_assert(sizeof(Recall::Move) <= Recall::move_words * sizeof(Recall::Word));
static_assert(sizeof(Recall::Head) <= Recall::head_words * sizeof(Recall::Word));
static_assert(sizeof(Recall::Effect) == sizeof(Recall::Word));

namespace {
#ifdef DIRECTOR_PLANTED_FAULTS // so little that random cases need more
constexpr std::size_t room_for_decisions = 6, room_for_moves = 10, room_for_effects = 40;
constexpr std::uint16_t least_rest = 3;
#else
constexpr std::size_t room_for_decisions = Recall::most_decisions, room_for_moves = Recall::most_moves,
                      room_for_effects = 0xffff;
constexpr std::uint16_t least_rest = Recall::rest;
#endif
} // namespace

/// The place of the number of the move from the decision that stands, in the situation in hand; a free one if it is not
/// known.
std::size_t Recall::Part::look_up() const {
  Word digest_of_it = 0;
  for (std::size_t i = 0; i < head().words; ++i) digest_of_it = mix(digest_of_it, question()[i]);
  std::size_t place = digest_of_it % places;
  const std::uint16_t* const moves = places_of_moves();
  while (moves[place] != 0 && !is_asked(*at<Move>(moves[place]))) place = (place + 1) % places;
  return place;
}

Recall::Move& Recall::Part::add(std::uint8_t to) const {
  Head& own = head();
  const std::uint16_t word = own.end;
  own.end = static_cast<std::uint16_t>(word + move_words + own.words);
  ++own.moves;
  places_of_moves()[look_up()] = word;
  at<Move>(own.taken)->next = word;
  own.taken = word;
  own.guess = 0;
  Move& out = *at<Move>(word);
  out = {};
  for (std::size_t i = 0; i < own.words; ++i) situation<Word>(out)[i] = question()[i];
  out.to = to;
  return out;
}

std::uint8_t Recall::Part::number_spare() const {
  const Index* const given = spare();
  Word found = 0;
  for (std::size_t i = 0; i < head().rows; i += 2) found = mix(found, Word{given[i]} << 32 | given[i + 1]);
  const auto is_it = [&](std::size_t number) {
    if (digest()[number] != found) return false;
    for (std::size_t i = 0; i < head().rows; ++i) {
      if (row(number)[i] != given[i]) return false;
    }
    return true;
  };
  std::uint8_t number = 0;
  while (number < head().decisions && !is_it(number)) ++number;
  if (number == head().decisions) {
    digest()[number] = found;
    ++head().decisions;
  }
  return number;
}

bool Recall::Part::full() const { return head().decisions >= room_for_decisions || head().moves >= room_for_moves; }

void Recall::Part::forget() const {
  Head& own = head();
  current() = unknown;
  own.decisions = own.moves = own.used = 0;
  own.effects = 0;
  own.taken = own.end = static_cast<std::uint16_t>(first_move());
  own.guess = 0;
  for (std::size_t i = 0; i < places; ++i) places_of_moves()[i] = 0;
}

void Recall::Part::make_room() const {
  Head& own = head();
  if (own.used < own.moves) own.rest = least_rest;
  forget();
}

Recall::Recall(const Tables& t, std::span<std::byte> memory) {
  const std::size_t needed = bytes(t);
  if (needed == 0 || memory.size() < needed) return;
  bytes_ = reinterpret_cast<std::uint8_t*>(memory.data());
  begin_ = reinterpret_cast<std::uint32_t*>(bytes_ + sizeof(Word));
  condition_place_ = begin_ + t.components.size();
}

void Recall::reset(const Tables& t) {
  if (!on()) return;
  const std::size_t all = bytes(t);
  for (std::size_t i = 0; i < all; ++i) bytes_[i] = 0;
  std::size_t begin = lists(t);
  for (Index c = 0; c < t.components.size(); ++c) {
    const Component& row = t.components[c];
    const Size size = size_of(t, row);
    if (size.question == 0) continue;
    begin_[c] = static_cast<std::uint32_t>(begin);
    begin += size.all();
    const Part own = part_at(begin_[c]);
    own.head().words = static_cast<std::uint16_t>(size.question);
    own.head().rows = static_cast<std::uint16_t>(size.rows);
    own.head().room = static_cast<std::uint16_t>(size.effects < room_for_effects ? size.effects : room_for_effects);
    own.forget();
    std::uint32_t place = std::uint32_t{edges_at(c)} + row.edges.size() + row.groups.size();
    for (const Index each : t.list(row.conditions)) {
      condition_place_[each] = t.conditions[each].components.size() == 1 ? place : several;
      ++place;
    }
  }
}

bool Recall::can_tie(const Tables& t, const Edge& a, const Edge& b) {
  for (Index i = a.levels.begin; i != a.levels.end; ++i) {
    for (Index j = b.levels.begin; j != b.levels.end; ++j) {
      if (t.levels[i].urgency == t.levels[j].urgency) return true;
    }
  }
  return false;
}

} // namespace director
