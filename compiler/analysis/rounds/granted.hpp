#pragma once
// SPDX-License-Identifier: MIT
// Finds what is granted when the condition of a task has been caused: the task, and the other members of its unit.

#include "compiler/analysis/causing/takings.hpp"
#include "compiler/analysis/chains/runs_below.hpp"
#include "compiler/analysis/input.hpp"
#include "compiler/analysis/requests/requests.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace director::analysis {

/// A task, and what it takes and runs then.
struct Granted {
  GroupId waits{};                      ///< the task that was pushed for
  GroupId task{};                       ///< the same, or one that is granted together with it
  const Task* member = nullptr;         ///< that other one, in the unit
  bool is_held = false;                 ///< the requester needs it too, so that it was held before
  std::shared_ptr<const Claims> claims; ///< with one of its packs; null: with any of them
  Takings takings;
  RunsBelow below;
  std::optional<ProviderId> pushed{}; ///< the task begins with this provider, for which another one was pushed before

  bool is_other() const { return member != nullptr; }
};

/// The task itself.
Granted granted_alone(const Model& model, const Shared& shared, GroupId task);

/// First the task itself, then the members of its units in named packs, if these are ever granted. Of a flat list, it
/// depends on the body which tasks are granted together.
std::vector<Granted> granted_with(const Input& input, GroupId task);

/// Of what is pushed, the task alone.
std::vector<Granted> granted_with(const Input& input, const Wanting& wanting);

/// The same with each pack of the provider that was pushed for, because only one of them is requested at a time. Of
/// other members, with all.
std::vector<Granted> with_each_pack(const Model& model, const Facts& facts, const Shared& shared, Granted granted,
                                    ProviderId provider);

/// Whether the group may be requested by another task, which goes after this one and from which this one takes it. True
/// too if it is not known which pack the task requests.
bool is_requested_beside(const Shared& shared, const Granted& granted, GroupId group);

/// Whether the group leads to the task, or to the one that was pushed for.
bool leads_to_granted(const Shared& shared, GroupId above, const Granted& granted);

/// How the task takes a need of each provider of the group, described for the causing provider if it is one of them,
/// else for the first. Empty: some provider keeps its needs.
std::optional<Taking> why_needs_fail(const Model& model, const Facts& facts, const Takings& takings, GroupId group,
                                     ProviderId causer);

/// How the task takes what another member of the unit of this request cannot do without, so that all of that unit is
/// blocked. Empty: it is not a request of a unit, or the unit keeps what it needs, leads to the task, or keeps what the
/// causing provider needs.
std::optional<Taking> why_unit_ends(const Model& model, const Facts& facts, const Shared& shared,
                                    const Granted& granted, const Request& request, ProviderId causer);

/// The requests from the provider down to the group, with any pack. Empty: it leads to it by none.
std::vector<ChainStep> way_below(const Model& model, const Shared& shared, ProviderId from, GroupId to);

/// "`Kick` is granted", "`Look` is granted together with `Kick`", "`Arm.reaching` begins"
std::string is_granted(const Model& model, const Granted& granted);

} // namespace director::analysis
