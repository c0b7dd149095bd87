// Header: tests/property/long_game.hpp. Test: tests/property/long_game_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/long_game.hpp"

#include "runtime/core/engine/engine.hpp"
#include "runtime/hosted/engine_memory.hpp"
#include "tests/property/random.hpp"
#include "tests/support/numbers_of_event.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>

namespace director::property {

namespace {

constexpr int inputs = 300;             ///< inputs of a game
constexpr int most_for_one_input = 100; ///< micro-steps for one input: bodies may run each other without end
constexpr Time millisecond = 1'000'000;

std::int32_t any_value(const compiler::State& state, Random& random) {
  return static_cast<std::int32_t>(
      state.low + static_cast<std::int64_t>(random.below(static_cast<std::size_t>(state.high - state.low + 1))));
}

/// The bodies of one game: a function of the game, of the body, and of how often it ran.
class RandomBodies {
public:
  RandomBodies(const compiler::Model& model, const Tables& tables, std::uint64_t seed)
      : model_(model),
        tables_(tables),
        seed_(seed),
        calls_(tables.providers.size() + tables.groups.size()) {}

  Bodies functions() {
    Bodies out;
    out.self = this;
    out.run = [](void* self, Run& run) { return static_cast<RandomBodies*>(self)->run(run); };
    out.start = [](void* self, Handling& handling) {
      RandomBodies& bodies = *static_cast<RandomBodies*>(self);
      bodies.handle(handling, bodies.row_of(handling).start);
    };
    out.stop = [](void* self, Handling& handling) {
      RandomBodies& bodies = *static_cast<RandomBodies*>(self);
      bodies.handle(handling, bodies.row_of(handling).stop);
    };
    return out;
  }

private:
  const compiler::Group& row_of(const Handling& handling) const {
    return model_.groups[compiler::GroupId{handling.group()}];
  }

  /// The random numbers for one call of this body.
  Random random(std::size_t body) { return Random(seed_ * 7'919 + body * 104'729 + ++calls_[body]); }

  Outcome run(Run& run) {
    const compiler::Provider& provider = model_.providers[compiler::ProviderId{run.provider()}];
    Random random = this->random(run.provider());
    set_some(run, provider.causing, random);
    set_some(run, provider.sets, random);
    const std::size_t answer = random.below(100);
    if (random.chance(0.07)) run.wait(random.one_of({10, 25, 50}) * millisecond);
    if (answer < 4) return run.done();
    if (answer < 6) return run.fail();
    if (answer < 30) return run.keep();
    if (provider.packs.empty()) return run.pack();
    for (const compiler::Task& task : random.one_of(provider.packs).tasks) {
      if (!random.chance(0.85)) continue;
      const auto edge = static_cast<Index>(task.edge.value);
      const Range levels = tables_.edges[edge].levels;
      run.request(edge, static_cast<Index>(levels.begin + random.below(levels.size())), random.chance(0.2));
    }
    return run.pack();
  }

  void handle(Handling& handling, const std::optional<compiler::Handler>& handler) {
    if (!handler) return; // it only owns states
    Random random = this->random(tables_.providers.size() + handling.group());
    set_some(handling, handler->sets, random);
  }

  void set_some(auto& context, const std::vector<compiler::ConditionUse>& uses, Random& random) const {
    for (const compiler::ConditionUse& use : uses) {
      if (!random.chance(0.3)) continue;
      const compiler::Condition& condition = model_.conditions[use.id];
      context.set(static_cast<Index>(condition.state.value),
                  condition.operands.empty() ? any_value(model_.states[condition.state], random)
                                             : static_cast<std::int32_t>(random.one_of(condition.operands)));
    }
  }

  const compiler::Model& model_;
  const Tables& tables_;
  const std::uint64_t seed_;
  std::vector<std::uint64_t> calls_; ///< for each provider's body, then for each group's handlers
};

/// One of the two engines.
class Player {
public:
  Player(const Compiled& compiled, std::uint64_t seed, Index most_decided_whole)
      : tables_(compiled.lowered.view()),
        bodies_(compiled.model, tables_, seed),
        cells_(64),
        inbox_(cells_),
        memory_(tables_),
        engine_(tables_, memory_.state().data(), bodies_.functions(), inbox_, observer()) {
    engine_.set_most_decided_whole(most_decided_whole);
    engine_.set_budget(1);
  }
  void post(std::span<const Input> records) {
    if (!engine_.post(records)) throw std::logic_error("the inbox is full");
  }
  bool micro_step(Time now) {
    events.clear();
    return engine_.step(now) == StepResult::budget_exhausted;
  }
  void forget_trail() { engine_.forget_trail(); }
  const Engine& engine() const { return engine_; }
  const Tables& tables() const { return tables_; }

  std::vector<tests::EventNumbers> events; ///< events of the last micro-step

private:
  Observer observer() {
    return {[](void* self, const Event& event) {
              static_cast<Player*>(self)->events.push_back(tests::numbers_of(event, 0));
            },
            this};
  }

  const Tables tables_;
  RandomBodies bodies_;
  std::vector<Inbox::Cell> cells_;
  Inbox inbox_;
  EngineMemory memory_;
  Engine engine_;
};

/// The records of one input.
std::vector<Input> draw(const compiler::Model& model, const Tables& tables, Random& random) {
  std::vector<Index> externals;
  for (const compiler::StateId id : model.states.ids()) {
    if (model.states[id].external) externals.push_back(static_cast<Index>(id.value));
  }
  const std::size_t kind = random.below(100);
  if (kind < 45) {
    std::vector<Input> out;
    for (const Index state : random.some(externals, 1, 2)) {
      out.push_back({.kind = Input::Kind::set, .more = true, .thing = state});
      out.back().value = any_value(model.states[compiler::StateId{state}], random);
    }
    out.back().more = false;
    return out;
  }
  Input out;
  if (kind < 50 && !model.triggers.empty()) {
    out.kind = Input::Kind::fire;
    out.thing = static_cast<Index>(random.below(model.triggers.size()));
  } else if (kind < 58) {
    out.kind = random.chance(0.65) ? Input::Kind::enable : Input::Kind::disable;
    out.thing = static_cast<Index>(random.below(model.providers.size()));
  } else if (kind < 68) {
    out.kind = Input::Kind::cancel;
    out.thing = static_cast<Index>(random.below(model.roots.size()));
  } else {
    out.kind = Input::Kind::request;
    out.thing = static_cast<Index>(random.below(model.roots.size()));
    const Range levels = tables.edges[out.thing].levels;
    out.set_level(static_cast<Index>(levels.begin + random.below(levels.size())));
  }
  return {out};
}

std::string name(Index row) { return row == nil ? "-" : std::to_string(row); }

/// The state in which both have to agree, line by line.
std::vector<std::string> lines_of(const Player& player) {
  const State& s = player.engine().memory();
  const Tables& t = player.tables();
  std::vector<std::string> out;
  for (Index g = 0; g < t.groups.size(); ++g) {
    const GroupAssignment& at = s.last[g];
    std::string line = "group " + std::to_string(g) + " holder " + name(at.holder) + " active " + name(at.active) +
                       " planned " + name(at.planned) + " flags " + std::to_string(at.flags) + " push " +
                       name(at.push.edge) + " " + name(at.push.provider) + " " + name(at.push.condition) + " pending " +
                       std::to_string(s.run_queue[g].pending) + " plan";
    for (const Index slot : t.groups[g].slots.rows()) line += " " + name(s.last.plan[slot]);
    if (at.holder != nil) line += " place " + std::to_string(s.place[g]);
    out.push_back(line);
  }
  for (Index e = 0; e < t.edges.size(); ++e) {
    if (s.request[e].level == nil) continue;
    out.push_back("edge " + std::to_string(e) + " level " + name(s.request[e].level) + " stamp " +
                  std::to_string(s.request[e].stamp) + " queued " + std::to_string(static_cast<int>(s.queued[e].why)) +
                  " " + name(s.queued[e].condition));
  }
  std::string queue = "queue";
  for (Index g = s.counters->queue_first; g != nil; g = s.run_queue[g].runs_before) queue += " " + name(g);
  out.push_back(queue);
  return out;
}

bool same(const Player& a, const Player& b) {
  if (a.events != b.events) return false;
  const State &x = a.engine().memory(), &y = b.engine().memory();
  const Tables& t = a.tables();
  for (Index g = 0; g < t.groups.size(); ++g) {
    if (!(x.last[g] == y.last[g]) || x.run_queue[g].pending != y.run_queue[g].pending ||
        x.run_queue[g].runs_before != y.run_queue[g].runs_before ||
        (x.last[g].holder != nil && x.place[g] != y.place[g]))
      return false;
  }
  for (Index slot = 0; slot < t.plan_groups.size(); ++slot) {
    if (x.last.plan[slot] != y.last.plan[slot]) return false;
  }
  for (Index e = 0; e < t.edges.size(); ++e) {
    if (x.request[e].level != y.request[e].level) return false;
    if (x.request[e].level == nil) continue;
    if (x.request[e].stamp != y.request[e].stamp || !(x.queued[e] == y.queued[e])) return false;
  }
  return x.counters->queue_first == y.counters->queue_first && x.counters->micro_step == y.counters->micro_step;
}

std::string difference(const Player& followed, const Player& whole) {
  const std::vector<std::string> a = lines_of(followed), b = lines_of(whole);
  std::string out = "micro-steps " + std::to_string(followed.engine().micro_steps()) + " and " +
                    std::to_string(whole.engine().micro_steps()) + "\n";
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const std::string left = i < a.size() ? a[i] : "", right = i < b.size() ? b[i] : "";
    if (left != right) out += "  again: " + left + "\n  whole: " + right + "\n";
  }
  if (followed.events != whole.events) out += "  observers get other events\n";
  return out;
}

} // namespace

std::string decided_otherwise(const Compiled& compiled, std::uint64_t seed, std::uint64_t& micro_steps) {
  Player followed(compiled, seed, 0), whole(compiled, seed, nil);
  Random random(seed);
  Time now = 0;
  for (int i = 0; i < inputs; ++i) {
    now += random.between(0, 20) * millisecond;
    for (int more = random.chance(0.15) ? 2 : 1; more > 0; --more) {
      const std::vector<Input> input = draw(compiled.model, followed.tables(), random);
      followed.post(input), whole.post(input);
    }
    for (int left = most_for_one_input; left > 0; --left) {
      ++micro_steps;
      if (random.chance(0.03)) followed.forget_trail(); // as after a state is loaded
      const bool goes_on = followed.micro_step(now);
      if (goes_on != whole.micro_step(now) || !same(followed, whole))
        return "after input " + std::to_string(i + 1) + ", in micro-step " +
               std::to_string(whole.engine().micro_steps()) + "\n" + difference(followed, whole);
      if (!goes_on) break;
    }
  }
  return "";
}

} // namespace director::property
