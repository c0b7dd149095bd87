// Header: compiler/checks/check.hpp. Test: compiler/checks/undone_in_turn.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/takings.hpp"
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/conflicts/takers.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace director::checks {

namespace {

/// A task whose provider waits for a condition by itself, and a state that the provider sets, its start, or what it
/// pushes.
struct Undoer {
  GroupId task{};
  const Want* want = nullptr;
  const ConditionUse* entry = nullptr;
  std::optional<ProviderId> pushed; ///< this one sets it
  bool promised = false;            ///< ... by causing it
  bool at_start = false;            ///< the start of the task sets it
};

/// Pairs of tasks are considered up to this many, of at most so many undoers.
constexpr std::size_t most_pairs = 10'000, most_undoers = 200'000;

class UndoneInTurn {
public:
  UndoneInTurn(const Input& input, Findings& findings)
      : model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        findings_(findings) {}

  void run() {
    for (const Wanting& wanting : shared_.wants()) {
      for (const Want& want : wanting.wants) {
        if (want.waiter != wanting.provider) continue;
        add(wanting.task, want);
      }
    }
    for (const auto& [states, all] : undoers_) {
      const auto others = undoers_.find({states.second, states.first});
      if (others == undoers_.end()) continue;
      for (const auto& [conditions, alike] : all) look_at(conditions, alike, others->second);
    }
  }

private:
  /// By the condition that it waits for, and what it sets.
  using Undoers = std::map<std::pair<ConditionId, ConditionId>, std::vector<Undoer>>;

  void add(GroupId task, const Want& want) {
    for (const ConditionUse& entry : model_.providers[want.waiter].sets) add({task, &want, &entry, {}});
    if (const std::optional<Handler>& start = model_.groups[task].start) {
      for (const ConditionUse& entry : start->sets) add({task, &want, &entry, {}, false, true});
    }
    std::set<ConditionId> known; // of several that set the same the first is enough
    for (const ProviderId causer : want.causers) {
      const Provider& row = model_.providers[causer];
      for (const auto* entries : {&row.sets, &row.causing}) {
        for (const ConditionUse& entry : *entries) {
          if (known.insert(entry.id).second) add({task, &want, &entry, causer, entries == &row.causing});
        }
      }
    }
  }

  void add(const Undoer& one) {
    if (undoers_count_ == most_undoers) return leave_open(one.entry->span, name_of(model_, one.want->waiter));
    ++undoers_count_;
    undoers_[{state_of(one.want->condition), state_of(*one.entry)}][{one.want->condition.id, one.entry->id}].push_back(
        one);
  }

  StateId state_of(const ConditionUse& use) const { return model_.conditions[use.id].state; }

  void look_at(const std::pair<ConditionId, ConditionId>& conditions, const std::vector<Undoer>& alike,
               const Undoers& all) {
    std::vector<const std::vector<Undoer>*> others; // only with these it may be so
    for (const auto& [their, each] : all) {
      if (!model_.satisfies(conditions.second, their.first) && !model_.satisfies(their.second, conditions.first))
        others.push_back(&each);
    }
    for (const Undoer& one : alike) look_at(one, others);
  }

  /// Reports the first one with which it goes round.
  void look_at(const Undoer& one, const std::vector<const std::vector<Undoer>*>& others) {
    for (const std::vector<Undoer>* alike : others) {
      for (const Undoer& other : *alike) {
        if (!(one.task < other.task) || have_one_causer(one, other)) continue;
        if (++pairs_ > most_pairs) {
          return leave_open(one.entry->span, fmt::format("{} and {}", name_of(model_, one.want->waiter),
                                                         name_of(model_, other.want->waiter)));
        }
        if (undoing(other, one).empty() || undoing(one, other).empty() || !may_run_in_turn(one, other)) continue;
        const std::optional<ProviderId> first = causer(one, other), second = causer(other, one);
        if (!first || !second || model_.providers[*first].group == model_.providers[*second].group) continue;
        if (are_of_one_state(one, other) && !alternate(one, *first, other, *second)) continue;
        return report(one, *first, other, *second, undoing(other, one));
      }
    }
  }

  bool have_one_causer(const Undoer& one, const Undoer& other) const {
    return one.pushed && other.pushed && model_.providers[*one.pushed].group == model_.providers[*other.pushed].group;
  }

  /// Whether what is pushed for the one brings about by itself that the other one ends.
  bool are_of_one_state(const Undoer& one, const Undoer& other) const {
    return one.pushed && other.pushed && state_of(one.want->condition) == state_of(other.want->condition);
  }

  /// Whether each push brings about what its task waits for, again and again.
  bool alternate(const Undoer& one, ProviderId first, const Undoer& other, ProviderId second) const {
    for (const ProviderId pushed : {first, second}) {
      if (spoils(pushed, one) || spoils(pushed, other)) return false;
    }
    return !is_kept_off(first, second) && !is_kept_off(second, first);
  }

  /// Whether what is pushed makes another condition of the task false.
  bool spoils(ProviderId pushed, const Undoer& of) const {
    const Provider& row = model_.providers[pushed];
    for (const ConditionUse& use : model_.providers[of.want->waiter].when) {
      for (const auto* entries : {&row.sets, &row.causing}) {
        for (const ConditionUse& entry : *entries) {
          if (state_of(entry) == state_of(use) && state_of(use) != state_of(of.want->condition) &&
              !model_.satisfies(entry.id, use.id))
            return true;
        }
      }
    }
    return false;
  }

  /// Whether the group of the other causing provider, which nothing pushes then, keeps what the pushed one needs.
  bool is_kept_off(ProviderId pushed, ProviderId other) const {
    const Provider& row = model_.providers[pushed];
    const std::vector<ProviderId>& all = model_.group_of(other).providers;
    const auto first = std::find_if(all.begin(), all.end(), [&](ProviderId id) { return facts_.chosen.contains(id); });
    if (first == all.end() || shared_.chains().may_beat(row.group, model_.providers[other].group)) return false;
    return std::any_of(row.needs.begin(), row.needs.end(), [&](const Use<GroupId>& need) {
      return shared_.indispensable().needs_part_of(model_.providers[*first], need.id);
    });
  }

  /// Recorded once for all from there on.
  void leave_open(const dsl::Span& span, const std::string& from) {
    if (std::exchange(is_open_, true)) return;
    shared_.budget().leave_open(span, fmt::format("whether two tasks end each other in turn, from {} on", from));
  }

  /// Together, so that the one ends the other one; or, if both wait for values of one state, one after the other.
  bool may_run_in_turn(const Undoer& one, const Undoer& other) const {
    Region a = region_of(model_, model_.providers[one.want->waiter].when);
    Region b = region_of(model_, model_.providers[other.want->waiter].when);
    if (are_of_one_state(one, other)) {
      a.states.erase(state_of(one.want->condition));
      b.states.erase(state_of(one.want->condition));
    }
    if (!compatible(a, b) || !in_common(shared_.claims(one.task).groups(), shared_.claims(other.task).groups()).empty())
      return false;
    bool meet = false;
    shared_.chains().visit(one.task, {other.task},
                           [&](const Meeting& meeting, GroupId) { meet = meet || !meeting.one_unit(); });
    return meet;
  }

  /// The values with which it ends the other one.
  ValueSet undoing(const Undoer& by, const Undoer& of) const {
    return undoing_values(model_, of.want->waiter, of.want->condition.id, model_.conditions[by.entry->id].accepts);
  }

  /// What causes the condition of the one while the other one runs: if it sets the state, what it pushes.
  std::optional<ProviderId> causer(const Undoer& one, const Undoer& other) const {
    const Takings takings(model_, shared_.indispensable(), shared_.claims(other.task), other.task);
    for (const ProviderId id : one.want->causers) {
      if (one.pushed && *one.pushed != id) continue;
      if (!takings.takes(model_.providers[id].group) && takings.need_taken(id) == nullptr) return id;
    }
    return std::nullopt;
  }

  /// "`Pick` may set `Arm == out`"
  std::string set_by(const Undoer& one) const {
    if (one.at_start)
      return fmt::format("the start of {} may set {}", name_of(model_, one.task), name_of(model_, one.entry->id));
    const std::string waiter = name_of(model_, one.want->waiter);
    return fmt::format("{} may {} {}",
                       one.pushed ? fmt::format("{}, pushed for {},", name_of(model_, *one.pushed), waiter) : waiter,
                       one.promised ? "cause" : "set", name_of(model_, one.entry->id));
  }

  void report(const Undoer& one, ProviderId ones_causer, const Undoer& other, ProviderId others_causer,
              const ValueSet& ends_one) {
    if (!seen_.insert({one.want->waiter, other.want->waiter}).second) return;
    const std::string first = name_of(model_, one.want->waiter), second = name_of(model_, other.want->waiter);
    dsl::Diagnostic& finding =
        findings_.add(one.entry->span, fmt::format("{}, which ends {}, and {}, which ends {}: each has its condition "
                                                   "caused again, and the two go round",
                                                   set_by(one), second, set_by(other), first));
    finding.notes.push_back({other.entry->span, set_by(other)});
    finding.notes.push_back(runs_only_while(model_, other.want->waiter, other.want->condition));
    if (dsl::Note note = causes(model_, others_causer, other.want->condition.id); note.span != other.entry->span)
      finding.notes.push_back(std::move(note));
    finding.notes.push_back(runs_only_while(model_, one.want->waiter, one.want->condition));
    if (dsl::Note note = causes(model_, ones_causer, one.want->condition.id); note.span != one.entry->span)
      finding.notes.push_back(std::move(note));
    finding.help = fmt::format("let {} and {} need one group, so that one of them waits for the other; or {}", first,
                               second, stay_help(model_, *one.want, ends_one));
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  Findings& findings_;
  std::map<std::pair<StateId, StateId>, Undoers>
      undoers_; ///< by the state that they wait for, and the one that they set
  std::set<std::pair<ProviderId, ProviderId>> seen_;
  std::size_t undoers_count_ = 0;
  std::size_t pairs_ = 0; ///< looked at so far
  bool is_open_ = false;  ///< there are more than can be looked at
};

} // namespace

void undone_in_turn(const Input& input, Findings& findings) { UndoneInTurn(input, findings).run(); }

} // namespace director::checks
