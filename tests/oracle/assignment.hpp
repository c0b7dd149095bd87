#pragma once
// SPDX-License-Identifier: MIT
// semantics.md, section 2: what changes while a behaviour runs. Assignment is what arbitration decides; Facts is all
// its other input.

#include "dsl/data.hpp"
#include "tests/oracle/parts.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace director::oracle {

enum class Reason { new_task, pushed, subtask_done, wait, trigger };

struct Request {
  std::uint32_t level = 0; ///< of Edge::levels
  std::optional<dsl::Data> data;
  std::uint64_t stamp = 0; ///< micro-step in which the edge became requested, or in which its level last changed
};

/// A push (u, k, c) with k as the key, and the unmet condition that it was made for.
struct Push {
  EdgeId by{};
  ProviderId to{};
  ConditionId unmet{};
  bool operator==(const Push&) const = default;
};

struct Held {
  EdgeId by{};
  bool granted = false; ///< it was granted as the target of a unit
  bool needed = false;  ///< claimed for a plan
  bool stale = false;   ///< 4.4; always for a group in limbo
  bool operator==(const Held&) const = default;
};

/// What a push in force serves: its provider, and the false condition that it was made for.
struct Service {
  ProviderId provider{};
  ConditionId unmet{};
  bool operator==(const Service&) const = default;
};

struct Assignment {
  IdTable<GroupId, std::optional<Held>> held;
  IdTable<GroupId, std::optional<ProviderId>> active; ///< a group is live if it has one
  IdTable<GroupId, Plan> plan;                        ///< for the needs of the active provider
  std::map<GroupId, Push> pushes;
  std::set<GroupId> in_force;         ///< 4.3: pushed groups
  std::map<GroupId, Service> serving; ///< those pushes in force whose condition is still false
  std::vector<GroupId> order;         ///< the groups that are held, in order

  explicit Assignment(const Model& model)
      : held(model.groups.size()),
        active(model.groups.size()),
        plan(model.groups.size()) {}

  bool granted(GroupId g) const { return held[g] && held[g]->granted; }
  bool granted_to(EdgeId e, GroupId g) const { return granted(g) && held[g]->by == e; }
  bool held_by(EdgeId e, GroupId g) const { return held[g] && held[g]->by == e; }
  /// Whether holders, granted groups, providers and pushes are equal.
  bool same_decision(const Assignment& other) const;
};

struct Facts {
  IdTable<StateId, std::optional<std::int64_t>> value; ///< nothing: unset
  std::set<ProviderId> disabled;
  IdTable<EdgeId, std::optional<Request>> request;
  IdTable<GroupId, std::set<Reason>> pending;
  std::set<EdgeId> anew; ///< requested anew in this micro-step

  explicit Facts(const Model& model);
  bool enabled(ProviderId provider) const { return !disabled.contains(provider); }
  bool holds(const Model& model, ConditionId condition) const;
};

} // namespace director::oracle
