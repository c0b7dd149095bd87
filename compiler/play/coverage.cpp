// Header: compiler/play/coverage.hpp. Test: tests/compiler/play/coverage_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/coverage.hpp"

#include "compiler/analysis/chains/claims.hpp"
#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/pushes.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace director::compiler {

namespace {

using Kind = CoveragePoint::Kind;

/// Whether they are granted together, or not at all.
bool in_unit(const analysis::Together& together, const Level& level) {
  return together.provider && level.shares_unit();
}

class Planner {
public:
  Planner(const Model& model, const Graph& graph)
      : model_(model),
        facts_(analysis::find_facts(model, graph)),
        counts_([this](ProviderId id) {
          return facts_.capable.contains(id) && facts_.requested.contains(model_.providers[id].group);
        }),
        branches_(model, counts_, [this](ProviderId id) { return facts_.capable.contains(id); }) {}

  Coverage plan() {
    for (const ProviderId id : model_.providers.ids()) {
      if (counts_(id)) add({Kind::provider, id.value}, model_.providers[id].span);
    }
    plan_packs();
    plan_levels();
    plan_conditions();
    plan_pushes();
    for (const analysis::Together& together : analysis::find_together(model_, counts_)) plan_take_overs(together);
    return std::move(out_);
  }

  std::vector<PossibleTake> takes() {
    std::vector<PossibleTake> out;
    std::map<std::pair<EdgeId, EdgeId>, std::size_t> places;
    for (const analysis::Together& together : analysis::find_together(model_, counts_)) {
      for_each_pair(together, [&](const Task& taker, const Task& loser) {
        takes_some(together, taker, loser, [&](GroupId group, const Winning& ranks) {
          const auto [at, fresh] = places.try_emplace({taker.edge, loser.edge}, out.size());
          if (fresh) out.push_back({taker.edge, loser.edge, std::vector<bool>(model_.groups.size()), {}});
          out[at->second].groups[group.value] = true;
          out[at->second].ranks.insert(ranks);
          return false;
        });
      });
    }
    return out;
  }

private:
  void add(const CoveragePoint::Key& key, Span span) {
    if (seen_.insert(key).second) out_.points.push_back({key, span, false});
  }

  void plan_packs() {
    for (const ProviderId id : model_.providers.ids()) {
      const Provider& provider = model_.providers[id];
      if (!counts_(id) || !provider.has_packs) continue;
      for (std::uint32_t i = 0; i < provider.packs.size(); ++i) add({Kind::pack, id.value, i}, provider.packs[i].span);
    }
  }

  void plan_levels() {
    for (const analysis::Together& together : analysis::find_together(model_, counts_)) {
      for (const Task& task : *together.tasks) {
        for (const Task::NamedLevel& level : task.levels) add({Kind::level, task.edge.value, level.level}, task.span);
      }
    }
  }

  /// Groups that may be wanted: requested, or needed by a provider of a wanted one.
  IdSet<GroupId> wanted() const {
    IdSet<GroupId> out(model_.groups.size());
    std::vector<GroupId> open;
    for (const GroupId id : model_.groups.ids()) {
      if (facts_.requested.contains(id) && out.add(id)) open.push_back(id);
    }
    while (!open.empty()) {
      const GroupId group = open.back();
      open.pop_back();
      for (const ProviderId id : model_.groups[group].providers) {
        for (const Use<GroupId>& need : model_.providers[id].needs) {
          if (out.add(need.id)) open.push_back(need.id);
        }
      }
    }
    return out;
  }

  void plan_condition(Kind kind, ProviderId id, const ConditionUse& use) {
    const Condition& condition = model_.conditions[use.id];
    const ValueSet& values = facts_.values[condition.state];
    const ValueSet accepted = values.intersected(condition.accepts);
    if (!accepted.empty()) add({kind, id.value, use.id.value, 1}, use.span);
    if (model_.states[condition.state].may_be_unset() || accepted != values)
      add({kind, id.value, use.id.value, 0}, use.span);
  }

  void plan_conditions() {
    const IdSet<GroupId> groups = wanted();
    for (const ProviderId id : model_.providers.ids()) {
      const Provider& provider = model_.providers[id];
      if (!groups.contains(provider.group)) continue;
      for (const ConditionUse& use : provider.when) plan_condition(Kind::when, id, use);
      if (!counts_(id)) continue;
      for (const ConditionUse& use : provider.stay) plan_condition(Kind::stay, id, use);
    }
  }

  void plan_pushes() {
    for (const auto& [waiter, causer] : analysis::find_all_pushes(model_, facts_))
      add({Kind::push, waiter.value, causer.value}, model_.providers[causer].span);
  }

  const analysis::Claims& claims(GroupId task) {
    std::unique_ptr<analysis::Claims>& out = claims_[task];
    if (!out) out = std::make_unique<analysis::Claims>(branches_, task);
    return *out;
  }

  void plan_take_overs(const analysis::Together& together) {
    for_each_pair(together, [&](const Task& taker, const Task& loser) {
      if (takes_some(together, taker, loser, [](GroupId, const Winning&) { return true; }))
        add({Kind::take_over, taker.edge.value, loser.edge.value}, taker.span);
    });
  }

  template <class Action>
  static void for_each_pair(const analysis::Together& together, Action action) {
    for (const Task& taker : *together.tasks) {
      for (const Task& loser : *together.tasks) {
        if (taker.edge != loser.edge) action(taker, loser);
      }
    }
  }

  /// Whether some group that it may take, with the ranks by which it may, was `enough`.
  template <class Enough>
  bool takes_some(const analysis::Together& together, const Task& taker, const Task& loser, Enough enough) {
    const analysis::Claims &of_taker = claims(taker.target), &of_loser = claims(loser.target);
    const std::vector<GroupId>& groups = of_taker.groups();
    return std::any_of(groups.begin(), groups.end(), [&](GroupId group) {
      return may_take(together, taker, of_taker, loser, of_loser, group,
                      [&](const Winning& ranks) { return enough(group, ranks); });
    });
  }

  template <class Enough>
  bool may_take(const analysis::Together& together, const Task& taker, const analysis::Claims& of_taker,
                const Task& loser, const analysis::Claims& of_loser, GroupId group, Enough enough) const {
    for (const analysis::Reach takes : analysis::all_reaches) {
      for (const analysis::Reach loses : analysis::all_reaches) {
        const analysis::Claim *first = of_taker.find(group, takes), *second = of_loser.find(group, loses);
        if (first == nullptr || second == nullptr || !analysis::compatible(first->region, second->region)) continue;
        if (goes_before(together, taker, takes, loser, loses, enough)) return true;
      }
    }
    return false;
  }

  /// Whether it does at levels that were `enough`. In a unit nothing is taken from what is granted with it.
  template <class Enough>
  bool goes_before(const analysis::Together& together, const Task& taker, analysis::Reach takes, const Task& loser,
                   analysis::Reach loses, Enough enough) const {
    using analysis::Reach;
    for (const Task::NamedLevel& a : taker.levels) {
      for (const Task::NamedLevel& b : loser.levels) {
        const Level &first = model_.edges[taker.edge].levels[a.level],
                    &second = model_.edges[loser.edge].levels[b.level];
        const bool together_granted = in_unit(together, first) && in_unit(together, second);
        if (together_granted && (takes == Reach::own || loses == Reach::own)) continue;
        const bool first_optional = first.optional || takes == Reach::optional;
        const bool second_optional = second.optional || loses == Reach::optional;
        const bool wins = first_optional != second_optional ? second_optional : first.priority > second.priority;
        if (wins && enough(Winning{{first.priority, first_optional}, {second.priority, second_optional}})) return true;
      }
    }
    return false;
  }

  const Model& model_;
  const analysis::Facts facts_;
  const std::function<bool(ProviderId)> counts_;
  const analysis::Branches branches_;
  std::map<GroupId, std::unique_ptr<analysis::Claims>> claims_;
  std::set<CoveragePoint::Key> seen_;
  Coverage out_;
};

} // namespace

std::string_view name_of(CoverageClass of) {
  switch (of) {
  case CoverageClass::providers: return "providers";
  case CoverageClass::packs: return "packs";
  case CoverageClass::levels: return "levels";
  case CoverageClass::conditions: return "conditions";
  case CoverageClass::pushes: return "pushes";
  case CoverageClass::take_overs: break;
  }
  return "take_overs";
}

CoverageClass class_of(Kind kind) {
  switch (kind) {
  case Kind::provider: return CoverageClass::providers;
  case Kind::pack: return CoverageClass::packs;
  case Kind::level: return CoverageClass::levels;
  case Kind::when:
  case Kind::stay: return CoverageClass::conditions;
  case Kind::push: return CoverageClass::pushes;
  case Kind::take_over: break;
  }
  return CoverageClass::take_overs;
}

std::size_t Coverage::covered() const {
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [](const CoveragePoint& point) { return point.covered; }));
}

int Coverage::percent() const { return points.empty() ? 100 : static_cast<int>(covered() * 100 / points.size()); }

void Coverage::merge(const Coverage& other) {
  for (std::size_t i = 0; i < points.size() && i < other.points.size(); ++i)
    points[i].covered = points[i].covered || other.points[i].covered;
}

Coverage coverage_of(const Model& model, const Graph& graph) { return Planner(model, graph).plan(); }

std::vector<PossibleTake> possible_takes(const Model& model, const Graph& graph) {
  return Planner(model, graph).takes();
}

} // namespace director::compiler
