// Header: compiler/explore/search/search.hpp. Test: tests/compiler/explore/search/search_test.cpp.
// SPDX-License-Identifier: MIT
//
// A state that was found is kept as its key, the state that it was found from, and which of the possibilities there led
// to it. Only unexplored states are kept whole, packed. The frontier is processed slice by slice: all cores expand the
// states of a slice, then one adds what is new, in order, so that neither the number of cores nor their timing changes
// anything. Micro-steps with the same result as an earlier one are counted, and not taken again (Foresight): everything
// that they lead to was found then.
#include "compiler/explore/search/search.hpp"

#include "compiler/explore/search/frontier.hpp"
#include "compiler/explore/search/known.hpp"
#include "compiler/explore/search/worker.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <map>
#include <memory>
#include <span>
#include <thread>
#include <utility>

namespace director::compiler {

namespace {

constexpr std::size_t slice_size = 1'024;
constexpr std::size_t most_cycles = 64;

struct Origin {
  Number parent = none;
  std::uint32_t place = 0; ///< among all possibilities there
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
    first.key = key_of(machine.hash(), 0);
    first.roots = requested_roots(machine);
    machine.forget();
    Packed state;
    machine.pack(state);
    add(first, state, none);
    while (!frontier_.empty() && !cut_) take_slice();
    out_.complete = !cut_;
    out_.states = origins_.size();
    for (const auto& worker : workers_) {
      out_.happened.add(worker->watch.happened);
      unite(out_.doubted, worker->watch.doubted);
    }
    find_cycles();
    find_root_sets();
    return std::move(out_);
  }

private:
  bool enough() const { return origins_.size() >= options_.bound || (options_.only_assertions && left_ == 0); }

  Number add(const Step& step, std::span<const std::uint8_t> state, Number parent) {
    const auto number = static_cast<Number>(origins_.size());
    known_.add(step.key, number);
    origins_.push_back({parent, step.place});
    usual_.push_back(none);
    const auto [set, fresh] = set_of_.try_emplace(step.roots, static_cast<std::uint32_t>(sets_.size()));
    if (fresh) sets_.emplace_back();
    ++sets_[set->second].found;
    frontier_.push({state, step.watch, set->second});
    return number;
  }

  void take_slice() {
    frontier_.first(slice_size, slice_);
    const std::size_t count = slice_.size();
    expansions_.resize(std::max(expansions_.size(), count));
    std::atomic<std::size_t> next{0};
    const auto work = [&](Worker& worker) {
      worker.begin_slice();
      for (std::size_t i = next++; i < count; i = next++) worker.expand(slice_[i], known_, played_, expansions_[i]);
    };
    std::vector<std::thread> helpers;
    for (std::size_t i = 1; i < workers_.size() && count >= 64; ++i)
      helpers.emplace_back([&, i] { work(*workers_[i]); });
    work(*workers_.front());
    for (std::thread& helper : helpers) helper.join();
    remember_played();
    for (std::size_t i = 0; i < count && !cut_; ++i) {
      if (i + 1 < count) fetch(expansions_[i + 1]);
      merge(i);
      cut_ = enough() && (i + 1 < count || frontier_.size() > count);
    }
    frontier_.drop(count);
    out_.most_bytes = std::max(out_.most_bytes, bytes());
    if (options_.progress) options_.progress({origins_.size(), frontier_.size(), bytes()});
  }

  std::size_t bytes() const {
    return frontier_.bytes() + known_.bytes() + played_.bytes() + origins_.capacity() * sizeof(Origin) +
           usual_.capacity() * sizeof(Number);
  }

  void fetch(const Expansion& expansion) const {
    for (const Step& step : expansion.steps) known_.fetch(step.key);
  }

  void remember_played() {
    const std::size_t slots = std::min(PlayedTable::most_slots, std::bit_ceil(4 * origins_.size()));
    if (slots > played_.size()) played_.grow(slots);
    for (const auto& worker : workers_) {
      for (const auto& [key, ways] : worker->newly_played) played_.add(key, ways);
      worker->newly_played.clear();
    }
  }

  void merge(std::size_t place) {
    const Expansion& expansion = expansions_[place];
    const auto from = static_cast<Number>(out_.explored++); // they are explored in the order of discovery
    ++sets_[slice_[place].roots].explored;
    out_.micro_steps += expansion.micro_steps;
    for (const Seen& seen : expansion.seen) {
      std::optional<Way>& way = out_.seen[seen.assertion];
      if (way) continue;
      way = way_to(from);
      way->push_back(seen.place);
      --left_;
    }
    for (const Step& step : expansion.steps) {
      Number to = known_.find(step.key);
      if (to == none) to = add(step, std::span(expansion.packed).subspan(step.begin, step.end - step.begin), from);
      if (step.usual) usual_[from] = to;
    }
  }

  Way way_to(Number number) const {
    Way way;
    for (; origins_[number].parent != none; number = origins_[number].parent) way.push_back(origins_[number].place);
    std::reverse(way.begin(), way.end());
    return way;
  }

  /// With the usual answer of every body, each state has at most one successor.
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

  void find_root_sets() {
    for (const auto& [roots, at] : set_of_) {
      RootSet& set = out_.root_sets.emplace_back(std::move(sets_[at]));
      for (Index e = 0; e < ground_.tables.root_edges && e < 64; ++e) {
        if ((roots >> e & 1) != 0) set.roots.push_back(e);
      }
    }
  }

  const Ground& ground_;
  const SearchOptions& options_;
  std::vector<std::unique_ptr<Worker>> workers_;
  Known known_;
  PlayedTable played_{1U << 10};
  std::vector<Origin> origins_; ///< state
  std::vector<Number> usual_;   ///< state: its successor if bodies give their usual answers
  Frontier frontier_;
  std::vector<Waiting> slice_; ///< its first states
  std::vector<Expansion> expansions_;
  std::map<std::uint64_t, std::uint32_t> set_of_; ///< roots that are requested: row of sets_
  std::vector<RootSet> sets_;
  std::size_t left_ = 0;
  bool cut_ = false; ///< it ended before everything was explored
  Searched out_;
};

/// The assertions in groups that one Watch can check.
std::vector<std::vector<std::size_t>> groups_of(const Model& model, const std::vector<std::size_t>& assertions) {
  std::vector<std::vector<std::size_t>> out(1);
  std::size_t soft = 0;
  for (const std::size_t at : assertions) {
    if (model.assertions[at].kind != Assertion::Kind::soft) {
      out.front().push_back(at);
      continue;
    }
    const std::size_t group = soft++ / most_soft;
    if (group == out.size()) out.emplace_back();
    out[group].push_back(at);
  }
  return out;
}

} // namespace

Searched search(const Ground& ground, const SearchOptions& options) {
  const std::vector<std::vector<std::size_t>> groups = groups_of(ground.model, options.assertions);
  if (groups.size() == 1) return Search(ground, options).run();
  SearchOptions part = options;
  part.assertions = groups.front();
  Searched out = Search(ground, part).run();
  const auto decides = [&](const std::vector<std::size_t>& group, bool complete) {
    return complete || std::all_of(group.begin(), group.end(), [&](std::size_t at) { return out.seen[at]; });
  };
  bool complete = options.only_assertions ? decides(groups.front(), out.complete) : out.complete;
  part.only_assertions = true;
  for (std::size_t i = 1; i < groups.size(); ++i) {
    part.assertions = groups[i];
    Searched more = Search(ground, part).run();
    for (const std::size_t at : groups[i]) out.seen[at] = std::move(more.seen[at]);
    complete = complete && decides(groups[i], more.complete);
  }
  out.complete = complete;
  return out;
}

} // namespace director::compiler
