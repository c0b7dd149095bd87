// Header: compiler/analysis/clashes/granted.hpp. Test: compiler/checks/undone_by_stop.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/clashes/granted.hpp"

#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::analysis {

namespace {

/// Other tasks that are granted with a task are considered up to this many.
constexpr std::size_t most_members = 16;

Granted grant(const Model& model, const Shared& shared, GroupId waits, GroupId task, const Task* member) {
  const Claims& claims = shared.claims(task);
  return {waits, task, member, Takings(model, shared.indispensable(), claims, task),
          RunsBelow(shared.branches(), claims, task)};
}

} // namespace

Granted granted_alone(const Model& model, const Shared& shared, GroupId task) {
  return grant(model, shared, task, task, nullptr);
}

std::vector<Granted> granted_with(const Model& model, const Shared& shared, GroupId task) {
  std::vector<Granted> out;
  out.push_back(granted_alone(model, shared, task));
  for (const Request& request : shared.requests().of(task)) {
    if (!request.requester || request.pack->name.empty() || !model.is_always_member(*request.task)) continue;
    for (const Task* member : unit_members(model, *request.pack)) {
      const bool known =
          std::any_of(out.begin(), out.end(), [&](const Granted& each) { return each.task == member->target; });
      if (!known && out.size() < most_members) out.push_back(grant(model, shared, task, member->target, member));
    }
  }
  return out;
}

std::string is_granted(const Model& model, const Granted& granted) {
  const std::string out = name_of(model, granted.task) + " is granted";
  return granted.is_other() ? fmt::format("{} together with {}", out, name_of(model, granted.waits)) : out;
}

} // namespace director::analysis
