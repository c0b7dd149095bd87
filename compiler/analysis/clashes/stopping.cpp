// Header: compiler/analysis/clashes/stopping.hpp. Test: compiler/checks/push_in_vain.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/clashes/stopping.hpp"

#include <algorithm>
#include <tuple>

namespace director::analysis {

namespace {

/// Limit, beyond which nothing is reported: real behaviours take some tens of steps for a condition.
constexpr std::size_t most_steps = 200;
/// Limit: more conditions are hardly ever lost together, and the search would be quadratic in the length of a cycle.
constexpr std::size_t most_lost = 3;

} // namespace

void Stopping::suppose_lost(ConditionId id) {
  lost_.emplace(model_.conditions[id].state, id);
  order_.push_back(id);
}

bool Stopping::lose(ConditionId id) {
  if (!may_be_lacking(id)) return false;
  suppose_lost(id);
  const Condition& condition = model_.conditions[id];
  const std::vector<Source>& all = sources_[condition.state];
  return std::all_of(all.begin(), all.end(), [&](const Source& source) {
    return !source.values.overlaps(condition.accepts) || cannot_act(source);
  });
}

bool Stopping::cannot_run(GroupId group, bool lose_more) {
  const std::vector<ProviderId>& all = model_.groups[group].providers;
  return std::all_of(all.begin(), all.end(), [&](ProviderId id) { return cannot_run(id, lose_more); });
}

/// Tries what is lost already first, to lose no more than necessary.
bool Stopping::cannot_run(ProviderId id, bool lose_more) {
  if (is_stopped(id)) return true;
  if (steps_++ > most_steps) return false;
  const auto is_lost_now = [&](const ConditionUse& use) { return is_lost(use.id); };
  const auto becomes_lost = [&](const ConditionUse& use) { return lose_too(use.id); };
  const auto stop = [&] { return stopped_.insert(id).second; };
  return tries([&] { return stop() && lacks(id, is_lost_now); }) ||
         tries([&] { return stop() && is_unrequested(model_.providers[id].group, lose_more); }) ||
         (lose_more && tries([&] { return stop() && lacks(id, becomes_lost); }));
}

std::optional<ConditionUse> Stopping::lacked_by(ProviderId id) const {
  for (const ConditionUse& use : model_.providers[id].when) {
    if (is_lost(use.id) && is_always_needed(id, use)) return use;
  }
  return std::nullopt;
}

bool Stopping::is_lost(ConditionId id) const {
  const Condition& condition = model_.conditions[id];
  const auto at = lost_.find(condition.state);
  return at != lost_.end() && condition.accepts.subset_of(model_.conditions[at->second].accepts);
}

bool Stopping::may_be_lacking(ConditionId id) const {
  const Condition& condition = model_.conditions[id];
  return model_.states[condition.state].may_be_unset() || !facts_.values[condition.state].subset_of(condition.accepts);
}

/// At most one condition of a state, so that all of them may be false at one time.
bool Stopping::lose_too(ConditionId id) {
  return order_.size() < most_lost && lost_.count(model_.conditions[id].state) == 0 && tries([&] { return lose(id); });
}

/// Undoes all changes if the attempt fails.
template <class Attempt>
bool Stopping::tries(const Attempt& attempt) {
  const auto before = std::tuple(lost_, order_, stopped_);
  if (attempt()) return true;
  std::tie(lost_, order_, stopped_) = before;
  return false;
}

/// A stop may come together with the loss, and a state of a stopped group has its initial value.
bool Stopping::cannot_act(const Source& source) {
  switch (source.kind) {
  case Source::Kind::initial: return !model_.states[source.state].of.has_value();
  case Source::Kind::external:
  case Source::Kind::expires:
  case Source::Kind::stop: return false;
  case Source::Kind::causing:
  case Source::Kind::sets: return cannot_run(*source.provider, true);
  case Source::Kind::start: return cannot_run(*source.group, true);
  }
  return false;
}

/// Neither its `when` nor its `stay` can hold without it, and no push waives it.
bool Stopping::is_always_needed(ProviderId id, const ConditionUse& use) const {
  const Condition& condition = model_.conditions[use.id];
  const Provider& provider = model_.providers[id];
  if (facts_.is_impossible(id, condition.state)) return false; // treated as corrected
  const auto is_of_state = [&](const ConditionUse& other) {
    return model_.conditions[other.id].state == condition.state;
  };
  if (facts_.pushed.contains(id) && std::any_of(provider.causing.begin(), provider.causing.end(), is_of_state))
    return false;
  if (provider.stay.empty()) return true;
  const Region stay = region_of(model_, provider.stay);
  const auto at = stay.states.find(condition.state);
  return at != stay.states.end() && at->second.subset_of(condition.accepts);
}

/// By itself, or by all providers of a need.
template <class Takes>
bool Stopping::lacks(ProviderId id, const Takes& takes) {
  const Provider& provider = model_.providers[id];
  if (std::any_of(provider.when.begin(), provider.when.end(),
                  [&](const ConditionUse& use) { return is_always_needed(id, use) && takes(use); }))
    return true;
  return std::any_of(provider.needs.begin(), provider.needs.end(), [&](const Use<GroupId>& need) {
    if (!facts_.may_wait.contains(need.id) || steps_++ > most_steps) return false;
    const std::vector<ProviderId>& all = model_.groups[need.id].providers;
    return std::all_of(all.begin(), all.end(),
                       [&](ProviderId each) { return !facts_.capable.contains(each) || lacks(each, takes); });
  });
}

/// Whether all its requesters are stopped.
bool Stopping::is_unrequested(GroupId group, bool lose_more) {
  const std::vector<EdgeId>& requesters = model_.groups[group].requesters;
  return std::all_of(requesters.begin(), requesters.end(), [&](EdgeId id) {
    const Edge& edge = model_.edges[id];
    if (edge.levels.empty()) return true;
    return edge.requester.has_value() && cannot_run(*edge.requester, lose_more);
  });
}

} // namespace director::analysis
