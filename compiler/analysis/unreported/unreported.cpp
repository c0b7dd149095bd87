// Header: compiler/analysis/unreported/unreported.hpp. Test: tests/compiler/analysis/unreported/unreported_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/unreported/unreported.hpp"

#include "compiler/analysis/states/sources.hpp"

#include <algorithm>

namespace director::analysis {

namespace {

using dsl::Diagnostic;

class UnreportedSearch {
public:
  UnreportedSearch(const Model& model, const Occurrences& occurrences, const std::vector<Diagnostic>& findings)
      : model_(model),
        occurrences_(occurrences),
        sources_(find_sources(model)) {
    out_.reported = IdSet<EdgeId>(model.edges.size());
    find_members();
    for (const Diagnostic& finding : findings) {
      reported_.insert(finding.rules_out.begin(), finding.rules_out.end());
      reported_in_packs_.insert(finding.rules_out_together.begin(), finding.rules_out_together.end());
    }
  }

  Unreported run() {
    if (occurrences_.whole != nullptr) find_packs();
    for (const GroupId group : model_.groups.ids()) look_at(group);
    return std::move(out_);
  }

private:
  void find_members() {
    for (const ProviderId id : model_.providers.ids()) {
      const std::vector<Pack>& packs = model_.providers[id].packs;
      for (std::size_t i = 0; i < packs.size(); ++i) {
        const std::vector<EdgeId> members = members_of(model_, id, i);
        std::vector<dsl::Span> spans;
        for (const Task& task : packs[i].tasks) {
          if (std::find(members.begin(), members.end(), task.edge) != members.end()) spans.push_back(task.span);
        }
        for (const dsl::Span span : spans) whole_only_.emplace(span, spans);
      }
    }
  }

  /// Packs without a reported member that are never granted whole.
  void find_packs() {
    for (const ProviderId id : model_.providers.ids()) {
      const std::vector<Pack>& packs = model_.providers[id].packs;
      for (std::size_t i = 0; occurrences_.runs.contains(id) && i < packs.size(); ++i) {
        const std::vector<EdgeId> members = members_of(model_, id, i);
        if (members.empty() || occurrences_.whole->count({id, i}) != 0) continue;
        if (std::any_of(packs[i].tasks.begin(), packs[i].tasks.end(), [&](const Task& task) {
              return is_reported(task.span) || reported_in_packs_.count(task.span) != 0;
            }))
          continue;
        // What prevents them may have a finding of its own.
        const auto blamed = occurrences_.to_blame.find({id, i});
        const bool has_blame = blamed != occurrences_.to_blame.end() && !occurrences_.granted.contains(blamed->second);
        if (!has_blame) out_.packs.emplace_back(id, i);
        for (const EdgeId member : members) {
          if (!has_blame || blamed->second != member) in_packs_.insert(member);
        }
      }
    }
  }

  void look_at(GroupId id) {
    const Group& group = model_.groups[id];
    const std::vector<ProviderId>& all = group.providers;
    const auto runs = [&](ProviderId each) { return occurrences_.runs.contains(each); };
    // A group that is never requested is explained by its requesters.
    std::vector<EdgeId> requested, refused;
    for (const EdgeId edge : group.requesters) {
      if (!occurrences_.requested.contains(edge)) continue;
      requested.push_back(edge);
      if (!occurrences_.granted.contains(edge)) refused.push_back(edge);
    }
    if (requested.empty()) return;
    if (std::none_of(all.begin(), all.end(), runs)) {
      const bool silent = is_reported(group.name.span) || all_refused_are_reported(requested) ||
                          std::all_of(all.begin(), all.end(), [&](ProviderId each) { return is_silent(each); });
      if (silent) return;
      out_.groups.push_back(id);
      for (const EdgeId edge : requested) {
        if (is_reported(edge)) out_.reported.add(edge);
      }
      return;
    }
    for (const EdgeId edge : refused) {
      if (!is_reported(edge)) out_.tasks.push_back(edge);
    }
    if (std::any_of(group.requesters.begin(), group.requesters.end(),
                    [&](EdgeId edge) { return waits_for_conflict(edge); }))
      return; // it may run for that one
    for (const ProviderId each : all) {
      if (!runs(each) && !is_silent(each)) out_.providers.push_back(each);
    }
  }

  /// Whether its requester never runs since each request for that is in a pack that a finding reports.
  bool waits_for_conflict(EdgeId edge) const {
    const std::optional<GroupId>& requester = model_.edges[edge].requester;
    if (!requester || model_.edges[edge].levels.empty() || occurrences_.requested.contains(edge)) return false;
    const std::vector<EdgeId>& above = model_.groups[*requester].requesters;
    bool asked = false;
    for (const EdgeId each : above) {
      if (!occurrences_.requested.contains(each)) continue;
      const std::vector<const Task*> entries = entries_of(model_, each);
      if (occurrences_.granted.contains(each) || std::none_of(entries.begin(), entries.end(), [&](const Task* task) {
            return reported_in_packs_.count(task->span) != 0;
          }))
        return false;
      asked = true;
    }
    return asked;
  }

  bool all_refused_are_reported(const std::vector<EdgeId>& requested) const {
    return std::all_of(requested.begin(), requested.end(), [&](EdgeId edge) { return is_reported(edge); });
  }

  bool is_reported(dsl::Span span) const { return reported_.count(span) != 0; }

  bool is_reported(EdgeId edge) const {
    const std::vector<const Task*> all = entries_of(model_, edge);
    return in_packs_.count(edge) != 0 ||
           std::any_of(all.begin(), all.end(), [&](const Task* task) { return is_reported(task->span); }) ||
           (!all.empty() && std::all_of(all.begin(), all.end(), [&](const Task* task) { return is_in_vain(*task); }));
  }

  /// Whether a finding reports that its pack, or one member of it, is never granted.
  bool is_in_vain(const Task& task) const {
    const auto members = whole_only_.find(task.span);
    if (members == whole_only_.end()) return false;
    return reported_in_packs_.count(task.span) != 0 || std::any_of(members->second.begin(), members->second.end(),
                                                                   [&](dsl::Span span) { return is_reported(span); });
  }

  /// Whether another finding is about it, or about all that could serve a need of it, or it waits for what only others
  /// that never run could cause.
  bool is_silent(ProviderId id) {
    const auto [at, is_new] = silent_.emplace(id, false); // the value while it is computed, in a cycle
    if (is_new) at->second = finds_silent(id);
    return at->second;
  }
  bool finds_silent(ProviderId id) {
    if (occurrences_.runs.contains(id)) return false;
    const Provider& provider = model_.providers[id];
    const auto any_reported = [&](const std::vector<ConditionUse>& uses) {
      return std::any_of(uses.begin(), uses.end(), [&](const ConditionUse& use) { return is_reported(use.span); });
    };
    const auto none_left = [&](const Use<GroupId>& use) {
      const Group& group = model_.groups[use.id];
      const std::vector<ProviderId>& all = group.providers;
      return is_reported(use.span) || is_reported(group.name.span) ||
             std::all_of(all.begin(), all.end(), [&](ProviderId each) { return is_silent(each); });
    };
    return is_reported(provider.span) || any_reported(provider.when) || any_reported(provider.causing) ||
           std::any_of(provider.when.begin(), provider.when.end(),
                       [&](const ConditionUse& use) { return never_came(use.id); }) ||
           std::any_of(provider.needs.begin(), provider.needs.end(), none_left);
  }

  bool never_came(ConditionId id) const {
    const Condition& condition = model_.conditions[id];
    const std::vector<Source>& sources = sources_[condition.state];
    return std::none_of(sources.begin(), sources.end(), [&](const Source& source) {
      return source.values.overlaps(condition.accepts) && acts(model_, source, occurrences_.runs);
    });
  }

  const Model& model_;
  const Occurrences& occurrences_;
  IdTable<StateId, std::vector<Source>> sources_;
  std::set<dsl::Span> reported_;
  std::set<dsl::Span> reported_in_packs_; ///< entries that are never granted together
  /// Entries that are granted only together with others, and all of these.
  std::map<dsl::Span, std::vector<dsl::Span>> whole_only_;
  std::set<EdgeId> in_packs_; ///< members of packs that are never granted whole
  std::map<ProviderId, bool> silent_;
  Unreported out_;
};

} // namespace

std::vector<EdgeId> members_of(const Model& model, ProviderId provider, std::size_t pack) {
  std::vector<EdgeId> out;
  if (!model.providers[provider].has_packs) return out;
  for (const Task& task : model.providers[provider].packs[pack].tasks) {
    if (model.is_usually_member(task)) out.push_back(task.edge);
  }
  if (out.size() < 2) out.clear();
  return out;
}

std::vector<const Task*> entries_of(const Model& model, EdgeId edge) {
  std::vector<const Task*> out;
  const auto look = [&](const std::vector<Task>& tasks) {
    for (const Task& task : tasks) {
      if (task.edge == edge) out.push_back(&task);
    }
  };
  const std::optional<GroupId>& requester = model.edges[edge].requester;
  if (!requester) {
    look(model.roots);
    return out;
  }
  for (const ProviderId id : model.groups[*requester].providers) {
    for (const Pack& pack : model.providers[id].packs) look(pack.tasks);
  }
  return out;
}

Unreported find_unreported(const Model& model, const Occurrences& occurrences,
                           const std::vector<Diagnostic>& findings) {
  return UnreportedSearch(model, occurrences, findings).run();
}

} // namespace director::analysis
