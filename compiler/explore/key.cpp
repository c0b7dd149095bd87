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

namespace director::compiler {

namespace {

/// Mixes as in SplitMix64, a word at a time.
class Hash {
public:
  void add(std::uint64_t word) {
    std::uint64_t z = sum_ ^ (word * 0x9e3779b97f4a7c15 + 0x632be59bd9b4e019);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    sum_ = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  }
  /// What follows is of another kind: parts of different length must not be taken for one another.
  void part() { add(0xfffffffeffffff00); }
  void add(std::uint32_t a, std::uint32_t b) { add(std::uint64_t{a} << 32 | b); }
  std::uint64_t sum() const { return sum_ == 0 ? 1 : sum_ ^ (sum_ >> 31); }

private:
  std::uint64_t sum_ = 0x2545f4914f6cdd1d;
};

std::uint32_t class_of(std::uint8_t pending) {
  constexpr auto new_task = static_cast<std::uint8_t>(Reason::new_task),
                 pushed = static_cast<std::uint8_t>(Reason::pushed);
  return (pending & (new_task | pushed)) | ((pending & ~(new_task | pushed)) != 0 ? 0x80U : 0U);
}

} // namespace

std::uint64_t Machine::key(std::uint64_t watch) {
  const Tables& t = ground_.tables;
  const director::State& s = engine_.memory();
  Hash hash;
  hash.add(watch);

  // Requests, and the order in which those of one priority were made.
  const auto ranked = [&](Index begin, Index end) {
    scratch_.clear();
    for (Index e = begin; e != end; ++e) {
      if (s.request[e] != nil) scratch_.push_back(e);
    }
    if (scratch_.size() > 1)
      std::sort(scratch_.begin(), scratch_.end(),
                [&](Index a, Index b) { return s.stamp[a] != s.stamp[b] ? s.stamp[a] < s.stamp[b] : a < b; });
    for (Index e = begin; e != end; ++e) s.stamp[e] = 0;
    if (scratch_.size() == 1) {
      s.stamp[scratch_.front()] = 1;
      hash.add(scratch_.front(), 0);
      hash.add(s.request[scratch_.front()]);
    }
    if (scratch_.size() < 2) return;
    for (std::size_t i = 0; i < scratch_.size(); ++i) s.stamp[scratch_[i]] = i + 1;
    for (Index e = begin; e != end; ++e) {
      if (s.request[e] == nil) continue;
      const std::int32_t priority = t.levels[s.request[e]].priority;
      std::uint32_t place = 0;
      for (const Index other : scratch_) {
        if (other == e) break;
        place += t.levels[s.request[other]].priority == priority ? 1U : 0U;
      }
      hash.add(e, place);
      hash.add(s.request[e]);
    }
  };
  ranked(0, t.root_edges);
  for (const director::Group& group : t.groups) {
    if (!group.edges.empty()) ranked(group.edges.begin, group.edges.end);
  }
  s.counters->micro_step = t.edges.size();
  hash.part();

  for (Index v = 0; v < t.states.size(); ++v) {
    if (ground_.classes[v].count() < 2 && !ground_.model.states[StateId{v}].may_be_unset()) continue;
    hash.add(ground_.classes[v].of(engine_.value(v)));
  }

  // Who has what.
  hash.part();
  for (Index g = 0; g < t.groups.size(); ++g) {
    const Standing& stands = s.last[g];
    const std::uint32_t rest = stands.flags | (s.done[g] != 0 ? 0x100U : 0U) | class_of(s.pending[g]) << 16;
    if (stands.holder == nil && stands.push.edge == nil && rest == 0) continue;
    hash.add(g, rest);
    hash.add(stands.holder, stands.active);
    hash.add(stands.planned, stands.push.edge);
    hash.add(stands.push.provider, stands.push.condition);
  }
  hash.part();
  for (Index slot = 0; slot < t.plan_groups.size(); ++slot) {
    if (s.last.plan[slot] != nil) hash.add(slot, s.last.plan[slot]);
  }

  // What is left to do.
  hash.part();
  hash.add(static_cast<std::uint32_t>(phase_), s.counters->unsettled);
  for (Index g = s.counters->queue_first; g != nil; g = s.runs_before[g]) hash.add(g);
  hash.part();
  for (Index v = 0; v < t.states.size() && s.counters->handlers_set != 0; ++v) {
    if (s.handler_values[v] != unset) hash.add(v, static_cast<std::uint32_t>(s.handler_values[v]));
  }
  return hash.sum();
}

} // namespace director::compiler
