// Header: compiler/analysis/causing/wants.hpp. Test: tests/compiler/analysis/causing/wants_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/wants.hpp"

#include "compiler/analysis/chains/sparse_set.hpp"

#include <algorithm>
#include <cstddef>
#include <map>

namespace director::analysis {

namespace {

class WantSearch {
public:
  WantSearch(const Model& model, const Facts& facts, const Chains& chains, const Causers& causers)
      : model_(model),
        facts_(facts),
        chains_(chains),
        causers_(causers),
        pushes_(model, facts, chains, causers),
        waiting_(model, facts) {}

  std::vector<Wanting> run() {
    for (const GroupId task : model_.groups.ids()) {
      if (facts_.requested.contains(task)) look_at(task);
    }
    return std::move(out_);
  }

  std::vector<Wanting> run_pushed(const Indispensable& indispensable, const std::vector<Wanting>& wants) {
    for (const Wanting& wanting : wants) {
      for (const Want& want : wanting.wants) add_pushed(want.causers, {wanting.task, want.condition.id});
    }
    std::map<GroupId, PushSearch> searches;
    for (std::size_t next = 0; next < open_.size(); ++next) {
      const auto [id, pushed] = open_[next];
      look_at_pushed(indispensable, id, pushed, searches.try_emplace(pushed.by, pushes_, pushed.by).first->second);
    }
    std::sort(out_.begin(), out_.end(), [](const Wanting& a, const Wanting& b) { return a.provider < b.provider; });
    return std::move(out_);
  }

private:
  void add_pushed(const std::vector<ProviderId>& all, const Pushed& pushed) {
    for (const ProviderId id : all) {
      if (seen_.add(id)) open_.emplace_back(id, pushed);
    }
  }

  /// Whether what runs instead of the pushed provider until then keeps what the causing one needs.
  bool is_kept_off(const Indispensable& indispensable, ProviderId causer, ProviderId pushed) const {
    const Provider& row = model_.providers[causer];
    const Provider& waiting = model_.providers[pushed];
    if (row.needs.empty() || !chains_.may_beat(waiting.group, row.group)) return false;
    const auto keeps = [&](const Provider& other) {
      return std::any_of(row.needs.begin(), row.needs.end(),
                         [&](const Use<GroupId>& need) { return indispensable.needs_part_of(other, need.id); });
    };
    bool out = false;
    for (const ProviderId id : model_.groups[waiting.group].providers) {
      if (id == pushed || !facts_.chosen.contains(id)) continue;
      out = keeps(model_.providers[id]);
      if (!out || model_.providers[id].when.empty()) break;
    }
    return out;
  }

  void look_at_pushed(const Indispensable& indispensable, ProviderId id, const Pushed& pushed, PushSearch& search) {
    const GroupId group = model_.providers[id].group;
    Wanting wanting{group, id, {}};
    for (const ConditionUse& use : model_.providers[id].when) {
      if (!may_be_lacking(group, use.id) || !pushes_.may_lack_with(use.id, pushed.wanted)) continue;
      Want want{id, use, {}, pushed};
      for (const ProviderId causer : causers_[use.id]) {
        const GroupId other = model_.providers[causer].group;
        if (other != group && other != pushed.by && facts_.active.contains(causer) &&
            search.may_push_for(id, causer, use.id) && !is_kept_off(indispensable, causer, id))
          want.causers.push_back(causer);
      }
      add_pushed(want.causers, {pushed.by, use.id});
      if (!want.causers.empty()) wanting.wants.push_back(std::move(want));
    }
    if (!wanting.wants.empty()) out_.push_back(std::move(wanting));
  }

  void look_at(GroupId task) {
    std::vector<Wanting> found;
    if (!waiting_.may_wait(task)) return;
    for (const ProviderId provider : model_.groups[task].providers) {
      if (!facts_.capable.contains(provider) || !waiting_.may_be_first(provider)) continue;
      Wanting wanting{task, provider, {}};
      for (const ProviderId waiter : with_needs(provider)) {
        for (const ConditionUse& use : model_.providers[waiter].when) {
          if (may_be_lacking(task, use.id)) wanting.wants.push_back({waiter, use, {}});
        }
      }
      if (!wanting.wants.empty()) found.push_back(std::move(wanting));
    }
    if (found.empty()) return;
    PushSearch search(pushes_, task);
    for (Wanting& wanting : found) {
      for (Want& want : wanting.wants) want.causers = causers_for(want, wanting, search);
      const auto is_hopeless = [](const Want& want) { return want.causers.empty(); };
      wanting.wants.erase(std::remove_if(wanting.wants.begin(), wanting.wants.end(), is_hopeless), wanting.wants.end());
      if (!wanting.wants.empty()) out_.push_back(std::move(wanting));
    }
  }

  bool may_be_lacking(GroupId task, ConditionId id) const {
    return !causers_[id].empty() && !facts_.holds_always(model_, id, facts_.contexts[task]);
  }

  std::vector<ProviderId> causers_for(const Want& want, const Wanting& wanting, PushSearch& search) const {
    const PushExclusion& exclusion = pushes_.exclusion();
    std::vector<ProviderId> out;
    for (const ProviderId id : causers_[want.condition.id]) {
      const GroupId group = model_.providers[id].group;
      if (group == wanting.task || group == model_.providers[want.waiter].group || !facts_.active.contains(id) ||
          exclusion.excludes(want.waiter, id) || exclusion.find_beside(wanting.provider, id))
        continue;
      if (search.may_push(id, want.condition.id)) out.push_back(id);
    }
    return out;
  }

  /// The provider, and those of the groups that its needs may lead to.
  std::vector<ProviderId> with_needs(ProviderId provider) const {
    std::vector<ProviderId> out{provider};
    SparseSet<GroupId> seen;
    for (std::size_t next = 0; next < out.size(); ++next) {
      for (const Use<GroupId>& need : model_.providers[out[next]].needs) {
        if (!facts_.may_wait.contains(need.id) || !seen.add(need.id)) continue;
        for (const ProviderId below : model_.groups[need.id].providers) {
          if (waiting_.may_be_first(below)) out.push_back(below);
        }
      }
    }
    return out;
  }

  const Model& model_;
  const Facts& facts_;
  const Chains& chains_;
  const Causers& causers_;
  Pushes pushes_;
  Waiting waiting_;
  std::vector<Wanting> out_;
  std::vector<std::pair<ProviderId, Pushed>> open_; ///< pushed, to be looked at
  SparseSet<ProviderId> seen_;                      ///< all of these
};

} // namespace

std::vector<Wanting> find_wants(const Model& model, const Facts& facts, const Chains& chains, const Causers& causers) {
  return WantSearch(model, facts, chains, causers).run();
}

std::vector<Wanting> find_wants_of_pushed(const Model& model, const Facts& facts, const Chains& chains,
                                          const Causers& causers, const Indispensable& indispensable,
                                          const std::vector<Wanting>& wants) {
  return WantSearch(model, facts, chains, causers).run_pushed(indispensable, wants);
}

} // namespace director::analysis
