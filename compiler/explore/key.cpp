// Door: compiler/explore/machine.hpp. Test: tests/compiler/explore/search_test.cpp.
//
// What makes two states the same: everything in the decision state that semantics.md names as an input of what comes
// next, and nothing else. Stamps count as ranks among the requests of one requester at one priority, because only
// these are ever compared (4.1, rule 5); values as what the conditions make of them; of a reason only whether it is
// new_task, pushed or another, and of a done flag only whether it is there, because bodies may do anything in any case;
// task data not at all. What the engine keeps only to be fast follows from the rest, since it must decide as a pass
// from nothing does.
//
// The only place of this room that knows how the engine's memory is laid out.
#include "compiler/explore/machine.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

namespace director::compiler {

namespace {

__extension__ using Wide = unsigned __int128;

/// The product of two words, its halves folded into one.
std::uint64_t fold(std::uint64_t a, std::uint64_t b) {
  const Wide product = Wide{a} * b;
  return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
}

constexpr std::uint64_t salt[] = {0x2545f4914f6cdd1d, 0x9e3779b97f4a7c15, 0xbf58476d1ce4e5b9, 0x94d049bb133111eb,
                                  0x632be59bd9b4e019, 0xd6e8feb86659fd93, 0xa0761d6478bd642f, 0xe7037ed1a0b428db};
constexpr std::size_t lanes = 4, stride = 2 * lanes;

/// `count`: a multiple of `stride`. Four lanes, for none has to wait for another.
std::uint64_t hash(const std::uint64_t* words, std::size_t count) {
  std::uint64_t lane[lanes] = {salt[4], salt[5], salt[6], salt[7]};
  for (std::size_t i = 0; i < count; i += stride) {
    for (std::size_t l = 0; l < lanes; ++l) lane[l] = fold(words[i + 2 * l] ^ salt[l], words[i + 2 * l + 1] ^ lane[l]);
  }
  return fold(fold(lane[0] ^ salt[0], lane[1] ^ salt[5]) ^ salt[2], fold(lane[2] ^ salt[1], lane[3] ^ salt[6]) ^ count);
}

/// Writes what makes a state as words.
class Projection {
public:
  /// `words`: as many as it takes (Machine::find_marks).
  explicit Projection(std::vector<std::uint64_t>& words) : begin_(words.data()), at_(begin_) {}
  /// Returns where they begin.
  template <class T>
  std::uint64_t* add(const T* rows, std::size_t count) {
    std::uint64_t* const begin = at_;
    const std::size_t bytes = count * sizeof(T);
    if (bytes == 0) return begin;
    at_ += words_of(bytes);
    at_[-1] = 0;
    std::memcpy(begin, rows, bytes);
    return begin;
  }
  void add(std::uint64_t word) { *at_++ = word; }
  std::uint64_t* end() const { return at_; }
  std::uint64_t sum() {
    while (static_cast<std::size_t>(at_ - begin_) % stride != 0) add(0);
    return hash(begin_, static_cast<std::size_t>(at_ - begin_));
  }

  static std::size_t words_of(std::size_t bytes) { return (bytes + 7) / 8; }

private:
  std::uint64_t *begin_, *at_;
};

/// Of eight groups' reasons at once: new_task, pushed, and whether there is another.
std::uint64_t classes_of(std::uint64_t pending) {
  constexpr std::uint64_t each = 0x0101010101010101, top = 0x80 * each;
  constexpr std::uint64_t own =
      (static_cast<std::uint64_t>(Reason::new_task) | static_cast<std::uint64_t>(Reason::pushed)) * each;
  const std::uint64_t others = pending & ~own;
  return (pending & own) | ((((others & ~top) + ~top) | others) & top);
}

/// What no two edges can have in common that are requested at the same time decides nothing.
bool can_be_equal(const Tables& t, Index a, Index b) {
  const Range one = t.edges[a].levels, other = t.edges[b].levels;
  for (Index i = one.begin; i != one.end; ++i) {
    for (Index j = other.begin; j != other.end; ++j) {
      if (t.levels[i].priority == t.levels[j].priority) return true;
    }
  }
  return false;
}

} // namespace

/// What print() needs and the tables tell.
void Machine::find_marks() {
  const Tables& t = ground_.tables;
  marks_.push_back(0);
  for (Index v = 0; v < t.states.size(); ++v) {
    const std::size_t classes = ground_.classes[v].count();
    const bool counts = classes > 1 || ground_.model.states[StateId{v}].may_be_unset();
    if (counts) minded_.push_back(v);
    first_mark_.push_back(marks_.size());
    for (std::size_t c = 0; c <= classes; ++c) {
      const std::uint64_t name = std::uint64_t{v} << 32 | c;
      marks_.push_back(counts ? fold(fold(name ^ salt[0], salt[1]) ^ salt[2], salt[3]) : 0);
    }
  }
  std::size_t contested_edges = 0;
  const auto look = [&](Range edges) {
    bool contested = false;
    for (Index a = edges.begin; a != edges.end; ++a) {
      for (Index b = edges.begin; b != a; ++b) contested = contested || can_be_equal(t, a, b);
    }
    if (!contested) return;
    contested_.push_back(edges);
    contested_edges += edges.size();
  };
  look({0, t.root_edges});
  for (const director::Group& group : t.groups) look(group.edges);
  const auto words = [](std::size_t rows, std::size_t bytes) { return Projection::words_of(rows * bytes); };
  projection_.resize(words(t.edges.size(), sizeof(Index)) + contested_edges / 4 + contested_.size() +
                     words(t.groups.size(), sizeof(Standing)) + words(t.plan_groups.size(), sizeof(Index)) +
                     2 * words(t.groups.size(), 1) + 1 + words(t.states.size(), sizeof(std::int32_t)) +
                     t.groups.size() + stride);
}

static_assert(std::has_unique_object_representations_v<Standing>, "it is hashed as the bytes that it is");

Print Machine::print() const {
  const Tables& t = ground_.tables;
  const director::State& s = engine_.memory();
  const director::Counters& c = *s.counters;
  Projection all(projection_);

  // Requests, and the order in which those of one priority were made.
  all.add(s.request, t.edges.size());
  for (const Range& edges : contested_) {
    std::uint64_t places = 0;
    for (Index e = edges.begin; e != edges.end; ++e) {
      std::uint64_t place = 0;
      for (Index other = edges.begin; other != edges.end && s.request[e] != nil; ++other) {
        if (s.request[other] == nil || other == e) continue;
        if (t.levels[s.request[other]].priority != t.levels[s.request[e]].priority) continue;
        place += (s.stamp[other] != s.stamp[e] ? s.stamp[other] < s.stamp[e] : other < e) ? 1U : 0U;
      }
      places = places << 16 | place;
      if ((e - edges.begin) % 4 == 3) all.add(std::exchange(places, 0));
    }
    all.add(places);
  }

  // Who has what.
  all.add(s.last.group, t.groups.size());
  all.add(s.last.plan, t.plan_groups.size());
  all.add(s.done, t.groups.size());
  for (std::uint64_t* word = all.add(s.pending, t.groups.size()); word != all.end(); ++word) *word = classes_of(*word);

  // What is left to do.
  all.add(std::uint64_t{c.unsettled} << 8 | std::uint64_t{c.handlers_set} << 9 | static_cast<std::uint64_t>(phase_));
  if (c.handlers_set) all.add(s.handler_values, t.states.size());
  for (Index g = c.queue_first; g != nil; g = s.runs_before[g]) all.add(std::uint64_t{g} + 1);

  Print out{all.sum(), 0};
  for (const Index v : minded_) out.values += mark_of(v, engine_.value(v));
  return out;
}

std::uint64_t Machine::key(const Print& print, std::uint64_t watch) {
  const std::uint64_t sum = fold(fold(print.rest ^ salt[3], print.values ^ salt[7]) ^ salt[1], watch ^ salt[4]);
  return sum == 0 ? 1 : sum;
}

// Values before a micro-step decide nothing: arbitration looks at those after it, at requests and at the last
// assignment (semantics.md 4), and what the engine does not decide anew it would decide as before. A run's answers
// follow from requests and done flags.
std::uint64_t Machine::foresee(const Print& from, std::uint64_t watch, const Choices& choices, std::size_t answer,
                               std::size_t puts, bool each) const {
  Print to = from;
  const Puts& all = choices.puts[puts];
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Index state = all[i].state;
    const bool again = std::any_of(all.begin() + static_cast<std::ptrdiff_t>(i) + 1, all.end(),
                                   [&](const Put& later) { return later.state == state; });
    if (!again) to.values += mark_of(state, all[i].value) - mark_of(state, loaded_values_[state]);
  }
  const std::uint64_t what = choices.body ? (each ? puts + 1 : 0) << 32 | (answer + 1) : 0;
  return key(to, fold(watch ^ salt[2], what ^ salt[5]));
}

/// Of the requests of one requester, each gets its place as its stamp.
void Machine::forget() {
  const Tables& t = ground_.tables;
  const director::State& s = engine_.memory();
  const auto rank = [&](Index begin, Index end) {
    scratch_.clear();
    for (Index e = begin; e != end; ++e) {
      if (s.request[e] != nil) scratch_.push_back(e);
    }
    if (scratch_.size() > 1)
      std::sort(scratch_.begin(), scratch_.end(),
                [&](Index a, Index b) { return s.stamp[a] != s.stamp[b] ? s.stamp[a] < s.stamp[b] : a < b; });
    for (Index e = begin; e != end; ++e) s.stamp[e] = 0;
    for (std::size_t i = 0; i < scratch_.size(); ++i) s.stamp[scratch_[i]] = i + 1;
  };
  rank(0, t.root_edges);
  for (const director::Group& group : t.groups) {
    if (!group.edges.empty()) rank(group.edges.begin, group.edges.end);
  }
  s.counters->micro_step = t.edges.size();
}

} // namespace director::compiler
