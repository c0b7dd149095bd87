// Header: compiler/play/coverage/coverage.hpp. Test: tests/compiler/play/coverage/coverage_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/coverage/coverage.hpp"

#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/pushes.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace director::compiler {

namespace points {

using Kind = CoveragePoint::Kind;

/// Whether they are granted together, or not at all.
inline bool in_unit(const analysis::Together& together, const Level& level) {
  return together.provider && level.shares_unit();
}

class Planner {
public:
  Planner(const Model& model, const Graph& graph)
      : model_(model),
        facts_(analysis::find_facts(model, graph, analysis::Reported::as_is)),
        // Also what others of its group precede: the program may disable these.
        counts_([this](ProviderId id) {
          return facts_.capable.contains(id) && facts_.requested.contains(model_.providers[id].group);
        }),
        branches_(model, {counts_, [this](ProviderId id) { return facts_.capable.contains(id); },
                          [this](ProviderId id) { return facts_.pushed.contains(id); }, analysis::Requested::by_group}),
        together_(analysis::find_together(model, counts_)) {}

  Coverage plan() {
    for (const ProviderId id : model_.providers.ids()) {
      if (counts_(id)) add({Kind::provider, id.value}, model_.providers[id].span);
    }
    plan_packs();
    plan_levels();
    plan_conditions();
    plan_pushes();
    for (const analysis::Together& together : together_) plan_take_overs(together);
    return std::move(out_);
  }

  std::vector<PossibleTake> takes(const TakeLimits& limits) {
    std::vector<PossibleTake> out;
    const auto counts = [&](GroupId taker, GroupId loser) {
      return !limits.among || (limits.among->both.contains(taker) && limits.among->both.contains(loser)) ||
             limits.among->either.contains(taker) || limits.among->either.contains(loser);
    };
    std::map<std::pair<EdgeId, EdgeId>, std::size_t> places;
    for (const analysis::Together& together : together_) {
      for_each_pair(together, [&](const Task& taker, const Task& loser) {
        if (out.size() > limits.most || !counts(taker.target, loser.target)) return;
        any_rivalry(together, taker, loser, [&](const Rivalry& each) {
          const analysis::Leaders leaders = leaders_of(together, each);
          const bool equal = each.ranks.first == each.ranks.second; // then the place of a unit takes nothing
          if (each.wins ? leaders.always : equal || leaders.all.empty()) return false;
          const auto [at, fresh] = places.try_emplace({taker.edge, loser.edge}, out.size());
          if (fresh) out.push_back({taker.edge, loser.edge, std::vector<bool>(model_.groups.size()), {}, {}, {}, {}});
          PossibleTake& take = out[at->second];
          take.groups[each.group.value] = true;
          (each.wins ? take.except : take.leaders).insert(leaders.all.begin(), leaders.all.end());
          if (each.wins) take.ranks.insert(each.ranks);
          if (!each.wins) take.led_over.insert(each.ranks.second.priority);
          return false;
        });
      });
    }
    return out;
  }

  void rivalries(EdgeId taker, EdgeId loser, const std::function<void(const Rivalry&)>& visit) {
    for (const Entry& first : entries(taker)) {
      for (const Entry& second : entries(loser)) {
        if (first.together != second.together) continue;
        any_rivalry(*first.together, *first.task, *second.task, [&](const Rivalry& each) {
          visit(each);
          return false;
        });
      }
    }
  }

private:
  struct Entry {
    const analysis::Together* together = nullptr;
    const Task* task = nullptr;
  };
  const std::vector<Entry>& entries(EdgeId edge) {
    if (entries_.empty()) {
      entries_ = IdTable<EdgeId, std::vector<Entry>>(model_.edges.size());
      for (const analysis::Together& together : together_) {
        for (const Task& task : *together.tasks) entries_[task.edge].push_back({&together, &task});
      }
    }
    return entries_[edge];
  }

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
    for (const analysis::Together& together : together_) {
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

  void plan_take_overs(const analysis::Together& together) {
    for_each_pair(together, [&](const Task& taker, const Task& loser) {
      if (any_rivalry(together, taker, loser,
                      [&](const Rivalry& each) { return each.wins && !leaders_of(together, each).always; }))
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

  /// Whether some rivalry of the two was `enough`, with which the search ends.
  template <class Enough>
  bool any_rivalry(const analysis::Together& together, const Task& taker, const Task& loser, Enough enough) {
    const analysis::Claims &of_taker = claims_.of(taker.target), &of_loser = claims_.of(loser.target);
    const std::vector<GroupId>& others = of_loser.groups(); // both in order
    auto other = others.begin();
    for (const GroupId group : of_taker.groups()) {
      other = std::lower_bound(other, others.end(), group);
      if (other == others.end()) break;
      if (*other != group) continue;
      for (const analysis::Reach takes : analysis::all_reaches) {
        if (of_taker.find(group, takes) == nullptr) continue;
        for (const analysis::Reach loses : analysis::all_reaches) {
          if (of_loser.find(group, loses) == nullptr ||
              !analysis::compatible(of_taker.held_region(group, takes), of_loser.held_region(group, loses)))
            continue;
          Rivalry each{together.provider, together.pack, together.tasks, &taker, &loser, nullptr,
                       nullptr,           group,         takes,          loses,  {}};
          if (any_levels(each, together, enough)) return true;
        }
      }
    }
    return false;
  }

  /// Of the one that is behind by rank: it is claimed at the place of its unit, unlike what its tasks claim.
  analysis::Leaders leaders_of(const analysis::Together& together, const Rivalry& each) const {
    const Task &member = each.wins ? *each.loser : *each.taker, &rival = each.wins ? *each.taker : *each.loser;
    const Level &own = level_of(member, each.wins ? *each.loser_level : *each.taker_level),
                &rivals = level_of(rival, each.wins ? *each.taker_level : *each.loser_level);
    const analysis::Reach reach = each.wins ? each.loses : each.takes;
    if (!together.provider || reach != analysis::Reach::own || !analysis::is_placed(own, rivals)) return {};
    return analysis::find_leaders(model_, *together.tasks, together.whole, member.edge, own.priority, rival.edge,
                                  rivals.priority);
  }

  const Level& level_of(const Task& task, const Task::NamedLevel& level) const {
    return model_.edges[task.edge].levels[level.level];
  }

  /// Whether the loser, and with it what is requested below it, may be requested before the taker is.
  bool may_precede(const analysis::Together& together, const Task& loser, const Task& taker) const {
    if (!together.whole) return true;
    const GroupId requester = model_.providers[*together.provider].group;
    const std::vector<ProviderId>& providers = model_.groups[requester].providers;
    return std::any_of(providers.begin(), providers.end(), [&](ProviderId id) {
      const Provider& provider = model_.providers[id];
      return counts_(id) && std::any_of(provider.packs.begin(), provider.packs.end(), [&](const Pack& pack) {
               return pack.requests(loser.edge) && !(provider.has_packs && pack.requests(taker.edge));
             });
    });
  }

  /// Whether it was `enough` at some levels. In a unit nothing is taken from what is granted with it, nor by that, if
  /// both are requested at once.
  template <class Enough>
  bool any_levels(Rivalry& each, const analysis::Together& together, Enough enough) const {
    using analysis::Reach;
    for (const Task::NamedLevel& a : each.taker->levels) {
      for (const Task::NamedLevel& b : each.loser->levels) {
        const Level &first = level_of(*each.taker, a), &second = level_of(*each.loser, b);
        const bool together_granted = in_unit(together, first) && in_unit(together, second);
        if (together_granted && each.loses == Reach::own) continue;
        if (together_granted && each.takes == Reach::own && !may_precede(together, *each.loser, *each.taker)) continue;
        each.taker_level = &a, each.loser_level = &b;
        const bool first_optional = first.optional || each.takes == Reach::optional;
        const bool second_optional = second.optional || each.loses == Reach::optional;
        each.ranks = {{first.priority, first_optional}, {second.priority, second_optional}};
        each.wins = first_optional != second_optional ? second_optional : first.priority > second.priority;
        if (enough(each)) return true;
      }
    }
    return false;
  }

  const Model& model_;
  const analysis::Facts facts_;
  const std::function<bool(ProviderId)> counts_;
  const analysis::Branches branches_;
  const std::vector<analysis::Together> together_;
  IdTable<EdgeId, std::vector<Entry>> entries_; ///< filled on first use
  const analysis::ClaimsCache claims_{branches_};
  std::set<CoveragePoint::Key> seen_;
  Coverage out_;
};

} // namespace points

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

CoverageClass class_of(CoveragePoint::Kind kind) {
  using Kind = CoveragePoint::Kind;
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

Coverage coverage_of(const Model& model, const Graph& graph) { return points::Planner(model, graph).plan(); }

std::vector<PossibleTake> possible_takes(const Model& model, const Graph& graph, const TakeLimits& limits) {
  return points::Planner(model, graph).takes(limits);
}

struct Rivalries::Finder : points::Planner {
  using Planner::Planner;
};

Rivalries::Rivalries(const Model& model, const Graph& graph) : finder_(std::make_unique<Finder>(model, graph)) {}

Rivalries::~Rivalries() = default;

void Rivalries::between(EdgeId taker, EdgeId loser, const std::function<void(const Rivalry&)>& visit) {
  finder_->rivalries(taker, loser, visit);
}

} // namespace director::compiler
