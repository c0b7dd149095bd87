// Header: compiler/analysis/rounds/granted.hpp. Test: compiler/checks/undone_by_stop.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/rounds/granted.hpp"

#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace director::analysis {

namespace {

/// Other tasks that are granted with a task are considered up to this many.
constexpr std::size_t most_members = 16;
/// Packs of a task are considered one by one if there are at most so many; else all together.
constexpr std::size_t most_packs = 16;

Granted grant(const Model& model, const Shared& shared, GroupId waits, GroupId task, const Task* member, bool is_held) {
  const Claims& claims = shared.claims(task);
  return {waits,
          task,
          member,
          is_held,
          nullptr,
          Takings(model, shared.indispensable(), claims, task, waits, is_held, shared.chains()),
          RunsBelow(shared.branches(), claims, task)};
}

/// Whether members of the pack exclude each other, so that its unit is never granted.
bool has_conflict(const Input& input, const Pack* pack) {
  const std::vector<PackConflict>& all = input.conflicts.pack_conflicts();
  return std::any_of(all.begin(), all.end(), [&](const PackConflict& conflict) {
    return conflict.pack == pack && conflict.verdict == UnitVerdict::impossible;
  });
}

/// Whether each provider of the group needs what the causing one needs too, so that the two never run together.
bool keeps_off(const Model& model, const Facts& facts, const Indispensable& indispensable, GroupId group,
               ProviderId causer) {
  const Provider& row = model.providers[causer];
  const std::vector<ProviderId>& all = model.groups[group].providers;
  return indispensable.needs_part_of(row, group) || std::all_of(all.begin(), all.end(), [&](ProviderId id) {
           const std::vector<Use<GroupId>>& needs = model.providers[id].needs;
           return !facts.active.contains(id) || std::any_of(needs.begin(), needs.end(), [&](const Use<GroupId>& need) {
             return indispensable.needs_part_of(row, need.id);
           });
         });
}

/// What the group runs with: a provider, and a pack of it.
std::vector<std::pair<ProviderId, const Pack*>> packs_of(const Model& model, const Facts& facts, GroupId group,
                                                         std::optional<ProviderId> provider) {
  std::vector<std::pair<ProviderId, const Pack*>> out;
  for (const ProviderId id : model.groups[group].providers) {
    if (!facts.active.contains(id) || (provider && id != *provider)) continue;
    for (const Pack& pack : model.providers[id].packs) out.emplace_back(id, &pack);
    if (model.providers[id].packs.empty()) out.emplace_back(id, nullptr);
  }
  return out;
}

} // namespace

Granted granted_alone(const Model& model, const Shared& shared, GroupId task) {
  return grant(model, shared, task, task, nullptr, false);
}

std::vector<Granted> granted_with(const Input& input, GroupId task) {
  const Model& model = input.model;
  const Shared& shared = input.shared;
  std::vector<Granted> out;
  out.push_back(granted_alone(model, shared, task));
  for (const Request& request : shared.requests().of(task)) {
    if (!request.requester || request.pack->name.empty() || !model.is_always_member(*request.task) ||
        has_conflict(input, request.pack))
      continue;
    for (const Task* member : unit_members(model, *request.pack)) {
      const Provider& requester = model.providers[*request.requester];
      const bool is_held = requester.needs_group(member->target);
      const bool keeps_off = shared.indispensable().needs_part_of(requester, member->target); // it is never granted
      const bool known = std::any_of(out.begin(), out.end(), [&](const Granted& each) {
        return each.task == member->target && (is_held || !each.is_held);
      });
      if (!known && (is_held || !keeps_off) && out.size() < most_members)
        out.push_back(grant(model, shared, task, member->target, member, is_held));
    }
  }
  return out;
}

std::vector<Granted> granted_with(const Input& input, const Wanting& wanting) {
  if (!wanting.wants.front().pushed) return granted_with(input, wanting.task);
  std::vector<Granted> out{granted_alone(input.model, input.shared, wanting.task)};
  out.front().pushed = wanting.provider;
  return out;
}

std::vector<Granted> with_each_pack(const Model& model, const Facts& facts, const Shared& shared, Granted granted,
                                    ProviderId provider) {
  const auto packs = packs_of(model, facts, granted.task, provider);
  std::vector<Granted> out;
  if (granted.is_other() || packs.empty() || packs.size() > most_packs ||
      packs_of(model, facts, granted.task, {}).size() == 1) {
    out.push_back(std::move(granted));
    return out;
  }
  for (const auto& [id, pack] : packs) {
    const Branches branches = shared.branches().with(id, pack);
    const auto claims = std::make_shared<const Claims>(branches, granted.task);
    out.push_back(
        {granted.waits, granted.task, granted.member, granted.is_held, claims,
         Takings(model, shared.indispensable(), *claims, granted.task, granted.waits, granted.is_held, shared.chains()),
         RunsBelow(branches, *claims, granted.task), granted.pushed});
  }
  return out;
}

bool is_requested_beside(const Shared& shared, const Granted& granted, GroupId group) {
  if (!granted.claims || !shared.claims(granted.task).contains(group)) return true;
  bool out = false;
  shared.chains().visit(granted.task, {group}, [&](const Meeting& meeting, GroupId) {
    const GroupId other = meeting.second->target;
    if (out || other == granted.task || meeting.one_unit() || !meeting.first_goes_before()) return;
    const Claims without(shared.branches(), other, {granted.task});
    out = RunsBelow(shared.branches(), without, other).contains(group);
  });
  return out;
}

bool leads_to_granted(const Shared& shared, GroupId above, const Granted& granted) {
  const Claims& claims = shared.claims(above);
  return claims.contains(granted.task) || claims.contains(granted.waits);
}

std::optional<Taking> why_needs_fail(const Model& model, const Facts& facts, const Takings& takings, GroupId group,
                                     ProviderId causer) {
  const bool causes = model.providers[causer].group == group;
  std::optional<Taking> out;
  for (const ProviderId id : model.groups[group].providers) {
    if (id != causer && !facts.active.contains(id)) continue;
    const Use<GroupId>* need = takings.need_taken(id);
    if (need == nullptr) return std::nullopt;
    if (causes ? id != causer : out.has_value()) continue;
    out = takings.way_to(*need, group);
    out->notes.insert(out->notes.begin(),
                      {need->span, fmt::format("{} needs {}", name_of(model, id), name_of(model, need->id))});
  }
  return out;
}

std::optional<Taking> why_unit_ends(const Model& model, const Facts& facts, const Shared& shared,
                                    const Granted& granted, const Request& request, ProviderId causer) {
  if (!request.requester || request.pack->name.empty() || !model.is_always_member(*request.task)) return std::nullopt;
  std::optional<Taking> out;
  const std::vector<const Task*> unit = unit_members(model, *request.pack);
  for (const Task* member : unit) {
    if (member == request.task) continue;
    if (keeps_off(model, facts, shared.indispensable(), member->target, causer)) return std::nullopt;
    if (out) continue;
    if (granted.takings.takes(member->target)) out = granted.takings.way_to(member->target);
    if (!out) out = why_needs_fail(model, facts, granted.takings, member->target, causer);
    if (!out) continue;
    out->notes.insert(out->notes.begin(), {request.task->span, fmt::format("{} is granted only together with {}",
                                                                           name_of(model, request.task->target),
                                                                           name_of(model, member->target))});
  }
  const auto leads_to_task = [&](const Task* member) {
    const Claims& claims = shared.claims(member->target);
    return claims.contains(granted.waits) || claims.contains(granted.task);
  };
  if (out && std::any_of(unit.begin(), unit.end(), leads_to_task)) return std::nullopt;
  return out;
}

std::vector<ChainStep> way_below(const Model& model, const Shared& shared, ProviderId from, GroupId to) {
  for (const Pack& pack : model.providers[from].packs) {
    for (const Task& task : pack.tasks) {
      const Claims& claims = shared.claims(task.target);
      if (!claims.contains(to)) continue;
      const RunsBelow below(shared.branches(), claims, task.target);
      if (!below.contains(to)) continue;
      std::vector<ChainStep> out = below.path(to);
      out.insert(out.begin(), {model.providers[from].group, task.target, false, task.span});
      return out;
    }
  }
  return {};
}

std::string is_granted(const Model& model, const Granted& granted) {
  if (granted.pushed) return name_of(model, *granted.pushed) + " begins";
  const std::string out = name_of(model, granted.task) + " is granted";
  return granted.is_other() ? fmt::format("{} together with {}", out, name_of(model, granted.waits)) : out;
}

} // namespace director::analysis
