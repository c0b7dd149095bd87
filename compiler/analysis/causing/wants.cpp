// Header: compiler/analysis/causing/wants.hpp. Test: tests/compiler/analysis/causing/wants_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/wants.hpp"

#include "compiler/analysis/chains/sparse_set.hpp"

#include <algorithm>

namespace director::analysis {

namespace {

class WantSearch {
public:
  WantSearch(const Model& model, const Facts& facts, const Chains& chains, const Causers& causers)
      : model_(model),
        facts_(facts),
        causers_(causers),
        pushes_(model, facts, chains, causers),
        waiting_(model, facts) {}

  std::vector<Wanting> run() {
    for (const GroupId task : model_.groups.ids()) {
      if (facts_.requested.contains(task)) look_at(task);
    }
    return std::move(out_);
  }

private:
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
  const Causers& causers_;
  Pushes pushes_;
  Waiting waiting_;
  std::vector<Wanting> out_;
};

} // namespace

std::vector<Wanting> find_wants(const Model& model, const Facts& facts, const Chains& chains, const Causers& causers) {
  return WantSearch(model, facts, chains, causers).run();
}

} // namespace director::analysis
