// Header: compiler/explore/verdict.hpp. Test: tests/compiler/explore/verdict_test.cpp.
// SPDX-License-Identifier: MIT
//
// Proofs that need no exploration. Each result names what it depends on; if none applies, the exploration decides.
//
// never_together: being granted means to control a whole plan at once (4.4, Grant), so whatever is in every plan of a
// group is controlled for it for as long as it is granted. A group has one holder. Two groups that share such a part
// can be granted together only if the part is held by the same edge for both, and following that edge's requester
// upwards, only if one of the two is part of a plan of the other, which is ruled out. Or their conditions exclude each
// other: after every micro-step the `when` or the `stay` of the active provider of a granted group holds, except
// conditions on states that the provider itself causes (4.3), and both for the same values.
//
// beats: a pass is greedy in order, so what a unit finds taken was taken by units that go before it. If both groups are
// requested by root alone and neither leads to the other, any two edges of the two sides meet at root, where rules 3
// and 4 of 4.1 compare the root edges: the winner's side always goes before, and never finds anything taken by the
// loser's. (At rest nothing is stale, so nothing is kept against that order.)
//
// soft: by being granted `to` may take itself and what it may need. If `from` can neither request nor need any of that,
// granting `to` takes nothing from it; and if no group above it needs any of that, or requests it together with what
// leads to `from`, that stops nothing above it either. Otherwise a latch: `to` waits for a value of a state that is
// `of: from` and does not begin with that value, that only one causing provider of `from` ever sets, and that the
// `when` and `stay` of all its other providers exclude. Then from the moment in which the causing provider set it the
// condition holds at most for as long as `from` is live, and that provider is the active one: a stop of `from` resets
// the value before anything else is decided.
//
// can_run: the facts of the checks decide for every provider whether it may ever run; they are an over-approximation,
// for programs that disable no provider. If the same facts for programs that do prove less, the reason says so.
//
// The same facts prove what is asserted of a group that never runs. Such a group is never granted, so it is never
// granted together with another one, and nothing passes to it or from it. A group that nothing requests is never
// blocked, nor is anything below it; if nothing holds it for a need either, its side holds nothing.
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/plans/plans.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/explore/verdict.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/model/closure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace director::compiler {

namespace {

bool has(const std::vector<GroupId>& groups, GroupId group) {
  return std::find(groups.begin(), groups.end(), group) != groups.end();
}

Verdict proven(std::string why) {
  Verdict out;
  out.kind = Verdict::Kind::proven;
  out.why = std::move(why);
  return out;
}

/// A group that is in every plan of both; empty if there is none.
std::optional<GroupId> shared_part(const Model& model, const analysis::Indispensable& parts, GroupId a, GroupId b) {
  if (has(needed_by(model, a), b) || has(needed_by(model, b), a)) return {};
  if (!parts.of(a) || !parts.of(b)) return {};
  for (const GroupId part : *parts.of(a)) {
    if (has(*parts.of(b), part)) return part;
  }
  return {};
}

/// Whether some state would need two values.
bool exclude(const Model& model, ProviderId p, const std::vector<ConditionUse>& of_p, ProviderId q,
             const std::vector<ConditionUse>& of_q) {
  const auto waived = [&](ProviderId id, StateId state) {
    const std::vector<ConditionUse>& promises = model.providers[id].causing;
    return std::any_of(promises.begin(), promises.end(),
                       [&](const ConditionUse& use) { return model.conditions[use.id].state == state; });
  };
  for (const ConditionUse& a : of_p) {
    for (const ConditionUse& b : of_q) {
      const Condition &one = model.conditions[a.id], &other = model.conditions[b.id];
      if (one.state == other.state && !one.accepts.overlaps(other.accepts) && !waived(p, one.state) &&
          !waived(q, one.state))
        return true;
    }
  }
  return false;
}

bool exclude(const Model& model, GroupId a, GroupId b) {
  const auto never_both = [&](ProviderId p, ProviderId q) {
    const Provider &one = model.providers[p], &other = model.providers[q];
    for (const auto* of_p : {&one.when, &one.stay}) {
      for (const auto* of_q : {&other.when, &other.stay}) {
        const bool there = (of_p == &one.when || !of_p->empty()) && (of_q == &other.when || !of_q->empty());
        if (there && !exclude(model, p, *of_p, q, *of_q)) return false;
      }
    }
    return true;
  };
  for (const ProviderId p : model.groups[a].providers) {
    for (const ProviderId q : model.groups[b].providers) {
      if (!never_both(p, q)) return false;
    }
  }
  return true;
}

std::optional<Verdict> never_together(const Assertion& assertion, const Model& model) {
  const analysis::Indispensable parts(model);
  std::vector<std::string> shared;
  bool excluded = false;
  for (std::size_t i = 0; i < assertion.groups.size(); ++i) {
    for (std::size_t j = i + 1; j < assertion.groups.size(); ++j) {
      const GroupId a = assertion.groups[i].id, b = assertion.groups[j].id;
      const std::optional<GroupId> part = shared_part(model, parts, a, b);
      if (!part && (a == b || !exclude(model, a, b))) return {};
      excluded = excluded || !part;
      if (!part) continue;
      std::string word = analysis::name_of(model, *part);
      if (std::find(shared.begin(), shared.end(), word) == shared.end()) shared.push_back(std::move(word));
    }
  }
  const std::string conditions = "their conditions exclude each other";
  if (shared.empty()) return proven(conditions);
  return proven(fmt::format("{}no two of them can be granted without {}, and a group has one holder",
                            excluded ? conditions + ", or " : "", fmt::join(shared, " or ")));
}

/// All groups to which edges lead from this one, itself included.
std::vector<GroupId> below(const Model& model, GroupId group) {
  std::vector<GroupId> out{group};
  add_led_to(model, out);
  return out;
}

/// The edge from root, if no other edge leads to it.
std::optional<EdgeId> only_root_edge(const Model& model, GroupId group) {
  const std::vector<EdgeId>& requesters = model.groups[group].requesters;
  if (requesters.size() != 1 || model.edges[requesters.front()].requester) return {};
  return requesters.front();
}

std::optional<Verdict> beats(const Assertion& assertion, const Model& model) {
  const GroupId winner = assertion.groups.front().id, loser = assertion.groups.back().id;
  const std::optional<EdgeId> first = only_root_edge(model, winner), second = only_root_edge(model, loser);
  if (!first || !second || winner == loser) return {};
  const auto priority = [](const Level& a, const Level& b) { return a.priority < b.priority; };
  const std::vector<Level>&high = model.edges[*first].levels, &low = model.edges[*second].levels;
  if (std::min_element(high.begin(), high.end(), priority)->priority <=
      std::max_element(low.begin(), low.end(), priority)->priority)
    return {};
  const bool always_optional = std::all_of(low.begin(), low.end(), [](const Level& level) { return level.optional; });
  bool optional = model.edges[*first].has_optional();
  for (const GroupId group : below(model, winner)) {
    for (const EdgeId edge : model.groups[group].edges) optional = optional || model.edges[edge].has_optional();
  }
  if (optional && !always_optional) return {};
  return proven("both are requested by the program alone, and at root its side always goes first");
}

const ConditionUse* on_state(const Model& model, const std::vector<ConditionUse>& uses, StateId state) {
  const auto at = std::find_if(uses.begin(), uses.end(),
                               [&](const ConditionUse& use) { return model.conditions[use.id].state == state; });
  return at == uses.end() ? nullptr : &*at;
}

bool may_set(const Model& model, const std::vector<ConditionUse>& uses, const Condition& wanted) {
  return std::any_of(uses.begin(), uses.end(), [&](const ConditionUse& use) {
    const Condition& set = model.conditions[use.id];
    return set.state == wanted.state && set.accepts.overlaps(wanted.accepts);
  });
}

/// Whether the condition is false whenever one of these holds.
bool excludes(const Model& model, const std::vector<ConditionUse>& uses, const Condition& wanted) {
  return std::any_of(uses.begin(), uses.end(), [&](const ConditionUse& use) {
    const Condition& other = model.conditions[use.id];
    return other.state == wanted.state && !other.accepts.overlaps(wanted.accepts);
  });
}

/// The provider of `from` that alone latches the wanted value; empty if it is no latch.
std::optional<ProviderId> latched_by(const Model& model, GroupId from, const Condition& wanted) {
  const State& state = model.states[wanted.state];
  if (!state.of || state.of->id != from || state.external || state.expires || !state.initial ||
      wanted.accepts.contains(*state.initial))
    return {};
  std::optional<ProviderId> out;
  for (const ProviderId id : model.providers.ids()) {
    const Provider& provider = model.providers[id];
    if (!may_set(model, provider.causing, wanted) && !may_set(model, provider.sets, wanted)) continue;
    if (out || provider.group != from || on_state(model, provider.causing, wanted.state) == nullptr) return {};
    out = id;
  }
  for (const Group& group : model.groups) {
    for (const auto* handler : {&group.start, &group.stop}) {
      if (*handler && may_set(model, (*handler)->sets, wanted)) return {};
    }
  }
  for (const ProviderId id : model.groups[from].providers) {
    const Provider& provider = model.providers[id];
    const bool excluded =
        excludes(model, provider.when, wanted) && (provider.stay.empty() || excludes(model, provider.stay, wanted));
    if (id != out && !excluded) return {};
  }
  return out;
}

std::optional<Verdict> latch(const Model& model, GroupId from, GroupId to) {
  std::optional<ProviderId> by;
  for (const ProviderId id : model.groups[to].providers) {
    std::optional<ProviderId> one;
    for (const ConditionUse& use : model.providers[id].when) {
      if (!one) one = latched_by(model, from, model.conditions[use.id]);
    }
    if (!one) return {};
    by = one;
  }
  return proven(fmt::format("{} waits for what only `{}` sets, and only while that runs", analysis::name_of(model, to),
                            model.full_name(*by)));
}

using analysis::Facts;

Facts facts_of(const Model& model, analysis::Enabled enabled = analysis::Enabled::all) {
  return analysis::find_facts(model, make_graph(model), analysis::Reported::as_is, enabled);
}

/// Why `holds` is true of what can happen, and whether it is also true if the program disables providers. The facts
/// prove what never happens; they do not prove that something happens.
template <class Holds>
std::string why_nothing_runs(const Model& model, const Facts& facts, GroupId group, Holds holds) {
  const std::string name = analysis::name_of(model, group);
  return fmt::format(fmt::runtime(facts.requested.contains(group) ? "no provider of {} can ever run{}"
                                                                  : "nothing that runs requests {}{}"),
                     name, holds(facts_of(model, analysis::Enabled::some)) ? "" : ", unless a provider is disabled");
}

/// Empty: it may run.
std::string why_it_never_runs(const Model& model, const Facts& facts, GroupId group) {
  const auto never_runs = [&](const Facts& known) { return !model.has_any(group, known.active); };
  return never_runs(facts) ? why_nothing_runs(model, facts, group, never_runs) : std::string{};
}

std::optional<Verdict> can_run(const Assertion& assertion, const Model& model) {
  std::string why = why_it_never_runs(model, facts_of(model), assertion.groups.front().id);
  if (why.empty()) return {};
  Verdict out;
  out.kind = Verdict::Kind::refuted;
  out.why = std::move(why);
  return out;
}

/// That all but one of these groups never run. `soft`, `never_together`: of two groups one is enough.
std::optional<Verdict> never_run(const Assertion& assertion, const Model& model) {
  const Facts facts = facts_of(model);
  std::vector<std::string> reasons;
  for (const Use<GroupId>& use : assertion.groups) {
    std::string why = why_it_never_runs(model, facts, use.id);
    if (!why.empty()) reasons.push_back(std::move(why));
  }
  if (reasons.empty() || reasons.size() + 1 < assertion.groups.size()) return {};
  return proven(fmt::format("{}", fmt::join(reasons, ", and ")));
}

/// That the winner's side requests nothing, or the loser's holds nothing.
std::optional<Verdict> without_a_side(const Assertion& assertion, const Model& model) {
  const GroupId winner = assertion.groups.front().id, loser = assertion.groups.back().id;
  const Facts facts = facts_of(model);
  const std::vector<EdgeId>& holders = model.groups[loser].requesters;
  for (const GroupId group : {winner, loser}) {
    const auto has_no_side = [&](const Facts& known) {
      const auto holds = [&](EdgeId edge) { return known.holding.contains(edge); };
      return !known.requested.contains(group) &&
             (group == winner || std::none_of(holders.begin(), holders.end(), holds));
    };
    if (has_no_side(facts)) return proven(why_nothing_runs(model, facts, group, has_no_side));
  }
  return {};
}

/// What a group may lose so that it stops: itself and its needs; and what is requested in one pack, or flat list,
/// with it, for these tasks may be one unit.
void add_stakes(const Model& model, GroupId group, std::vector<GroupId>& to) {
  to.push_back(group);
  const std::vector<GroupId> needs = needed_by(model, group);
  to.insert(to.end(), needs.begin(), needs.end());
}

/// By what `from`, or a group above it, may stop if another group takes it.
std::vector<GroupId> stakes_of(const Model& model, GroupId from) {
  std::vector<GroupId> out = below(model, from), above{from};
  for (std::size_t i = 0; i < above.size(); ++i) {
    add_stakes(model, above[i], out);
    for (const EdgeId edge : model.groups[above[i]].requesters) {
      const std::optional<GroupId> requester = model.edges[edge].requester;
      if (!requester) continue;
      for (const ProviderId id : model.groups[*requester].providers) {
        for (const Pack& pack : model.providers[id].packs) {
          const auto leads = [&](const Task& task) { return task.edge == edge; };
          if (std::none_of(pack.tasks.begin(), pack.tasks.end(), leads)) continue;
          for (const Task& task : pack.tasks) add_stakes(model, task.target, out);
        }
      }
      if (!has(above, *requester)) above.push_back(*requester);
    }
  }
  return out;
}

std::optional<Verdict> soft(const Assertion& assertion, const Model& model) {
  const GroupId from = assertion.groups.front().id, to = assertion.groups.back().id;
  std::vector<GroupId> takes = needed_by(model, to);
  takes.push_back(to);
  const std::vector<GroupId> stakes = stakes_of(model, from);
  const bool apart = std::none_of(takes.begin(), takes.end(), [&](GroupId group) { return has(stakes, group); });
  if (!apart) return latch(model, from, to);
  return proven(fmt::format("being granted, {} takes nothing that {} requests or needs, or a group above it needs",
                            analysis::name_of(model, to), analysis::name_of(model, from)));
}

} // namespace

std::optional<Verdict> prove_at_once(const Assertion& assertion, const Model& model) {
  const auto either = [&](auto first, auto second) {
    std::optional<Verdict> out = first(assertion, model);
    return out ? out : second(assertion, model);
  };
  switch (assertion.kind) {
  case Assertion::Kind::never_together: return either(never_together, never_run);
  case Assertion::Kind::beats: return either(beats, without_a_side);
  case Assertion::Kind::soft: return either(soft, never_run);
  case Assertion::Kind::can_run: return can_run(assertion, model);
  }
  return {};
}

} // namespace director::compiler
