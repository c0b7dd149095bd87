// Header: tests/property/verdicts.hpp. Test: tests/property/verdicts_test.cpp.
// SPDX-License-Identifier: MIT
//
// Something depends on others if it could not happen without one of them, also in cycles. It is reported if a finding
// claims it, or if all of these are reported; such a chain must end at a finding, so that a cycle does not report
// itself.
#include "compiler/graph/graph.hpp"
#include "tests/property/verdicts.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace director::property {

using compiler::ConditionId;
using compiler::ConditionUse;
using compiler::EdgeId;
using compiler::GroupId;
using compiler::Model;
using compiler::ProviderId;

namespace {

class UnreachedSearch {
public:
  UnreachedSearch(const Model& model, const Reached& reached, const std::vector<dsl::Diagnostic>& findings)
      : model_(model),
        reached_(reached),
        packs_(whole_packs(model)) {
    for (const compiler::Graph::Causing& arrow : compiler::make_graph(model).causing) {
      if (model.providers[arrow.causer].group == model.providers[arrow.waiter].group) continue;
      pushes_[{arrow.causer, arrow.condition.id}].push_back(arrow.waiter);
    }
    begin_ = {0, model.providers.size(), 2 * model.providers.size()};
    begin_.push_back(begin_.back() + model.edges.size());
    begin_.push_back(begin_.back() + packs_.size());
    begin_.push_back(begin_.back() + pushes_.size());
    claimed_.resize(begin_.back() + model.states.size());
    below_.resize(model.groups.size());
    for (const GroupId id : model.groups.ids()) find_below(id, below_[id.value]);
    take(follow_on_of(model));
    take_unrequested(findings);
    for (const dsl::Diagnostic& finding : findings) {
      for (const Claim& claim : claims_of(finding, model)) take(claim);
      for (const ProviderId id : hints_of(finding, model)) claimed_[runs(id)] = true;
      for (const EdgeId id : losers_of(finding, model)) claimed_[granted(id)] = true;
      for (const compiler::StateId id : lacking_of(finding, model)) claimed_[lacks(id)] = true;
    }
    find_ways();
    find_told();
  }

  std::vector<Unreached> run() const {
    std::vector<Unreached> out;
    for (const ProviderId id : model_.providers.ids()) {
      if (!reached_.ran[id.value]) out.push_back({"provider " + way_of(id), model_.full_name(id), told_[runs(id)]});
    }
    for (const EdgeId id : model_.edges.ids()) {
      if (is_task(id) && !reached_.granted[id.value])
        out.push_back({"task " + way_of(id), model_.edge_name(id), told_[granted(id)]});
    }
    for (std::size_t i = 0; i < packs_.size(); ++i) {
      if (!reached_.whole[i]) out.push_back({"pack", in_words(NeverWhole{i}, model_), told_[begin_[3] + i]});
    }
    std::size_t row = begin_[4];
    for (const auto& [push, waiters] : pushes_) {
      const std::size_t here = row++;
      if (reached_.pushed.contains(push)) continue;
      if (is_pushed_otherwise(push)) continue;
      out.push_back({"push " + way_of(push.first, waiters),
                     model_.full_name(push.first) + " for " + model_.conditions[push.second].text, told_[here]});
    }
    return out;
  }

private:
  using Row = std::size_t;
  using All = std::vector<Row>; ///< one of these is enough

  Row runs(ProviderId id) const { return id.value; }
  Row can(ProviderId id) const { return begin_[1] + id.value; }
  /// The row for values that the state never had.
  Row lacks(compiler::StateId id) const { return begin_[5] + id.value; }
  Row granted(EdgeId id) const { return begin_[2] + id.value; }
  bool is_task(EdgeId id) const { return !model_.edges[id].levels.empty(); }

  /// Whether the promise is pushed for another condition: it counts once, however many conditions wait for it.
  bool is_pushed_otherwise(const std::pair<ProviderId, ConditionId>& push) const {
    const std::vector<ConditionUse>& promises = model_.providers[push.first].causing;
    return std::any_of(promises.begin(), promises.end(), [&](const ConditionUse& promise) {
      return model_.satisfies(promise.id, push.second) &&
             std::any_of(reached_.pushed.begin(), reached_.pushed.end(), [&](const auto& other) {
               return other.first == push.first && model_.satisfies(promise.id, other.second);
             });
    });
  }

  void find_below(GroupId group, std::set<GroupId>& out) const {
    if (!out.insert(group).second) return;
    for (const EdgeId edge : model_.groups[group].edges) find_below(model_.edges[edge].target, out);
  }

  // What findings claim

  void take(const FollowOn& follow) {
    const auto has = [](const auto& list, const auto& what) {
      return std::find(list.begin(), list.end(), what) != list.end();
    };
    for (const ProviderId id : follow.idle) claimed_[runs(id)] = true;
    for (const EdgeId id : follow.ungranted) claimed_[granted(id)] = true;
    for (std::size_t i = 0; i < packs_.size(); ++i) {
      if (has(follow.unwhole, std::pair(packs_[i].provider, packs_[i].pack))) claimed_[begin_[3] + i] = true;
    }
    Row row = begin_[4];
    for (const auto& [push, waiters] : pushes_) {
      if (has(follow.unpushed, push.first) || has(follow.unpushed_for, push)) claimed_[row] = true;
      ++row;
    }
  }

  /// All groups that need the group never request it, and a finding reports each of them.
  void take_unrequested(const std::vector<dsl::Diagnostic>& findings) {
    for (const GroupId group : model_.groups.ids()) {
      const std::vector<EdgeId>& all = model_.groups[group].requesters;
      const auto is_told = [&](EdgeId id) {
        const compiler::Edge& edge = model_.edges[id];
        if (is_task(id) || !edge.requester) return false;
        const std::vector<ProviderId>& providers = model_.groups[*edge.requester].providers;
        return std::any_of(findings.begin(), findings.end(), [&](const dsl::Diagnostic& finding) {
          return finding.id == "unused_need" && std::any_of(providers.begin(), providers.end(), [&](ProviderId by) {
                   const auto& needs = model_.providers[by].needs;
                   return std::any_of(needs.begin(), needs.end(),
                                      [&](const auto& need) { return need.id == group && need.span == finding.span; });
                 });
        });
      };
      if (all.empty() || !std::all_of(all.begin(), all.end(), is_told)) continue;
      for (const ProviderId id : model_.groups[group].providers) claimed_[runs(id)] = true;
    }
  }

  void take(const Claim& claim) {
    if (const auto* c = std::get_if<NeverRuns>(&claim)) {
      claimed_[runs(c->provider)] = true;
      if (!conditions_held(c->provider)) claimed_[can(c->provider)] = true;
    }
    if (const auto* c = std::get_if<NeverGranted>(&claim)) claimed_[granted(c->edge)] = true;
    if (const auto* c = std::get_if<NeverWhole>(&claim)) claimed_[begin_[3] + c->pack] = true;
    if (const auto* c = std::get_if<NeverBelow>(&claim)) take_below(*c);
    if (const auto* c = std::get_if<NeverPushed>(&claim)) {
      const auto at = pushes_.find({c->provider, c->condition});
      if (at != pushes_.end()) claimed_[begin_[4] + static_cast<Row>(std::distance(pushes_.begin(), at))] = true;
    }
  }

  /// Groups that request the group there never get it; providers that need it never run.
  void take_below(const NeverBelow& claim) {
    const GroupId target = model_.edges[claim.edge].target;
    if (target == claim.group || needs(target, claim.group)) claimed_[granted(claim.edge)] = true;
    for (const GroupId group : below_[target.value]) {
      for (const EdgeId edge : model_.groups[group].edges) {
        const GroupId wanted = model_.edges[edge].target;
        if (wanted == claim.group || needs(wanted, claim.group)) claimed_[granted(edge)] = true;
      }
      for (const ProviderId id : model_.groups[group].providers) {
        for (const auto& need : model_.providers[id].needs) {
          if (need.id == claim.group || needs(need.id, claim.group)) claimed_[runs(id)] = true;
        }
      }
    }
  }

  /// Whether a provider of the group needs the other one, directly or not.
  bool needs(GroupId group, GroupId what) const {
    std::set<GroupId> seen{group};
    std::vector<GroupId> open{group};
    while (!open.empty()) {
      const GroupId at = open.back();
      open.pop_back();
      for (const ProviderId id : model_.groups[at].providers) {
        for (const auto& need : model_.providers[id].needs) {
          if (need.id == what) return true;
          if (seen.insert(need.id).second) open.push_back(need.id);
        }
      }
    }
    return false;
  }

  // Dependences

  void find_ways() {
    ways_.resize(claimed_.size());
    for (const ProviderId id : model_.providers.ids()) {
      if (!reached_.ran[id.value]) find_ways(id);
    }
    for (const EdgeId id : model_.edges.ids()) {
      if (is_task(id) && !reached_.granted[id.value]) find_ways(id);
    }
    for (std::size_t i = 0; i < packs_.size(); ++i) {
      std::vector<All>& ways = ways_[begin_[3] + i];
      if (reached_.whole[i]) continue;
      if (!reached_.ran[packs_[i].provider.value]) ways.push_back({runs(packs_[i].provider)});
      for (const EdgeId member : packs_[i].members) {
        if (reached_.granted[member.value]) continue;
        ways.push_back({granted(member)});
        ways_[granted(member)].push_back({begin_[3] + i});
      }
    }
    Row row = begin_[4];
    for (const auto& [push, waiters] : pushes_) {
      if (!reached_.ran[push.first.value]) ways_[row].push_back({runs(push.first)});
      if (std::none_of(waiters.begin(), waiters.end(), [&](ProviderId id) { return reached_.ran[id.value]; }))
        ways_[row].push_back(all_run(waiters));
      // The first choice for a need, whose condition it would then wait for.
      for (const ProviderId waiter : waiters) {
        for (const auto& need : model_.providers[waiter].needs) {
          const ProviderId first = model_.groups[need.id].providers.front();
          if (!conditions_held(first)) ways_[row].push_back({can(first)});
        }
      }
      ++row;
    }
    for (const compiler::StateId id : model_.states.ids()) {
      All setters;
      for (const ConditionId condition : model_.conditions.ids()) {
        if (model_.conditions[condition].state != id || held(condition)) continue;
        for (const ProviderId setter : setters_of(condition)) setters.push_back(runs(setter));
      }
      if (!setters.empty()) ways_[lacks(id)].push_back(std::move(setters));
    }
  }

  All all_run(const std::vector<ProviderId>& providers) const {
    All out;
    for (const ProviderId id : providers) out.push_back(runs(id));
    return out;
  }

  void find_ways(ProviderId id) {
    const compiler::Provider& provider = model_.providers[id];
    ways_[runs(id)].push_back({can(id)});
    for (const ConditionUse& use : provider.when) {
      const std::vector<ProviderId> setters = setters_of(use.id);
      if (!held(use.id) && !setters.empty()) ways_[can(id)].push_back(all_run(setters));
    }
    for (const auto& need : provider.needs) {
      const std::vector<ProviderId>& below = model_.groups[need.id].providers;
      if (std::any_of(below.begin(), below.end(), [&](ProviderId q) { return reached_.ran[q.value]; })) continue;
      All& way = ways_[can(id)].emplace_back();
      for (const ProviderId q : below) way.push_back(can(q));
    }
    // Earlier providers, which would not run if the states had values that they never have.
    for (const ProviderId earlier : model_.groups[provider.group].providers) {
      if (earlier == id) break;
      for (const ConditionUse& use : model_.providers[earlier].when) {
        if (reached_.ran[earlier.value] && held_with(use.id, provider))
          ways_[runs(id)].push_back({lacks(model_.conditions[use.id].state)});
      }
    }
    All requests;
    for (const EdgeId edge : model_.groups[provider.group].requesters) {
      if (reached_.granted[edge.value]) return;
      if (is_task(edge)) requests.push_back(granted(edge));
    }
    if (!requests.empty()) ways_[runs(id)].push_back(std::move(requests));
  }

  void find_ways(EdgeId id) {
    const compiler::Edge& edge = model_.edges[id];
    if (!reached_.requested[id.value]) {
      if (edge.requester) ways_[granted(id)].push_back(all_run(requesting(id)));
      return;
    }
    const std::vector<ProviderId>& providers = model_.groups[edge.target].providers;
    if (std::none_of(providers.begin(), providers.end(), [&](ProviderId p) { return reached_.ran[p.value]; }))
      ways_[granted(id)].push_back(all_run(providers));
  }

  bool conditions_held(ProviderId id) const {
    const auto& when = model_.providers[id].when;
    return std::all_of(when.begin(), when.end(), [&](const ConditionUse& use) { return held(use.id); });
  }

  bool held(ConditionId id) const {
    const compiler::Condition& condition = model_.conditions[id];
    const auto& seen = reached_.values[condition.state.value];
    return std::any_of(seen.begin(), seen.end(),
                       [&](std::int32_t value) { return value != unset && condition.accepts.contains(value); });
  }

  /// Whether it held whenever the conditions of the provider on this state did, and would not with every possible value
  /// of the state.
  bool held_with(ConditionId id, const compiler::Provider& provider) const {
    const compiler::Condition& condition = model_.conditions[id];
    compiler::ValueSet own = model_.states[condition.state].domain();
    bool may_be_unset = true;
    for (const ConditionUse& use : provider.when) {
      if (model_.conditions[use.id].state != condition.state) continue;
      own = own.intersected(model_.conditions[use.id].accepts);
      may_be_unset = false;
    }
    const auto& seen = reached_.values[condition.state.value];
    return !own.subset_of(condition.accepts) && std::all_of(seen.begin(), seen.end(), [&](std::int32_t value) {
      if (value == unset) return !may_be_unset;
      return !own.contains(value) || condition.accepts.contains(value);
    });
  }

  std::vector<ProviderId> setters_of(ConditionId id) const {
    const compiler::Condition& condition = model_.conditions[id];
    const auto sets = [&](const std::vector<ConditionUse>& uses) {
      return std::any_of(uses.begin(), uses.end(), [&](const ConditionUse& use) {
        const compiler::Condition& each = model_.conditions[use.id];
        return each.state == condition.state && each.accepts.overlaps(condition.accepts);
      });
    };
    std::vector<ProviderId> out;
    for (const ProviderId p : model_.providers.ids()) {
      const compiler::Group& group = model_.group_of(p);
      if (sets(model_.providers[p].causing) || sets(model_.providers[p].sets) ||
          (group.start && sets(group.start->sets)) || (group.stop && sets(group.stop->sets)))
        out.push_back(p);
    }
    return out;
  }

  /// Providers with an entry for it.
  std::vector<ProviderId> requesting(EdgeId id) const {
    std::vector<ProviderId> out;
    for (const ProviderId p : model_.groups[*model_.edges[id].requester].providers) {
      for (const compiler::Pack& pack : model_.providers[p].packs) {
        for (const compiler::Task& task : pack.tasks) {
          if (task.edge == id && (out.empty() || out.back() != p)) out.push_back(p);
        }
      }
    }
    return out;
  }

  void find_told() {
    std::vector<bool> may(claimed_.size(), true);
    told_ = claimed_;
    const auto whole = [](const All& way, const std::vector<bool>& in) {
      return std::all_of(way.begin(), way.end(), [&](Row row) { return in[row]; });
    };
    for (bool changed = true; changed;) {
      changed = false;
      for (Row row = 0; row < may.size(); ++row) {
        if (!may[row] || claimed_[row]) continue;
        may[row] = std::any_of(ways_[row].begin(), ways_[row].end(), [&](const All& way) { return whole(way, may); });
        changed = changed || !may[row];
      }
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (Row row = 0; row < may.size(); ++row) {
        if (!may[row] || told_[row]) continue;
        told_[row] = std::any_of(ways_[row].begin(), ways_[row].end(), [&](const All& way) {
          return whole(way, may) && std::any_of(way.begin(), way.end(), [&](Row other) { return told_[other]; });
        });
        changed = changed || told_[row];
      }
    }
  }

  // Its kind, for the report.

  bool any(GroupId group, const std::vector<bool>& of) const {
    const auto& edges = model_.groups[group].requesters;
    return std::any_of(edges.begin(), edges.end(), [&](EdgeId e) { return of[e.value]; });
  }

  std::string way_of(ProviderId id) const {
    const GroupId group = model_.providers[id].group;
    if (!any(group, reached_.requested)) return "whose group is never requested";
    if (!conditions_held(id)) return "one of whose conditions never holds";
    if (!any(group, reached_.granted)) return "whose group is requested and never granted";
    const bool promises = !model_.providers[id].causing.empty(), needs = !model_.providers[id].needs.empty();
    const bool waits = !model_.providers[id].when.empty();
    std::string out = "while another of its group runs";
    if (needs) out += ", with needs";
    if (waits) out += ", with conditions";
    if (promises) out += ", with a promise";
    return out;
  }

  std::string way_of(EdgeId id) const {
    const compiler::Edge& edge = model_.edges[id];
    if (!reached_.requested[id.value]) return "that is never requested";
    const auto& providers = model_.groups[edge.target].providers;
    const bool runs =
        std::any_of(providers.begin(), providers.end(), [&](ProviderId p) { return reached_.ran[p.value]; });
    const std::string level = edge.levels.front().optional ? "optional"
                              : edge.levels.front().apart  ? "apart"
                              : edge.requester             ? "mandatory"
                                                           : "of the program";
    return level + (runs ? ", of a group that runs for others" : ", of a group that never runs");
  }

  std::string way_of(ProviderId causer, const std::vector<ProviderId>& waiters) const {
    if (!reached_.ran[causer.value]) return "to a provider that never runs";
    const auto all = [&](auto&& holds) { return std::all_of(waiters.begin(), waiters.end(), holds); };
    if (all([&](ProviderId id) { return !any(model_.providers[id].group, reached_.requested); }))
      return "for one that is never requested";
    if (all([&](ProviderId id) {
          const auto& providers = model_.group_of(id).providers;
          return std::any_of(providers.begin(), providers.end(),
                             [&](ProviderId p) { return model_.providers[p].when.empty(); });
        }))
      return "for one of a group that can run without";
    return all([&](ProviderId id) { return !reached_.ran[id.value]; }) ? "for one that never runs"
                                                                       : "for one that runs anyway";
  }

  const Model& model_;
  const Reached& reached_;
  std::vector<WholePack> packs_;
  std::map<std::pair<ProviderId, ConditionId>, std::vector<ProviderId>> pushes_; ///< with the providers that wait
  std::vector<std::set<GroupId>> below_; ///< each group and all groups that it may lead to
  std::vector<Row> begin_; ///< first rows of providers that run, providers that can run, edges, packs, pushes
  std::vector<bool> claimed_, told_;
  std::vector<std::vector<All>> ways_; ///< each was missing completely
};

} // namespace

std::vector<Unreached> unreached_of(const Model& model, const Reached& reached,
                                    const std::vector<dsl::Diagnostic>& findings) {
  return UnreachedSearch(model, reached, findings).run();
}

} // namespace director::property
