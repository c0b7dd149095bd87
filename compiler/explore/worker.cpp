// Door: compiler/explore/worker.hpp. Test: tests/compiler/explore/search_test.cpp.
#include "compiler/explore/worker.hpp"

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

void Worker::expand(const Packed& from, const Known& known, const Played& played, Expansion& out) {
  out.steps.clear();
  out.seen.clear();
  machine.unpack(from);
  watch.before(machine, from.watch);
  machine.list(happens_);
  place_ = 0;
  moved_ = false;
  const Print print = machine.print();
  for (const Happens& happens : happens_) {
    const Choices choices = machine.choices(happens);
    if (choices.answers == 0) {
      tape_.begin();
      take_all(happens, known, out);
    }
    for (std::size_t answer = 0; answer < choices.answers; ++answer) {
      for (std::size_t puts = 0; puts < choices.puts.size(); ++puts) {
        const std::uint64_t key = machine.foresee(print, from.watch, choices, answer, puts, watch.minds_puts());
        const bool usual = choices.body && answer == 0 && puts == 0;
        std::size_t ways = usual ? 0 : mine_played_.find(key);
        if (ways == 0 && !usual) ways = played.find(key);
        if (ways != 0) {
          place_ += static_cast<std::uint32_t>(ways);
          continue;
        }
        const std::uint32_t before = place_;
        choices.body ? tape_.begin({answer, puts}) : tape_.begin();
        take_all(happens, known, out);
        mine_played_.add(key, place_ - before);
        newly_played.emplace_back(key, place_ - before);
      }
    }
  }
  out.micro_steps = place_;
}

void Worker::take_all(const Happens& happens, const Known& known, Expansion& out) {
  do {
    if (moved_) machine.again();
    moved_ = true;
    machine.take(happens, tape_);
    seen_.clear();
    const std::uint64_t remembered = watch.after(machine, seen_);
    for (const std::size_t assertion : seen_) out.seen.push_back({assertion, place_});
    const std::uint64_t key = Machine::key(machine.print(), remembered);
    const bool usual = happens.kind == Happens::Kind::go && tape_.usual();
    // What this worker found before in the slice stands before this in it, too, and with its state.
    const bool fresh = known.find(key) == none && mine_.find(key) == none;
    if (fresh || usual) {
      Step& step = out.steps.emplace_back();
      step.key = key;
      step.place = place_;
      step.usual = usual;
      if (fresh) {
        mine_.add(key, 0);
        step.roots = requested_roots(machine);
        machine.forget();
        machine.pack(step.state);
        step.state.watch = remembered;
      }
    }
    ++place_;
  } while (tape_.next());
}

} // namespace director::compiler
