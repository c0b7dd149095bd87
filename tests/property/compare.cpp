// Header: tests/property/compare.hpp. Test: tests/property/property_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/compare.hpp"

#include "compiler/analysis/plans/bounds.hpp"
#include "compiler/play/play.hpp"
#include "runtime/core/inspect/view.hpp"
#include "tests/oracle/scripted.hpp"
#include "tests/property/engine_run.hpp"
#include "tests/property/invariants.hpp"

#include <algorithm>

namespace director::property {

namespace {

constexpr std::size_t most_micro_steps = 10'000; ///< of one scenario step: far more than bounded bodies need

/// The sequence of different snapshots: inputs without effect need not be micro-steps of both.
using Course = std::vector<Snapshot>;

void add(Course& course, Snapshot snapshot) {
  if (course.empty() || !(course.back() == snapshot)) course.push_back(std::move(snapshot));
}

class Comparing {
public:
  Comparing(const Compiled& compiled, Manner manner)
      : c_(compiled),
        oracle_(compiled.model, compiled.spec, manner == Manner::in_leaps),
        engine_(compiled, manner == Manner::in_leaps),
        rounds_(manner == Manner::often ? 4 : 1),
        bounds_(analysis::find_bounds(compiled.model, compiled.lowered.view())) {
    last_ = expected();
  }

  Verdict run() {
    const std::size_t steps = c_.spec.steps.size();
    for (std::size_t i = 0; i < rounds_ * steps && out_.difference.empty(); ++i) {
      step(i % steps);
      if (!out_.difference.empty()) out_.difference = "step " + std::to_string(i + 1) + ": " + out_.difference;
    }
    const oracle::Notes& notes = oracle_.behaviour().notes();
    show(Show::ladder, notes.ladders > 0);
    show(Show::denial_by_an_equal, notes.denials > 0);
    show(Show::repeated_pass, notes.repetitions > 0);
    show(Show::limbo, notes.limbo > 0);
    show(Show::alternative_plan, notes.later_plans > 0);
    show(Show::deferral, notes.deferrals > 0);
    out_.settling = static_cast<std::size_t>(notes.settling);
    if (static_cast<std::int64_t>(notes.most_repetitions) > bounds_.repetitions)
      fail("a pass is repeated more often than its bound says");
    if (out_.settling > c_.model.groups.size()) fail("it takes more passes to settle than there are groups");
    return out_;
  }

private:
  Snapshot expected() { return snapshot_of(oracle_.behaviour(), engine_.engine().tables()); }

  void show(Show what, bool shown) {
    bool& flag = out_.shown[static_cast<std::size_t>(what)];
    flag = flag || shown;
  }

  void step(std::size_t index) {
    Course wanted{expected()}, course{engine_.snapshot()};
    oracle_.begin_step(c_.spec.steps[index]);
    while (oracle_.micro_step()) {
      Snapshot now = expected();
      ++out_.micro_steps;
      look(now);
      add(wanted, std::move(now));
    }
    if (oracle_.exhausted()) return fail("the oracle does not come to rest");
    engine_.begin_step(c_.scenario.steps[index]);
    std::size_t count = 0;
    std::uint64_t work = engine_.engine().work();
    while (engine_.micro_step()) {
      if (++count > most_micro_steps) return fail("the engine does not come to rest");
      const std::uint64_t before = std::exchange(work, engine_.engine().work());
      if (work - before > static_cast<std::uint64_t>(bounds_.work_in_a_micro_step))
        return fail("a micro-step takes " + std::to_string(work - before) + " units of work, and its bound is " +
                    std::to_string(bounds_.work_in_a_micro_step));
      out_.dearest = std::max(out_.dearest,
                              static_cast<double>(work - before) / static_cast<double>(bounds_.work_in_a_micro_step));
      add(course, engine_.snapshot());
      if (!obeys(course.back(), false)) return;
      const std::size_t at = course.size() - 1;
      if (at >= wanted.size() || !(course[at] == wanted[at])) return differs(wanted, course, at);
    }
    add(course, engine_.snapshot());
    if (!obeys(course.back(), true)) return;
    const std::size_t at = course.size() - 1;
    if (course.size() != wanted.size() || !(course[at] == wanted[at]))
      return differs(wanted, course, course.size() < wanted.size() ? course.size() : at);
    compare_traces();
  }

  bool obeys(const Snapshot& now, bool at_rest) {
    const std::string wrong = broken_invariant(now, oracle_.behaviour().parts(), at_rest);
    if (!wrong.empty()) fail("an invariant is broken: " + wrong + "\n" + to_text(now, c_.model));
    return wrong.empty() && explains(now, at_rest);
  }

  /// Checks the answers of `why` for each group.
  bool explains(const Snapshot& now, bool at_rest) {
    const View view = view_of(engine_.engine());
    for (const oracle::GroupId g : c_.model.groups.ids()) {
      const Because claim = why(view, static_cast<Index>(g.value));
      const auto kind = static_cast<std::size_t>(claim.kind);
      out_.claimed[kind] = true;
      const oracle::Behaviour& it = oracle_.behaviour();
      const std::string wrong = wrong_claim(claim, view, now, c_, it.parts(), at_rest ? &it.notes() : nullptr);
      if (wrong.empty()) continue;
      fail("why " + c_.model.groups[g].name.value + " is not explained by " + std::to_string(kind) + ": " + wrong +
           "\n" + to_text(now, c_.model));
      return false;
    }
    return true;
  }

  void compare_traces() {
    const std::vector<std::string>& expected = oracle_.behaviour().trace();
    const std::vector<std::string>& happened = engine_.trace();
    const auto [a, b] = std::mismatch(expected.begin(), expected.end(), happened.begin(), happened.end());
    if (a == expected.end() && b == happened.end()) return;
    fail("the traces differ: oracle `" + (a == expected.end() ? "" : *a) + "`, engine `" +
         (b == happened.end() ? "" : *b) + "`");
  }

  void differs(const Course& expected, const Course& course, std::size_t at) {
    const auto lines = [](const std::vector<std::string>& trace, std::size_t from, std::size_t to) {
      std::string out;
      for (std::size_t i = from; i < std::min(to, trace.size()); ++i) out += "  " + trace[i] + "\n";
      return out;
    };
    const auto state = [&](const Course& of, const std::vector<std::string>& trace) {
      if (at >= of.size()) return std::string("  it rests\n");
      const std::size_t from = at == 0 ? of[at].lines : std::min(of[at - 1].lines, of[at].lines);
      return lines(trace, from, of[at].lines) + to_text(of[at], c_.model);
    };
    fail("after " + std::to_string(at) + " micro-steps\nboth before\n" +
         (at == 0 ? std::string() : to_text(expected[std::min(at, expected.size()) - 1], c_.model)) + "oracle\n" +
         state(expected, oracle_.behaviour().trace()) + "engine\n" + state(course, engine_.trace()));
  }

  void fail(std::string why) {
    if (out_.difference.empty()) out_.difference = std::move(why);
  }

  /// Notes what the scenario shows from one micro-step to the next.
  void look(const Snapshot& now) {
    for (std::size_t g = 0; g < now.groups.size(); ++g) {
      const auto& before = last_.groups[g].push;
      const auto& push = now.groups[g].push;
      show(Show::push, push.has_value());
      if (before && !push) {
        const compiler::Condition& unmet = c_.model.conditions[before->unmet];
        const auto& value = now.values[unmet.state.value];
        show(Show::dropped_push, !value || !unmet.accepts.contains(*value));
      }
    }
    for (std::size_t e = 0; e < now.requests.size(); ++e) {
      show(Show::level_change, last_.requests[e] && now.requests[e] && last_.requests[e] != now.requests[e]);
    }
    for (std::size_t i = last_.lines; i < now.lines; ++i) {
      show(Show::broken_promise, oracle_.behaviour().trace()[i].starts_with("broken"));
    }
    last_ = now;
  }

  const Compiled& c_;
  oracle::Player oracle_;
  EngineRun engine_;
  std::size_t rounds_; ///< number of times that the scenario is played
  const analysis::Bounds bounds_;
  Snapshot last_;
  Verdict out_;
};

/// Compares the output of `directorc simulate` with the oracle's trace.
std::string compare_simulated(const Compiled& compiled) {
  std::vector<std::string> expected, happened;
  oracle::Player oracle(compiled.model, compiled.spec, false);
  for (const dsl::StepSpec& step : compiled.spec.steps) {
    for (const dsl::InputSpec& input : step.inputs) expected.push_back("> " + input.shown);
    if (step.advance) expected.push_back("> advance " + dsl::to_text(step.advance->value));
    for (std::string& line : oracle.play(step)) expected.push_back(std::move(line));
  }
  compiler::play(compiled.scenario, compiled.model, compiled.lowered, {},
                 [&](const compiler::Happening& each) { happened.push_back(to_text(each)); });
  const auto [a, b] = std::mismatch(expected.begin(), expected.end(), happened.begin(), happened.end());
  if (a == expected.end() && b == happened.end()) return "";
  return "simulated, line " + std::to_string(a - expected.begin() + 1) + ": oracle `" +
         (a == expected.end() ? "" : *a) + "`, directorc `" + (b == happened.end() ? "" : *b) + "`";
}

/// The events of an observer must not depend on how much is decided again.
std::string compare_told(const Compiled& compiled, bool leap) {
  EngineRun whole(compiled, leap), followed(compiled, leap);
  whole.decide_whole(true), followed.decide_whole(false);
  for (EngineRun* run : {&whole, &followed}) {
    for (const compiler::ScenarioStep& step : compiled.scenario.steps) {
      run->begin_step(step);
      while (run->micro_step()) {}
    }
  }
  const auto &wanted = whole.events(), &got = followed.events();
  const auto [a, b] = std::mismatch(wanted.begin(), wanted.end(), got.begin(), got.end());
  if (a == wanted.end() && b == got.end()) return "";
  return "reported otherwise if all is decided again, from event " + std::to_string(a - wanted.begin() + 1) + " on";
}

} // namespace

Verdict compare(const Compiled& compiled, Manner manner) {
  Verdict verdict = Comparing(compiled, manner).run();
  if (verdict.difference.empty()) verdict.difference = compare_told(compiled, manner == Manner::in_leaps);
  if (verdict.difference.empty() && manner == Manner::once) verdict.difference = compare_simulated(compiled);
  return verdict;
}

} // namespace director::property
