// Header: compiler/analysis/conflicts/outranked.hpp. Test: compiler/checks/causer_goes_first.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/outranked.hpp"

#include "compiler/analysis/requests/company.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace director::analysis {

namespace {

class OutrankedSearch {
public:
  explicit OutrankedSearch(const Input& input)
      : model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        sources_(find_sources(input.model)) {}

  std::vector<Outranked> run() {
    for (const ProviderId waiter : model_.providers.ids()) {
      if (!facts_.requested.contains(model_.providers[waiter].group)) continue;
      for (const ConditionUse& use : model_.providers[waiter].when) look_at(waiter, use);
    }
    return std::move(out_);
  }

private:
  void look_at(ProviderId waiter, const ConditionUse& use) {
    Want want{waiter, use, {}};
    std::vector<GroupId> groups;
    for (const ProviderId id : shared_.causers()[use.id]) {
      const GroupId group = model_.providers[id].group;
      if (group == model_.providers[waiter].group) continue;
      // What runs without a push may cause it; what never runs is reported by another check.
      if (!facts_.active.contains(id) || facts_.chosen.contains(id)) return;
      want.causers.push_back(id);
      groups.push_back(group);
    }
    if (want.causers.empty() || comes_otherwise(want, groups)) return;
    for (const Request& request : shared_.requests().of(model_.providers[waiter].group)) {
      if (!request.requester) continue;
      const std::optional<Company::Rank> rank = company_of(groups).find_outranking(request);
      if (!rank || !shared_.standstill().may_wait(request, waiter, use)) continue;
      if (rank->need == nullptr && (others_push(want, *rank) || is_pushed_company(*rank))) continue;
      out_.push_back({waiter, use, want.causers, request.task, rank->waits, rank->first, rank->need, rank->needer});
    }
  }

  Company& company_of(const std::vector<GroupId>& groups) {
    return companies_.try_emplace(groups, model_, facts_, shared_.requests(), groups).first->second;
  }

  /// By anything but the causing providers and the stop of their groups, which are requested the whole time.
  bool comes_otherwise(const Want& want, const std::vector<GroupId>& groups) const {
    const Condition& condition = model_.conditions[want.condition.id];
    const auto among = [](const auto& all, auto one) { return std::find(all.begin(), all.end(), one) != all.end(); };
    const State& state = model_.states[condition.state];
    if (state.of && condition.accepts.contains(*state.initial) && !among(groups, state.of->id)) return true;
    return std::any_of(sources_[condition.state].begin(), sources_[condition.state].end(), [&](const Source& source) {
      if (source.kind == Source::Kind::initial || !source.values.overlaps(condition.accepts)) return false;
      if (source.provider) return !among(want.causers, *source.provider) && facts_.active.contains(*source.provider);
      return !source.group || !among(groups, *source.group);
    });
  }

  /// Another task of the same list goes before the causing group, and may push it for itself. Not if it waits for
  /// something else that only the waiting group brings about.
  bool others_push(const Want& want, const Company::Rank& rank) const {
    const auto is_wanted = [&](ProviderId causer) {
      return std::find(want.causers.begin(), want.causers.end(), causer) != want.causers.end();
    };
    return std::any_of(rank.list->begin(), rank.list->end(), [&](const Task& entry) {
      return !Company::goes_first(model_, *rank.first, entry) && entry.target != rank.first->target &&
             leads_to_pusher(entry.target, is_wanted, model_.providers[want.waiter].group);
    });
  }

  /// Whether the provider has a condition that nothing but this group makes true.
  bool depends_on(ProviderId provider, GroupId group) const {
    const std::vector<ConditionUse>& when = model_.providers[provider].when;
    return std::any_of(when.begin(), when.end(), [&](const ConditionUse& use) {
      const Condition& condition = model_.conditions[use.id];
      const State& state = model_.states[condition.state];
      if (state.initial && condition.accepts.contains(*state.initial)) return false;
      bool comes = false;
      for (const Source& source : sources_[condition.state]) {
        if (!source.values.overlaps(condition.accepts)) continue;
        if (!acts(model_, source, facts_.active)) continue;
        const std::optional<GroupId> by =
            source.provider ? std::optional(model_.providers[*source.provider].group) : source.group;
        if (by != group) return false;
        comes = true;
      }
      return comes;
    });
  }

  /// What waits is meant to be pushed by the task that goes first, not to run beside it.
  bool is_pushed_company(const Company::Rank& rank) const {
    const Claims& below = shared_.claims(rank.waits->target);
    return leads_to_pusher(rank.first->target,
                           [&](ProviderId causer) { return below.contains(model_.providers[causer].group); });
  }

  template <class Pushed>
  bool leads_to_pusher(GroupId from, const Pushed& pushed, std::optional<GroupId> waiting = std::nullopt) const {
    const Claims& below = shared_.claims(from);
    return std::any_of(shared_.wants().begin(), shared_.wants().end(), [&](const Wanting& wanting) {
      if (!below.contains(wanting.task)) return false;
      if (waiting && depends_on(wanting.provider, *waiting)) return false;
      return std::any_of(wanting.wants.begin(), wanting.wants.end(), [&](const Want& each) {
        return std::any_of(each.causers.begin(), each.causers.end(), pushed);
      });
    });
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  IdTable<StateId, std::vector<Source>> sources_;
  std::map<std::vector<GroupId>, Company> companies_; ///< of causing groups
  std::vector<Outranked> out_;
};

} // namespace

std::vector<Outranked> find_outranked(const Input& input) { return OutrankedSearch(input).run(); }

std::string propose_going_first(const Model& model, const Outranked& one) {
  const std::string waits = name_of(model, one.waits->target);
  if (one.need != nullptr)
    return fmt::format("instead of needing {}, request it `apart`, with a lower priority than {}",
                       name_of(model, one.need->id), waits);
  const std::string first = name_of(model, one.first->target);
  // Otherwise it would be in one unit with the other one.
  return model.may_be_left_out(*one.waits)
             ? fmt::format("make {} `apart` instead of `optional`, with a higher priority than {}", waits, first)
             : fmt::format("give {} a higher priority than {}", waits, first);
}

} // namespace director::analysis
