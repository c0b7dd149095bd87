// Door: compiler/explore/search.hpp. Test: tests/compiler/explore/search_test.cpp.
//
// A state that was found is kept as its key, the state that it was found from, and which of the things that can happen
// there led to it: 24 bytes. Only states whose turn has not come are kept whole, packed. The frontier is taken slice by
// slice: all cores expand the states of a slice, then one adds what is new, in order, so that neither the number of
// cores nor their haste changes anything. Micro-steps that end as one that was taken before are counted, and not taken
// again (Machine::foresee): all that they lead to was found then.
#include "compiler/explore/search.hpp"

#include "compiler/explore/known.hpp"
#include "compiler/explore/worker.hpp"

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
    first.roots = requested_roots(machine);
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

} // namespace director::compiler
