// Header: compiler/play/coverage/coverage_watch.hpp. Test: tests/compiler/play/coverage/coverage_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/coverage/coverage_watch.hpp"

#include "compiler/model/closure.hpp"

#include <algorithm>

namespace director::compiler {

namespace {

using Kind = CoveragePoint::Kind;

} // namespace

CoverageWatch::CoverageWatch(const Model& model, const Lowered& lowered, Coverage& coverage)
    : model_(model),
      lowered_(lowered),
      coverage_(coverage),
      before_{std::vector<Index>(model.groups.size(), nil), std::vector<Index>(model.groups.size(), nil),
              std::vector<bool>(model.groups.size()), std::vector<Index>(model.edges.size(), nil)} {
  for (std::size_t i = 0; i < coverage.points.size(); ++i) places_.emplace(coverage.points[i].key, i);
  for (const GroupId id : model.groups.ids()) {
    std::vector<GroupId> needed{id};
    add_needed(model, needed);
    needed_.add(std::move(needed));
  }
}

Onlooker CoverageWatch::onlooker() {
  return {[this](ProviderId provider, const Case* answer) { ran(provider, answer); },
          [this](const Engine& engine) { stepped(engine); }};
}

/// Marks a point, if it is one.
void CoverageWatch::mark(const CoveragePoint::Key& key) {
  const auto at = places_.find(key);
  if (at != places_.end()) coverage_.points[at->second].covered = true;
}

void CoverageWatch::ran(ProviderId provider, const Case* answer) {
  mark({Kind::provider, provider.value});
  if (answer != nullptr && answer->named_pack) mark({Kind::pack, provider.value, *answer->named_pack});
}

CoverageWatch::Assignment CoverageWatch::assignment(const Engine& engine) const {
  Assignment out;
  for (Index g = 0; g < model_.groups.size(); ++g) {
    out.active.push_back(engine.active(g));
    out.holders.push_back(engine.holder(g));
    out.pushed.push_back(engine.memory().last[g].push.edge != nil);
  }
  for (Index e = 0; e < model_.edges.size(); ++e) out.requests.push_back(engine.memory().request[e].level);
  return out;
}

void CoverageWatch::stepped(const Engine& engine) {
  look_at_levels(engine.memory());
  look_at_conditions(engine);
  look_at_pushes(engine.memory());
  Assignment now = assignment(engine);
  look_at_take_overs(now, engine);
  before_ = std::move(now);
}

void CoverageWatch::look_at_levels(const director::State& state) {
  for (Index e = 0; e < model_.edges.size(); ++e) {
    const Index level = state.request[e].level;
    if (level != nil) mark({Kind::level, e, level - lowered_.edges[e].levels.begin});
  }
}

bool CoverageWatch::holds(ConditionId id, const Engine& engine) const {
  const Condition& condition = model_.conditions[id];
  const std::int32_t value = engine.value(static_cast<Index>(condition.state.value));
  return value != unset && condition.accepts.contains(value);
}

void CoverageWatch::mark_conditions(Kind kind, ProviderId provider, const std::vector<ConditionUse>& uses,
                                    const Engine& engine) {
  for (const ConditionUse& use : uses) { mark({kind, provider.value, use.id.value, holds(use.id, engine) ? 1U : 0U}); }
}

/// `when` counts while its group is wanted, `stay` while its provider is active, or was until now.
void CoverageWatch::look_at_conditions(const Engine& engine) {
  IdSet<GroupId> wanted(model_.groups.size());
  for (const EdgeId id : model_.edges.ids()) {
    if (engine.memory().request[id.value].level == nil) continue;
    for (const GroupId group : needed_[model_.edges[id].target]) wanted.add(group);
  }
  for (const ProviderId id : model_.providers.ids()) {
    const Provider& provider = model_.providers[id];
    const auto group = static_cast<Index>(provider.group.value);
    if (wanted.contains(provider.group)) mark_conditions(Kind::when, id, provider.when, engine);
    if (before_.active[group] == id.value || engine.active(group) == id.value)
      mark_conditions(Kind::stay, id, provider.stay, engine);
  }
}

void CoverageWatch::look_at_pushes(const director::State& state) {
  for (Index g = 0; g < model_.groups.size(); ++g) {
    const Push& push = state.last[g].push;
    if (push.edge != nil) mark({Kind::push, lowered_.edges[push.edge].target, push.provider});
  }
}

/// The edges up to one of root; empty if a requester in between has no holder.
std::optional<CoverageWatch::Chain> CoverageWatch::chain(Index edge, const std::vector<Index>& holders) const {
  Chain out;
  while (edge < lowered_.edges.size() && out.size() <= holders.size()) {
    out.push_back(edge);
    const Index requester = lowered_.edges[edge].requester;
    if (requester == nil) return out;
    edge = holders[requester];
  }
  return std::nullopt;
}

/// Whether an edge of the chain is, from the sibling down: by its request now, or else before.
bool CoverageWatch::optional_below(const Chain& chain, std::size_t sibling, const Assignment& now) const {
  const auto is_optional = [&](Index edge) {
    const Index level = now.requests[edge] != nil ? now.requests[edge] : before_.requests[edge];
    return level != nil && lowered_.levels[level].optional;
  };
  return std::any_of(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(sibling) + 1, is_optional);
}

/// Whether some provider could run, with what it needs; else the group ended by itself.
bool CoverageWatch::could_go_on(GroupId group, const Engine& engine, std::vector<GroupId>& above) const {
  if (std::find(above.begin(), above.end(), group) != above.end()) return false;
  above.push_back(group);
  const std::vector<ProviderId>& all = model_.groups[group].providers;
  const bool out = std::any_of(all.begin(), all.end(), [&](ProviderId id) {
    const std::vector<Use<GroupId>>& needs = model_.providers[id].needs;
    return meets_conditions(id, engine) && std::all_of(needs.begin(), needs.end(), [&](const Use<GroupId>& need) {
             return could_go_on(need.id, engine, above);
           });
  });
  above.pop_back();
  return out;
}

/// All of its `when`, or of its `stay` if it was active; without those on states that it causes, if it was pushed.
bool CoverageWatch::meets_conditions(ProviderId id, const Engine& engine) const {
  const Provider& provider = model_.providers[id];
  const std::size_t group = provider.group.value;
  const bool was_active = before_.active[group] == id.value;
  const bool was_pushed = was_active && before_.pushed[group];
  const auto is_waived = [&](const ConditionUse& use) {
    return was_pushed &&
           std::any_of(provider.causing.begin(), provider.causing.end(), [&](const ConditionUse& promise) {
             return model_.conditions[promise.id].state == model_.conditions[use.id].state;
           });
  };
  const auto hold = [&](const std::vector<ConditionUse>& uses) {
    return std::all_of(uses.begin(), uses.end(),
                       [&](const ConditionUse& use) { return is_waived(use) || holds(use.id, engine); });
  };
  return hold(provider.when) || (was_active && !provider.stay.empty() && hold(provider.stay));
}

void CoverageWatch::take_over(const Chain& taker, const Chain& loser, const Assignment& now, const Engine& engine) {
  const auto requester = [&](Index edge) { return lowered_.edges[edge].requester; };
  const std::vector<Index>& requests = now.requests;
  for (std::size_t i = 0; i < taker.size(); ++i) {
    for (std::size_t j = 0; j < loser.size(); ++j) {
      if (requester(taker[i]) != requester(loser[j])) continue;
      const Index first = taker[i], second = loser[j];
      if (first == second || requests[first] == nil || requests[second] == nil) return; // the loser gave it up itself
      for (std::size_t k = 0; k < j; ++k) {
        std::vector<GroupId> above;
        if (!could_go_on(GroupId{requester(loser[k])}, engine, above)) return;
      }
      const bool first_optional = optional_below(taker, i, now);
      const bool second_optional = optional_below(loser, j, now);
      const auto priority = [&](Index edge) { return lowered_.levels[requests[edge]].priority; };
      if (first_optional != second_optional ? second_optional : priority(first) > priority(second))
        mark({Kind::take_over, first, second});
      return;
    }
  }
}

/// A group that went from one edge to another while the loser's side was still requested.
void CoverageWatch::look_at_take_overs(const Assignment& now, const Engine& engine) {
  for (Index g = 0; g < now.holders.size(); ++g) {
    if (now.holders[g] == before_.holders[g]) continue;
    const std::optional<Chain> taker = chain(now.holders[g], now.holders),
                               loser = chain(before_.holders[g], before_.holders);
    if (taker && loser) take_over(*taker, *loser, now, engine);
  }
}

} // namespace director::compiler
