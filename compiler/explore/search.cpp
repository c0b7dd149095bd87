// Door: compiler/explore/search.hpp. Test: tests/compiler/explore/search_test.cpp.
//
// A state that was found is kept as its key, the state that it was found from, and which of the things that can happen
// there led to it: 24 bytes. Only states whose turn has not come are kept whole, packed. The frontier is taken slice by
// slice: all cores expand the states of a slice, then one adds what is new, in order, so that neither the number of
// cores nor their haste changes anything. Micro-steps that end as one that was taken before are counted, and not taken
// again (Machine::foresee): all that they lead to was found then.
#include "compiler/explore/search.hpp"

#include "compiler/explore/known.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <deque>
#include <map>
#include <memory>
#include <thread>
#include <utility>

namespace director::compiler {

namespace {

constexpr std::size_t slice_size = 1'024;
constexpr std::size_t most_cycles = 8;

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

  /// `played`: what was played in the slices before.
  void expand(const Packed& from, const Known& known, const Played& played, Expansion& out) {
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

  Machine machine;
  Watch watch;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> newly_played;

private:
  /// Takes it with all that the tape can be from where it is.
  void take_all(const Happens& happens, const Known& known, Expansion& out) {
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
          step.roots = roots_of(machine);
          machine.forget();
          machine.pack(step.state);
          step.state.watch = remembered;
        }
      }
      ++place_;
    } while (tape_.next());
  }

  std::vector<Happens> happens_;
  std::vector<std::size_t> seen_;
  Tape tape_;
  Known mine_;                   ///< found in this slice
  Played mine_played_{1U << 15}; ///< and played, in any
  std::uint32_t place_ = 0;      ///< of what is next
  bool moved_ = false;           ///< the machine is elsewhere than where it was loaded
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
    first.key = Machine::key(machine.print(), 0);
    machine.forget();
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
      for (std::size_t i = next++; i < count; i = next++)
        worker.expand(frontier_[i].state, known_, played_, expansions_[i]);
    };
    std::vector<std::thread> helpers;
    for (std::size_t i = 1; i < workers_.size() && count >= 64; ++i)
      helpers.emplace_back([&, i] { work(*workers_[i]); });
    work(*workers_.front());
    for (std::thread& helper : helpers) helper.join();
    remember_played();
    for (std::size_t i = 0; i < count && !cut_; ++i) {
      merge(i);
      cut_ = enough() && (i + 1 < count || frontier_.size() > count);
    }
    for (std::size_t i = 0; i < count; ++i) {
      frontier_bytes_ -= sizeof(Waiting) + frontier_.front().state.words.size() * sizeof(std::uint64_t);
      frontier_.pop_front();
    }
    out_.most_bytes = std::max(out_.most_bytes, frontier_bytes_ + known_.bytes() + played_.bytes() +
                                                    origins_.size() * (sizeof(Origin) + sizeof(Number)));
    if (options_.progress) options_.progress(origins_.size(), frontier_.size());
  }

  void remember_played() {
    const std::size_t slots = std::min(Played::most_slots, std::bit_ceil(4 * origins_.size()));
    if (slots > played_.size()) played_.grow(slots);
    for (const auto& worker : workers_) {
      for (const auto& [key, ways] : worker->newly_played) played_.add(key, ways);
      worker->newly_played.clear();
    }
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
  Played played_{1U << 10};
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
  machine.forget();
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
      tape.begin();
      do {
        found = at++ == place;
        if (at != 1) machine.again();
        const Phase phase = machine.phase();
        machine.take(happens[i], tape);
        if (found) after(machine, happens[i], phase);
      } while (!found && tape.next());
    }
    machine.forget();
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
