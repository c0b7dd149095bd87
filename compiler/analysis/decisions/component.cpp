// Header: compiler/analysis/decisions/component.hpp. Test: tests/property/decisions_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/decisions/component.hpp"

#include "compiler/base/disjoint_sets.hpp"

#include <algorithm>
#include <map>

namespace director::analysis {

namespace {

class Maker {
public:
  Maker(const Model& model, const Facts& facts, Reported reported, const IdTable<StateId, std::vector<Source>>& sources,
        const std::vector<GroupId>& groups)
      : model_(model),
        facts_(facts),
        reported_(reported),
        sources_(sources),
        ids_(groups) {}

  std::optional<Component> make() {
    if (ids_.size() > Component::most_groups) return std::nullopt;
    for (const GroupId id : ids_) number(group_, id);
    add_edges();
    if (out_.edges.size() > Component::most_edges || out_.roots > Component::most_roots) return std::nullopt;
    add_states();
    if (out_.states.size() > Component::most_states || out_.conditions.size() > Component::most_conditions)
      return std::nullopt;
    for (const GroupId id : ids_) {
      for (const ProviderId provider : model_.groups[id].providers) number(provider_, provider);
    }
    if (provider_.size() > Component::most_providers || too_many_) return std::nullopt;
    for (const GroupId id : ids_) add_group(id);
    for (const GroupId id : ids_) {
      for (const ProviderId provider : model_.groups[id].providers) add_provider(provider);
    }
    for (Component::ProviderRow& row : out_.providers) {
      // A provider without a plan is never granted, unless that is reported: then it is assumed to need nothing.
      if (facts_.plans[row.id] == PlanVerdict::undecided) return std::nullopt;
      if (facts_.plans[row.id] == PlanVerdict::none && reported_ == Reported::corrected) {
        row.plans.emplace_back();
        continue;
      }
      Plan plan;
      Open open;
      add_needs(row.id, open);
      add_plans(open, bit(row.group), plan, row.plans);
      if (row.plans.size() > Component::most_plans) return std::nullopt;
    }
    find_reach();
    return std::move(out_);
  }

private:
  using Plan = Component::Plan;
  using Open = std::vector<std::pair<Row, GroupId>>; ///< needs that are not met yet, the next one last

  template <class Id>
  static void number(std::map<Id, Row>& rows, Id id) {
    rows.emplace(id, static_cast<Row>(rows.size()));
  }

  void add_edges() {
    const auto add = [&](EdgeId id) {
      const Edge& edge = model_.edges[id];
      if (out_.edges.size() > Component::most_edges) return;
      number(edge_, id);
      Component::EdgeRow& row = out_.edges.emplace_back();
      row.id = id;
      row.requester = edge.requester ? group_.at(*edge.requester) : nothing;
      row.target = group_.at(edge.target);
      row.levels = edge.levels;
      row.as_need.priority = edge.levels.empty() ? 0 : edge.levels.front().priority;
    };
    for (const Task& root : model_.roots) {
      if (group_.contains(root.target)) add(root.edge), ++out_.roots;
    }
    for (const GroupId id : ids_) {
      for (const EdgeId edge : model_.groups[id].edges) add(edge);
    }
  }

  void add_states() {
    for (const GroupId id : ids_) {
      for (const ProviderId provider : model_.groups[id].providers) {
        for (const auto* uses : {&model_.providers[provider].when, &model_.providers[provider].stay}) {
          for (const ConditionUse& use : *uses) {
            number(condition_, use.id);
            number(state_, model_.conditions[use.id].state);
          }
        }
      }
    }
    out_.states.resize(state_.size());
    out_.conditions.resize(condition_.size());
    if (state_.size() > Component::most_states || condition_.size() > Component::most_conditions) return;
    kinds_.resize(state_.size());
    for (const auto& [id, row] : state_) add_state(id, row, sources_[id]);
    for (const auto& [id, row] : condition_) {
      const Condition& condition = model_.conditions[id];
      out_.conditions[row] = {id, state_.at(condition.state), 0};
      for (const Row kind : kinds_of(out_.conditions[row].state, condition.accepts))
        out_.conditions[row].accepts |= bit(kind);
    }
  }

  /// Values that satisfy the same conditions are of one kind.
  void add_state(StateId id, Row row, const std::vector<Source>& sources) {
    const State& state = model_.states[id];
    std::map<std::vector<bool>, ValueSet> kinds;
    std::vector<const ValueSet*> accepted;
    for (const auto& [condition, unused] : condition_) {
      if (model_.conditions[condition].state == id) accepted.push_back(&model_.conditions[condition].accepts);
    }
    for (const ValueSet::Interval& piece : pieces_of(state.low, state.high, accepted)) {
      std::vector<bool> satisfied;
      for (const ValueSet* accepts : accepted) satisfied.push_back(accepts->contains(piece.low));
      kinds[satisfied].add_last(piece);
    }
    if (kinds.size() > Component::most_values) too_many_ = true;
    for (const auto& [unused, values] : kinds) kinds_[row].push_back(values);
    Component::StateRow& out = out_.states[row];
    out.id = id;
    out.values = static_cast<Row>(kinds_[row].size());
    out.initial = state.initial ? kinds_of(row, ValueSet::single(*state.initial)).front() : out.values;
    for (const Source& source : sources) {
      const std::vector<Row> values = kinds_of(row, source.values);
      const bool is_ours = (source.provider && group_.contains(model_.providers[*source.provider].group)) ||
                           (source.group && group_.contains(*source.group));
      if (is_ours || source.kind == Source::Kind::initial) continue;
      if (source.provider || source.group)
        add_all(values, out.at_any_time);
      else
        add_all(values, out.from_outside);
    }
    if (state.of && !group_.contains(state.of->id)) add_all({out.initial}, out.at_any_time);
    if (state.expires && !state.expires->to) add_all({out.values}, out.from_outside);
    for (const Impossible& fault : facts_.impossible) {
      if (fault.state == id && fault.why != Impossible::Why::contradictory)
        add_all(kinds_of(row, state.domain()), out.at_any_time);
    }
  }

  static void add_all(const std::vector<Row>& values, std::vector<Row>& out) {
    for (const Row value : values) {
      if (std::find(out.begin(), out.end(), value) == out.end()) out.push_back(value);
    }
  }

  std::vector<Row> kinds_of(Row state, const ValueSet& values) const {
    std::vector<Row> out;
    for (Row kind = 0; kind < kinds_[state].size(); ++kind) {
      if (kinds_[state][kind].overlaps(values)) out.push_back(kind);
    }
    return out;
  }

  std::vector<Component::Setting> settings(const std::vector<ConditionUse>& first,
                                           const std::vector<ConditionUse>& second) const {
    std::vector<Component::Setting> out;
    for (const auto* uses : {&first, &second}) {
      for (const ConditionUse& use : *uses) {
        const Condition& condition = model_.conditions[use.id];
        const auto state = state_.find(condition.state);
        if (state == state_.end()) continue;
        auto at = std::find_if(out.begin(), out.end(), [&](const auto& each) { return each.state == state->second; });
        if (at == out.end()) at = out.insert(out.end(), {state->second, {}});
        add_all(kinds_of(state->second, condition.accepts), at->values);
      }
    }
    return out;
  }

  void add_group(GroupId id) {
    const Group& group = model_.groups[id];
    Component::GroupRow& row = out_.groups.emplace_back();
    row.id = id;
    for (const ProviderId provider : group.providers) row.providers.push_back(provider_.at(provider));
    for (const EdgeId edge : group.edges) row.edges.push_back(edge_.at(edge));
    for (const EdgeId edge : group.requesters) row.requesters.push_back(edge_.at(edge));
    if (group.start) row.start = settings(group.start->sets, {});
    if (group.stop) row.stop = settings(group.stop->sets, {});
    for (const auto& [state, place] : state_) {
      const auto& owner = model_.states[state].of;
      if (owner && owner->id == id) row.owned.push_back(place);
    }
  }

  void add_provider(ProviderId id) {
    const Provider& provider = model_.providers[id];
    Component::ProviderRow& row = out_.providers.emplace_back();
    row.id = id;
    row.group = group_.at(provider.group);
    for (const ConditionUse& use : provider.when) row.when.push_back(condition_.at(use.id));
    for (const ConditionUse& use : provider.stay) row.stay.push_back(condition_.at(use.id));
    for (const Impossible& fault : facts_.impossible_of(id))
      row.unsure = row.unsure || (!fault.stay && fault.why == Impossible::Why::contradictory);
    for (const ConditionUse& promise : provider.causing) {
      const auto state = state_.find(model_.conditions[promise.id].state);
      if (state == state_.end()) continue;
      row.causes_states |= bit(state->second);
      for (const auto& [condition, place] : condition_) {
        if (model_.satisfies(promise.id, condition)) row.causes |= bit(place);
      }
    }
    row.sets = settings(provider.causing, provider.sets);
    for (const Pack& pack : provider.packs) {
      Component::PackRow& out = row.packs.emplace_back();
      for (const Task& task : pack.tasks) {
        Component::Entry& entry = out.entries.emplace_back();
        entry.edge = edge_.at(task.edge);
        entry.may_lack = !provider.has_packs;
        for (const Task::NamedLevel& level : task.levels) {
          add_all({static_cast<Row>(level.level)}, entry.levels);
          entry.may_lack = entry.may_lack || model_.edges[task.edge].levels[level.level].optional;
        }
        const Level& usual = model_.edges[task.edge].levels[task.levels.front().level];
        if (usual.shares_unit() && provider.has_packs) out.members.push_back(entry.edge);
      }
      if (out.members.size() < 2) out.members.clear();
    }
    if (row.packs.empty()) row.packs.emplace_back();
  }

  void add_needs(ProviderId id, Open& open) const {
    const Provider& provider = model_.providers[id];
    for (auto need = provider.needs.rbegin(); need != provider.needs.rend(); ++need)
      open.emplace_back(group_.at(provider.group), need->id);
  }

  /// Every choice of a provider for each need, and for what these need, no group twice (semantics.md, section 1).
  void add_plans(Open open, Rows held, Plan& plan, std::vector<Plan>& out) const {
    if (out.size() > Component::most_plans) return;
    if (open.empty()) return out.push_back(plan);
    const auto [needer, id] = open.back();
    open.pop_back();
    const Row group = group_.at(id);
    if ((held & bit(group)) != 0) return;
    Row by = 0;
    for (const Row edge : out_.groups[needer].edges) {
      if (out_.edges[edge].target == group) by = edge;
    }
    for (const Row provider : out_.groups[group].providers) {
      plan.push_back({group, provider, needer, by});
      Open rest = open;
      add_needs(out_.providers[provider].id, rest);
      add_plans(std::move(rest), held | bit(group), plan, out);
      plan.pop_back();
    }
  }

  void find_reach() {
    for (Component::GroupRow& row : out_.groups) {
      std::vector<Row> open(row.edges);
      while (!open.empty()) {
        const Row target = out_.edges[open.back()].target;
        open.pop_back();
        if ((row.may_request & bit(target)) != 0) continue;
        row.may_request |= bit(target);
        open.insert(open.end(), out_.groups[target].edges.begin(), out_.groups[target].edges.end());
      }
      row.below = row.may_request | bit(group_.at(row.id));
    }
  }

  const Model& model_;
  const Facts& facts_;
  Reported reported_;
  const IdTable<StateId, std::vector<Source>>& sources_;
  const std::vector<GroupId>& ids_;
  Component out_;
  std::map<GroupId, Row> group_;
  std::map<ProviderId, Row> provider_;
  std::map<EdgeId, Row> edge_;
  std::map<StateId, Row> state_;
  std::map<ConditionId, Row> condition_;
  std::vector<std::vector<ValueSet>> kinds_; ///< of each state
  bool too_many_ = false;
};

} // namespace

std::optional<Component> make_component(const Model& model, const Facts& facts, Reported reported,
                                        const IdTable<StateId, std::vector<Source>>& sources,
                                        const std::vector<GroupId>& groups) {
  return Maker(model, facts, reported, sources, groups).make();
}

std::vector<std::vector<GroupId>> small_components(const Model& model) {
  // A group with a promise for a state is joined with each group that has conditions on it, whatever the values.
  DisjointSets sets(model.groups.size());
  const auto join = [&](GroupId a, GroupId b) { sets.join(a.value, b.value); };
  for (const Edge& edge : model.edges) {
    if (edge.requester) join(*edge.requester, edge.target);
  }
  IdTable<StateId, std::optional<GroupId>> causer(model.states.size());
  for (const Provider& provider : model.providers) {
    for (const ConditionUse& use : provider.causing) {
      std::optional<GroupId>& first = causer[model.conditions[use.id].state];
      if (first) join(*first, provider.group);
      first = provider.group;
    }
  }
  for (const Provider& provider : model.providers) {
    for (const auto* uses : {&provider.when, &provider.stay}) {
      for (const ConditionUse& use : *uses) {
        if (const auto& first = causer[model.conditions[use.id].state]) join(*first, provider.group);
      }
    }
  }
  std::map<std::uint32_t, std::vector<GroupId>> rows;
  for (const GroupId id : model.groups.ids()) rows[sets.find(id.value)].push_back(id);
  std::vector<std::vector<GroupId>> out;
  for (auto& [unused, groups] : rows) {
    if (groups.size() <= Component::most_groups) out.push_back(std::move(groups));
  }
  return out;
}

} // namespace director::analysis
