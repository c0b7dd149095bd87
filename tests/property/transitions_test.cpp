// SPDX-License-Identifier: MIT
// On random behaviours: each cell of the transition matrix says what its scenario shows. Whether the second one runs
// at once, when the first one is done, or never; and of all that runs for the first one, what stops, what stops and
// begins again, and what runs on for another requester. A cell `both` has none of these.
//
//   DIRECTOR_SEED, DIRECTOR_CASES   as in property_test.cpp
//   DIRECTOR_SHOW                   set: each cell that says something else, with its behaviour and its scenario
#include "compiler/play/scenario/resolve_scenario.hpp"
#include "compiler/transitions/matrix.hpp"
#include "runtime/core/inspect/view.hpp"
#include "tests/property/engine_run.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/small_behaviour.hpp"
#include "tests/property/watch.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <set>

namespace {

using namespace director::property;
using director::Index;
using director::nil;
using director::View;
using director::compiler::GroupId;
using director::compiler::Transition;
using director::compiler::TransitionMatrix;

using Groups = std::set<GroupId>;
using Kind = Transition::Kind;

/// What runs, and for which request.
struct CellMoment {
  explicit CellMoment(const Compiled& compiled, const director::Engine& engine) {
    const View view = view_of(engine);
    for (const GroupId id : compiled.model.groups.ids()) {
      const Index holder = view.holder(static_cast<Index>(id.value));
      holders.push_back(holder == nil || view.is_limbo(holder) ? nil : holder);
      if (view.granted(static_cast<Index>(id.value))) running.insert(id);
    }
  }
  /// Whether the request is the group's, or that of a group above it.
  bool is_under(const Compiled& compiled, GroupId id, Index edge) const {
    Index by = holders[id.value];
    for (std::size_t steps = 0; by != nil && by != edge && steps <= holders.size(); ++steps) {
      const auto above = compiled.model.edges[director::compiler::EdgeId{by}].requester;
      by = above ? holders[above->value] : nil;
    }
    return by == edge;
  }
  std::vector<Index> holders;
  Groups running;
};

/// The play of a cell.
struct CellPlay {
  bool first_ran = false, second_ran = false, second_ran_later = false;
  Groups stops, again, taken;
};

Groups stopped_since(const EngineRun& run, std::size_t events) {
  Groups out;
  for (std::size_t i = events; i < run.events().size(); ++i) {
    const director::tests::EventNumbers& event = run.events()[i]; // kind, input, reasons, why, group, …
    if (event[0] == static_cast<std::int64_t>(director::Event::Kind::stop))
      out.insert(GroupId{static_cast<std::uint32_t>(event[4])});
  }
  return out;
}

CellPlay play_cell(const Compiled& compiled, GroupId first, GroupId second) {
  EngineRun run(compiled, false);
  CellPlay out;
  Groups side;
  Index edge = nil;
  const auto& steps = compiled.scenario.steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::size_t known = run.events().size();
    run.begin_step(steps[i]);
    while (run.micro_step()) {}
    const CellMoment rest(compiled, run.engine());
    if (i == 0) {
      out.first_ran = rest.running.contains(first);
      edge = rest.holders[first.value];
      for (const GroupId id : rest.running) {
        if (rest.is_under(compiled, id, edge)) side.insert(id);
      }
    } else if (i == 1) {
      out.second_ran = rest.running.contains(second);
      const Groups stopped = stopped_since(run, known);
      for (const GroupId id : side) {
        if (!rest.running.contains(id))
          out.stops.insert(id);
        else if (stopped.contains(id))
          out.again.insert(id);
        else if (!rest.is_under(compiled, id, edge))
          out.taken.insert(id);
      }
    } else {
      out.second_ran_later = rest.running.contains(second);
    }
  }
  return out;
}

/// Of the named ones, those that are not above the first one.
Groups without_chain(const std::vector<GroupId>& named, const TransitionMatrix::Row& row) {
  Groups out(named.begin(), named.end());
  for (const GroupId id : row.chain) out.erase(id);
  return out;
}

/// What is wrong with the cell; empty: nothing.
std::string fault_of(const Transition& cell, const TransitionMatrix::Row& row, const CellPlay& shown) {
  if (!shown.first_ran) return "the first one does not run";
  const Groups stops = without_chain(cell.stops, row), again = without_chain(cell.again, row),
               taken = without_chain(cell.taken, row);
  if (stops != shown.stops) return "what stops";
  if (again != shown.again) return "what stops and begins again";
  if (taken != shown.taken) return "what runs on for others";
  switch (cell.kind) {
  case Kind::waits: return shown.second_ran ? "it runs at once" : shown.second_ran_later ? "" : "it does not run";
  case Kind::never: return shown.second_ran || shown.second_ran_later ? "it runs" : "";
  case Kind::condition_lost: return shown.second_ran || shown.second_ran_later ? "" : "it does not run";
  case Kind::both:
    if (!shown.stops.empty() || !shown.again.empty() || !shown.taken.empty()) return "the first one loses something";
    [[fallthrough]];
  default: return shown.second_ran ? "" : "it does not run at once";
  }
}

struct CellCounts {
  std::map<std::string, std::size_t> kinds;
  std::size_t stops = 0, again = 0, taken = 0;
};

/// A line for each wrong cell.
std::string find_wrong(Compiled& compiled, const std::string& text, CellCounts& counts) {
  const director::compiler::Model& model = compiled.model;
  const TransitionMatrix matrix = find_transitions(model, compiled.lowered, "behaviour.yaml");
  for (director::Group& group : compiled.lowered.groups) group.stop = true; // each stop is reported
  std::string out;
  for (const TransitionMatrix::Row& row : matrix.rows) {
    for (std::size_t column = 0; column < row.cells.size(); ++column) {
      const Transition& cell = row.cells[column];
      ++counts.kinds[std::string(name_of(cell.kind))];
      if (cell.scenario.empty() || cell.kind == Kind::endless) continue;
      std::string scenario;
      for (const std::size_t piece : cell.scenario) scenario += matrix.pieces[piece];
      auto played = director::compiler::scenario_from(scenario, model);
      REQUIRE(played);
      compiled.scenario = std::move(*played);
      const GroupId second = matrix.rows[column].group;
      const CellPlay shown = play_cell(compiled, row.group, second);
      counts.stops += shown.stops.size(), counts.again += shown.again.size(), counts.taken += shown.taken.size();
      const std::string fault = fault_of(cell, row, shown);
      if (fault.empty()) continue;
      out += "  " + model.groups[row.group].name.value + " to " + model.groups[second].name.value + ": " + fault +
             "; the cell is " + std::string(name_of(cell.kind)) + ": " + cell.words + "\n";
      if (std::getenv("DIRECTOR_SHOW") != nullptr) out += text + "\n" + scenario + "\n";
    }
  }
  return out;
}

void compare_cells(const std::function<Node(std::uint64_t)>& make, std::uint64_t cases) {
  const auto first = director::tests::from_environment<std::uint64_t>("DIRECTOR_SEED", 1);
  CellCounts counts;
  std::string wrong;
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    watch(seed);
    const std::string text = to_yaml(make(seed));
    const CompileResult result =
        compile(text, "scenario: none\nbehaviour: behaviour.yaml\nsteps:\n  - advance: 1 ms\n");
    const std::string some = result.compiled ? find_wrong(*result.compiled, text, counts) : "";
    stop_watching();
    if (!some.empty()) wrong += "DIRECTOR_SEED=" + std::to_string(seed) + "\n" + some;
  }
  std::cout << cases << " cases:";
  for (const auto& [kind, count] : counts.kinds) std::cout << " " << kind << " " << count << ",";
  std::cout << " " << counts.stops << " stops, " << counts.again << " of what begins again, " << counts.taken
            << " run on for others\n";
  CHECK(wrong == "");
  if (cases >= 100) CHECK(counts.again > cases / 50);
}

TEST_CASE("cells of the transition matrix say what their scenarios show") {
  compare_cells([](std::uint64_t seed) { return generate(seed).behaviour; },
                director::tests::cases_of({.usual = 150, .slow = 10, .whole = 1'000}));
}

TEST_CASE("cells of the transition matrix say what their scenarios show, of small behaviours") {
  compare_cells([](std::uint64_t seed) { return to_document(small_behaviour(seed)); },
                director::tests::cases_of({.usual = 400, .slow = 20, .whole = 4'000}));
}

} // namespace
