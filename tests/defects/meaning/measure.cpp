// Header: tests/defects/CMakeLists.txt. Test: itself.
// SPDX-License-Identifier: MIT
//
//   defects_meaning                  each defect, against the same behaviour without it: which kinds of change are
//   told;
//                                    and changes of text that mean nothing, of which nothing may be told.
//                                    DIRECTOR_LONG in the environment: 16 of each check, and 1,000; else some of both.
//                                    And of two groups whose situation is as before, nothing may change when played.
//   defects_meaning --show ID SEED   one of them, and what is told
//   defects_meaning --silent N       one change without meaning, and what is told
#include "compiler/diff/diff.hpp"
#include "compiler/diff/situations.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/transitions/matrix.hpp"
#include "dsl/source/file_access.hpp"
#include "tests/defects/meaning/expected.hpp"
#include "tests/defects/meaning/vary.hpp"
#include "tests/defects/trial.hpp"
#include "tests/support/environment.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace director;
using namespace director::defects;

constexpr std::size_t long_seeds = 16;                           ///< for each shape of a defect
constexpr std::uint64_t long_silent = 1'000, usual_silent = 150; ///< changes without meaning

/// As `defects` numbers them: those are without a mistake but for the defect.
Case case_of(const std::vector<Planter>& shapes, std::uint64_t seed) {
  return {&shapes[seed % shapes.size()], seed, static_cast<int>(seed / shapes.size() % 5)};
}

using Shapes = std::map<std::string, std::vector<Planter>>;

Shapes shapes_of(const std::vector<Planter>& planters) {
  Shapes out;
  for (const Planter& planter : planters) out[planter.id].push_back(planter);
  return out;
}

struct Told {
  std::vector<compiler::BehaviourChange> changes;
  std::string text;
};

compiler::Checked check(const Planted& planted, dsl::Sources& sources) {
  dsl::MemoryFiles files;
  for (const auto& [path, text] : planted.texts) files.add(path, text);
  return compiler::check(planted.main, files, sources);
}

Told tell(const Planted& before, const Planted& after) {
  dsl::Sources sources;
  const compiler::Checked was = check(before, sources), is = check(after, sources);
  Told out;
  out.changes = compiler::find_changes(was, is);
  out.text = compiler::changes_text(out.changes, {}, sources);
  return out;
}

std::set<std::string> kinds_of(const Told& told) {
  std::set<std::string> out;
  for (const auto& change : told.changes) out.emplace(compiler::page_of(change.kind).id);
  return out;
}

void show(const Planted& planted) {
  for (const auto& [path, text] : planted.texts) std::cout << "-- " << path << "\n" << text;
}

bool is_named(const Case& one, const Told& told) {
  const std::set<std::string>& expected = expected_kinds(*one.planter);
  if (expected.empty()) return told.changes.empty();
  for (const std::string& kind : kinds_of(told)) {
    if (expected.count(kind) != 0) return true;
  }
  return false;
}

struct Silent {
  Planted before, after;
  Ways ways;
};

/// Of a behaviour without a defect.
Silent make_silent(const std::vector<Planter>& planters, std::uint64_t seed) {
  const Planter& planter = planters[seed % planters.size()];
  const Case one{&planter, seed, static_cast<int>(seed / planters.size() % 5)};
  Silent out;
  Random random(seed + 7'000'000);
  out.before = make_planted(one, false, [](Robot&) {});
  if (out.before.edited) {
    out.after = out.before;
  } else {
    out.after = make_planted(one, false, [&](Robot& robot) { vary(robot, random, out.ways); });
  }
  if (out.before.edited || random.chance(0.3)) comment(out.after.texts, random, out.ways);
  return out;
}

std::size_t measure_defects(const std::vector<Planter>& planters, bool whole) {
  std::size_t planted = 0, missed = 0;
  std::map<std::string, std::size_t> told;
  for (const auto& [id, shapes] : shapes_of(planters)) {
    const std::size_t seeds = whole ? std::max(long_seeds, shapes.size()) : shapes.size();
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const Case one = case_of(shapes, seed);
      const Told result = tell(make_planted(one, false), make_planted(one, true));
      ++planted;
      for (const std::string& kind : kinds_of(result)) ++told[kind];
      if (is_named(one, result)) continue;
      ++missed;
      std::cout << "not named: " << id << " " << seed << " (" << one.planter->shape << "), told are";
      for (const std::string& kind : kinds_of(result)) std::cout << " " << kind;
      std::cout << "\n";
    }
  }
  std::cout << "defects planted: " << planted << ", named by what they change: " << planted - missed << "\n";
  for (const auto& [kind, count] : told) std::cout << "  " << kind << ": " << count << "\n";
  return missed;
}

std::size_t measure_silence(const std::vector<Planter>& planters, bool whole) {
  std::size_t loud = 0;
  Ways ways;
  const std::uint64_t count = whole ? long_silent : usual_silent;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const Silent one = make_silent(planters, seed);
    for (const auto& [way, times] : one.ways) ways[way] += times;
    const Told result = tell(one.before, one.after);
    if (result.changes.empty()) continue;
    ++loud;
    std::cout << "not silent: " << seed << "\n" << result.text;
  }
  std::cout << "changes without meaning: " << count << ", told of: " << loud << "\n";
  for (const auto& [way, times] : ways) std::cout << "  " << way << ": " << times << "\n";
  return loud;
}

/// What `directorc diff` does not play, since nothing in it has changed: played here.
struct Unplayed {
  std::size_t pairs = 0, wrong = 0, played_by_diff = 0;
};

void play_what_is_as_before(const Planted& before, const Planted& after, Unplayed& count) {
  using compiler::Model;
  dsl::Sources sources;
  const compiler::Checked was = check(before, sources), is = check(after, sources);
  if (!was.lowerable || !is.lowerable) return;
  const std::set<std::string> changed = compiler::diff::changed_situations({was, is});
  const compiler::Lowered old_tables = compiler::lower(was.model), new_tables = compiler::lower(is.model);
  compiler::TransitionPlays old_plays(was.model, old_tables), new_plays(is.model, new_tables);
  const auto asks = [](const Model& model, compiler::GroupId id) { return !model.groups[id].edges.empty(); };
  for (const compiler::GroupId from : was.model.groups.ids()) {
    for (const compiler::GroupId to : was.model.groups.ids()) {
      const std::string &first = was.model.groups[from].name.value, &second = was.model.groups[to].name.value;
      const auto from_now = is.model.find_group(first), to_now = is.model.find_group(second);
      if (from == to || !from_now || !to_now) continue;
      if (!asks(was.model, from) || !asks(was.model, to) || !asks(is.model, *from_now) || !asks(is.model, *to_now))
        continue;
      if (changed.contains(first) || changed.contains(second)) {
        ++count.played_by_diff;
        continue;
      }
      ++count.pairs;
      const compiler::Transition old = old_plays.between(from, to), now = new_plays.between(*from_now, *to_now);
      if (old.kind == now.kind && old.bound == now.bound) continue;
      ++count.wrong;
      std::cout << "not played, and changed: from " << first << " to " << second << ", before "
                << compiler::name_of(old.kind) << ", now " << compiler::name_of(now.kind) << "\n";
      for (const auto& [path, text] : after.texts) std::cout << "-- " << path << "\n" << text;
    }
  }
}

std::size_t measure_unplayed(const std::vector<Planter>& planters, bool whole) {
  Unplayed count;
  for (const auto& [id, shapes] : shapes_of(planters)) {
    const std::size_t seeds = whole ? std::max(long_seeds, shapes.size()) : 1;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const Case one = case_of(shapes, seed);
      play_what_is_as_before(make_planted(one, false), make_planted(one, true), count);
    }
  }
  std::cout << "transitions that are not played again: " << count.pairs << ", changed nevertheless: " << count.wrong
            << "; played again: " << count.played_by_diff << "\n";
  return count.wrong;
}

} // namespace

int main(int count, char** arguments) {
  const std::vector<Planter> planters = all_planters();
  const std::vector<std::string> words(arguments + 1, arguments + count);
  if (words.size() == 3 && words[0] == "--show") {
    const Shapes shapes = shapes_of(planters);
    if (shapes.count(words[1]) == 0) return std::cerr << "no defect is planted for " << words[1] << "\n", 2;
    const Case one = case_of(shapes.at(words[1]), std::strtoull(words[2].c_str(), nullptr, 10));
    const Planted before = make_planted(one, false), after = make_planted(one, true);
    std::cout << "== " << words[1] << ", " << one.planter->shape << "\n";
    show(before);
    std::cout << "== with the defect\n";
    show(after);
    std::cout << tell(before, after).text;
    return 0;
  }
  if (words.size() == 2 && words[0] == "--silent") {
    const Silent one = make_silent(planters, std::strtoull(words[1].c_str(), nullptr, 10));
    show(one.before);
    std::cout << "== after\n";
    show(one.after);
    std::cout << tell(one.before, one.after).text;
    return 0;
  }
  const bool whole = tests::is_long();
  const std::size_t missed = measure_defects(planters, whole), loud = measure_silence(planters, whole),
                    unplayed = measure_unplayed(planters, whole);
  return missed == 0 && loud == 0 && unplayed == 0 ? 0 : 1;
}
