// Door: compiler/checks/analysis/plans.hpp. Test: tests/checks/analysis/plans_test.cpp.
#include "compiler/checks/analysis/plans.hpp"

#include <algorithm>

namespace director::checks {

namespace {

/// Depth first over what is still to be met, the nearest need first. The agenda is a linked list on the stack of the
/// search itself, so that taking a step back costs nothing.
class PlanSearch {
public:
  PlanSearch(const Model& model, std::int64_t most, std::int64_t steps, const IdSet<ProviderId>* mended)
      : model_(model),
        used_(model.groups.size(), false),
        most_(most),
        steps_(steps),
        mended_(mended) {}

  PlanCount run(ProviderId provider) {
    const Provider& row = model_.providers[provider];
    used_[row.group.value] = true;
    const Agenda agenda{&row.needs, 0, nullptr};
    meet(&agenda);
    return count_;
  }

private:
  struct Agenda {
    const std::vector<Use<GroupId>>* needs;
    std::size_t next;
    const Agenda* then;
  };

  void meet(const Agenda* agenda) {
    while (agenda != nullptr && agenda->next == agenda->needs->size()) agenda = agenda->then;
    if (agenda == nullptr) {
      if (++count_.plans >= most_) stop();
      return;
    }
    const GroupId group = (*agenda->needs)[agenda->next].id;
    if (used_[group.value]) return;
    const Agenda rest{agenda->needs, agenda->next + 1, agenda->then};
    used_[group.value] = true;
    for (const ProviderId provider : model_.groups[group].providers) {
      if (steps_-- <= 0) stop();
      if (!count_.complete) break;
      const bool is_mended = mended_ != nullptr && mended_->contains(provider);
      const Agenda below{&model_.providers[provider].needs, 0, &rest};
      meet(is_mended ? &rest : &below);
    }
    used_[group.value] = false;
  }

  void stop() { count_.complete = false; }

  const Model& model_;
  std::vector<bool> used_;
  std::int64_t most_;
  std::int64_t steps_;
  const IdSet<ProviderId>* mended_;
  PlanCount count_;
};

/// What is indispensable by way of one provider: whatever its needs cannot do without.
IdSet<GroupId> by_provider(const Model& model, const Provider& provider, const IdTable<GroupId, IdSet<GroupId>>& sets) {
  IdSet<GroupId> out(model.groups.size());
  for (const Use<GroupId>& need : provider.needs) {
    for (const GroupId group : model.groups.ids()) {
      if (sets[need.id].contains(group)) out.add(group);
    }
  }
  return out;
}

} // namespace

PlanCount count_plans(const Model& model, ProviderId provider, std::int64_t most, std::int64_t steps) {
  return PlanSearch(model, most, steps, nullptr).run(provider);
}

PlanVerdict find_plan(const Model& model, ProviderId provider, const IdSet<ProviderId>* mended) {
  if (model.providers[provider].needs.empty()) return PlanVerdict::found;
  const PlanCount count = PlanSearch(model, 1, plan_steps, mended).run(provider);
  if (count.plans > 0) return PlanVerdict::found;
  return count.complete ? PlanVerdict::none : PlanVerdict::undecided;
}

IdTable<GroupId, IdSet<GroupId>> indispensable_groups(const Model& model) {
  const std::size_t count = model.groups.size();
  IdSet<GroupId> everything(count);
  for (const GroupId group : model.groups.ids()) everything.add(group);
  // A greatest fixed point: begin with everything and take away what some provider does without.
  IdTable<GroupId, IdSet<GroupId>> sets(count, everything);
  for (bool changed = true; changed;) {
    changed = false;
    for (const GroupId group : model.groups.ids()) {
      IdSet<GroupId> both = everything;
      for (const ProviderId provider : model.groups[group].providers) {
        const IdSet<GroupId> here = by_provider(model, model.providers[provider], sets);
        IdSet<GroupId> common(count);
        for (const GroupId id : model.groups.ids()) {
          if (both.contains(id) && here.contains(id)) common.add(id);
        }
        both = common;
      }
      both.add(group);
      if (both == sets[group]) continue;
      sets[group] = both;
      changed = true;
    }
  }
  return sets;
}

} // namespace director::checks
