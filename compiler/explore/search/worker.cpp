// Header: compiler/explore/search/worker.hpp. Test: tests/compiler/explore/search/search_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/explore/search/worker.hpp"

#include <algorithm>

namespace director::compiler {

std::uint64_t requested_roots(const Machine& machine) {
  std::uint64_t out = 0;
  const Index count = std::min<Index>(machine.ground().tables.root_edges, 64);
  for (Index e = 0; e < count; ++e) {
    if (machine.engine().state(e) != RunState::none) out |= std::uint64_t{1} << e;
  }
  return out;
}

/// Prefetches all keys that can be predicted, so that lookups do not wait for one another.
void Worker::foresee(const PlayedTable& played) {
  foreseen_.clear();
  if (!foresees_) return;
  const Foresight& ahead = machine.look_ahead();
  const std::vector<Action>& answers = machine.answers();
  const std::size_t puts = answers.empty() ? 0 : machine.ground().bodies[answers.front().provider].puts.size();
  for (std::size_t i = 0; i < answers.size(); ++i) {
    for (std::size_t j = 0; j < puts; ++j) foreseen_.push_back(ahead.of_body(i, j, watched_, watch.depends_on_puts()));
  }
  for (const Happens& happens : happens_) {
    if (happens.kind == Happens::Kind::set)
      foreseen_.push_back(ahead.of_input(machine.ground().sets[happens.row], watched_));
  }
  for (const std::uint64_t key : foreseen_) {
    mine_played_.fetch(key);
    played.fetch(key);
  }
}

void Worker::expand(const Waiting& from, const Known& known, const PlayedTable& played, Expansion& out) {
  out.steps.clear();
  out.packed.clear();
  out.seen.clear();
  machine.unpack(from.state);
  if (leave_) leave_(machine);
  watched_ = from.watch;
  watch.before(machine, watched_);
  machine.list(happens_);
  foresee(played);
  place_ = 0;
  moved_ = false;
  auto foreseen = foreseen_.begin();
  /// Skips a micro-step whose result is known; but the usual one is always taken, as its successor has to be known.
  const auto take_new = [&](const Happens& happens, bool usual) {
    const std::uint64_t key = *foreseen++;
    std::size_t ways = usual ? 0 : mine_played_.find(key);
    if (ways == 0 && !usual) ways = played.find(key);
    if (ways != 0) {
      place_ += static_cast<std::uint32_t>(ways);
      return;
    }
    const std::uint32_t taken = take_all(happens, known, out);
    mine_played_.add(key, taken);
    newly_played.emplace_back(key, taken);
  };
  for (const Happens& happens : happens_) {
    const bool goes = happens.kind == Happens::Kind::go;
    const std::size_t answers = goes ? machine.answers().size() : 0;
    if (!foresees_ || (answers == 0 && happens.kind != Happens::Kind::set)) {
      choices_.begin();
      take_all(happens, known, out);
      continue;
    }
    if (!goes) {
      choices_.begin();
      take_new(happens, false);
      continue;
    }
    const std::size_t puts = machine.ground().bodies[machine.answers().front().provider].puts.size();
    for (std::size_t i = 0; i < answers * puts; ++i) {
      choices_.begin({i / puts, i % puts});
      take_new(happens, i == 0);
    }
  }
  out.micro_steps = place_;
}

std::uint32_t Worker::take_all(const Happens& happens, const Known& known, Expansion& out) {
  const std::uint32_t before = place_;
  do {
    if (moved_) machine.again();
    moved_ = true;
    machine.take(happens, choices_);
    if (look_) look_(machine);
    const StateHash hash = machine.hash();
    known.fetch(key_of(hash, watched_)); // a likely key
    seen_.clear();
    const std::uint64_t remembered = watch.after(machine, seen_);
    for (const std::size_t assertion : seen_) out.seen.push_back({assertion, place_});
    const std::uint64_t key = key_of(hash, remembered);
    const bool usual = happens.kind == Happens::Kind::go && choices_.usual();
    // A state that this worker found before in the slice also precedes this one there, with its data.
    const bool fresh = !mine_.has(key) && !known.has(key);
    if (fresh || usual) {
      Step& step = out.steps.emplace_back();
      step.key = key;
      step.place = place_;
      step.usual = usual;
      if (fresh) {
        mine_.add(key, 0);
        step.roots = requested_roots(machine);
        step.watch = remembered;
        machine.forget();
        step.begin = out.packed.size();
        machine.pack(out.packed);
        step.end = out.packed.size();
      }
    }
    ++place_;
  } while (choices_.next());
  return place_ - before;
}

} // namespace director::compiler
