// Door: compiler/checks/analysis/clashes/clashes.hpp. Test: compiler/checks/push_cycle.md.
#include "compiler/checks/analysis/clashes/clashes.hpp"

#include "compiler/checks/analysis/facts/facts.hpp"
#include "compiler/checks/analysis/shared.hpp"
#include "compiler/checks/analysis/states/sources.hpp"
#include "compiler/checks/analysis/words/notes.hpp"
#include "compiler/checks/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace director::checks {

namespace {

using dsl::Note;

class ClashSearch {
public:
  ClashSearch(const Model& model, const Graph& graph, const Facts& facts, const Shared& shared)
      : model_(model),
        graph_(graph),
        facts_(facts),
        shared_(shared),
        sources_(find_sources(model)) {}

  std::vector<Clash> run() {
    for (const Wanting& wanting : shared_.wants()) {
      for (const Want& want : wanting.wants) look_above(wanting.task, want);
      for (std::size_t first = 0; first < wanting.wants.size(); ++first) {
        for (std::size_t second = first + 1; second < wanting.wants.size(); ++second)
          look_at(wanting, wanting.wants[first], wanting.wants[second]);
      }
    }
    return std::move(out_);
  }

private:
  const Provider& row(ProviderId id) const { return model_.providers[id]; }
  const Condition& condition(const ConditionUse& use) const { return model_.conditions[use.id]; }

  void look_at(const Wanting& wanting, const Want& first, const Want& second) {
    if (condition(first.condition).state == condition(second.condition).state) return;
    // Two providers of one group are no parts of one plan.
    if (first.waiter != second.waiter && row(first.waiter).group == row(second.waiter).group) return;
    const bool both = std::any_of(first.causers.begin(), first.causers.end(), [&](ProviderId id) {
      return std::find(second.causers.begin(), second.causers.end(), id) != second.causers.end();
    });
    if (both || seen_.count({first.condition.span, second.condition.span}) != 0) return;
    std::optional<Clash> clash = find_incompatible(first, second);
    if (!clash) clash = find_cycle(first, second);
    if (!clash) clash = find_vain(first, second);
    if (!clash) clash = find_vain(second, first);
    if (!clash) return;
    seen_.insert({first.condition.span, second.condition.span});
    clash->task = wanting.task;
    out_.push_back(std::move(*clash));
  }

  /// No push of it is ever made where the groups above the task keep what it needs.
  void look_above(GroupId task, const Want& want) {
    std::vector<Note> because;
    for (const ProviderId causer : want.causers) {
      std::optional<std::vector<Note>> notes = find_held(task, causer);
      if (!notes) return;
      because = std::move(*notes);
    }
    if (comes_otherwise(want) || !seen_.insert({want.condition.span, want.condition.span}).second) return;
    Clash clash = make(Clash::Kind::vain, want, want);
    clash.loss = Clash::Loss::held;
    clash.task = task;
    clash.because = std::move(because);
    out_.push_back(std::move(clash));
  }

  std::optional<std::vector<Note>> find_held(GroupId task, ProviderId causer) const {
    for (const Taken& wanted : taken_by(causer)) {
      if (!wanted.by_need) continue;
      for (std::optional<GroupId> above = graph_.gate[task]; above; above = graph_.gate[*above]) {
        const std::optional<Note> keeps = always_keeps(*above, task, wanted.group);
        if (keeps) return std::vector<Note>{wanted.note, *keeps};
      }
    }
    return std::nullopt;
  }

  /// Every provider of the group that leads to the task needs the other group.
  std::optional<Note> always_keeps(GroupId group, GroupId task, GroupId kept) const {
    std::optional<Note> out;
    for (const ProviderId id : model_.groups[group].providers) {
      if (!facts_.active.contains(id) || !leads_to(id, task)) continue;
      const std::vector<Taken> taken = taken_by(id);
      const auto at =
          std::find_if(taken.begin(), taken.end(), [&](const Taken& one) { return one.by_need && one.group == kept; });
      if (at == taken.end()) return std::nullopt;
      if (!out) out = at->note;
    }
    return out;
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

  std::optional<Clash> find_incompatible(const Want& first, const Want& second) const {
    const GroupId group = row(first.causers.front()).group;
    const auto is_elsewhere = [&](ProviderId id) { return row(id).group != group; };
    if (std::any_of(first.causers.begin(), first.causers.end(), is_elsewhere) ||
        std::any_of(second.causers.begin(), second.causers.end(), is_elsewhere))
      return std::nullopt;
    const auto because = for_each_pair(first, second, [&](ProviderId a, ProviderId b) {
      std::optional<std::vector<Note>> out;
      const auto there = excludes(a, b), back = excludes(b, a);
      if (there && back) out = {*there, *back};
      return out;
    });
    if (!because) return std::nullopt;
    Clash out = make(Clash::Kind::incompatible, first, second);
    out.because = *because;
    return out;
  }

  /// A condition of `provider` that what `other` causes excludes.
  std::optional<Note> excludes(ProviderId provider, ProviderId other) const {
    const Region region = region_of(model_, row(provider).when), caused = region_of(model_, row(other).causing);
    for (const ConditionUse& use : row(provider).when) {
      const StateId state = condition(use).state;
      const auto at = caused.states.find(state);
      if (at == caused.states.end() || !at->second.intersected(region.states.at(state)).empty()) continue;
      return runs_only_while(model_, provider, use);
    }
    return std::nullopt;
  }

  /// Why a causing provider can run only while a condition is false.
  std::optional<Note> runs_without(ProviderId causer, const ConditionUse& other) const {
    const Condition& wanted = condition(other);
    const Region region = region_of(model_, row(causer).when);
    const auto at = region.states.find(wanted.state);
    if (at == region.states.end() || !at->second.intersected(wanted.accepts).empty()) return std::nullopt;
    for (const ConditionUse& use : row(causer).when) {
      if (condition(use).state == wanted.state) return runs_only_while(model_, causer, use);
    }
    return std::nullopt;
  }

  /// Why a causing provider makes a condition false: it cannot run otherwise, or sets the state to something else.
  std::optional<Note> undoes(ProviderId causer, const ConditionUse& other) const {
    if (std::optional<Note> note = runs_without(causer, other)) return note;
    const Condition& wanted = condition(other);
    const ValueSet set = values_set_by(model_, row(causer), wanted.state);
    if (set.empty() || !set.intersected(wanted.accepts).empty()) return std::nullopt;
    for (const bool promised : {true, false}) {
      for (const ConditionUse& use : promised ? row(causer).causing : row(causer).sets) {
        if (condition(use).state != wanted.state) continue;
        return Note{use.span, fmt::format("{} {} {}", name_of(model_, causer), promised ? "causes" : "sets",
                                          name_of(model_, use.id))};
      }
    }
    return std::nullopt;
  }

  std::optional<Clash> find_cycle(const Want& first, const Want& second) const {
    Clash out = make(Clash::Kind::cycle, first, second);
    const auto mutual = for_each_pair(first, second, [&](ProviderId a, ProviderId b) {
      std::optional<std::vector<Note>> notes;
      const auto there = undoes(a, second.condition), back = undoes(b, first.condition);
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
      const auto one_way =
          for_each_pair(held, late, [&](ProviderId, ProviderId b) { return runs_without(b, held.condition); });
      if (!one_way) continue;
      out.because = {*one_way};
      return out;
    }
    return std::nullopt;
  }

  std::optional<Clash> find_vain(const Want& first, const Want& second) const {
    if (comes_otherwise(second)) return std::nullopt;
    Clash out = make(Clash::Kind::vain, first, second);
    using Find = std::optional<std::vector<Note>> (ClashSearch::*)(ProviderId, ProviderId) const;
    const std::pair<Clash::Loss, Find> losses[] = {{Clash::Loss::request, &ClashSearch::lost_request},
                                                   {Clash::Loss::group, &ClashSearch::lost_group},
                                                   {Clash::Loss::provider, &ClashSearch::lost_provider}};
    for (const auto& [loss, find] : losses) {
      const auto because =
          for_each_pair(first, second, [&, how = find](ProviderId a, ProviderId b) { return (this->*how)(a, b); });
      if (!because) continue;
      out.loss = loss;
      out.because = *because;
      return out;
    }
    return std::nullopt;
  }

  /// Something that no push is needed for may make the condition true.
  bool comes_otherwise(const Want& want) const {
    const Condition& wanted = condition(want.condition);
    const std::vector<Source>& sources = sources_[wanted.state];
    return std::any_of(sources.begin(), sources.end(), [&](const Source& source) {
      if (source.kind == Source::Kind::initial || source.values.intersected(wanted.accepts).empty()) return false;
      if (!source.provider) return true;
      const bool is_causer =
          std::find(want.causers.begin(), want.causers.end(), *source.provider) != want.causers.end();
      return !is_causer && facts_.active.contains(*source.provider);
    });
  }

  /// Only the group of `a` leads to that of `b`, and `a` does not.
  std::optional<std::vector<Note>> lost_request(ProviderId a, ProviderId b) const {
    const GroupId from = row(a).group, to = row(b).group;
    std::optional<GroupId> gate = graph_.gate[to];
    while (gate && *gate != from) gate = graph_.gate[*gate];
    if (!gate || leads_to(a, to)) return std::nullopt;
    std::vector<Note> out;
    for (const EdgeId edge : model_.groups[to].requesters) {
      const std::optional<GroupId> requester = model_.edges[edge].requester;
      if (!requester || model_.edges[edge].levels.empty()) continue;
      for (const ProviderId id : model_.groups[*requester].providers) {
        const Task* task = entry_for(id, to);
        if (task == nullptr || !facts_.active.contains(id)) continue;
        out.push_back({task->span, fmt::format("{} requests {}", name_of(model_, id), name_of(model_, to))});
      }
    }
    return out;
  }

  bool leads_to(ProviderId provider, GroupId group) const {
    for (const Pack& pack : row(provider).packs) {
      for (const Task& task : pack.tasks) {
        const std::vector<GroupId>& below = shared_.claims(task.target).groups();
        if (task.target == group || std::binary_search(below.begin(), below.end(), group)) return true;
      }
    }
    return false;
  }

  const Task* entry_for(ProviderId provider, GroupId group) const {
    for (const Pack& pack : row(provider).packs) {
      for (const Task& task : pack.tasks) {
        if (task.target == group) return &task;
      }
    }
    return nullptr;
  }

  struct Taken {
    GroupId group{};
    Note note;
    bool by_need = true;
  };

  /// The groups that a provider holds for itself as long as it runs.
  std::vector<Taken> taken_by(ProviderId provider) const {
    std::vector<Taken> out;
    const auto take = [&](GroupId group, dsl::Span span, bool by_need) {
      const std::string verb = by_need ? "needs" : "requests";
      const auto& parts = shared_.indispensable().of(group);
      for (const GroupId part : parts ? *parts : std::vector<GroupId>{group}) {
        const std::string by = part == group ? "" : fmt::format(", which cannot do without {}", name_of(model_, part));
        out.push_back({part,
                       {span, fmt::format("{} {} {}{}", name_of(model_, provider), verb, name_of(model_, group), by)},
                       by_need});
      }
    };
    for (const Use<GroupId>& need : row(provider).needs) take(need.id, need.span, true);
    const std::vector<Pack>& packs = row(provider).packs;
    if (packs.empty()) return out;
    for (const Task& task : packs.front().tasks) {
      const bool always = std::all_of(packs.begin(), packs.end(), [&](const Pack& pack) {
        return std::any_of(pack.tasks.begin(), pack.tasks.end(), [&](const Task& other) {
          return other.target == task.target && !model_.edges[other.edge].levels[other.levels.front().level].optional;
        });
      });
      if (always) take(task.target, task.span, false);
    }
    return out;
  }

  /// The one holds what the other cannot do without, or both want the same.
  std::optional<std::vector<Note>> lost_group(ProviderId a, ProviderId b) const {
    if (row(a).group == row(b).group) return std::nullopt;
    const GroupId victim = row(b).group;
    for (const Taken& taken : taken_by(a)) {
      if (taken.group == victim && taken.by_need && entry_for(a, victim) == nullptr)
        return std::vector<Note>{taken.note};
      for (const Taken& wanted : taken_by(b)) {
        if (wanted.group != taken.group || !wanted.by_need) continue;
        const bool first_wins = shared_.chains().beaten_by(row(a).group, {victim}).contains(victim);
        const bool second_wins = shared_.chains().beaten_by(victim, {row(a).group}).contains(row(a).group);
        if (first_wins || (taken.by_need && !second_wins)) return std::vector<Note>{taken.note, wanted.note};
      }
    }
    return std::nullopt;
  }

  /// What the one sets makes a condition of the other one false, and nothing else makes it true again.
  std::optional<std::vector<Note>> lost_provider(ProviderId a, ProviderId b) const {
    for (const auto& [state, accepted] : region_of(model_, row(b).when).states) {
      const ValueSet set = values_set_by(model_, row(a), state);
      if (set.empty() || !set.intersected(accepted).empty() || comes_from_others(state, accepted, a)) continue;
      std::vector<Note> out;
      for (const std::vector<ConditionUse>* uses : {&row(a).causing, &row(a).sets}) {
        for (const ConditionUse& use : *uses) {
          if (condition(use).state != state) continue;
          out.push_back({use.span, fmt::format("{} makes {}", name_of(model_, a), name_of(model_, use.id))});
        }
      }
      for (const ConditionUse& use : row(b).when) {
        if (condition(use).state != state) continue;
        out.push_back(runs_only_while(model_, b, use));
      }
      return out;
    }
    return std::nullopt;
  }

  bool comes_from_others(StateId state, const ValueSet& values, ProviderId but) const {
    return std::any_of(sources_[state].begin(), sources_[state].end(), [&](const Source& source) {
      return source.kind != Source::Kind::initial && source.provider != but &&
             !source.values.intersected(values).empty();
    });
  }

  const Model& model_;
  const Graph& graph_;
  const Facts& facts_;
  const Shared& shared_;
  IdTable<StateId, std::vector<Source>> sources_;
  std::set<std::pair<dsl::Span, dsl::Span>> seen_;
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
  for (const auto& [causer, condition] : promises) finding.notes.push_back(causes(model, causer, condition.id));
  finding.notes.insert(finding.notes.end(), clash.because.begin(), clash.because.end());
}

} // namespace director::checks
