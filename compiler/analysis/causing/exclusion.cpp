// Header: compiler/analysis/causing/exclusion.hpp. Test: compiler/checks/uncovered_state.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/exclusion.hpp"

#include "compiler/analysis/chains/sparse_set.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/model/closure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace director::analysis {

namespace {

using dsl::Note;

class Exclusion {
public:
  Exclusion(const Model& model, const Facts& facts, ProviderId id, const Task* reported)
      : model_(model),
        facts_(facts),
        id_(id),
        reported_entry_(reported) {}

  std::vector<Note> run() {
    for (const Use<GroupId>& need : model_.providers[id_].needs) needed_.push_back(need.id);
    add_needed(model_, needed_);
    find_states();
    if (states_.empty()) return {};
    if (facts_.excluded.contains(id_)) explain_above();
    explain_conditions(id_);
    for (const GroupId group : needed_) {
      for (const ProviderId id : model_.groups[group].providers) explain_conditions(id);
    }
    return std::move(notes_);
  }

private:
  /// Finds the states for which two sets of conditions accept no common value; if it takes more than two sets, the
  /// states of at least two of them.
  void find_states() {
    std::vector<std::vector<Region>> parties{{facts_.region_to_begin(model_, id_)}};
    if (facts_.excluded.contains(id_)) parties.push_back({facts_.grants[model_.providers[id_].group]});
    for (const GroupId group : needed_) {
      std::vector<Region>& party = parties.emplace_back();
      for (const ProviderId id : model_.groups[group].providers) party.push_back(facts_.region_to_begin(model_, id));
    }
    std::set<StateId> shared;
    for (std::size_t i = 0; i < parties.size(); ++i) {
      for (std::size_t j = i + 1; j < parties.size(); ++j) {
        for (const Region& a : parties[i]) {
          for (const Region& b : parties[j]) compare(a, b, shared);
        }
      }
    }
    if (states_.empty()) states_ = std::move(shared);
  }

  void compare(const Region& a, const Region& b, std::set<StateId>& shared) {
    for (const auto& [state, values] : a.states) {
      const auto at = b.states.find(state);
      if (at == b.states.end()) continue;
      shared.insert(state);
      if (!values.intersected(at->second).overlaps(facts_.values[state])) states_.insert(state);
    }
  }

  /// Explains which groups request it, and under which conditions the groups above it run that use these states.
  void explain_above() {
    std::vector<GroupId> open{model_.providers[id_].group};
    SparseSet<GroupId> seen;
    seen.add(open.front());
    for (std::size_t next = 0; next < open.size() && notes_.size() < most_alike; ++next) {
      for (const EdgeId edge : model_.groups[open[next]].requesters) {
        const auto requester = model_.edges[edge].requester;
        if (!requester) continue;
        bool any_requests = false;
        for (const ProviderId id : model_.groups[*requester].providers) {
          if (!facts_.active.contains(id)) continue;
          any_requests = explain_request(id, open[next]) || any_requests;
          explain_conditions(id);
        }
        if (any_requests && seen.add(*requester)) open.push_back(*requester);
      }
    }
  }

  bool explain_request(ProviderId id, GroupId group) {
    const auto [pack, task] = find_entry(model_, id, group);
    if (task == nullptr) return false;
    if (task != reported_entry_) notes_.push_back(requests(model_, id, *task));
    explain_members(*pack, *task);
    return true;
  }

  /// Explains which tasks are granted only together with it, if their conditions use these states.
  void explain_members(const Pack& pack, const Task& task) {
    if (pack.name.empty() || !model_.may_be_member(task)) return;
    for (const Task& other : pack.tasks) {
      if (&other == &task || !model_.may_be_member(other) || !has_conditions(other.target)) continue;
      notes_.push_back({other.span, fmt::format("it is granted only together with {}", name_of(model_, other.target))});
      for (const ProviderId id : model_.groups[other.target].providers) explain_conditions(id);
    }
  }

  void explain_conditions(ProviderId id) {
    if (!reported_.insert(id).second) return;
    for (const ConditionUse& use : model_.providers[id].when) {
      if (states_.count(model_.conditions[use.id].state) != 0) notes_.push_back(runs_only_while(model_, id, use));
    }
    const bool needs =
        id == id_ || std::find(needed_.begin(), needed_.end(), model_.providers[id].group) != needed_.end();
    for (const Use<GroupId>& need : model_.providers[id].needs) {
      if (needs && has_conditions(need.id))
        notes_.push_back({need.span, fmt::format("{} needs {}", name_of(model_, id), name_of(model_, need.id))});
    }
  }

  /// Whether one of its providers, or of those below, has conditions on these states.
  bool has_conditions(GroupId group) const {
    std::vector<GroupId> all{group};
    add_needed(model_, all);
    return std::any_of(all.begin(), all.end(), [&](GroupId each) {
      const std::vector<ProviderId>& providers = model_.groups[each].providers;
      return std::any_of(providers.begin(), providers.end(), [&](ProviderId id) {
        const std::vector<ConditionUse>& when = model_.providers[id].when;
        return std::any_of(when.begin(), when.end(), [&](const ConditionUse& use) {
          return states_.count(model_.conditions[use.id].state) != 0;
        });
      });
    });
  }

  const Model& model_;
  const Facts& facts_;
  ProviderId id_;
  const Task* reported_entry_;
  std::vector<GroupId> needed_; ///< that its needs may lead to, the nearest first
  std::set<StateId> states_;
  std::set<ProviderId> reported_;
  std::vector<Note> notes_;
};

} // namespace

std::vector<Note> explain_exclusion(const Model& model, const Facts& facts, ProviderId provider, const Task* reported) {
  return Exclusion(model, facts, provider, reported).run();
}

} // namespace director::analysis
