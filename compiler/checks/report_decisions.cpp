// Header: compiler/checks/report_decisions.hpp. Test: tests/compiler/checks/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/checks/report_decisions.hpp"

#include "compiler/analysis/decisions/decisions.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/unreported/unreported.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/proposals.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace director::checks {

namespace {

/// Of components that were not decided all may happen.
Occurrences occurrences_of(const Model& model, const Decisions& decisions) {
  Occurrences out{decisions.runs, decisions.requested, decisions.granted, &decisions.whole, {}};
  for (const ProviderId id : model.providers.ids()) {
    if (!decisions.decided.contains(model.providers[id].group)) out.runs.add(id);
  }
  for (const EdgeId id : model.edges.ids()) {
    if (decisions.decided.contains(model.edges[id].target)) continue;
    out.requested.add(id);
    out.granted.add(id);
  }
  for (const ProviderId id : model.providers.ids()) {
    for (std::size_t i = 0; i < model.providers[id].packs.size(); ++i) {
      std::set<EdgeId> keep;
      const std::vector<EdgeId> members = members_of(model, id, i);
      for (const EdgeId member : members) {
        for (const EdgeId other : decisions.refused[member].together) {
          if (std::find(members.begin(), members.end(), other) != members.end()) keep.insert(other);
        }
      }
      if (keep.size() == 1) out.to_blame.emplace(PackOf{id, i}, *keep.begin());
    }
  }
  return out;
}

class Reporter {
public:
  Reporter(const Input& input, const Decisions& decisions)
      : input_(input),
        model_(input.model),
        decisions_(decisions) {}

  std::vector<dsl::Diagnostic> run(const Unreported& unreported) {
    for (const PackOf& pack : unreported.packs) report(pack);
    for (const GroupId group : unreported.groups) report(group, unreported.reported);
    for (const EdgeId edge : unreported.tasks) report(edge);
    for (const ProviderId id : unreported.providers) report(id);
    return std::move(out_);
  }

private:
  dsl::Diagnostic& add(std::string_view id, dsl::Span span, std::string message) {
    const dsl::Level level = level_of(*find_registered(id));
    out_.push_back({std::string(id), level, span, std::move(message), {}, {}});
    return out_.back();
  }

  bool decided(GroupId group) const { return decisions_.decided.contains(group); }

  bool may_run(GroupId group) const { return model_.has_any(group, input_.facts.active); }

  std::string requester_of(EdgeId edge) const {
    const auto& requester = model_.edges[edge].requester;
    return requester ? name_of(model_, *requester) : "the program";
  }

  /// Reports that none of the group's providers ever runs.
  void report(GroupId id, const IdSet<EdgeId>& reported) {
    bool granted = false;
    for (const EdgeId edge : model_.groups[id].requesters) {
      if (!decisions_.requested.contains(edge)) continue;
      if (decisions_.granted.contains(edge))
        granted = true;
      else if (!reported.contains(edge))
        report(edge);
    }
    if (!granted || !decided(id)) return;
    for (const ProviderId provider : model_.groups[id].providers) report(provider);
  }

  /// Whether a handler declares that it may set the state.
  bool is_set_by_handler(StateId state) const {
    return std::any_of(model_.groups.begin(), model_.groups.end(), [&](const Group& group) {
      for (const auto* handler : {&group.start, &group.stop}) {
        if (!*handler) continue;
        for (const ConditionUse& entry : (*handler)->sets) {
          if (model_.conditions[entry.id].state == state) return true;
        }
      }
      return false;
    });
  }

  /// Reports a provider that was chosen, and lost control again before each run.
  void report_undone(ProviderId id, const std::vector<StateId>& states) {
    const bool handlers = std::any_of(states.begin(), states.end(), [&](StateId at) { return is_set_by_handler(at); });
    std::vector<dsl::Note> notes;
    std::vector<std::string> groups; // that would have to go on
    bool waits_itself = true;        // false: a `stay` of its own would not help what it needs
    for (const StateId at : states) {
      const std::vector<ConditionUse>& when = model_.providers[id].when;
      waits_itself = waits_itself && std::any_of(when.begin(), when.end(), [&](const ConditionUse& use) {
                       return model_.conditions[use.id].state == at;
                     });
      const State& state = model_.states[at];
      if (!state.of) continue;
      groups.push_back(name_of(model_, state.of->id));
      notes.push_back({state.of->span, fmt::format("{} is {} again when {} stops", name_of(model_, at),
                                                   state.value_text(*state.initial), name_of(model_, state.of->id))});
    }
    std::vector<std::string> causes;
    if (handlers) causes.emplace_back("what a handler sets");
    if (!notes.empty()) causes.emplace_back("a state that returns to its initial value");
    const std::string name = name_of(model_, id);
    dsl::Diagnostic& finding = add("shadowed_provider", model_.providers[id].span,
                                   fmt::format("{} never runs: wherever it is granted, {} takes that away before it "
                                               "runs",
                                               name, list_of(causes, "or")));
    finding.rules_out = {model_.providers[id].span};
    finding.notes = std::move(notes);
    finding.help = handlers ? "let `start` or `stop` set what leaves its conditions true, or give it a `stay`"
                   : waits_itself || groups.empty()
                       ? fmt::format("give {} a `stay` under which it can continue", name)
                       : fmt::format("let something that goes on request {}", list_of(groups));
  }

  void report(ProviderId id) {
    const Provider& provider = model_.providers[id];
    if (!decided(provider.group) || !input_.facts.active.contains(id)) return;
    const std::vector<StateId>& undoing = decisions_.set_before_run[id];
    if (!undoing.empty()) return report_undone(id, undoing);
    const Hindrance& hindrance = decisions_.passed_over[id];
    const std::string name = name_of(model_, id), group = name_of(model_, provider.group);
    std::vector<std::string> reasons;
    if (!hindrance.first.empty()) reasons.push_back("another provider comes first");
    if (!hindrance.lacking.empty()) reasons.push_back("a condition does not hold");
    if (!hindrance.taken.empty()) reasons.push_back("what it needs is held");
    dsl::Diagnostic& finding =
        add("shadowed_provider", provider.span,
            reasons.empty()
                ? fmt::format("{} never runs: no decision about {} ever comes to it", name, group)
                : fmt::format("{} never runs: whenever {} is requested, {}", name, group, list_of(reasons, "or")));
    finding.rules_out = {provider.span};
    for (const ProviderId first : hindrance.first)
      finding.notes.push_back({model_.providers[first].span, fmt::format("{} comes first", name_of(model_, first))});
    add_notes(hindrance, provider.span, {id}, finding);
    propose_or_leave_out(model_, input_.facts, id,
                         hindrance.first.empty() ? fmt::format("request {} where it can have what it lacks", group)
                                                 : fmt::format("let the others leave {} something", name),
                         finding);
  }

  void report(EdgeId id) {
    const Edge& edge = model_.edges[id];
    const std::vector<const Task*> entries = entries_of(model_, id);
    if (entries.empty() || !decided(edge.target) || !may_run(edge.target)) return;
    const Hindrance& hindrance = decisions_.refused[id];
    const bool optional = edge.levels[entries.front()->levels.front().level].optional;
    const std::string name = name_of(model_, edge.target);
    std::vector<std::string> reasons;
    if (!hindrance.taken.empty()) reasons.push_back("what it takes is held");
    if (!hindrance.lacking.empty()) reasons.push_back("a condition does not hold");
    if (!hindrance.together.empty()) reasons.push_back("what is granted only together with it cannot be");
    dsl::Diagnostic& finding = add(
        optional ? "optional_never_runs" : "starved_task", entries.front()->span,
        reasons.empty() ? fmt::format("{0} never runs for {1}: whenever it is requested, {1} has lost control again",
                                      name, requester_of(id))
                        : fmt::format("{} never runs for {}: whenever it is requested, {}", name, requester_of(id),
                                      list_of(reasons, "or")));
    for (const Task* entry : entries) finding.rules_out.push_back(entry->span);
    add_together(hindrance, finding);
    add_notes(hindrance, entries.front()->span, model_.groups[edge.target].providers, finding);
    for (std::size_t i = 1; i < entries.size(); ++i)
      finding.notes.push_back({entries[i]->span, fmt::format("{} is requested here too", name)});
    finding.help = reasons.empty() ? fmt::format("let {} keep control, or leave {} out", requester_of(id), name)
                                   : fmt::format("request {} where it can have that, or leave it out", name);
  }

  void report(const PackOf& at) {
    if (!decided(model_.providers[at.first].group) || !input_.facts.active.contains(at.first)) return;
    const Pack& pack = model_.providers[at.first].packs[at.second];
    const std::vector<EdgeId> members = members_of(model_, at.first, at.second);
    std::vector<std::string> names;
    std::vector<ProviderId> providers;
    Hindrance hindrance;
    const auto join = [](auto& all, const auto& more) {
      for (const auto& each : more) {
        if (std::find(all.begin(), all.end(), each) == all.end()) all.push_back(each);
      }
    };
    for (const EdgeId member : members) {
      const GroupId target = model_.edges[member].target;
      if (!may_run(target)) return;
      names.push_back(name_of(model_, target));
      join(providers, model_.groups[target].providers);
      join(hindrance.lacking, decisions_.refused[member].lacking);
      join(hindrance.taken, decisions_.refused[member].taken);
      join(hindrance.holders, decisions_.refused[member].holders);
    }
    std::vector<std::string> reasons;
    if (!hindrance.taken.empty()) reasons.push_back("what one of them takes is held");
    if (!hindrance.lacking.empty()) reasons.push_back("a condition does not hold");
    const Task* last = nullptr;
    for (const Task& task : pack.tasks) {
      if (std::find(members.begin(), members.end(), task.edge) != members.end()) last = &task;
    }
    std::string message = fmt::format("{} can never be granted together", few_of(names));
    if (!reasons.empty()) message += fmt::format(": whenever they are requested, {}", list_of(reasons, "or"));
    dsl::Diagnostic& finding = add("possible_pack_conflict", last->span, std::move(message));
    for (const Task& task : pack.tasks) {
      if (std::find(members.begin(), members.end(), task.edge) != members.end())
        finding.rules_out_together.push_back(task.span);
    }
    add_notes(hindrance, last->span, providers, finding);
    finding.help = "make one of them `apart` or `optional`, or request them in different packs";
  }

  void add_together(const Hindrance& hindrance, dsl::Diagnostic& finding) const {
    for (const EdgeId other : hindrance.together) {
      const std::vector<const Task*> entries = entries_of(model_, other);
      if (!entries.empty())
        finding.notes.push_back({entries.front()->span, fmt::format("{} is granted only together with it",
                                                                    name_of(model_, model_.edges[other].target))});
    }
  }

  /// Adds a note for what is held, at the need for it, and for what does not hold, at the condition. `begin`: their
  /// possible owners.
  void add_notes(const Hindrance& hindrance, dsl::Span otherwise, const std::vector<ProviderId>& begin,
                 dsl::Diagnostic& finding) const {
    const std::vector<ProviderId> all = with_needs(begin);
    for (const GroupId group : hindrance.taken) {
      dsl::Span span = otherwise;
      for (const ProviderId id : all) {
        for (const Use<GroupId>& need : model_.providers[id].needs) {
          if (need.id == group && span == otherwise) span = need.span;
        }
      }
      std::vector<std::string> holders;
      for (const EdgeId holder : hindrance.holders) {
        if (model_.edges[holder].target == group) holders.push_back(requester_of(holder));
      }
      finding.notes.push_back({span, holders.empty() ? fmt::format("{} is held then", name_of(model_, group))
                                                     : fmt::format("{} is held then, for {}", name_of(model_, group),
                                                                   few_of(holders, "or"))});
    }
    for (const ConditionId condition : hindrance.lacking) {
      for (const ProviderId id : all) {
        const std::vector<ConditionUse>& when = model_.providers[id].when;
        const auto use =
            std::find_if(when.begin(), when.end(), [&](const ConditionUse& each) { return each.id == condition; });
        if (use == when.end()) continue;
        finding.notes.push_back({use->span, fmt::format("{} does not hold then", name_of(model_, condition))});
        break;
      }
    }
    shorten_list(finding.notes);
  }

  /// Adds the providers that their needs may lead to.
  std::vector<ProviderId> with_needs(std::vector<ProviderId> all) const {
    std::set<ProviderId> seen(all.begin(), all.end());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::vector<Use<GroupId>> needs = model_.providers[all[i]].needs;
      for (const Use<GroupId>& need : needs) {
        for (const ProviderId below : model_.groups[need.id].providers) {
          if (seen.insert(below).second) all.push_back(below);
        }
      }
    }
    return all;
  }

  const Input& input_;
  const Model& model_;
  const Decisions& decisions_;
  std::vector<dsl::Diagnostic> out_;
};

} // namespace

std::vector<dsl::Diagnostic> report_decisions(const Input& input, const std::vector<dsl::Diagnostic>& findings) {
  const Decisions& decisions = input.shared.decisions();
  return Reporter(input, decisions).run(find_unreported(input.model, occurrences_of(input.model, decisions), findings));
}

} // namespace director::checks
