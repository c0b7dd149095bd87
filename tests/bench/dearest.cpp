// Header: tests/bench/dearest.hpp. Test: tests/bench/dearest_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/bench/dearest.hpp"

#include "compiler/analysis/plans/bounds.hpp"
#include "compiler/analysis/plans/work.hpp"
#include "tests/bench/texts.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

namespace bench {

using director::Index;
using director::Input;

namespace {

constexpr int replays = 3;
constexpr std::uint64_t some_work = 20;          ///< with less, a micro-step spends most of its time on other things
constexpr std::size_t most_micro_steps = 10'000; ///< after one input

using Clock = std::chrono::steady_clock;

double nanoseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::nano>(Clock::now() - begin).count();
}

struct MicroStep {
  std::uint64_t work = 0;
  double nanoseconds = std::numeric_limits<double>::max();
};

/// Repeats the same inputs; for each micro-step the least time counts.
std::vector<MicroStep> wander(const Search& search, std::uint64_t seed) {
  std::vector<MicroStep> out;
  for (int replay = 0; replay < replays; ++replay) {
    Wanderer wanderer(search.compile(seed), seed);
    std::size_t at = 0;
    for (std::size_t i = 0; i < search.inputs; ++i) {
      wanderer.post();
      bool more = true;
      for (std::size_t left = most_micro_steps; more && left > 0; --left, ++at) {
        const std::uint64_t work = wanderer.work();
        const Clock::time_point begin = Clock::now();
        more = wanderer.micro_step();
        const double took = nanoseconds_since(begin);
        if (replay == 0) out.emplace_back().work = wanderer.work() - work;
        out[at].nanoseconds = std::min(out[at].nanoseconds, took);
      }
    }
  }
  return out;
}

} // namespace

Wanderer::Wanderer(Compiled compiled, std::uint64_t seed)
    : robot_(std::move(compiled), 64, Play::at_random),
      random_(seed) {
  const director::compiler::Model& model = robot_.model();
  for (const director::compiler::StateId id : model.states.ids()) {
    if (model.states[id].external) externals_.push_back(static_cast<Index>(id.value));
  }
  for (Index edge = 0; edge < model.roots.size(); ++edge) roots_.push_back(edge);
  for (const director::compiler::TriggerId id : model.triggers.ids()) triggers_.push_back(static_cast<Index>(id.value));
}

Input Wanderer::draw() {
  const std::uint32_t kind = random_.below(100);
  if (kind < 55 && !externals_.empty()) {
    const Index state = externals_[random_.below(externals_.size())];
    const director::compiler::State& row = robot_.model().states[director::compiler::StateId{state}];
    Input out{.kind = Input::Kind::set, .thing = state};
    out.value = static_cast<std::int32_t>(row.low + random_.below(static_cast<std::size_t>(row.high - row.low + 1)));
    return out;
  }
  if (kind < 60 && !triggers_.empty())
    return {.kind = Input::Kind::fire, .thing = triggers_[random_.below(triggers_.size())]};
  const Index root = roots_[random_.below(roots_.size())];
  if (kind < 65) {
    const auto provider = random_.below(robot_.model().providers.size());
    return {.kind = random_.percent(70) ? Input::Kind::enable : Input::Kind::disable, .thing = provider};
  }
  if (kind < 75) return {.kind = Input::Kind::cancel, .thing = root};
  const director::Range levels = robot_.engine().tables().edges[root].levels;
  return robot_.request(root, random_.below(levels.size()));
}

void Wanderer::post() {
  now_ += random_.below(50'000);
  robot_.post(draw());
}

bool Wanderer::micro_step() { return robot_.micro_step(now_); }

Dearest find_dearest(const Search& search) {
  Dearest out;
  double time = 0, work = 0;
  for (std::uint64_t seed = 1; seed <= search.seeds; ++seed) {
    const Compiled compiled = search.compile(seed);
    const auto bounds = director::analysis::find_bounds(compiled.model, compiled.lowered.view());
    const auto bound = static_cast<std::uint64_t>(bounds.work_in_a_micro_step);
    for (const MicroStep& each : wander(search, seed)) {
      ++out.micro_steps;
      out.nanoseconds = std::max(out.nanoseconds, each.nanoseconds);
      if (const double share = static_cast<double>(each.work) / static_cast<double>(bound); share > out.share) {
        out.share = share;
        out.work = each.work;
        out.work_bound = bound;
      }
      if (each.work < some_work) continue;
      time += each.nanoseconds;
      work += static_cast<double>(each.work);
    }
  }
  out.nanoseconds_of_work = work > 0 ? time / work : 0;
  out.nanoseconds_bound = static_cast<double>(out.work_bound) * director::analysis::nanoseconds_of_work;
  return out;
}

const std::vector<Search>& searches() {
  static const std::vector<Search> all = [] {
    const auto file = [](const char* path) { return [path](std::uint64_t) { return compile_file(path); }; };
    std::vector<Search> out{
        {"dearest/soccer", "behaviours/soccer", file("behaviours/soccer/soccer.yaml"), 20, 5'000},
        {"dearest/robocup", "behaviours/robocup", file("behaviours/robocup/robocup.yaml"), 10, 5'000}};
    for (const std::size_t groups : {20U, 60U, 200U, 400U}) {
      const std::string count = std::to_string(groups);
      out.push_back({"dearest/random/" + count, "random behaviours of " + count + " groups",
                     [groups](std::uint64_t seed) { return compile_text(random_behaviour(groups, seed)); },
                     std::size_t{groups} <= 60 ? 20U : 5U, 200'000 / (groups * 5)});
    }
    out.push_back({"dearest/wide", "50 units of 4 members with 10 providers each",
                   [](std::uint64_t) { return compile_text(wide_units(50)); }, 2, 1'000});
    return out;
  }();
  return all;
}

} // namespace bench
