// Header: compiler/explore/oscillations.hpp. Test: tests/compiler/explore/oscillations_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/explore/oscillations.hpp"

#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/base/counted.hpp"
#include "compiler/explore/scenario/write_scenario.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace director::compiler {

namespace {

/// What runs, starts or stops in a cycle, by name, with its place.
std::map<std::string, dsl::Span> moving(const std::vector<Taken>& round, const Model& model) {
  std::map<std::string, dsl::Span> out;
  for (const Taken& taken : round) {
    for (const Action& action : taken.actions) {
      const Word& group = model.groups[GroupId{action.group}].name;
      if (action.kind == Action::Kind::run)
        out.emplace(model.full_name(ProviderId{action.provider}), model.providers[ProviderId{action.provider}].span);
      else
        out.emplace(group.value, group.span);
    }
  }
  return out;
}

bool keeps_promises(const std::vector<Taken>& round, const Ground& ground) {
  const auto is_promised = [&](ProviderId provider, const Put& put) {
    const std::vector<ConditionUse>& causing = ground.model.providers[provider].causing;
    return std::any_of(causing.begin(), causing.end(), [&](const ConditionUse& use) {
      const Condition& condition = ground.model.conditions[use.id];
      return condition.state.value == put.state && condition.accepts.contains(put.value);
    });
  };
  const auto keeps = [&](const Action& action) {
    if (action.kind != Action::Kind::run) return false;
    const Puts& puts = ground.bodies[action.provider].puts[action.puts];
    return std::any_of(puts.begin(), puts.end(),
                       [&](const Put& put) { return is_promised(ProviderId{action.provider}, put); });
  };
  return std::any_of(round.begin(), round.end(),
                     [&](const Taken& taken) { return std::any_of(taken.actions.begin(), taken.actions.end(), keeps); });
}

std::vector<std::string> names_in(const std::vector<Taken>& round, const Model& model) {
  std::vector<std::string> out;
  for (const auto& [name, span] : moving(round, model)) out.push_back(name);
  return out;
}

Oscillation oscillation(const Ground& ground, const Searched::Cycle& cycle, const std::string& behaviour) {
  Oscillation out;
  Way way = cycle.way;
  way.resize(way.size() + cycle.length, 0); // the first possibility is the usual one
  std::vector<Taken> all = Follower(ground, Breadth::all).follow(way);
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(cycle.way.size());
  out.round.assign(begin, all.end());
  out.way.assign(all.begin(), begin);
  out.keeps_promises = keeps_promises(out.round, ground);
  ScenarioHead head;
  head.title = "it never comes to rest";
  head.doc = fmt::format("The last step repeats for ever: {}.", fmt::join(names_in(out.round, ground.model), ", "));
  head.behaviour = behaviour;
  head.round = out.round;
  out.scenario = write_scenario(ground, out.way, head);
  return out;
}

} // namespace

std::vector<Oscillation> find_oscillations(const Ground& ground, const Searched& searched,
                                           const std::string& behaviour) {
  std::vector<Oscillation> out;
  std::set<std::vector<std::string>> known; // of several ways into one cycle the shortest is enough
  for (const Searched::Cycle& cycle : searched.cycles) {
    Oscillation each = oscillation(ground, cycle, behaviour);
    if (known.insert(names_in(each.round, ground.model)).second) out.push_back(std::move(each));
  }
  return out;
}

std::string in_words(const Ground& ground, const Oscillation& oscillation) {
  return fmt::format("Never at rest{}: after {} it repeats {}: {}",
                     oscillation.keeps_promises ? ", if what is promised takes no time" : "",
                     in_words(ground, oscillation.way), counted(oscillation.round.size(), "micro-step"),
                     fmt::join(names_in(oscillation.round, ground.model), ", "));
}

std::vector<dsl::Diagnostic> never_at_rest(const Ground& ground, const std::vector<Oscillation>& oscillations) {
  std::vector<dsl::Diagnostic> out;
  for (const Oscillation& each : oscillations) {
    if (each.keeps_promises) continue;
    const std::map<std::string, dsl::Span> all = moving(each.round, ground.model);
    std::vector<std::string> names;
    for (const auto& [name, span] : all) names.push_back(fmt::format("`{}`", name));
    const std::string way = in_words(ground, each.way);
    dsl::Diagnostic finding{"never_at_rest",
                            dsl::Level::error,
                            all.begin()->second,
                            fmt::format("the engine never comes to rest{}: {} in a cycle of {} micro-steps",
                                        way.empty() ? way : " after " + way,
                                        names.size() == 1 ? names.front() + " runs again and again"
                                                          : analysis::list_of(names, "and") + " go round",
                                        each.round.size()),
                            {},
                            {}};
    for (auto next = std::next(all.begin()); next != all.end(); ++next)
      finding.notes.push_back({next->second, fmt::format("`{}` runs, starts or stops in it", next->first)});
    analysis::shorten_list(finding.notes);
    finding.help = each.scenario ? "let a `stay` accept what changes, or keep it from changing; `directorc explore FILE "
                                   "--output FOLDER` writes a scenario that shows it"
                                 : "let a `stay` accept what changes, or keep it from changing";
    out.push_back(std::move(finding));
  }
  return out;
}

} // namespace director::compiler
