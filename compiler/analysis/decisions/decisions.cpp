// Header: compiler/analysis/decisions/decisions.hpp. Test: tests/property/decisions_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/decisions/decisions.hpp"

#include "compiler/analysis/decisions/moves.hpp"

#include <algorithm>

namespace director::analysis {

namespace {

class Finder {
public:
  Finder(const Component& part, const Model& model, const Facts& facts, Decisions& out, std::int64_t& steps_left)
      : part_(part),
        out_(out),
        left_(steps_left) {
    gathered_.passed_over.resize(part.providers.size());
    gathered_.refused.resize(part.edges.size());
    set_before_run_.resize(part.providers.size());
    find_goals(model, facts);
  }

  /// False: it is above the limits, or there is nothing to report.
  bool run() {
    for (;;) {
      gathered_.pushes = gathered_.found;
      const Closed how = close();
      if (how != Closed::again) return how == Closed::whole;
    }
  }

  void store() {
    for (const Component::GroupRow& group : part_.groups) out_.decided.add(group.id);
    for (Row edge = 0; edge < part_.edges.size(); ++edge) {
      const EdgeId id = part_.edges[edge].id;
      if ((requested_ & bit(edge)) != 0) out_.requested.add(id);
      if ((granted_ & bit(edge)) != 0) out_.granted.add(id);
      out_.refused[id] = ids_of(gathered_.refused[edge]);
    }
    for (Row provider = 0; provider < part_.providers.size(); ++provider) {
      const ProviderId id = part_.providers[provider].id;
      if ((ran_ & bit(provider)) != 0) out_.runs.add(id);
      out_.passed_over[id] = ids_of(gathered_.passed_over[provider]);
      for (const Row state : each(set_before_run_[provider])) out_.set_before_run[id].push_back(part_.states[state].id);
    }
    for (const PossiblePush& push : gathered_.found)
      out_.pushed.emplace(part_.providers[push.to].id, part_.conditions[push.unmet].id);
    out_.whole.insert(whole_.begin(), whole_.end());
  }

  std::size_t moments() const { return seen_.size(); }
  std::size_t passes() const { return gathered_.passes; }

private:
  using PackOf = std::pair<ProviderId, std::size_t>;

  enum class Closed { whole, again, not_at_all };

  /// All moments that follow from the first one, with the pushes that are known so far. It restarts with each new push:
  /// earlier decisions may be different with it.
  Closed close() {
    Moves moves(part_, gathered_, left_);
    seen_.clear();
    open_.clear();
    look(moves.first());
    while (!open_.empty()) {
      const Moment moment = open_.back();
      open_.pop_back();
      if (!moves.from(moment, [&](const Moment& next) { look(next); }) || all_is_reached()) return Closed::not_at_all;
      if (gathered_.found.size() != gathered_.pushes.size()) return Closed::again;
    }
    return Closed::whole;
  }

  void look(const Moment& moment) {
    if (!seen_.add(moment)) return;
    open_.push_back(moment);
    const auto runs = [&](Row edge) {
      const Row target = part_.edges[edge].target;
      return moment.level[edge] != nothing && moment.by[target] == edge && moment.has(target, Moment::granted);
    };
    for (Row edge = 0; edge < part_.edges.size(); ++edge) {
      if (moment.level[edge] != nothing) requested_ |= bit(edge);
      if (runs(edge)) granted_ |= bit(edge);
    }
    Rows given = 0;
    for (Row state = 0; state < part_.states.size(); ++state) {
      if (moment.given[state] != nothing) given |= bit(state);
    }
    for (Row group = 0; group < part_.groups.size(); ++group) {
      if (!moment.has(group, Moment::granted)) continue;
      if (given == 0) ran_ |= bit(moment.active[group]);
      set_before_run_[moment.active[group]] |= given;
      // What one provider requested may be kept by the next one.
      for (const Row id : part_.groups[group].providers) {
        const Component::ProviderRow& provider = part_.providers[id];
        for (std::size_t i = 0; i < provider.packs.size(); ++i) {
          const std::vector<Row>& members = provider.packs[i].members;
          if (!members.empty() && std::all_of(members.begin(), members.end(), runs)) whole_.emplace(provider.id, i);
        }
      }
    }
  }

  /// What may happen according to the facts.
  void find_goals(const Model& model, const Facts& facts) {
    const auto runs = [&](Row provider) { return facts.active.contains(part_.providers[provider].id); };
    const auto any_runs = [&](Row edge) {
      const std::vector<Row>& all = part_.groups[part_.edges[edge].target].providers;
      return std::any_of(all.begin(), all.end(), runs);
    };
    for (Row row = 0; row < part_.providers.size(); ++row) {
      if (!runs(row)) continue;
      const Component::ProviderRow& provider = part_.providers[row];
      run_goal_ |= bit(row);
      for (std::size_t i = 0; i < provider.packs.size(); ++i) {
        if (!provider.packs[i].members.empty()) whole_goal_.emplace(provider.id, i);
        for (const Component::Entry& entry : provider.packs[i].entries) {
          if (any_runs(entry.edge)) grant_goal_ |= bit(entry.edge);
        }
      }
      if (!facts.pushed.contains(provider.id)) continue; // no task may push it
      for (const Component::ProviderRow& waiter : part_.providers) {
        if (waiter.group == provider.group || !facts.requested.contains(model.providers[waiter.id].group)) continue;
        for (const Row condition : waiter.when) {
          if ((provider.causes & bit(condition)) != 0) push_goal_.emplace(row, condition);
        }
      }
    }
    for (Row edge = 0; edge < part_.roots; ++edge) {
      if (any_runs(edge)) grant_goal_ |= bit(edge);
    }
  }

  bool all_is_reached() const {
    if ((run_goal_ & ~ran_) != 0 || (grant_goal_ & ~granted_) != 0) return false;
    const auto is_whole = [&](const PackOf& pack) { return whole_.count(pack) != 0; };
    const auto is_pushed = [&](const std::pair<Row, Row>& goal) {
      return std::any_of(gathered_.found.begin(), gathered_.found.end(),
                         [&](const PossiblePush& push) { return push.to == goal.first && push.unmet == goal.second; });
    };
    return std::all_of(whole_goal_.begin(), whole_goal_.end(), is_whole) &&
           std::all_of(push_goal_.begin(), push_goal_.end(), is_pushed);
  }

  Hindrance ids_of(const Reasons& reasons) const {
    Hindrance out;
    const auto add = [](Rows rows, const auto& table, auto& ids) {
      for (Row row = 0; row < table.size(); ++row) {
        if ((rows & bit(row)) != 0) ids.push_back(table[row].id);
      }
    };
    add(reasons.lacking, part_.conditions, out.lacking);
    add(reasons.taken, part_.groups, out.taken);
    add(reasons.holders, part_.edges, out.holders);
    add(reasons.first, part_.providers, out.first);
    add(reasons.together, part_.edges, out.together);
    return out;
  }

  const Component& part_;
  Decisions& out_;
  std::int64_t& left_;
  Gathered gathered_;
  Seen<Moment> seen_;
  std::vector<Moment> open_;
  Rows ran_ = 0, requested_ = 0, granted_ = 0, run_goal_ = 0, grant_goal_ = 0;
  std::vector<Rows> set_before_run_; ///< by provider
  std::set<PackOf> whole_, whole_goal_;
  std::set<std::pair<Row, Row>> push_goal_;
};

} // namespace

Decisions find_decisions(const Model& model, const Facts& facts, Reported reported, Budget& budget) {
  Decisions out;
  out.looked_at = out.decided = IdSet<GroupId>(model.groups.size());
  out.runs = IdSet<ProviderId>(model.providers.size());
  out.requested = out.granted = IdSet<EdgeId>(model.edges.size());
  out.passed_over = IdTable<ProviderId, Hindrance>(model.providers.size());
  out.refused = IdTable<EdgeId, Hindrance>(model.edges.size());
  out.set_before_run = IdTable<ProviderId, std::vector<StateId>>(model.providers.size());
  const std::int64_t most = budget.grant(Decisions::steps_for(model.groups.size()));
  std::int64_t left = most;
  const IdTable<StateId, std::vector<Source>> sources = find_sources(model);
  for (const std::vector<GroupId>& groups : small_components(model)) {
    if (left < 0) break;
    const std::optional<Component> part = make_component(model, facts, reported, sources, groups);
    if (!part) continue;
    Finder finder(*part, model, facts, out, left);
    if (finder.run()) finder.store();
    for (std::size_t i = 0; left >= 0 && i < groups.size(); ++i) out.looked_at.add(groups[i]);
    out.moments += finder.moments();
    out.passes += finder.passes();
  }
  budget.spend(most - std::max<std::int64_t>(left, 0));
  return out;
}

} // namespace director::analysis
