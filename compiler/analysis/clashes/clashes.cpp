// Header: compiler/analysis/clashes/clashes.hpp. Test: compiler/checks/push_cycle.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/clashes/clashes.hpp"

#include "compiler/analysis/clashes/exclusions.hpp"
#include "compiler/analysis/clashes/losses.hpp"
#include "compiler/analysis/clashes/lost_for_good.hpp"
#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

using dsl::Note;

/// Of the members of a unit that wait, this many are compared with each other.
constexpr std::size_t most_compared = 16;

class ClashSearch {
public:
  ClashSearch(const Model& model, const Graph& graph, const Facts& facts, const Shared& shared)
      : model_(model),
        facts_(facts),
        shared_(shared),
        losses_(model, graph, facts, shared) {}

  std::vector<Clash> run() {
    for (const Wanting& wanting : shared_.wants()) {
      for (const Want& want : wanting.wants) look_above(wanting.task, want);
      for (std::size_t first = 0; first < wanting.wants.size(); ++first) {
        for (std::size_t second = first + 1; second < wanting.wants.size(); ++second)
          look_at(wanting, wanting.wants[first], wanting.wants[second]);
      }
    }
    for (const ProviderId id : model_.providers.ids()) {
      if (!facts_.active.contains(id) || !row(id).has_packs) continue;
      for (const Pack& pack : row(id).packs) look_at(pack);
    }
    take_lost();
    return std::move(out_);
  }

private:
  const Provider& row(ProviderId id) const { return model_.providers[id]; }
  const Condition& condition(const ConditionUse& use) const { return model_.conditions[use.id]; }

  void look_at(const Wanting& wanting, const Want& first, const Want& second) {
    if (!may_clash(first, second) || seen_.count({first.condition.span, second.condition.span}) != 0) return;
    std::optional<Clash> clash = find_incompatible(wanting.task, first, second);
    if (!clash) clash = find_cycle(wanting.task, first, second);
    if (!clash) clash = find_vain(first, second);
    const bool in_order = in_one_group(first, second) && !may_precede(second, wanting.task); // see find_cycle()
    if (!clash && !in_order) clash = find_vain(second, first);
    if (in_order) ordered_.emplace_back(first.condition.span, second.condition.id);
    if (!clash) return;
    seen_.insert({first.condition.span, second.condition.span});
    clash->task = wanting.task;
    out_.push_back(std::move(*clash));
  }

  /// All pushes for a unit last until each member can run, like those for one task.
  void look_at(const Pack& pack) {
    std::vector<const Task*> members;
    for (const Task* task : unit_members(model_, pack)) {
      if (members.size() < most_compared && model_.is_always_member(*task) && !shared_.wants_of(task->target).empty())
        members.push_back(task);
    }
    // They are pushed for in this order.
    const auto priority = [&](const Task* task) {
      return model_.edges[task->edge].levels[task->levels.front().level].priority;
    };
    std::stable_sort(members.begin(), members.end(),
                     [&](const Task* a, const Task* b) { return priority(a) > priority(b); });
    for (std::size_t first = 0; first < members.size(); ++first) {
      for (std::size_t second = first + 1; second < members.size(); ++second)
        look_at(*members[first], *members[second]);
    }
  }

  void look_at(const Task& a, const Task& b) {
    if (!compared_.insert(a.target < b.target ? std::pair(a.target, b.target) : std::pair(b.target, a.target)).second)
      return;
    for (const Want* first : shared_.wants_of(a.target)) {
      for (const Want* second : shared_.wants_of(b.target)) {
        if (may_clash(*first, *second) && may_hold_together(*first, *second) && !is_noted(first->condition) &&
            !is_noted(second->condition))
          look_at(a, *first, b, *second);
      }
    }
  }

  /// Otherwise they are in no combination of the unit.
  bool may_hold_together(const Want& first, const Want& second) const {
    return compatible(region_of(model_, row(first.waiter).when), region_of(model_, row(second.waiter).when));
  }

  /// What can never be granted together is a conflict of the pack.
  void look_at(const Task& a, const Want& first, const Task& b, const Want& second) {
    if (find_incompatible(a.target, first, second)) return;
    const Task* late = &b;
    std::optional<Clash> clash = find_cycle(a.target, first, second);
    if (!clash) clash = find_vain(first, second);
    if (!clash) {
      clash = find_vain(second, first);
      late = &a;
    }
    if (!clash || shared_.units().verdict({a.target, b.target}) == UnitVerdict::impossible) return;
    seen_.insert({clash->first.span, clash->second.span});
    clash->task = late == &b ? a.target : b.target;
    clash->member = late;
    out_.push_back(std::move(*clash));
  }

  bool may_clash(const Want& first, const Want& second) const {
    if (condition(first.condition).state == condition(second.condition).state) return false;
    // Two providers of one group are never parts of one plan.
    if (first.waiter != second.waiter && row(first.waiter).group == row(second.waiter).group) return false;
    return std::none_of(first.causers.begin(), first.causers.end(), [&](ProviderId id) {
      return std::find(second.causers.begin(), second.causers.end(), id) != second.causers.end();
    });
  }

  bool is_noted(const ConditionUse& use) const {
    return std::any_of(seen_.begin(), seen_.end(),
                       [&](const auto& pair) { return pair.first == use.span || pair.second == use.span; });
  }

  /// A push for it is never made if the groups above the task hold what it needs.
  void look_above(GroupId task, const Want& want) {
    std::vector<Note> because;
    for (const ProviderId causer : want.causers) {
      std::optional<std::vector<Note>> notes = losses_.held_above(task, causer);
      if (!notes) return;
      because = std::move(*notes);
    }
    if (losses_.comes_otherwise(want) || !seen_.insert({want.condition.span, want.condition.span}).second) return;
    Clash clash = make(Clash::Kind::vain, want, want);
    clash.loss = Clash::Loss::held;
    clash.task = task;
    clash.because = std::move(because);
    out_.push_back(std::move(clash));
  }

  /// If the condition is part of another clash, that finding is enough.
  void take_lost() {
    for (LostForGood& each : find_lost_for_good(model_, facts_, shared_)) {
      if (is_noted(each.condition) || is_kept_by_order(each)) continue;
      Clash& clash = out_.emplace_back();
      clash.kind = Clash::Kind::vain;
      clash.loss = Clash::Loss::for_good;
      clash.task = each.task;
      clash.first_waiter = clash.second_waiter = each.waiter;
      clash.first = clash.second = each.condition;
      clash.first_causer = clash.second_causer = each.causer;
      clash.lost = std::move(each.lost);
      clash.lacking = each.lacking;
      clash.unrequested = each.unrequested;
      clash.because = std::move(each.because);
    }
  }

  /// Whether only a push for a later condition makes the other lost one false: then the first one holds already.
  bool is_kept_by_order(const LostForGood& lost) const {
    if (!lost.lacking || lost.lost.size() != 2) return false;
    const Condition& lacking = model_.conditions[*lost.lacking];
    return std::any_of(ordered_.begin(), ordered_.end(), [&](const auto& pair) {
      const Condition& later = model_.conditions[pair.second];
      return pair.first == lost.condition.span && later.state == lacking.state &&
             facts_.values[later.state].subset_of(lacking.accepts.united(later.accepts));
    });
  }

  static Clash make(Clash::Kind kind, const Want& first, const Want& second) {
    Clash out;
    out.kind = kind;
    out.first_waiter = first.waiter;
    out.second_waiter = second.waiter;
    out.first = first.condition;
    out.second = second.condition;
    out.first_causer = first.causers.front();
    out.second_causer = second.causers.front();
    return out;
  }

  template <class Find>
  static auto for_each_pair(const Want& first, const Want& second, const Find& find) {
    decltype(find(first.causers.front(), second.causers.front())) out;
    for (const ProviderId a : first.causers) {
      for (const ProviderId b : second.causers) {
        auto found = find(a, b);
        if (!found) return decltype(found){};
        if (!out) out = std::move(found);
      }
    }
    return out;
  }

  std::optional<Clash> find_incompatible(GroupId task, const Want& first, const Want& second) const {
    if (!in_one_group(first, second)) return std::nullopt;
    const auto because = for_each_pair(first, second, [&](ProviderId a, ProviderId b) {
      std::optional<std::vector<Note>> out;
      const auto there = excludes(model_, a, b), back = excludes(model_, b, a);
      if (there && back) out = {*there, *back};
      return out;
    });
    if (!because) return std::nullopt;
    Clash out = make(Clash::Kind::incompatible, first, second);
    out.because = *because;
    out.task = task;
    note_order(out, first, second);
    return out;
  }

  bool in_one_group(const Want& first, const Want& second) const {
    const GroupId group = row(first.causers.front()).group;
    const auto is_here = [&](ProviderId id) { return row(id).group == group; };
    return std::all_of(first.causers.begin(), first.causers.end(), is_here) &&
           std::all_of(second.causers.begin(), second.causers.end(), is_here);
  }

  /// A group is pushed for the first condition until that holds, and then for the next one.
  void note_order(Clash& clash, const Want& first, const Want& second) const {
    clash.first_may_precede = may_precede(first, clash.task);
    clash.second_may_precede = may_precede(second, clash.task);
  }

  /// Whether it may hold without a push of this task for it.
  bool may_precede(const Want& want, GroupId task) const {
    const State& state = model_.states[condition(want.condition).state];
    if ((state.initial && condition(want.condition).accepts.contains(*state.initial)) || losses_.comes_otherwise(want))
      return true;
    const auto is_causer = [&](ProviderId id) {
      return std::find(want.causers.begin(), want.causers.end(), id) != want.causers.end();
    };
    if (std::any_of(want.causers.begin(), want.causers.end(),
                    [&](ProviderId id) { return facts_.chosen.contains(id); }))
      return true;
    return std::any_of(shared_.wants().begin(), shared_.wants().end(), [&](const Wanting& other) {
      return other.task != task && std::any_of(other.wants.begin(), other.wants.end(), [&](const Want& one) {
               return std::any_of(one.causers.begin(), one.causers.end(), is_causer);
             });
    });
  }

  std::optional<Clash> find_cycle(GroupId task, const Want& first, const Want& second) const {
    Clash out = make(Clash::Kind::cycle, first, second);
    out.task = task;
    const bool in_order = in_one_group(first, second);
    if (in_order) note_order(out, first, second);
    const auto mutual = for_each_pair(first, second, [&](ProviderId a, ProviderId b) {
      std::optional<std::vector<Note>> notes;
      const auto there = undoes(model_, a, second.condition), back = undoes(model_, b, first.condition);
      if (there && back) notes = {*there, *back};
      return notes;
    });
    if (mutual) {
      out.because = *mutual;
      return out;
    }
    for (const bool swapped : {false, true}) {
      const Want& held = swapped ? second : first;
      const Want& late = swapped ? first : second;
      // The first one is caused first.
      if (swapped && in_order && !out.second_may_precede) continue;
      const auto one_way =
          for_each_pair(held, late, [&](ProviderId, ProviderId b) { return runs_without(model_, b, held.condition); });
      if (!one_way) continue;
      out.because = {*one_way};
      return out;
    }
    return std::nullopt;
  }

  std::optional<Clash> find_vain(const Want& first, const Want& second) const {
    if (losses_.comes_otherwise(second)) return std::nullopt;
    Clash out = make(Clash::Kind::vain, first, second);
    for (const Clash::Loss loss : {Clash::Loss::request, Clash::Loss::group, Clash::Loss::provider}) {
      const auto because = for_each_pair(first, second, [&](ProviderId a, ProviderId b) {
        return loss == Clash::Loss::request ? losses_.lost_request(a, b)
               : loss == Clash::Loss::group ? losses_.lost_group(a, b)
                                            : losses_.lost_provider(a, b, second);
      });
      if (!because) continue;
      out.loss = loss;
      out.because = *because;
      out.shares_group =
          loss == Clash::Loss::request && losses_.lost_group(out.first_causer, out.second_causer).has_value();
      return out;
    }
    return std::nullopt;
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  Losses losses_;
  std::set<std::pair<dsl::Span, dsl::Span>> seen_;
  std::set<std::pair<GroupId, GroupId>> compared_; ///< members of one unit
  /// A condition, and one that is caused only after it.
  std::vector<std::pair<dsl::Span, ConditionId>> ordered_;
  std::vector<Clash> out_;
};

} // namespace

std::vector<Clash> find_clashes(const Model& model, const Graph& graph, const Facts& facts, const Shared& shared) {
  return ClashSearch(model, graph, facts, shared).run();
}

void add_parties(const Model& model, const Clash& clash, dsl::Diagnostic& finding) {
  std::vector<std::pair<ProviderId, ConditionUse>> promises{{clash.second_causer, clash.second}};
  if (clash.first.span != clash.second.span) {
    finding.notes.push_back(
        {clash.first.span,
         fmt::format("{} waits for {} as well", name_of(model, clash.first_waiter), name_of(model, clash.first.id))});
    promises.insert(promises.begin(), {clash.first_causer, clash.first});
  }
  if (clash.member != nullptr)
    finding.notes.push_back(
        {clash.member->span, fmt::format("{} is granted only together with {}", name_of(model, clash.member->target),
                                         name_of(model, clash.task))});
  finding.rules_out = {clash.first.span, clash.second.span};
  // Another provider of the task waits for the same in vain.
  for (const ProviderId id : model.groups[clash.task].providers) {
    for (const ConditionUse& use : model.providers[id].when) {
      const auto& same = use.id == clash.first.id ? clash.first : clash.second;
      if (use.id == same.id && use.span != same.span) finding.rules_out.push_back(use.span);
    }
  }
  for (const auto& [causer, condition] : promises) {
    finding.notes.push_back(causes(model, causer, condition.id));
    const bool is_in_vain = clash.kind == Clash::Kind::vain && clash.loss != Clash::Loss::for_good;
    if (is_in_vain) finding.rules_out.push_back(finding.notes.back().span);
  }
  finding.notes.insert(finding.notes.end(), clash.because.begin(), clash.because.end());
}

} // namespace director::analysis
