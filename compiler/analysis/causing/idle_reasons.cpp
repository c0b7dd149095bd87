// Header: compiler/analysis/causing/promises.hpp. Test: compiler/checks/unreachable_causing.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/exclusion.hpp"
#include "compiler/analysis/causing/promises.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <set>

namespace director::analysis {

namespace {

using dsl::Note;

/// Follows the reasons down from a provider that never runs, and explains at each step what is missing there.
class IdleReasons {
public:
  IdleReasons(const Model& model, const Facts& facts, const Task* reported)
      : model_(model),
        facts_(facts),
        reported_(reported),
        sources_(find_sources(model)) {}

  std::vector<Note> run(const std::vector<ProviderId>& providers) {
    for (const ProviderId id : providers) explain(id);
    return std::move(notes_);
  }

  /// After run().
  std::optional<Deadlock> deadlock() const { return has_end_ ? std::nullopt : deadlock_; }

private:
  /// `needed`: it needs no request.
  void explain(ProviderId id, bool needed = false) {
    if (facts_.active.contains(id) || !seen_.insert(id).second) return;
    const Provider& provider = model_.providers[id];
    const std::size_t before = notes_.size();
    if (!needed && !facts_.requested.contains(provider.group)) explain_request(provider.group);
    for (const ConditionUse& use : provider.when) {
      if (!facts_.may_hold(model_, id, use)) explain_condition(use);
    }
    explain_contradictions(provider);
    for (const Use<GroupId>& need : provider.needs) {
      if (facts_.capable_groups.contains(need.id)) continue;
      notes_.push_back({need.span, fmt::format("it needs {}, which never can run", name_of(model_, need.id))});
      for (const ProviderId below : model_.groups[need.id].providers) explain(below, true);
    }
    if (notes_.size() != before) return;
    if (facts_.excluded.contains(id) && explain_company(provider.group)) return;
    has_end_ = true;
    if (facts_.requested.contains(provider.group) && facts_.capable.contains(id) && !facts_.excluded.contains(id)) {
      // Nothing is missing: it is neither chosen nor pushed.
      notes_.push_back({provider.span, fmt::format("{} never runs: whenever it could, others of its group come first",
                                                   name_of(model_, id))});
      return;
    }
    for (Note& note : explain_exclusion(model_, facts_, id, reported_)) {
      if (std::find(notes_.begin(), notes_.end(), note) == notes_.end()) notes_.push_back(std::move(note));
    }
  }

  void explain_contradictions(const Provider& provider) {
    for (const auto& [state, values] : region_of(model_, provider.when).states) {
      if (!values.empty()) continue;
      std::vector<std::string> names;
      Span last{};
      for (const ConditionUse& use : provider.when) {
        if (model_.conditions[use.id].state != state) continue;
        names.push_back(name_of(model_, use.id));
        last = use.span;
      }
      notes_.push_back({last, fmt::format("{} never hold together", list_of(names, "and"))});
    }
  }

  void explain_request(GroupId group) {
    if (!groups_.insert(group).second) return;
    std::vector<ProviderId> next;
    bool requested = false;
    for (const EdgeId edge : model_.groups[group].requesters) {
      if (!model_.edges[edge].requester || model_.edges[edge].levels.empty()) continue;
      for (const ProviderId id : model_.groups[*model_.edges[edge].requester].providers) {
        const Task* const entry = find_entry(model_, id, group).task;
        if (entry == nullptr) continue;
        requested = true;
        notes_.push_back({entry->span, fmt::format("{} requests {}, but never runs itself", name_of(model_, id),
                                                   name_of(model_, group))});
        next.push_back(id);
      }
    }
    if (!requested) {
      notes_.push_back({model_.groups[group].name.span, fmt::format("nothing requests {}", name_of(model_, group))});
      has_end_ = true;
    }
    for (const ProviderId id : next) explain(id);
  }

  /// Explains that its requests are granted only together with something that can never run; false if that is not so.
  bool explain_company(GroupId group) {
    if (kept_.count(group) != 0) return true;
    std::vector<GroupId> others;
    for (const EdgeId edge : model_.groups[group].requesters) {
      if (!model_.edges[edge].requester) continue;
      for (const ProviderId id : model_.groups[*model_.edges[edge].requester].providers) {
        if (!model_.providers[id].has_packs || !facts_.active.contains(id)) continue;
        for (const Pack& pack : model_.providers[id].packs) add_company(id, unit_members(model_, pack), group, others);
      }
    }
    if (others.empty()) return false;
    kept_.insert(group);
    for (const GroupId other : others) {
      for (const ProviderId id : model_.groups[other].providers) explain(id, true);
    }
    return true;
  }

  void add_company(ProviderId by, const std::vector<const Task*>& members, GroupId group,
                   std::vector<GroupId>& others) {
    const auto own =
        std::find_if(members.begin(), members.end(), [&](const Task* member) { return member->target == group; });
    if (own == members.end()) return;
    std::vector<const Task*> waiting;
    std::copy_if(members.begin(), members.end(), std::back_inserter(waiting), [&](const Task* member) {
      return member->target != group && !facts_.capable_groups.contains(member->target);
    });
    if (waiting.empty()) return;
    const Task* other = waiting.front();
    const GroupId target = other->target;
    if (*own != reported_) notes_.push_back(requests(model_, by, **own));
    notes_.push_back({other->span, fmt::format("it is granted only together with {}", name_of(model_, target))});
    if (!deadlock_) deadlock_ = Deadlock{other, *own, {waiting.begin() + 1, waiting.end()}};
    others.push_back(target);
  }

  void explain_condition(const ConditionUse& use) {
    const Condition& condition = model_.conditions[use.id];
    std::vector<std::string> who;
    std::vector<ProviderId> next;
    for (const Source& source : sources_[condition.state]) {
      if (!source.values.overlaps(condition.accepts)) continue;
      if (source.provider) {
        who.push_back(name_of(model_, *source.provider));
        next.push_back(*source.provider);
      } else if (source.group) {
        who.push_back(fmt::format("the {} of {}", source.kind == Source::Kind::start ? "start" : "stop",
                                  name_of(model_, *source.group)));
        for (const ProviderId id : model_.groups[*source.group].providers) next.push_back(id);
      } else if (source.kind == Source::Kind::expires) {
        who.push_back("its expiry after another value");
        for (const Source& other : sources_[condition.state]) {
          if (other.provider) next.push_back(*other.provider);
        }
      }
    }
    if (next.empty()) has_end_ = true;
    const std::string name = name_of(model_, use.id);
    notes_.push_back(
        {use.span, who.empty() ? fmt::format("it waits for {}, and nothing sets that", name)
                               : fmt::format("it waits for {}, and only {} could set that", name, list_of(who, "or"))});
    for (const ProviderId id : next) explain(id);
  }

  const Model& model_;
  const Facts& facts_;
  const Task* const reported_;
  IdTable<StateId, std::vector<Source>> sources_;
  std::vector<Note> notes_;
  std::set<ProviderId> seen_;
  std::set<GroupId> groups_, kept_;
  std::optional<Deadlock> deadlock_; ///< the first one found
  bool has_end_ = false;             ///< something is missing that depends on nothing else
};

std::int32_t highest_priority(const Model& model, const Task& task) {
  std::int32_t out = std::numeric_limits<std::int32_t>::min();
  for (const Task::NamedLevel& use : task.levels)
    out = std::max(out, model.edges[task.edge].levels[use.level].priority);
  return out;
}

} // namespace

std::string apart_help(const Model& model, const Deadlock& deadlock, bool to_push) {
  const std::string kept = name_of(model, deadlock.kept->target);
  const auto goes_after = [&](const Task* task) {
    return to_push && highest_priority(model, *task) <= highest_priority(model, *deadlock.kept);
  };
  if (deadlock.also.empty()) {
    const std::string waits = name_of(model, deadlock.waits->target);
    return goes_after(deadlock.waits) ? fmt::format("make {} `apart`, with a higher priority than {}", waits, kept)
                                      : fmt::format("make {} `apart`, so that it waits for itself alone", waits);
  }
  std::vector<std::string> names{name_of(model, deadlock.waits->target)};
  for (const Task* task : deadlock.also) names.push_back(name_of(model, task->target));
  const bool some_go_after =
      goes_after(deadlock.waits) || std::any_of(deadlock.also.begin(), deadlock.also.end(), goes_after);
  return some_go_after ? fmt::format("make {} `apart`, with higher priorities than {}", list_of(names), kept)
                       : fmt::format("make {} `apart`, so that each waits for itself alone", list_of(names));
}

Idleness explain_idle(const Input& input, ProviderId provider) {
  return explain_idle(input.model, input.facts, {provider});
}

Idleness explain_idle(const Model& model, const Facts& facts, const std::vector<ProviderId>& providers,
                      const Task* reported) {
  IdleReasons reasons(model, facts, reported);
  Idleness out;
  out.notes = reasons.run(providers);
  out.deadlock = reasons.deadlock();
  return out;
}

} // namespace director::analysis
