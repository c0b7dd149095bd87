// Door: compiler/explore/search.hpp. Test: tests/compiler/explore/search_test.cpp.
//
// A state that was found is kept as its key, the state that it was found from, and which of the things that can happen
// there led to it: 24 bytes. Only states whose turn has not come are kept whole, packed. The frontier is taken slice by
// slice: all cores expand the states of a slice, then one adds what is new, in order, so that neither the number of
// cores nor their haste changes anything.
#include "compiler/explore/search.hpp"

#include <algorithm>
#include <atomic>
#include <deque>
#include <map>
#include <memory>
#include <thread>

namespace director::compiler {

namespace {

using Number = std::uint32_t;
constexpr Number none = static_cast<Number>(-1);
constexpr std::size_t slice_size = 1'024;
constexpr std::size_t most_cycles = 8;

/// Key -> number, by open addressing; at most half full.
class Known {
public:
  Known() : slots_(1U << 12) {}
  Number find(std::uint64_t key) const {
    for (std::size_t at = key & mask();; at = (at + 1) & mask()) {
      if (slots_[at].key == key || slots_[at].key == 0) return slots_[at].key == 0 ? none : slots_[at].number;
    }
  }
  void add(std::uint64_t key, Number number) {
    if (++count_ * 2 > slots_.size()) grow();
    put(key, number);
  }
  void clear() {
    std::fill(slots_.begin(), slots_.end(), Slot{});
    count_ = 0;
  }
  std::size_t bytes() const { return slots_.size() * sizeof(Slot); }

private:
  struct Slot {
    std::uint64_t key = 0;
    Number number = none;
  };
  std::size_t mask() const { return slots_.size() - 1; }
  void put(std::uint64_t key, Number number) {
    std::size_t at = key & mask();
    while (slots_[at].key != 0) at = (at + 1) & mask();
    slots_[at] = {key, number};
  }
  void grow() {
    std::vector<Slot> old(slots_.size() * 2);
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.key != 0) put(slot.key, slot.number);
    }
  }
  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

struct Origin {
  Number parent = none;
  std::uint32_t place = 0; ///< among all that can happen there
};

struct Step {
  std::uint64_t key = 0;
  std::uint32_t place = 0;
  bool usual = false; ///< no input, and every body does what is usual
  std::uint64_t roots = 0;
  Packed state; ///< empty where it was known
};

struct Seen {
  std::size_t assertion = 0;
  std::uint32_t place = 0;
};

struct Expansion {
  std::vector<Step> steps;
  std::vector<Seen> seen;
  std::size_t micro_steps = 0;
};

std::uint64_t roots_of(const Machine& machine) {
  std::uint64_t out = 0;
  const Index count = std::min<Index>(machine.ground().tables.root_edges, 64);
  for (Index e = 0; e < count; ++e) {
    if (machine.engine().state(e) != RunState::none) out |= std::uint64_t{1} << e;
  }
  return out;
}

class Worker {
public:
  Worker(const Ground& ground, const SearchOptions& options)
      : machine(ground, options.breadth),
        watch(ground, options.assertions) {}

  void begin_slice() { mine_.clear(); }

  void expand(const Packed& from, const Known& known, Expansion& out) {
    out.steps.clear();
    out.seen.clear();
    machine.unpack(from);
    watch.before(machine, from.watch);
    machine.list(happens_);
    std::uint32_t place = 0;
    for (const Happens& happens : happens_) {
      tape_.clear();
      do {
        if (place != 0) machine.again();
        machine.take(happens, tape_);
        seen_.clear();
        const std::uint64_t remembered = watch.after(machine, seen_);
        for (const std::size_t assertion : seen_) out.seen.push_back({assertion, place});
        Step step;
        step.key = machine.key(remembered);
        step.place = place;
        step.usual = happens.kind == Happens::Kind::go && tape_.usual();
        // What this worker found before in the slice stands before this in it, too, and with its state.
        const bool fresh = known.find(step.key) == none && mine_.find(step.key) == none;
        if (fresh) {
          mine_.add(step.key, 0);
          machine.pack(step.state);
          step.state.watch = remembered;
          step.roots = roots_of(machine);
        }
        if (fresh || step.usual) out.steps.push_back(std::move(step));
        ++place;
      } while (tape_.next());
    }
    out.micro_steps = place;
  }

  Machine machine;
  Watch watch;

private:
  std::vector<Happens> happens_;
  std::vector<std::size_t> seen_;
  Tape tape_;
  Known mine_; ///< found in this slice
};

class Search {
public:
  Search(const Ground& ground, const SearchOptions& options) : ground_(ground), options_(options), out_(ground.tables) {
    unsigned threads = options.threads != 0 ? options.threads : std::thread::hardware_concurrency();
    threads = std::max(threads, 1U);
    for (unsigned i = 0; i < threads; ++i) workers_.push_back(std::make_unique<Worker>(ground, options));
    out_.breadth = options.breadth;
    out_.seen.resize(ground.model.assertions.size());
    left_ = options.assertions.size();
  }

  Searched run() {
    Machine& machine = workers_.front()->machine;
    machine.start();
    Step first;
    first.key = machine.key(0);
    machine.pack(first.state);
    first.roots = roots_of(machine);
    add(std::move(first), none);
    while (!frontier_.empty() && !cut_) take_slice();
    out_.complete = !cut_;
    out_.states = origins_.size();
    for (const auto& worker : workers_) out_.happened.add(worker->watch.happened);
    find_cycles();
    for (auto& [roots, set] : root_sets_) {
      for (Index e = 0; e < ground_.tables.root_edges && e < 64; ++e) {
        if ((roots >> e & 1) != 0) set.roots.push_back(e);
      }
      out_.root_sets.push_back(std::move(set));
    }
    return std::move(out_);
  }

private:
  bool enough() const { return origins_.size() >= options_.bound || (options_.only_assertions && left_ == 0); }

  Number add(Step step, Number parent) {
    const auto number = static_cast<Number>(origins_.size());
    known_.add(step.key, number);
    origins_.push_back({parent, step.place});
    usual_.push_back(none);
    RootSet& set = root_sets_[step.roots];
    ++set.found;
    frontier_bytes_ += sizeof(Waiting) + step.state.words.size() * sizeof(std::uint64_t);
    frontier_.push_back({std::move(step.state), number, &set});
    return number;
  }

  void take_slice() {
    const std::size_t count = std::min(frontier_.size(), slice_size);
    expansions_.resize(std::max(expansions_.size(), count));
    std::atomic<std::size_t> next{0};
    const auto work = [&](Worker& worker) {
      worker.begin_slice();
      for (std::size_t i = next++; i < count; i = next++) worker.expand(frontier_[i].state, known_, expansions_[i]);
    };
    std::vector<std::thread> helpers;
    for (std::size_t i = 1; i < workers_.size() && count >= 64; ++i)
      helpers.emplace_back([&, i] { work(*workers_[i]); });
    work(*workers_.front());
    for (std::thread& helper : helpers) helper.join();
    for (std::size_t i = 0; i < count && !cut_; ++i) {
      merge(i);
      cut_ = enough() && (i + 1 < count || frontier_.size() > count);
    }
    for (std::size_t i = 0; i < count; ++i) {
      frontier_bytes_ -= sizeof(Waiting) + frontier_.front().state.words.size() * sizeof(std::uint64_t);
      frontier_.pop_front();
    }
    out_.most_bytes = std::max(out_.most_bytes,
                               frontier_bytes_ + known_.bytes() + origins_.size() * (sizeof(Origin) + sizeof(Number)));
    if (options_.progress) options_.progress(origins_.size(), frontier_.size());
  }

  void merge(std::size_t place) {
    const Number from = frontier_[place].number;
    ++frontier_[place].set->explored;
    ++out_.explored;
    out_.micro_steps += expansions_[place].micro_steps;
    for (const Seen& seen : expansions_[place].seen) {
      std::optional<Way>& way = out_.seen[seen.assertion];
      if (way) continue;
      way = way_to(from);
      way->push_back(seen.place);
      --left_;
    }
    for (Step& step : expansions_[place].steps) {
      const bool usual = step.usual;
      Number to = known_.find(step.key);
      if (to == none) to = add(std::move(step), from);
      if (usual) usual_[from] = to;
    }
  }

  Way way_to(Number number) const {
    Way way;
    for (; origins_[number].parent != none; number = origins_[number].parent) way.push_back(origins_[number].place);
    std::reverse(way.begin(), way.end());
    return way;
  }

  /// Where every body does what is usual, each state has one follower at most.
  void find_cycles() {
    std::vector<Number> visit(origins_.size(), none);
    for (Number start = 0; start < origins_.size() && out_.cycles.size() < most_cycles; ++start) {
      Number at = start;
      while (at != none && visit[at] == none) {
        visit[at] = start;
        at = usual_[at];
      }
      if (at == none || visit[at] != start) continue;
      Searched::Cycle cycle;
      cycle.way = way_to(at);
      Number around = at;
      do {
        ++cycle.length;
        around = usual_[around];
      } while (around != at);
      out_.cycles.push_back(std::move(cycle));
    }
  }

  struct Waiting {
    Packed state;
    Number number = 0;
    RootSet* set = nullptr;
  };

  const Ground& ground_;
  const SearchOptions& options_;
  std::vector<std::unique_ptr<Worker>> workers_;
  Known known_;
  std::vector<Origin> origins_;
  std::vector<Number> usual_;
  std::deque<Waiting> frontier_;
  std::vector<Expansion> expansions_;
  std::map<std::uint64_t, RootSet> root_sets_;
  std::size_t frontier_bytes_ = 0, left_ = 0;
  bool cut_ = false; ///< it ended before everything was explored
  Searched out_;
};

} // namespace

Searched search(const Ground& ground, const SearchOptions& options) { return Search(ground, options).run(); }

namespace {

/// Plays a way again, from the start without a break; `before` and `after` are called around each micro-step of it.
template <class Before, class After>
void replay(const Ground& ground, const Way& way, Breadth breadth, Before&& before, After&& after) {
  Machine machine(ground, breadth);
  machine.start();
  machine.key(0);
  std::vector<Happens> happens;
  Packed here;
  Tape tape;
  for (const std::uint32_t place : way) {
    machine.pack(here);
    machine.unpack(here);
    machine.list(happens);
    before(machine);
    std::uint32_t at = 0;
    bool found = false;
    for (std::size_t i = 0; i < happens.size() && !found; ++i) {
      tape.clear();
      do {
        found = at++ == place;
        if (at != 1) machine.again();
        const Phase phase = machine.phase();
        machine.take(happens[i], tape);
        if (found) after(machine, happens[i], phase);
      } while (!found && tape.next());
    }
    machine.key(0);
  }
}

} // namespace

std::vector<Taken> follow(const Ground& ground, const Way& way, Breadth breadth) {
  std::vector<Taken> out;
  replay(
      ground, way, breadth, [](const Machine&) {},
      [&](const Machine& machine, const Happens& happens, Phase before) {
        out.push_back({happens, machine.deeds(), before, machine.phase()});
      });
  return out;
}

bool shows(const Ground& ground, const Way& way, Breadth breadth, std::size_t assertion, bool strict) {
  Watch watch(ground, {assertion}, strict);
  std::uint64_t remembered = 0;
  std::vector<std::size_t> seen;
  replay(
      ground, way, breadth, [&](const Machine& machine) { watch.before(machine, remembered); },
      [&](const Machine& machine, const Happens&, Phase) {
        seen.clear();
        remembered = watch.after(machine, seen);
      });
  return !seen.empty();
}

} // namespace director::compiler
