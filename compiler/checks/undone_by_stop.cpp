// Header: compiler/checks/check.hpp. Test: compiler/checks/undone_by_stop.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace director::checks {

namespace {

/// What the stop of a group gives a state, and where that is written.
struct StopValue {
  ValueSet values;
  dsl::Span span{};
  std::string what;
};

class UndoneByStop {
public:
  UndoneByStop(const Input& input, Findings& findings)
      : model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        findings_(findings) {}

  void look_at(const Wanting& wanting, const Want& want) {
    for (const ProviderId causer : want.causers) {
      const StateId state = model_.conditions[want.condition.id].state;
      for (const StopValue& stop : stop_values(model_.providers[causer].group, state)) {
        const ValueSet values = undoing_values(model_, want.waiter, want.condition.id, stop.values);
        if (values.empty() || seen_.count({stop.span, want.condition.span}) != 0) continue;
        Stopped how = why_stopped(wanting.task, causer);
        if (!how.notes.empty()) report(wanting, want, causer, stop, values, std::move(how));
      }
    }
  }

private:
  std::vector<StopValue> stop_values(GroupId id, StateId state) const {
    const Group& group = model_.groups[id];
    const State& row = model_.states[state];
    std::vector<StopValue> out;
    if (group.stop) {
      for (const ConditionUse& entry : group.stop->sets) {
        if (model_.conditions[entry.id].state != state) continue;
        out.push_back({model_.conditions[entry.id].accepts, entry.span,
                       fmt::format("the stop of {} may set {}", name_of(model_, id), name_of(model_, entry.id))});
      }
    }
    // The handler's own word wins, but it need not say one.
    if (row.of && row.of->id == id)
      out.push_back({ValueSet::single(*row.initial), row.of->span,
                     fmt::format("{} is {} again when {} stops", name_of(model_, state), row.value_text(*row.initial),
                                 name_of(model_, id))});
    return out;
  }

  /// How it comes to that, and the requests below the task on the way: what they ask for goes with the task.
  struct Stopped {
    std::vector<dsl::Note> notes{};
    std::vector<dsl::Span> requests{};
  };

  /// How the task takes what each provider of the causing group needs; nothing: it goes on, or changes hands.
  Stopped why_stopped(GroupId task, ProviderId causer) const {
    const Claims& claims = shared_.claims(task);
    const auto takes = [&](GroupId group) {
      return std::binary_search(claims.groups().begin(), claims.groups().end(), group);
    };
    const GroupId group = model_.providers[causer].group;
    if (takes(group)) return {};
    Stopped out;
    for (const ProviderId id : model_.groups[group].providers) {
      if (id != causer && !facts_.active.contains(id)) continue;
      const dsl::Span need = need_taken(id, takes);
      if (need == dsl::Span{}) return {};
      if (id == causer) out = notes_for(task, causer, claims, takes);
    }
    return out;
  }

  template <class Takes>
  dsl::Span need_taken(ProviderId id, const Takes& takes) const {
    for (const Use<GroupId>& need : model_.providers[id].needs) {
      if (takes_part(need.id, takes)) return need.span;
    }
    return {};
  }

  template <class Takes>
  std::optional<GroupId> takes_part(GroupId needed, const Takes& takes) const {
    if (takes(needed)) return needed;
    const auto& parts = shared_.indispensable().of(needed);
    if (!parts) return std::nullopt;
    const auto at = std::find_if(parts->begin(), parts->end(), takes);
    if (at == parts->end()) return std::nullopt;
    return *at;
  }

  template <class Takes>
  Stopped notes_for(GroupId task, ProviderId causer, const Claims& claims, const Takes& takes) const {
    Stopped out;
    for (const Use<GroupId>& need : model_.providers[causer].needs) {
      const std::optional<GroupId> taken = takes_part(need.id, takes);
      if (!taken) continue;
      out.notes.push_back({need.span, fmt::format("{} needs {}", name_of(model_, causer), name_of(model_, need.id))});
      if (*taken == task) {
        out.notes.push_back({model_.groups[task].name.span, fmt::format("{} is taken", name_of(model_, task))});
        return out;
      }
      for (const Reach reach : all_reaches) {
        if (claims.find(*taken, reach) == nullptr) continue;
        const std::vector<ChainStep> path = claims.path(*taken, reach);
        add_chain(model_, path, out.notes);
        for (const ChainStep& step : path) {
          if (!step.by_need) out.requests.push_back(step.span);
        }
        return out;
      }
    }
    return out;
  }

  void report(const Wanting& wanting, const Want& want, ProviderId causer, const StopValue& stop,
              const ValueSet& values, Stopped how) {
    seen_.insert({stop.span, want.condition.span});
    dsl::Diagnostic& finding = findings_.add(
        stop.span, fmt::format("{}, and it is stopped when {} is granted, which waits for {}: the two go "
                               "round",
                               stop.what, name_of(model_, wanting.task), name_of(model_, want.condition.id)));
    finding.rules_out = std::move(how.requests);
    finding.rules_out.push_back(want.condition.span);
    finding.notes.push_back(runs_only_while(model_, want.waiter, want.condition));
    finding.notes.push_back(causes(model_, causer, want.condition.id));
    for (dsl::Note& note : how.notes) finding.notes.push_back(std::move(note));
    finding.help = stay_help(model_, want, values);
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  Findings& findings_;
  std::set<std::pair<dsl::Span, dsl::Span>> seen_;
};

} // namespace

void undone_by_stop(const Input& input, Findings& findings) {
  UndoneByStop undone(input, findings);
  for (const Wanting& wanting : input.shared.wants()) {
    for (const Want& want : wanting.wants) undone.look_at(wanting, want);
  }
}

} // namespace director::checks
