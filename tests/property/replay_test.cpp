// SPDX-License-Identifier: MIT
// Replays of random scenarios: the same behaviour decides the same. Another one differs at the same place as the
// scenario played on it.
//
//   DIRECTOR_SEED, DIRECTOR_CASES   as in property_test.cpp
#include "compiler/lower/row_names.hpp"
#include "compiler/play/input_records.hpp"
#include "compiler/play/play.hpp"
#include "compiler/play/scripted_bodies.hpp"
#include "compiler/trace/lookup.hpp"
#include "compiler/trace/replay.hpp"
#include "compiler/trace/trace_order.hpp"
#include "runtime/core/engine/engine.hpp"
#include "runtime/hosted/engine_memory.hpp"
#include "runtime/hosted/trace/json_lines.hpp"
#include "tests/property/compiled.hpp"
#include "tests/property/generate.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace {

using namespace director::property;
using director::tests::from_environment;

/// Events, a line each.
struct Tape {
  director::Names names;
  std::string text;

  director::Observer observer() {
    return {[](void* self, const director::Event& event) {
              auto& to = *static_cast<Tape*>(self);
              director::append_event(event, to.names, to.text);
              to.text += '\n';
            },
            this};
  }
};

/// All events of the scenario.
std::string record(const Compiled& compiled) {
  const director::compiler::RowNames rows(compiled.model, compiled.lowered);
  Tape tape{rows.names(), {}};
  director::compiler::PlayOptions options;
  options.events = tape.observer();
  director::compiler::play(compiled.scenario, compiled.model, compiled.lowered, options,
                           [](const director::compiler::Happening&) {});
  return tape.text;
}

/// The same inputs in steps of at most a few micro-steps each: inputs come while others, timers and what handlers set
/// are still waiting, and a step is given a time at which several timers are late. `early`: counts steps that first
/// take what handlers set, and whose time is later than that of the timers before because an input waits.
std::string record_in_short_steps(const Compiled& compiled, Random& random, std::size_t& early) {
  const director::compiler::RowNames rows(compiled.model, compiled.lowered);
  Tape tape{rows.names(), {}};
  const director::Tables tables = compiled.lowered.view();
  director::compiler::ScriptedBodies bodies(compiled.scenario, tables);
  std::vector<director::Inbox::Cell> cells(1024);
  director::Inbox inbox(cells);
  director::EngineMemory memory(tables);
  director::Engine engine(tables, memory.state().data(), bodies.table(), inbox, tape.observer());
  for (const director::compiler::Setting& given : compiled.scenario.given)
    engine.preset(static_cast<director::Index>(given.state.value), static_cast<std::int32_t>(given.value));
  director::Time now = 0;
  const auto step = [&] {
    const director::Counters& counters = *engine.memory().counters;
    if (engine.inputs_wait() && counters.staged_count != 0 && counters.now < now) ++early;
    engine.set_budget(static_cast<std::uint32_t>(random.between(1, 3)));
    return engine.step(now);
  };
  step();
  for (const director::compiler::ScenarioStep& each : compiled.scenario.steps) {
    if (each.advance) now += *each.advance;
    for (const director::compiler::ScenarioInput& input : each.inputs) {
      now += random.between(0, 60) * 1'000;
      if (random.chance(0.7)) step();
      inbox.post(input_records(input, tables, bodies.data()));
    }
    for (int count = random.between(0, 3); count > 0; --count) step();
  }
  for (int left = 1000; left > 0 && step() == director::StepResult::budget_exhausted; --left) {}
  return tape.text;
}

director::compiler::Replayed replay(const std::string& recorded, const Compiled& compiled) {
  const director::compiler::RowNames rows(compiled.model, compiled.lowered);
  director::compiler::TraceLines lines(recorded);
  return director::compiler::replay(lines, compiled.model, rows.names());
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    out.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return out;
}

/// Reads each line and writes it again.
std::string written_again(const std::string& recorded, const Compiled& compiled) {
  const director::compiler::RowNames rows(compiled.model, compiled.lowered);
  const director::Names names = rows.names();
  const director::compiler::Lookup lookup(names);
  director::compiler::TraceLines lines(recorded);
  std::string out;
  while (const auto line = lines.next()) {
    director::append_event(lookup.event(line->json).event, names, out);
    out += '\n';
  }
  return out;
}

/// What `directorc trace` would say of the order of these lines.
std::string order_problem(const std::string& recorded, const Compiled& compiled) {
  const director::compiler::RowNames rows(compiled.model, compiled.lowered);
  const director::Names names = rows.names();
  const director::compiler::Lookup lookup(names);
  director::compiler::TraceLines lines(recorded);
  director::compiler::TraceOrder order;
  std::string out;
  while (const auto line = lines.next()) out += order.problem_of(lookup.event(line->json).event);
  return out;
}

/// Changes one priority.
std::string mutated(std::string behaviour, Random& random) {
  constexpr std::string_view word = "priority: ";
  std::vector<std::size_t> places;
  for (std::size_t at = behaviour.find(word); at != std::string::npos; at = behaviour.find(word, at + 1))
    places.push_back(at + word.size());
  if (places.empty()) return behaviour;
  const std::size_t at = places[random.below(places.size())];
  const std::size_t end = behaviour.find_first_not_of("-0123456789", at);
  return behaviour.replace(at, end - at, std::to_string(random.below(60)));
}

TEST_CASE(
    "a replay of a random scenario is equal to its trace, and differs where another behaviour decides differently") {
  const auto first = from_environment<std::uint64_t>("DIRECTOR_SEED", 1);
  const std::uint64_t cases = director::tests::cases_of({.usual = 1'000, .slow = 100});
  std::size_t events = 0, others = 0, differing = 0;
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    CAPTURE(seed);
    const Documents documents = generate(seed);
    const std::string behaviour = to_yaml(documents.behaviour), scenario = to_yaml(documents.scenario);
    const CompileResult result = compile(behaviour, scenario);
    REQUIRE(result.compiled);
    const std::string recorded = record(*result.compiled);
    CHECK(written_again(recorded, *result.compiled) == recorded); // otherwise it would count as damaged
    CHECK(order_problem(recorded, *result.compiled).empty());
    const auto replayed = replay(recorded, *result.compiled);
    if (replayed.difference)
      FAIL("line " << replayed.difference->line << "\n"
                   << replayed.difference->recorded_line << "\n"
                   << replayed.difference->replayed_line);
    REQUIRE(replayed.problem.empty());
    const std::vector<std::string> before = lines_of(recorded);
    CHECK(replayed.events == before.size());
    events += replayed.events;

    Random random(seed);
    const CompileResult other = compile(mutated(behaviour, random), scenario);
    if (!other.compiled) continue;
    ++others;
    const std::vector<std::string> after = lines_of(record(*other.compiled));
    const auto differs = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
    const auto place = static_cast<std::size_t>(differs.first - before.begin());
    const auto found = replay(recorded, *other.compiled);
    if (differs.first == before.end()) {
      CHECK(!found.difference);
      continue;
    }
    // With another priority a task may have a level more or less, and then the script itself requests another one.
    const auto has = [&](const char* word) { return before[place].find(word) != std::string::npos; };
    if (has("\"event\":\"ask\"") || has("\"event\":\"keep\"") || has("\"event\":\"input\"")) continue;
    ++differing;
    REQUIRE(found.difference);
    CHECK(found.difference->line == place + 1);
    CHECK(found.events == place);
    CHECK(found.difference->recorded_line == before[place]);
    if (place < after.size()) CHECK(found.difference->replayed_line == after[place]);
  }
  if (cases < 1'000) return;
  CHECK(events > 30'000);
  CHECK(others > cases / 2);
  CHECK(differing > cases / 100);
}

TEST_CASE("a replay of steps that ended early, and went on with an input, is equal to its trace") {
  const auto first = from_environment<std::uint64_t>("DIRECTOR_SEED", 1);
  const std::uint64_t cases = director::tests::cases_of({.usual = 1'000, .slow = 100});
  std::size_t early = 0;
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    CAPTURE(seed);
    const Documents documents = generate_any(seed);
    const CompileResult result = compile(to_yaml(documents.behaviour), to_yaml(documents.scenario));
    REQUIRE(result.compiled);
    Random random(seed);
    const std::string recorded = record_in_short_steps(*result.compiled, random, early);
    INFO(recorded);
    CHECK(order_problem(recorded, *result.compiled).empty());
    const auto replayed = replay(recorded, *result.compiled);
    if (replayed.difference)
      FAIL("line " << replayed.difference->line << "\n"
                   << replayed.difference->recorded_line << "\n"
                   << replayed.difference->replayed_line);
    REQUIRE(replayed.problem.empty());
  }
  if (cases < 1'000) return;
  CHECK(early > cases / 50);
}

} // namespace
