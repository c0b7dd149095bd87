// Header: compiler/analysis/clashes/lost_for_good.hpp. Test: compiler/checks/push_in_vain.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/clashes/lost_for_good.hpp"

#include "compiler/analysis/clashes/stopping.hpp"
#include "compiler/analysis/facts/waiting.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

using dsl::Note;

class LossSearch {
public:
  LossSearch(const Model& model, const Facts& facts, const Shared& shared)
      : model_(model),
        facts_(facts),
        shared_(shared),
        sources_(find_sources(model)),
        waiting_(model, facts) {}

  std::vector<LostForGood> run() {
    for (const GroupId task : model_.groups.ids()) {
      if (!facts_.requested.contains(task) || !waiting_.may_wait(task)) continue;
      for (const auto& [waiter, use] : waited_conditions(model_, facts_, task)) look_at(task, waiter, use);
    }
    choose();
    return std::move(out_);
  }

private:
  struct Found {
    GroupId task{};
    ProviderId waiter{};
    ConditionUse use{};
    ProviderId causer{};
    std::vector<ConditionId> lost; ///< by id
    Stopping stopping;
  };

  void look_at(GroupId task, ProviderId waiter, const ConditionUse& use) {
    const Promises& promises = shared_.promises();
    if (!facts_.capable.contains(waiter) || !waiting_.may_be_first(waiter) || promises.explained.contains(waiter) ||
        facts_.is_impossible(waiter, model_.conditions[use.id].state))
      return;
    const std::vector<ProviderId>& causers = shared_.causers()[use.id];
    const auto causer = std::find_if(causers.begin(), causers.end(), [&](ProviderId id) {
      return facts_.active.contains(id) && model_.providers[id].group != task;
    });
    if (causer == causers.end() || promises.explained.contains(*causer)) return;
    Stopping stopping(model_, facts_, sources_);
    if (!stopping.lose(use.id) || !stopping.cannot_run(task, true) || !is_credible(stopping)) return;
    std::vector<ConditionId> lost = stopping.lost();
    std::sort(lost.begin(), lost.end());
    found_.push_back({task, waiter, use, *causer, std::move(lost), std::move(stopping)});
  }

  /// Chooses, of those at one place, and of those that are lost with superfluous conditions, the smallest.
  void choose() {
    std::vector<const Found*> all, kept;
    for (const Found& each : found_) all.push_back(&each);
    std::stable_sort(all.begin(), all.end(),
                     [](const Found* a, const Found* b) { return a->lost.size() < b->lost.size(); });
    for (const Found* each : all) {
      const bool is_noted = std::any_of(kept.begin(), kept.end(), [&](const Found* one) {
        return one->use.span == each->use.span ||
               std::includes(each->lost.begin(), each->lost.end(), one->lost.begin(), one->lost.end());
      });
      if (!is_noted) kept.push_back(each);
    }
    std::sort(kept.begin(), kept.end()); // in the order of discovery
    for (const Found* each : kept) add(*each);
  }

  /// Whether something makes it false. The value at the start counts only for a state that belongs to a group, and that
  /// returns to it.
  bool is_spoilt_by(const Source& source, ConditionId id) const {
    if (source.values.subset_of(model_.conditions[id].accepts)) return false;
    if (source.provider)
      return facts_.active.contains(*source.provider) && !shared_.decisions().never_runs(model_, *source.provider);
    if (!source.group) return source.kind != Source::Kind::initial || model_.states[source.state].of.has_value();
    return model_.has_any(*source.group, facts_.active);
  }

  /// Whether each may be false. If there are several, one of them must be made false by something that runs whether or
  /// not they hold: otherwise the sources may ensure that the conditions are never lost together.
  bool is_credible(const Stopping& stopping) const {
    bool by_others = stopping.lost().size() == 1;
    for (const ConditionId id : stopping.lost()) {
      const State& state = model_.states[model_.conditions[id].state];
      bool spoilt = !state.initial || !model_.conditions[id].accepts.contains(*state.initial);
      for (const Source& source : sources_[model_.conditions[id].state]) {
        if (!is_spoilt_by(source, id)) continue;
        spoilt = true;
        by_others = by_others || !source.provider || !stopping.is_stopped(*source.provider);
      }
      if (!spoilt && !(state.expires && !state.expires->to)) return false;
    }
    return by_others;
  }

  void add(const Found& found) {
    const auto& [task, waiter, use, causer, lost, stopping] = found;
    LostForGood& out = out_.emplace_back(LostForGood{task, waiter, use, stopping.lost(), causer, {}, false, {}});
    if (const auto lacked = stopping.lacked_by(causer)) out.lacking = lacked->id;
    const std::vector<Use<GroupId>>& needs = model_.providers[causer].needs;
    out.unrequested = !out.lacking && std::none_of(needs.begin(), needs.end(), [&](const Use<GroupId>& need) {
      return !lacking_below(need.id, stopping).empty();
    });
    explained_now_.clear();
    noted_ = {{use.span, {}}, {promise_of(model_, causer, use.id).span, {}}};
    for (const ConditionId id : stopping.lost()) {
      for (const Source& source : sources_[model_.conditions[id].state]) {
        if (source.provider && source.values.overlaps(model_.conditions[id].accepts) &&
            facts_.active.contains(*source.provider))
          add_source(*source.provider, source, stopping, out.because);
      }
    }
    for (const ConditionId id : stopping.lost()) add_spoiler(id, stopping, out.because);
  }

  void add_note(Note note, std::vector<Note>& notes) {
    if (noted_.insert({note.span, note.message}).second && noted_.count({note.span, {}}) == 0)
      notes.push_back(std::move(note));
  }

  std::string sets(const Source& source, ProviderId id) const {
    const Provider& provider = model_.providers[id];
    for (const std::vector<ConditionUse>* uses : {&provider.causing, &provider.sets}) {
      for (const ConditionUse& use : *uses) {
        if (use.span != source.span) continue;
        return fmt::format("{} {} {}", name_of(model_, id), source.kind == Source::Kind::causing ? "causes" : "may set",
                           name_of(model_, use.id));
      }
    }
    return {};
  }

  /// Explains what the source could bring back, and why it cannot run then.
  void add_source(ProviderId id, const Source& source, const Stopping& stopping, std::vector<Note>& notes) {
    add_note({source.span, sets(source, id)}, notes);
    add_reason(id, stopping, notes);
  }

  void add_reason(ProviderId id, const Stopping& stopping, std::vector<Note>& notes) {
    if (!explained_now_.insert(id).second) return;
    if (const auto lacked = stopping.lacked_by(id)) {
      add_note(runs_only_while(model_, id, *lacked), notes);
      return;
    }
    const Provider& provider = model_.providers[id];
    for (const Use<GroupId>& need : provider.needs) {
      for (const auto& [below, lacked] : lacking_below(need.id, stopping)) {
        add_note({need.span, fmt::format("{} needs {}", name_of(model_, id), name_of(model_, need.id))}, notes);
        add_note(runs_only_while(model_, below, lacked), notes);
      }
    }
    for (const EdgeId edge : model_.groups[provider.group].requesters) {
      const std::optional<GroupId> requester = model_.edges[edge].requester;
      if (!requester || model_.edges[edge].levels.empty()) continue;
      for (const ProviderId by : model_.groups[*requester].providers) {
        if (facts_.active.contains(by)) add_request(by, provider.group, stopping, notes);
      }
    }
  }

  /// Needed providers that lack something.
  std::vector<std::pair<ProviderId, ConditionUse>> lacking_below(GroupId needed, const Stopping& stopping) const {
    std::vector<std::pair<ProviderId, ConditionUse>> out;
    for (const ProviderId id : model_.groups[needed].providers) {
      if (const auto lacked = stopping.lacked_by(id)) out.emplace_back(id, *lacked);
    }
    return out;
  }

  void add_request(ProviderId by, GroupId group, const Stopping& stopping, std::vector<Note>& notes) {
    const Task* const task = find_entry(model_, by, group).task;
    if (task == nullptr) return;
    add_note(requests(model_, by, *task), notes);
    add_reason(by, stopping, notes);
  }

  /// Explains the first source that makes it false, with preference for one that runs whether or not all this holds.
  void add_spoiler(ConditionId id, const Stopping& stopping, std::vector<Note>& notes) {
    const Source* first = nullptr;
    for (const Source& source : sources_[model_.conditions[id].state]) {
      if (!source.provider || !is_spoilt_by(source, id)) continue;
      if (first == nullptr || (stopping.is_stopped(*first->provider) && !stopping.is_stopped(*source.provider)))
        first = &source;
    }
    if (first != nullptr) add_note({first->span, sets(*first, *first->provider)}, notes);
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  IdTable<StateId, std::vector<Source>> sources_;
  Waiting waiting_;
  std::vector<Found> found_;
  std::set<std::pair<dsl::Span, std::string>> noted_; ///< without text: nothing more is reported there
  std::set<ProviderId> explained_now_;
  std::vector<LostForGood> out_;
};

} // namespace

std::vector<LostForGood> find_lost_for_good(const Model& model, const Facts& facts, const Shared& shared) {
  return LossSearch(model, facts, shared).run();
}

} // namespace director::analysis
