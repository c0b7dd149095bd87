// Header: compiler/checks/check.hpp. Test: compiler/checks/push_in_vain.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/chains/sparse_set.hpp"
#include "compiler/analysis/clashes/exclusions.hpp"
#include "compiler/analysis/clashes/holdings.hpp"
#include "compiler/analysis/clashes/losses.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/facts/waiting.hpp"
#include "compiler/analysis/requests/company.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/states/stopped_values.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/proposals.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"
#include "compiler/checks/report_stranded_pushes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace director::checks {

namespace {

std::string loss_of(const Model& model, const Clash& clash) {
  const std::string causer = name_of(model, clash.second_causer);
  switch (clash.loss) {
  case Clash::Loss::request:
    return fmt::format("the request for {}", name_of(model, model.providers[clash.second_causer].group));
  case Clash::Loss::group: return fmt::format("a group that {} cannot do without", causer);
  case Clash::Loss::provider: return fmt::format("a state that {} cannot run without", causer);
  case Clash::Loss::held:
  case Clash::Loss::for_good: break;
  }
  return {};
}

/// The first one is the awaited condition.
std::string lost_with(const Model& model, const std::vector<ConditionId>& lost) {
  if (lost.size() == 1) return "it is lost: what could bring it back runs only while it holds";
  std::vector<std::string> names{"that"};
  for (std::size_t i = 1; i < lost.size(); ++i) names.push_back(name_of(model, lost[i]));
  return fmt::format("{} are lost: what could bring them back runs only while one of them holds", list_of(names));
}

std::string message_of(const Model& model, const Clash& clash) {
  const std::string waits =
      fmt::format("{} waits for {} in vain", name_of(model, clash.second_waiter), name_of(model, clash.second.id));
  if (clash.loss == Clash::Loss::for_good) return fmt::format("{} once {}", waits, lost_with(model, clash.lost));
  if (clash.loss == Clash::Loss::held)
    return fmt::format("{}: what {} needs is kept above it", waits, name_of(model, clash.second_causer));
  const std::string causer = name_of(model, clash.first_causer), first = name_of(model, clash.first.id);
  if (clash.member != nullptr)
    return fmt::format("{}: the push of {} for {}, which {} waits for, takes away {}", waits, causer, first,
                       name_of(model, clash.first_waiter), loss_of(model, clash));
  return fmt::format("{}: its push of {} for {} takes away {}", waits, causer, first, loss_of(model, clash));
}

std::string help_of(const Model& model, const Clash& clash) {
  const std::string first = name_of(model, clash.first_causer), second = name_of(model, clash.second_causer);
  const std::string group = name_of(model, model.providers[clash.second_causer].group);
  switch (clash.loss) {
  case Clash::Loss::request:
    // What it requests would never get what it keeps for itself.
    if (!clash.shares_group) return fmt::format("let {} request {} too", first, group);
    return "let one provider cause both";
  case Clash::Loss::group: return "let one provider cause both, or let one of the two do without what both take";
  case Clash::Loss::provider:
    return fmt::format("let {} leave that state as it is, or {} run without it{}", first, second,
                       put_last(model, clash.second_causer, [&](const ConditionUse& use) {
                         return sets_against(model, clash.first_causer, use).has_value();
                       }));
  case Clash::Loss::held:
    return fmt::format("let {} or what is above {} do without that", second, name_of(model, clash.task));
  case Clash::Loss::for_good:
    if (clash.unrequested)
      return fmt::format("let something that runs without {}, and ranks after {}, request {}",
                         name_of(model, clash.second.id), name_of(model, clash.task), group);
    if (!clash.lacking) return fmt::format("let {} run without what is lost then", second);
    return fmt::format(
        "let {} run without {}{}", second, name_of(model, *clash.lacking),
        put_last(model, clash.second_causer, [&](const ConditionUse& use) { return use.id == *clash.lacking; }));
  }
  return {};
}

/// Whether it continues with the step's value by its `stay`, whatever the other states are.
bool stays_with(const Model& model, const compiler::Provider& provider, const Condition& step) {
  const Region region = region_of(model, provider.stay);
  const auto at = region.states.find(step.state);
  const ValueSet values = values_set_by(model, provider, step.state).intersected(step.accepts);
  return region.states.size() == 1 && at != region.states.end() && values.subset_of(at->second);
}

/// Whether every other provider of the group that sets the step's value has the condition too, or continues until then.
bool holds_before(const Model& model, ProviderId id, const ConditionUse& step, const ConditionUse& use) {
  const Condition& wanted = model.conditions[step.id];
  const std::vector<ProviderId>& all = model.group_of(id).providers;
  return std::all_of(all.begin(), all.end(), [&](ProviderId other) {
    const compiler::Provider& row = model.providers[other];
    if (other == id || !values_set_by(model, row, wanted.state).overlaps(wanted.accepts) ||
        stays_with(model, row, wanted))
      return true;
    return std::any_of(row.when.begin(), row.when.end(),
                       [&](const ConditionUse& each) { return model.satisfies(each.id, use.id); });
  });
}

using Sources = IdTable<StateId, std::vector<Source>>;

/// Whether something below the group may bring the condition about before it waits, without a push.
bool comes_below(const Input& input, const Sources& sources, const Claims& below, ConditionId id) {
  const Condition& wanted = input.model.conditions[id];
  const auto comes = [&](const Source& source) {
    if (source.kind == Source::Kind::initial || !source.values.overlaps(wanted.accepts)) return false;
    if (source.provider)
      return input.facts.chosen.contains(*source.provider) &&
             below.contains(input.model.providers[*source.provider].group);
    return !source.group || below.contains(*source.group);
  };
  return std::any_of(sources[wanted.state].begin(), sources[wanted.state].end(), comes);
}

/// What could be pushed for the condition, if nothing below the group itself would bring it about before. What is below
/// is not requested while the group waits.
std::optional<ProviderId> find_pushed(const Input& input, const Sources& sources, GroupId group, ConditionId id) {
  const Claims& below = input.shared.claims(group);
  std::optional<ProviderId> out;
  for (const ProviderId causer : input.shared.causers()[id]) {
    const bool is_below = below.contains(input.model.providers[causer].group);
    if (is_below && comes_below(input, sources, below, id)) return std::nullopt;
    const IdSet<ProviderId>& running = is_below ? input.facts.capable : input.facts.active;
    if (!out && running.contains(causer) && !input.shared.promises().explained.contains(causer)) out = causer;
  }
  return out;
}

bool has_root(const Model& model, const std::vector<GroupId>& groups) {
  return std::any_of(model.roots.begin(), model.roots.end(), [&](const Task& root) {
    return std::find(groups.begin(), groups.end(), root.target) != groups.end();
  });
}

/// Whether none of the groups need be requested where the task is: that is reported there (causer_not_running).
bool need_not_be_requested(const Input& input, const Request& request, const std::vector<GroupId>& groups) {
  return request.requester && !has_root(input.model, groups) &&
         !Company(input.model, input.facts, input.shared.requests(), groups).find_bare_chain(request).empty();
}

/// A step that has to wait: the group is not granted meanwhile, so that its own state begins again.
void look_at_steps(const Input& input, Findings& findings) {
  const Model& model = input.model;
  const Sources sources = find_sources(model);
  Waiting waiting(model, input.facts);
  for (const ProviderId id : model.providers.ids()) {
    const GroupId group = model.providers[id].group;
    const ConditionUse* step = find_own_step(model, id);
    if (step == nullptr || !input.facts.requested.contains(group) || !input.facts.capable.contains(id)) continue;
    if (!waiting.may_wait(group)) continue;
    const StateId own = model.conditions[step->id].state;
    const std::vector<Request>& of_group = input.shared.requests().of(group);
    for (const ConditionUse& use : model.providers[id].when) {
      const StateId state = model.conditions[use.id].state;
      if (state == own || input.facts.is_impossible(id, state) || input.facts.holds_always(model, use.id, Region{}) ||
          holds_before(model, id, *step, use))
        continue;
      const std::optional<ProviderId> causer = find_pushed(input, sources, group, use.id);
      if (!causer || std::any_of(of_group.begin(), of_group.end(), [&](const Request& request) {
            return need_not_be_requested(input, request, {model.providers[*causer].group});
          }))
        continue;
      const std::string waiter = name_of(model, id), name = name_of(model, group), of = name_of(model, own);
      dsl::Diagnostic& finding =
          findings.add(use.span, fmt::format("{} waits for {} in vain: while {} waits, {} is {} again", waiter,
                                             name_of(model, use.id), name, of,
                                             model.states[own].value_text(*model.states[own].initial)));
      finding.notes.push_back(runs_only_while(model, id, *step));
      finding.notes.push_back({model.states[own].of->span, fmt::format("{} begins again when {} stops", of, name)});
      finding.notes.push_back(causes(model, *causer, use.id));
      finding.help = fmt::format("let {} request a group that waits for {} instead", waiter, name_of(model, use.id));
    }
  }
}

/// What the pushed provider needs is kept by the one that requests the task, though not by all that do.
class KeptWhileRequested {
public:
  KeptWhileRequested(const Input& input, Findings& findings)
      : input_(input),
        model_(input.model),
        losses_(input.model, input.graph, input.facts, input.shared),
        findings_(findings) {
    for (const Clash& clash : input.conflicts.clashes()) seen_.insert(clash.second.span);
    for (const Loser& loser : input.conflicts.losers()) starving_.insert({loser.above, loser.refused.task->target});
  }

  void look_at(const Wanting& wanting) {
    for (const Want& want : wanting.wants) {
      if (want.waiter != wanting.provider || seen_.count(want.condition.span) != 0) continue;
      for (const Request& request : input_.shared.requests().of(wanting.task)) {
        if (!request.requester ||
            input_.shared.indispensable().needs_contain(model_.providers[*request.requester], wanting.task))
          continue;
        const std::vector<KeptNeed> kept = find_kept_needs(model_, input_.shared, *request.requester, want.causers);
        if (kept.empty() || !waits_here(request, want)) continue;
        report(request, want, kept.front());
        break;
      }
    }
  }

private:
  /// Whether it waits there for what only these cause, and one of them is requested: otherwise that is the finding.
  bool waits_here(const Request& request, const Want& want) const {
    std::vector<GroupId> groups;
    for (const ProviderId id : want.causers) {
      const GroupId group = model_.providers[id].group;
      if (input_.shared.promises().explained.contains(id) || starving_.count({*request.requester, group}) != 0)
        return false;
      groups.push_back(group);
    }
    if (losses_.comes_otherwise(want) ||
        !input_.shared.standstill().may_wait(request, want.waiter, want.condition, groups))
      return false;
    return !need_not_be_requested(input_, request, groups);
  }

  void report(const Request& request, const Want& want, const KeptNeed& one) {
    seen_.insert(want.condition.span);
    const ProviderId above = *request.requester, causer = want.causers.front();
    const std::string keeper = name_of(model_, above), by = name_of(model_, causer), group = name_of(model_, one.group);
    dsl::Diagnostic& finding =
        findings_.add(want.condition.span,
                      fmt::format("{} waits for {} in vain while {} keeps {}, which {} needs",
                                  name_of(model_, want.waiter), name_of(model_, want.condition.id), keeper, group, by));
    finding.notes.push_back(causes(model_, causer, want.condition.id));
    finding.notes.push_back(one.needed);
    finding.notes.push_back(one.kept);
    finding.notes.push_back(requests(model_, above, *request.task));
    finding.help = fmt::format("let {} or {} do without {}", by, keeper, group);
  }

  const Input& input_;
  const Model& model_;
  const Losses losses_;
  Findings& findings_;
  std::set<dsl::Span> seen_;                          ///< conditions with a finding
  std::set<std::pair<ProviderId, GroupId>> starving_; ///< groups that never run below this provider (self_conflict)
};

/// While the task waits, the outside excludes all that cause what it waits for, or all that request those.
class ExcludedCausers {
public:
  ExcludedCausers(const Input& input, Findings& findings)
      : input_(input),
        model_(input.model),
        exclusion_(input.shared.push_exclusion()),
        waiting_(input.model, input.facts),
        losses_(input.model, input.graph, input.facts, input.shared),
        findings_(findings) {
    for (const Clash& clash : input.conflicts.clashes()) seen_.insert(clash.second.span);
  }

  void look_at(GroupId task) {
    if (!waiting_.may_wait(task)) return;
    for (const ProviderId waiter : model_.groups[task].providers) {
      if (!input_.facts.capable.contains(waiter) || !waiting_.may_be_first(waiter)) continue;
      for (const ConditionUse& use : model_.providers[waiter].when) look_at(task, waiter, use);
    }
  }

private:
  struct Excluded {
    ProviderId causer{};
    StateId state{};
    bool unrequested = false; ///< it is not requested with these values; else it cannot run itself
  };

  void look_at(GroupId task, ProviderId waiter, const ConditionUse& use) {
    if (seen_.count(use.span) != 0 || input_.facts.is_impossible(waiter, model_.conditions[use.id].state)) return;
    Want want{waiter, use, {}};
    for (const ProviderId causer : input_.shared.causers()[use.id]) {
      const GroupId group = model_.providers[causer].group;
      if (group == task || !input_.facts.active.contains(causer)) continue;
      if (!input_.shared.chains().may_beat(task, group)) return;
      want.causers.push_back(causer);
    }
    if (want.causers.empty() || losses_.comes_otherwise(want)) return;
    for (const Request& request : input_.shared.requests().of(task)) {
      for (const Region& region : input_.shared.requests().regions(request)) {
        if (look_at(want, request, region)) return;
      }
    }
  }

  bool look_at(const Want& want, const Request& request, const Region& region) {
    std::vector<Excluded> all;
    std::vector<GroupId> groups, absent;
    for (const ProviderId causer : want.causers) {
      const std::optional<Excluded> one = find_excluded(want.waiter, region, causer);
      if (!one) return false;
      all.push_back(*one);
      groups.push_back(model_.providers[causer].group);
      if (one->unrequested || none_can_run(groups.back(), want.waiter, region)) absent.push_back(groups.back());
    }
    if (!input_.shared.standstill().may_wait(region, want.waiter, want.condition, absent) ||
        need_not_be_requested(input_, request, groups))
      return false;
    report(want, request, region, all);
    return true;
  }

  bool none_can_run(GroupId group, ProviderId waiter, const Region& region) const {
    const std::vector<ProviderId>& providers = model_.groups[group].providers;
    return std::all_of(providers.begin(), providers.end(), [&](ProviderId id) {
      return !input_.facts.active.contains(id) || exclusion_.find_outside(waiter, region, id, Region{});
    });
  }

  std::optional<Excluded> find_excluded(ProviderId waiter, const Region& region, ProviderId causer) const {
    if (const auto state = exclusion_.find_outside(waiter, region, causer, Region{})) return Excluded{causer, *state};
    std::optional<StateId> first;
    for (const Request& request : input_.shared.requests().of(model_.providers[causer].group)) {
      for (const Region& requested : input_.shared.requests().regions(request)) {
        const auto state = exclusion_.find_outside(waiter, region, causer, requested);
        if (!state) return std::nullopt;
        if (!first) first = state;
      }
    }
    if (!first) return std::nullopt;
    return Excluded{causer, *first, true};
  }

  void report(const Want& want, const Request& request, const Region& region, const std::vector<Excluded>& all) {
    const Excluded& first = all.front();
    std::vector<std::string> names;
    for (const Excluded& each : all) {
      if (each.state == first.state && each.unrequested == first.unrequested)
        names.push_back(name_of(model_, each.causer));
    }
    const ValueSet values = exclusion_.values_of(first.state, want.waiter, region);
    const std::string wanted = name_of(model_, want.condition.id);
    const std::string then = fmt::format("while {} is {}", name_of(model_, first.state),
                                         values_in_words(model_.states[first.state], values));
    dsl::Diagnostic& finding =
        findings_.add(want.condition.span, fmt::format("{} waits for {} in vain {}: {}, which could cause it, {} then",
                                                       name_of(model_, want.waiter), wanted, then, few_of(names),
                                                       !first.unrequested  ? "cannot run"
                                                       : names.size() == 1 ? "is not requested"
                                                                           : "are not requested"));
    for (const Excluded& each : all) {
      finding.notes.push_back(causes(model_, each.causer, want.condition.id));
      add_exclusion(model_, exclusion_, each.state, want.waiter, each.causer, finding.notes);
      if (exclusion_.conditions_on(each.state, want.waiter).empty()) add_request(request, each.state, finding.notes);
      if (!each.unrequested) continue;
      for (const Request& other : input_.shared.requests().of(model_.providers[each.causer].group))
        add_request(other, each.state, finding.notes);
    }
    shorten(finding.notes);
    finding.help = first.unrequested ? fmt::format("let something request {} that runs {}",
                                                   name_of(model_, model_.providers[first.causer].group), then)
                                     : propose_causer(model_, first.state, values, want.condition.id);
  }

  /// Adds the request, and the nearest above it whose conditions are on the state.
  void add_request(const Request& request, StateId state, std::vector<dsl::Note>& notes) const {
    std::vector<Request> open{request};
    SparseSet<GroupId> seen;
    for (std::size_t next = 0; next < open.size() && next < most_notes; ++next) {
      const Request at = open[next]; // the list grows
      if (!at.requester) continue;
      const GroupId above = model_.providers[*at.requester].group;
      add_once(requests(model_, *at.requester, *at.task), notes);
      if (!exclusion_.conditions_on(state, *at.requester).empty()) {
        add_exclusion(model_, exclusion_, state, *at.requester, *at.requester, notes);
      } else if (seen.add(above)) {
        const std::vector<Request>& further = input_.shared.requests().of(above);
        open.insert(open.end(), further.begin(), further.end());
      }
    }
  }

  const Input& input_;
  const Model& model_;
  const PushExclusion& exclusion_;
  Waiting waiting_;
  const Losses losses_;
  Findings& findings_;
  std::set<dsl::Span> seen_; ///< conditions with a finding
};

} // namespace

void push_in_vain(const Input& input, Findings& findings) {
  const Model& model = input.model;
  look_at_steps(input, findings);
  for (const Clash& clash : input.conflicts.clashes()) {
    if (clash.kind != Clash::Kind::vain) continue;
    dsl::Diagnostic& finding = findings.add(clash.second.span, message_of(model, clash));
    add_parties(model, clash, finding);
    finding.help = help_of(model, clash);
  }
  KeptWhileRequested kept(input, findings);
  for (const Wanting& wanting : input.shared.wants()) kept.look_at(wanting);
  ExcludedCausers excluded(input, findings);
  for (const GroupId task : model.groups.ids()) {
    if (input.facts.requested.contains(task)) excluded.look_at(task);
  }
  report_stranded_pushes(input, findings);
}

} // namespace director::checks
