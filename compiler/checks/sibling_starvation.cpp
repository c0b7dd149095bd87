// Door: compiler/checks/check.hpp. Test: compiler/checks/sibling_starvation.md.
#include "compiler/checks/analysis/conflicts/conflicts.hpp"
#include "compiler/checks/analysis/shared.hpp"
#include "compiler/checks/analysis/words/notes.hpp"
#include "compiler/checks/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

namespace director::checks {

namespace {

/// The priority of a member of the unit at its first level; nothing: it is none.
std::optional<std::int32_t> rank_in_unit(const Model& model, const Task& task) {
  const Level& level = model.edges[task.edge].levels[task.levels[0].level];
  if (level.optional || level.apart) return std::nullopt;
  return level.priority;
}

class Starvation {
public:
  Starvation(const Input& input, Findings& findings) : input_(input), findings_(findings) {
    for (const PackConflict& conflict : input.conflicts.pack_conflicts()) {
      for (const Task* member : conflict.members)
        conflicts_[member].insert(conflict.members.begin(), conflict.members.end());
    }
  }

  void look_at(GroupId requester, const Pack& pack) {
    std::unordered_map<GroupId, std::vector<const Task*>> wanted_by;
    for (const Task& task : pack.tasks) {
      if (pack.tasks.size() < 2 || !rank_in_unit(input_.model, task)) continue;
      for (const GroupId group : input_.shared.claims(task.target, requester).groups())
        wanted_by[group].push_back(&task);
    }
    for (const Task& taker : pack.tasks) {
      const auto low = rank_in_unit(input_.model, taker);
      if (pack.tasks.size() < 2 || !low) continue;
      std::set<const Task*> siblings; // in the order written
      for (const GroupId group : input_.shared.claims(taker.target, requester).groups())
        siblings.insert(wanted_by[group].begin(), wanted_by[group].end());
      for (const Task* sibling : siblings) {
        if (&taker == sibling || exclude(taker, *sibling)) continue;
        if (*rank_in_unit(input_.model, *sibling) >= *low) report(requester, taker, *sibling);
      }
    }
  }

private:
  /// That the two are never granted together is a finding of its own.
  bool exclude(const Task& a, const Task& b) const {
    if (!input_.shared.indispensable().in_common(a.target, b.target).empty()) return true;
    const auto at = conflicts_.find(&a);
    return at != conflicts_.end() && at->second.count(&b) != 0;
  }

  void report(GroupId requester, const Task& taker, const Task& sibling) {
    const Model& model = input_.model;
    const Claims& below = input_.shared.claims(sibling.target, requester);
    const Claims& own = input_.shared.claims(taker.target, requester);
    const Claim* nearest = nullptr;
    GroupId group{};
    for (const GroupId id : own.groups()) {
      const Claim* wanted = below.find(id, Reach::mandatory);
      const Claim* held = own.find(id, Reach::own);
      if (wanted == nullptr || held == nullptr || !input_.shared.indispensable().contains(taker.target, id)) continue;
      if (!compatible(wanted->region, held->region) || (nearest != nullptr && nearest->steps <= wanted->steps))
        continue;
      nearest = wanted;
      group = id;
    }
    if (nearest == nullptr) return;
    const std::string name = name_of(model, taker.target);
    const std::string other = name_of(model, sibling.target);
    dsl::Diagnostic& finding = findings_.add(
        taker.span,
        group == taker.target
            ? fmt::format("{} is granted before anything below {} is tried, which wants it too", name, other)
            : fmt::format("{} takes {} before anything below {} is tried, which wants it too", name,
                          name_of(model, group), other));
    finding.notes.push_back(
        {sibling.span, fmt::format("{} is granted together with {}", name_of(model, sibling.target), name)});
    add_chain(model, own.path(group, Reach::own), finding.notes);
    add_chain(model, below.path(group, Reach::mandatory), finding.notes);
    finding.help = fmt::format("make {} `apart` or `optional`, or ask for it one level lower", name);
  }

  const Input& input_;
  Findings& findings_;
  std::unordered_map<const Task*, std::set<const Task*>> conflicts_;
};

} // namespace

void sibling_starvation(const Input& input, Findings& findings) {
  Starvation starvation(input, findings);
  for (const ProviderId id : input.model.providers.ids()) {
    const Provider& provider = input.model.providers[id];
    if (!provider.has_packs || !input.facts.active.contains(id)) continue;
    for (const Pack& pack : provider.packs) starvation.look_at(provider.group, pack);
  }
}

} // namespace director::checks
