// Door: compiler/explore/never_runs.hpp. Test: compiler/checks/never_runs.md.
// SPDX-License-Identifier: MIT
//
// A provider that never ran has a finding of its own unless another finding speaks of it, or it could not have run
// without something else that never ran either: a requester of its group, or whoever sets what it waits for. Where no
// provider of a requested group ever ran, the group has the finding.
#include "compiler/explore/never_runs.hpp"

#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/explore/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace director::compiler {

namespace {

using analysis::name_of;
using analysis::Source;
using dsl::Diagnostic;

/// These say that something never happens, of what they stand at and of what their notes stand at.
bool says_never(const Diagnostic& finding) {
  static constexpr std::string_view ids[] = {"causer_not_running",   "contradictory_when", "imprecise_causing",
                                             "incompatible_pushes",  "needs_conflict",     "needs_cycle",
                                             "optional_never_runs",  "pack_conflict",      "push_cycle",
                                             "push_in_vain",         "self_conflict",      "self_defeating_handler",
                                             "shadowed_provider",    "sibling_starvation", "starved_task",
                                             "state_without_source", "task_cycle",         "unpushable_causing",
                                             "unreachable_causing",  "unreachable_when",   "unused_declaration"};
  return std::find(std::begin(ids), std::end(ids), finding.id) != std::end(ids) ||
         (finding.id == "possible_pack_conflict" && finding.message.find("can never") != std::string::npos) ||
         (finding.id == "uncovered_state" && finding.message.find("can ever run") != std::string::npos);
}

class Silences {
public:
  Silences(const Model& model, const Happened& happened, const std::vector<Diagnostic>& told)
      : model_(model),
        happened_(happened),
        sources_(analysis::find_sources(model)) {
    for (const Diagnostic& finding : told) {
      if (!says_never(finding)) continue;
      told_.insert(finding.span);
      for (const dsl::Note& note : finding.notes) told_.insert(note.span);
    }
  }

  std::vector<Diagnostic> run() {
    for (const GroupId group : model_.groups.ids()) look_at(group);
    return std::move(out_);
  }

private:
  void look_at(GroupId id) {
    const Group& group = model_.groups[id];
    const std::vector<ProviderId>& all = group.providers;
    const auto ran = [&](ProviderId each) { return happened_.ran[each.value]; };
    // What nobody ever asks for hangs on whoever would.
    std::vector<EdgeId> requested, refused;
    for (const EdgeId edge : group.requesters) {
      if (happened_.requested[edge.value]) requested.push_back(edge);
      if (happened_.requested[edge.value] && !happened_.granted[edge.value]) refused.push_back(edge);
    }
    if (requested.empty()) return;
    if (std::none_of(all.begin(), all.end(), ran)) {
      const bool silent = is_told(group.name.span) || all_refused_are_told(requested) ||
                          std::all_of(all.begin(), all.end(), [&](ProviderId each) { return is_silent(each); });
      if (!silent) report(id, group.name.span, fmt::format("{} never runs", name_of(model_, id)), requested);
      return;
    }
    for (const EdgeId edge : refused) {
      if (!is_told(edge)) report(edge);
    }
    for (const ProviderId each : all) {
      if (!ran(each) && !is_silent(each))
        report(id, model_.providers[each].span, fmt::format("{} never runs", name_of(model_, each)), requested);
    }
  }

  bool all_refused_are_told(const std::vector<EdgeId>& requested) const {
    return std::all_of(requested.begin(), requested.end(), [&](EdgeId edge) { return is_told(edge); });
  }

  bool is_told(dsl::Span span) const { return told_.count(span) != 0; }

  bool is_told(EdgeId edge) const {
    const std::vector<const Task*> all = entries(edge);
    return std::any_of(all.begin(), all.end(), [&](const Task* task) { return is_told(task->span); });
  }

  /// Another finding speaks of it, or it waits for what only others that never ran could bring about.
  bool is_silent(ProviderId id) const {
    const Provider& provider = model_.providers[id];
    const auto any_told = [&](const std::vector<ConditionUse>& uses) {
      return std::any_of(uses.begin(), uses.end(), [&](const ConditionUse& use) { return is_told(use.span); });
    };
    return is_told(provider.span) || any_told(provider.when) || any_told(provider.causing) ||
           std::any_of(provider.needs.begin(), provider.needs.end(),
                       [&](const auto& need) { return is_told(need.span); }) ||
           std::any_of(provider.when.begin(), provider.when.end(),
                       [&](const ConditionUse& use) { return never_came(use.id); });
  }

  bool never_came(ConditionId id) const {
    const Condition& condition = model_.conditions[id];
    const std::vector<Source>& sources = sources_[condition.state];
    return std::none_of(sources.begin(), sources.end(), [&](const Source& source) {
      return !source.values.intersected(condition.accepts).empty() && acted(source);
    });
  }

  bool acted(const Source& source) const {
    if (source.provider) return happened_.ran[source.provider->value];
    if (!source.group) return true;
    const std::vector<ProviderId>& all = model_.groups[*source.group].providers;
    return std::any_of(all.begin(), all.end(), [&](ProviderId each) { return happened_.ran[each.value]; });
  }

  std::vector<const Task*> entries(EdgeId edge) const {
    std::vector<const Task*> out;
    const auto look = [&](const std::vector<Task>& tasks) {
      for (const Task& task : tasks) {
        if (task.edge == edge) out.push_back(&task);
      }
    };
    if (!model_.edges[edge].requester) look(model_.roots);
    if (!model_.edges[edge].requester) return out;
    for (const ProviderId id : model_.groups[*model_.edges[edge].requester].providers) {
      for (const Pack& pack : model_.providers[id].packs) look(pack.tasks);
    }
    return out;
  }

  Diagnostic& add(dsl::Span span, std::string message) {
    out_.push_back({"never_runs", dsl::Level::lint, span, std::move(message), {}, {}});
    out_.back().message += ", whatever happens";
    return out_.back();
  }

  void report(GroupId id, dsl::Span span, std::string message, const std::vector<EdgeId>& requested) {
    Diagnostic& finding = add(span, std::move(message));
    for (const EdgeId edge : requested) {
      const std::vector<const Task*> all = entries(edge);
      if (!all.empty())
        finding.notes.push_back({all.front()->span, fmt::format("{} is requested here", name_of(model_, id))});
    }
    finding.help = help(id);
  }

  void report(EdgeId edge) {
    const Edge& row = model_.edges[edge];
    const std::vector<const Task*> all = entries(edge);
    const std::string name = name_of(model_, row.target);
    Diagnostic& finding = add(
        all.front()->span, fmt::format("{} never runs for {}", name,
                                       row.requester ? name_of(model_, *row.requester) : std::string("the program")));
    for (std::size_t i = 1; i < all.size(); ++i)
      finding.notes.push_back({all[i]->span, fmt::format("{} is requested here too", name)});
    finding.help = help(row.target);
  }

  std::string help(GroupId id) const {
    return fmt::format("`directorc why SCENARIO {}` tells what keeps it from running, in a scenario that requests it",
                       model_.groups[id].name.value);
  }

  const Model& model_;
  const Happened& happened_;
  IdTable<StateId, std::vector<Source>> sources_;
  std::set<dsl::Span> told_;
  std::vector<Diagnostic> out_;
};

} // namespace

NeverRuns find_never_runs(const Model& model, std::size_t bound, const std::vector<Diagnostic>& told,
                          std::function<void(const SearchProgress& so_far)> progress) {
  const Ground ground(model);
  SearchOptions how;
  how.bound = bound;
  how.progress = std::move(progress);
  const Searched searched = search(ground, how);
  NeverRuns out{{}, searched.complete, searched.states};
  if (out.complete) out.findings = Silences(model, searched.happened, told).run();
  return out;
}

} // namespace director::compiler
