// Header: compiler/checks/check.hpp. Test: compiler/checks/undone_by_stop.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/takings.hpp"
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <set>

namespace director::checks {

namespace {

/// The value that the stop of a group gives a state, and where it is declared.
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
      const GroupId group = model_.providers[causer].group;
      look_at_stop(wanting, want, causer, group, state, nullptr);
      for (const Pack& pack : model_.providers[causer].packs) {
        for (const Task& task : pack.tasks) {
          for (const GroupId below : shared_.claims(task.target).groups()) {
            if (below != group) look_at_stop(wanting, want, causer, below, state, &task);
          }
        }
      }
    }
  }

private:
  /// `task`: of the causing provider, which leads to the group that stops; null: that is the causing group itself.
  void look_at_stop(const Wanting& wanting, const Want& want, ProviderId causer, GroupId stopped, StateId state,
                    const Task* task) {
    for (const StopValue& stop : stop_values(stopped, state)) {
      const ValueSet values = undoing_values(model_, want.waiter, want.condition.id, stop.values);
      if (values.empty() || seen_.count({stop.span, want.condition.span}) != 0) continue;
      Taking how = why_stopped(wanting.task, stopped, causer);
      if (how.notes.empty()) continue;
      if (task != nullptr) {
        std::vector<ChainStep> chain = shared_.claims(task->target).path(stopped);
        chain.insert(chain.begin(), {model_.providers[causer].group, task->target, false, task->span});
        std::vector<dsl::Note> notes;
        add_chain(model_, chain, notes);
        how.notes.insert(how.notes.begin(), notes.begin(), notes.end());
      }
      report(wanting, want, causer, stop, values, std::move(how));
    }
  }

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
    // The handler's own value takes precedence, but it may not declare one.
    if (row.of && row.of->id == id)
      out.push_back({ValueSet::single(*row.initial), row.of->span,
                     fmt::format("{} is {} again when {} stops", name_of(model_, state), row.value_text(*row.initial),
                                 name_of(model_, id))});
    return out;
  }

  /// How the task takes what each provider of the group needs, told of the causer or the first one; empty: the group
  /// continues, or is handed over.
  Taking why_stopped(GroupId task, GroupId group, ProviderId causer) const {
    const Takings takings(model_, shared_.indispensable(), shared_.claims(task), task);
    if (takings.takes(group)) return {};
    const bool causes = model_.providers[causer].group == group;
    Taking out;
    for (const ProviderId id : model_.groups[group].providers) {
      if (id != causer && !facts_.active.contains(id)) continue;
      const Use<GroupId>* need = takings.need_taken(id);
      if (need == nullptr) return {};
      if (causes ? id != causer : !out.notes.empty()) continue;
      out = takings.way_to(*need);
      out.notes.insert(out.notes.begin(),
                       {need->span, fmt::format("{} needs {}", name_of(model_, id), name_of(model_, need->id))});
    }
    return out;
  }

  void report(const Wanting& wanting, const Want& want, ProviderId causer, const StopValue& stop,
              const ValueSet& values, Taking how) {
    seen_.insert({stop.span, want.condition.span});
    dsl::Diagnostic& finding = findings_.add(
        stop.span, fmt::format("{}, and it is stopped when {} is granted, which waits for {}: the two go "
                               "round",
                               stop.what, name_of(model_, wanting.task), name_of(model_, want.condition.id)));
    add_taking(model_, want, causer, std::move(how), finding);
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
