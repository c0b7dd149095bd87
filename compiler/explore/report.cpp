// Header: compiler/explore/report.hpp. Test: tests/compiler/explore/search/search_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/explore/report.hpp"

#include "compiler/explore/environment/focus.hpp"
#include "compiler/explore/limits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace director::compiler {

namespace {

/// Limit: file systems take 255 bytes, and a name gets an ending and a number.
constexpr std::size_t longest_name = 200;

/// Limit for sets of requested roots with a line each: there may be as many as subsets of the roots.
constexpr std::size_t most_root_sets = 16;

/// `number`: of several names that would be the same; 0: none.
std::string file_name(const std::string& words, std::size_t number = 0) {
  std::string out;
  for (const char c : words) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_')
      out += c;
    else if (!out.empty() && out.back() != '_')
      out += '_';
  }
  out.resize(std::min(out.size(), longest_name));
  while (!out.empty() && out.back() == '_') out.pop_back();
  if (number != 0) out += fmt::format("_{}", number);
  return out + ".scenario.yaml";
}

/// For a search that was cut off: searches for each provider that did not run, in a few states.
void look_for_those_that_never_ran(const Ground& ground, SearchOptions how, Happened& happened) {
  how.breadth = Breadth::lean;
  how.assertions.clear();
  how.bound = std::min(how.bound, states_of_focus);
  std::size_t tries = 64;
  for (const ProviderId id : ground.model.providers.ids()) {
    if (happened.ran[id.value]) continue;
    if (tries-- == 0) return;
    Ground focused(ground.model, ground.timed);
    focus_on(focused, {{}, {id}});
    happened.add(search(focused, how).happened);
    if (!happened.ran[id.value] && focused.make_all_packs_usual()) happened.add(search(focused, how).happened);
  }
}

/// A line for each set of requested roots; of many only some of those that are not explored completely.
std::string root_sets_text(const std::vector<RootSet>& sets, const Model& model) {
  const auto explored = [](const RootSet& set) {
    return fmt::format("{} found, {:.1f} % explored\n", set.found,
                       100.0 * static_cast<double>(set.explored) / static_cast<double>(set.found));
  };
  std::string out;
  RootSet others;
  std::size_t lines = 0, left = 0;
  for (const RootSet& set : sets) {
    const bool is_listed = sets.size() <= most_root_sets || set.explored < set.found;
    if (!is_listed || lines == most_root_sets) {
      others.found += set.found;
      others.explored += set.explored;
      ++left;
      continue;
    }
    std::vector<std::string> names;
    for (const Index edge : set.roots) names.push_back(model.groups[model.edges[EdgeId{edge}].target].name.value);
    out += fmt::format("  requested {}: {}", names.empty() ? "nothing" : fmt::format("{}", fmt::join(names, ", ")),
                       explored(set));
    ++lines;
  }
  if (left != 0)
    out += fmt::format("  {} {}sets of requested roots: {}", left, lines != 0 ? "other " : "", explored(others));
  return out;
}

std::string megabytes(std::size_t bytes) { return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6); }

} // namespace

Exploration explore(const Ground& ground, const ExploreOptions& options) {
  const Model& model = ground.model;
  SearchOptions how;
  how.bound = options.bound;
  how.threads = options.threads;
  how.progress = options.progress;
  std::vector<std::optional<Verdict>> early = decide_early(ground, how, options.behaviour);
  how.assertions = without_verdict(early);
  Exploration out{search(ground, how), {}, {}, {}, {}};
  out.verdicts = decide_late(ground, std::move(early), out.searched, options.behaviour);
  if (!out.searched.complete) look_for_those_that_never_ran(ground, how, out.searched.happened);
  for (const ProviderId id : model.providers.ids()) {
    if (!out.searched.happened.ran[id.value]) out.never_ran.push_back(id);
  }
  for (const EdgeId id : model.edges.ids()) {
    const bool waits = out.searched.happened.runnable[id.value] && !out.searched.happened.granted[id.value];
    if (tried_all(ground, out.searched) && waits) out.starved.push_back(id);
  }
  out.oscillations = find_oscillations(ground, out.searched, options.behaviour);
  return out;
}

std::string to_text(const Exploration& exploration, const Ground& ground) {
  const Model& model = ground.model;
  const Searched& searched = exploration.searched;
  std::string out = fmt::format("{} states, {} of them explored ({}), {} micro-steps, {} at most\n", searched.states,
                                searched.explored,
                                tried_all(ground, searched) ? "all there are"
                                : searched.complete         ? "all of what is tried"
                                                            : "the bound was reached",
                                searched.micro_steps, megabytes(searched.most_bytes));
  out += root_sets_text(searched.root_sets, model);
  if (!exploration.verdicts.empty()) out += "Assertions\n";
  for (std::size_t i = 0; i < exploration.verdicts.size(); ++i) {
    const Verdict& verdict = exploration.verdicts[i];
    out += fmt::format("  {}: {}: {}\n", name_of(verdict.kind), words_of(model.assertions[i], model), verdict.why);
  }
  const std::string_view so_far = tried_all(ground, searched) ? "" : " so far";
  if (!exploration.never_ran.empty()) {
    std::vector<std::string> names;
    for (const ProviderId id : exploration.never_ran) names.push_back(model.full_name(id));
    out += fmt::format("Never ran{}: {}\n", so_far, fmt::join(names, ", "));
  }
  for (const EdgeId id : exploration.starved)
    out +=
        fmt::format("Requested for ever: {} is never granted, though its conditions can be met\n", model.edge_name(id));
  for (const Oscillation& each : exploration.oscillations) out += in_words(ground, each) + "\n";
  out += "Not tried\n";
  for (const std::string& what : ground.left_out) out += fmt::format("  - {}\n", what);
  return out;
}

std::vector<std::pair<std::string, std::string>> scenarios_of(const Exploration& exploration, const Ground& ground) {
  std::vector<std::pair<std::string, std::string>> out;
  std::set<std::string> taken;
  const auto add = [&](const std::string& words, const std::string& text) {
    std::string name = file_name(words);
    for (std::size_t number = 2; !taken.insert(name).second; ++number) name = file_name(words, number);
    out.emplace_back(std::move(name), text);
  };
  for (std::size_t i = 0; i < exploration.verdicts.size(); ++i) {
    const Verdict& verdict = exploration.verdicts[i];
    if (verdict.scenario) add(words_of(ground.model.assertions[i], ground.model), *verdict.scenario);
  }
  for (std::size_t i = 0; i < exploration.oscillations.size(); ++i) {
    if (exploration.oscillations[i].scenario)
      add(fmt::format("never_at_rest_{}", i + 1), *exploration.oscillations[i].scenario);
  }
  return out;
}

} // namespace director::compiler
