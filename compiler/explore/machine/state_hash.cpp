// Header: compiler/explore/machine/state_hash.hpp. Test: tests/compiler/explore/search/search_test.cpp.
// SPDX-License-Identifier: MIT
//
// Defines when two states are equal: by everything in the decision state that semantics.md names as an input of the
// next decision, and nothing else. Stamps count as ranks among the requests of one requester at one priority, because
// only these are ever compared (4.1, rule 5); values by the conditions that they satisfy; of a reason only whether it
// is new_task, pushed or another, and of a done flag only whether it is set, because bodies may do anything in any
// case; task data not at all. What the engine stores only for speed follows from the rest, since it must decide like a
// pass from nothing.
#include "compiler/explore/machine/state_hash.hpp"

#include <algorithm>
#include <span>
#include <type_traits>
#include <utility>

namespace director::compiler {

namespace {

/// Of eight groups' reasons at once: new_task, pushed, and whether there is another.
std::uint64_t classes_of(std::uint64_t pending) {
  constexpr std::uint64_t each = 0x0101010101010101, top = 0x80 * each;
  constexpr std::uint64_t own =
      (static_cast<std::uint64_t>(Reason::new_task) | static_cast<std::uint64_t>(Reason::pushed)) * each;
  const std::uint64_t others = pending & ~own;
  return (pending & own) | ((((others & ~top) + ~top) | others) & top);
}

/// The order of two edges that cannot be equal decides nothing.
bool can_be_equal(const Tables& t, Index a, Index b) {
  const Range one = t.edges[a].levels, other = t.edges[b].levels;
  for (Index i = one.begin; i != one.end; ++i) {
    for (Index j = other.begin; j != other.end; ++j) {
      if (t.levels[i].priority == t.levels[j].priority) return true;
    }
  }
  return false;
}

/// Overwrites all bytes of the rows [begin, end) that were written.
template <class T>
void overwrite(std::uint64_t* rows, Index begin, Index end, int byte) {
  std::memset(reinterpret_cast<unsigned char*>(rows) + begin * sizeof(T), byte, (end - begin) * sizeof(T));
}

} // namespace

static_assert(std::has_unique_object_representations_v<GroupAssignment>, "it is hashed as the bytes that it is");

std::uint64_t key_of(const StateHash& hash, std::uint64_t watch) {
  const std::uint64_t sum = fold(fold(hash.rest ^ salt[3], hash.values ^ salt[7]) ^ salt[1], watch ^ salt[4]);
  return sum == 0 ? 1 : sum;
}

StateHasher::StateHasher(const Ground& ground, const Engine& engine) : ground_(ground), engine_(engine) {
  find_marks();
  find_contested();
  const Tables& t = ground.tables;
  requested_.resize(std::max<std::size_t>(t.most_edges, t.root_edges) + 1);
  const auto words = [](std::size_t rows, std::size_t bytes) { return Projection::words_of(rows * bytes); };
  std::size_t contested_edges = 0;
  for (const Contested& each : contested_) contested_edges += each.edges.size();
  projection_.resize(words(t.edges.size(), sizeof(Index)) + contested_edges / 4 + contested_.size() +
                     words(t.groups.size(), sizeof(GroupAssignment)) + words(t.plan_groups.size(), sizeof(Index)) +
                     2 * words(t.groups.size(), 1) + 1 + words(t.states.size(), sizeof(std::int32_t)) +
                     t.groups.size() + Projection::stride);
}

void StateHasher::find_marks() {
  marks_.push_back(0);
  for (Index v = 0; v < ground_.tables.states.size(); ++v) {
    const std::size_t classes = ground_.classes[v].count();
    const bool counts = classes > 1 || ground_.model.states[StateId{v}].may_be_unset();
    if (counts) observed_.push_back(v);
    first_mark_.push_back(marks_.size());
    for (std::size_t c = 0; c <= classes; ++c) {
      const std::uint64_t name = std::uint64_t{v} << 32 | c;
      marks_.push_back(counts ? fold(fold(name ^ salt[0], salt[1]) ^ salt[2], salt[3]) : 0);
    }
  }
}

void StateHasher::find_contested() {
  const Tables& t = ground_.tables;
  const auto look = [&](Range edges, Index group) {
    bool contested = false;
    for (Index a = edges.begin; a != edges.end; ++a) {
      for (Index b = edges.begin; b != a; ++b) contested = contested || can_be_equal(t, a, b);
    }
    if (contested) contested_.push_back({edges, group});
  };
  look({0, t.root_edges}, nil);
  for (Index g = 0; g < t.groups.size(); ++g) look(t.groups[g].edges, g);
}

/// For each requested edge, how many others of its priority were requested before. With only one, the usual case,
/// nothing is added.
void StateHasher::add_places(Projection& out, const Range& edges, const Requested* request) const {
  const Tables& t = ground_.tables;
  Index* end = requested_.data();
  for (Index e = edges.begin; e != edges.end; ++e) { // without an unpredictable branch
    *end = e;
    end += request[e].level != nil ? 1 : 0;
  }
  const std::span<const Index> requested(requested_.data(), end);
  if (requested.size() < 2) return;
  std::uint64_t places = 0;
  std::size_t count = 0;
  for (const Index e : requested) {
    std::uint64_t place = 0;
    for (const Index other : requested) {
      if (other == e || t.levels[request[other].level].priority != t.levels[request[e].level].priority) continue;
      const std::uint64_t its = request[other].stamp, own = request[e].stamp;
      place += (its != own ? its < own : other < e) ? 1U : 0U;
    }
    places = places << 16 | place;
    if (++count % 4 == 0) out.add(std::exchange(places, 0));
  }
  if (count % 4 != 0) out.add(places);
}

void StateHasher::add_places(Projection& out, Index group, const Requested* request) const {
  for (const Contested& each : contested_) {
    if (each.group == group) add_places(out, each.edges, request);
  }
}

std::uint64_t* StateHasher::add_levels(Projection& out) const {
  return out.add(engine_.memory().request, ground_.tables.edges.size(),
                 [](const Requested& request) { return request.level; });
}

/// Adds holders and active providers. Returns where the done flags begin; the reasons follow.
std::uint64_t* StateHasher::add_holdings(Projection& out) const {
  const Tables& t = ground_.tables;
  const director::State& s = engine_.memory();
  out.add(s.last.group, t.groups.size());
  out.add(s.last.plan, t.plan_groups.size());
  const auto done_of = [](const RunQueueEntry& entry) { return entry.done; };
  const auto pending_of = [](const RunQueueEntry& entry) { return entry.pending; };
  std::uint64_t* const done = out.add(s.run_queue, t.groups.size(), done_of);
  std::uint64_t* word = out.add(s.run_queue, t.groups.size(), pending_of);
  for (; word != out.end(); ++word) *word = classes_of(*word);
  return done;
}

void StateHasher::add_queue(Projection& out, Index first) const {
  const director::State& s = engine_.memory();
  for (Index g = first; g != nil; g = s.run_queue[g].runs_before) out.add(std::uint64_t{g} + 1);
}

StateHash StateHasher::hash(Phase phase) const {
  const Tables& t = ground_.tables;
  const director::State& s = engine_.memory();
  const director::Counters& c = *s.counters;
  Projection all(projection_.data());
  add_levels(all);
  for (const Contested& each : contested_) add_places(all, each.edges, s.request);
  add_holdings(all);
  const bool handlers_set = c.staged_count != 0;
  all.add(std::uint64_t{c.unsettled} << 8 | std::uint64_t{handlers_set} << 9 | static_cast<std::uint64_t>(phase));
  if (handlers_set) all.add(s.values, t.states.size(), [](const StateValue& row) { return row.staged; });
  add_queue(all, c.queue_first);
  return {all.sum(), values()};
}

std::uint64_t StateHasher::values() const {
  std::uint64_t out = 0;
  for (const Index v : observed_) out += mark_of(v, engine_.value(v));
  return out;
}

std::uint64_t StateHasher::rest_before(Index group) const {
  const Tables& t = ground_.tables;
  const director::State& s = engine_.memory();
  const bool runs = group != nil;
  Projection all(projection_.data());
  std::uint64_t* const requests = add_levels(all);
  if (runs) overwrite<Index>(requests, t.groups[group].edges.begin, t.groups[group].edges.end, 0xff);
  for (const Contested& each : contested_) {
    if (!runs || each.group != group) add_places(all, each.edges, s.request);
  }
  std::uint64_t* const done = add_holdings(all);
  if (runs) {
    overwrite<Bits>(done, group, group + 1, 0);
    overwrite<Bits>(done + Projection::words_of(t.groups.size()), group, group + 1, 0);
  }
  all.add(std::uint64_t{group} + 1);
  add_queue(all, runs ? s.run_queue[group].runs_before : s.counters->queue_first);
  return all.sum();
}

} // namespace director::compiler
