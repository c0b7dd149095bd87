// Header: compiler/explore/verdict.hpp. Test: tests/compiler/explore/verdict_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/explore/verdict.hpp"

#include "compiler/explore/environment/focus.hpp"
#include "compiler/explore/limits.hpp"
#include "compiler/explore/scenario/write_scenario.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace director::compiler {

namespace {

std::string refuted_by(const Assertion& assertion, const Model& model) {
  const auto name = [&](std::size_t i) { return fmt::format("`{}`", model.groups[assertion.groups[i].id].name.value); };
  switch (assertion.kind) {
  case Assertion::Kind::never_together: return "two of them are granted";
  case Assertion::Kind::beats:
    return fmt::format("a task of {}, or below it, is blocked by a group that the side of {} holds", name(0), name(1));
  case Assertion::Kind::soft: // words_of(Cut)
  case Assertion::Kind::can_run: break;
  }
  return {};
}

std::string words_of(const Cut& cut, const Assertion& soft, const Model& model) {
  const auto name = [&](GroupId group) { return fmt::format("`{}`", model.groups[group].name.value); };
  const Use<GroupId>&from = soft.groups.front(), &to = soft.groups.back();
  const GroupId taken{cut.group};
  const std::vector<ProviderId>& providers = model.groups[from.id].providers;
  const bool causes = std::any_of(providers.begin(), providers.end(),
                                  [&](ProviderId provider) { return !model.providers[provider].causing.empty(); });
  const bool is_edge = cut.edge < model.edges.size();
  const std::optional<GroupId> holder = is_edge ? model.edges[EdgeId{cut.edge}].requester : std::nullopt;
  std::string what = name(taken) + (taken == from.id ? " itself" : "");
  if (taken != from.id && holder) what += fmt::format(", which {} holds", name(*holder));
  if (cut.stops) what += fmt::format("{} {} stops", taken == from.id || !holder ? ", so that" : ", and", name(from.id));
  const std::string since =
      causes ? fmt::format("no provider of {} with `causing` ran since {} was requested", name(from.id), name(to.id))
             : fmt::format("no provider of {} has `causing`", name(from.id));
  return fmt::format("granting {} takes {}; {}", name(to.id), what, since);
}

Verdict by_search(const Ground& ground, std::size_t at, const Searched& searched, Follower& follower,
                  const std::string& behaviour) {
  const Assertion& assertion = ground.model.assertions[at];
  const bool wanted = assertion.kind == Assertion::Kind::can_run;
  Verdict out;
  out.explored = true;
  if (!searched.seen[at]) {
    if (!searched.complete) {
      out.why = fmt::format("not found in {} states, and there are more", searched.states);
      out.more_states = true;
    } else if (!ground.narrowed.empty()) {
      out.why =
          fmt::format("not found in {} states, and not tried: {}", searched.states, fmt::join(ground.narrowed, "; "));
    } else {
      if (at < searched.doubted.size() && searched.doubted[at]) {
        out.why = fmt::format("in some of its {} states a task of its side is blocked while the other side holds what "
                              "it may take, but others are in its way as well",
                              searched.states);
        return out;
      }
      out.kind = wanted ? Verdict::Kind::refuted : Verdict::Kind::proven;
      out.why = wanted ? fmt::format("it runs in none of its {} states", searched.states)
                       : fmt::format("it holds in all {} states", searched.states);
    }
    return out;
  }
  out.way = follower.follow(*searched.seen[at]);
  const std::optional<Blocked> blocked =
      assertion.kind == Assertion::Kind::beats ? follower.blocked(*searched.seen[at], at) : std::nullopt;
  const std::optional<Cut> cut =
      assertion.kind == Assertion::Kind::soft ? follower.cut(*searched.seen[at], at) : std::nullopt;
  const std::string event = blocked ? words_of(*blocked, assertion, ground.model)
                            : cut   ? words_of(*cut, assertion, ground.model)
                                    : refuted_by(assertion, ground.model);
  ScenarioHead head;
  head.title = fmt::format("{}: {}", wanted ? "it runs" : "refuted", words_of(assertion, ground.model));
  head.doc = wanted ? "How it comes to run." : "In the last step " + event + ".";
  head.behaviour = behaviour;
  if (!follower.shows(*searched.seen[at], at)) {
    out.why = fmt::format("after {}, it was found from a restored state, and not when the events were played from the "
                          "start; this is a fault of directorc: please report it",
                          in_words(ground, out.way));
    out.way.clear();
    return out;
  }
  out.scenario = write_scenario(ground, out.way, head);
  if (!out.scenario) {
    out.why = "a way to it was found, but it could not be played as a scenario: timers are due in another order there";
    out.way.clear();
    return out;
  }
  out.kind = wanted ? Verdict::Kind::proven : Verdict::Kind::refuted;
  out.why = wanted ? "it runs after: " + in_words(ground, out.way)
                   : fmt::format("after {}, {}", in_words(ground, out.way), event);
  if (blocked) out.notes = notes_of(*blocked, ground.model);
  return out;
}

/// What focused searches try, one after the other: the groups of the assertion, then the same with each of their
/// providers, since the one that is reached first may not be the one that matters.
std::vector<Goal> goals_of(const Assertion& assertion, const Model& model) {
  constexpr std::size_t most = 17;
  Goal groups;
  for (const Use<GroupId>& use : assertion.groups) groups.groups.push_back(use.id);
  std::vector<Goal> out{groups};
  for (const GroupId id : groups.groups) {
    const std::vector<ProviderId>& providers = model.groups[id].providers;
    for (const ProviderId provider : providers) {
      if (providers.size() > 1 && out.size() < most) out.push_back({groups.groups, {provider}});
    }
  }
  return out;
}

} // namespace

std::string_view name_of(Verdict::Kind kind) {
  switch (kind) {
  case Verdict::Kind::proven: return "proven";
  case Verdict::Kind::refuted: return "refuted";
  case Verdict::Kind::undecided: break;
  }
  return "not decided";
}

std::string words_of(const Assertion& assertion, const Model& model) {
  std::vector<std::string> names;
  for (const Use<GroupId>& use : assertion.groups) names.push_back(model.groups[use.id].name.value);
  switch (assertion.kind) {
  case Assertion::Kind::never_together: return fmt::format("never_together [{}]", fmt::join(names, ", "));
  case Assertion::Kind::beats: return fmt::format("beats {{{}: {}}}", names.front(), names.back());
  case Assertion::Kind::soft: return fmt::format("soft {{from: {}, to: {}}}", names.front(), names.back());
  case Assertion::Kind::can_run: break;
  }
  return "can_run " + names.front();
}

std::vector<std::optional<Verdict>> decide_early(const Ground& ground, SearchOptions options,
                                                 const std::string& behaviour) {
  std::vector<std::optional<Verdict>> out;
  for (const Assertion& assertion : ground.model.assertions) out.push_back(prove_at_once(assertion, ground.model));
  options.only_assertions = true;
  const auto look = [&](const Ground& where, std::vector<std::size_t> at, std::size_t bound,
                        Breadth breadth = Breadth::lean) {
    options.breadth = breadth;
    options.assertions = std::move(at);
    options.bound = bound;
    if (options.assertions.empty()) return true;
    const Searched searched = search(where, options);
    Follower follower(where, searched.breadth);
    for (const std::size_t i : options.assertions) {
      if (!searched.seen[i]) continue;
      Verdict verdict = by_search(where, i, searched, follower, behaviour);
      if (verdict.kind != Verdict::Kind::undecided) out[i] = std::move(verdict);
    }
    return searched.complete;
  };
  // A short lean search, and one with usual answers only; then searches that are focused on a goal; then a lean one up
  // to the bound.
  const std::size_t bound = options.bound, few = std::min(bound, states_of_focus);
  const bool all = look(ground, without_verdict(out), few);
  if (!all) look(ground, without_verdict(out), few, Breadth::usual);
  for (const std::size_t i : without_verdict(out)) {
    if (all) break;
    for (const Goal& goal : goals_of(ground.model.assertions[i], ground.model)) {
      if (out[i]) break;
      Ground focused(ground.model, ground.timed);
      focus_on(focused, goal);
      look(focused, {i}, few, Breadth::usual);
      if (!out[i]) look(focused, {i}, few);
      if (!out[i] && focused.make_all_packs_usual()) look(focused, {i}, few);
    }
  }
  if (!all && few < bound) look(ground, without_verdict(out), bound);
  return out;
}

std::vector<std::size_t> without_verdict(const std::vector<std::optional<Verdict>>& verdicts) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (!verdicts[i]) out.push_back(i);
  }
  return out;
}

std::vector<Verdict> decide_late(const Ground& ground, std::vector<std::optional<Verdict>> early,
                                 const Searched& searched, const std::string& behaviour) {
  std::vector<Verdict> out;
  Follower follower(ground, searched.breadth);
  for (std::size_t i = 0; i < early.size(); ++i) {
    out.push_back(early[i] ? std::move(*early[i]) : by_search(ground, i, searched, follower, behaviour));
  }
  return out;
}

std::vector<Verdict> decide_assertions(const Ground& ground, std::size_t bound) {
  const std::string behaviour = ground.model.name + ".yaml";
  SearchOptions options;
  options.bound = bound;
  options.only_assertions = true;
  std::vector<std::optional<Verdict>> early = decide_early(ground, options, behaviour);
  options.assertions = without_verdict(early);
  if (options.assertions.empty()) return decide_late(ground, std::move(early), Searched(ground.tables), behaviour);
  return decide_late(ground, std::move(early), search(ground, options), behaviour);
}

} // namespace director::compiler
