#pragma once
// SPDX-License-Identifier: MIT
// Finds what a task may come to hold: its group, what that needs, what it requests, and so on. For each group the
// states with which that can happen, as far as each state by itself determines it.

#include "compiler/analysis/chains/step.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/model/model.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace director::analysis {

/// How a group is reached from the task.
enum class Reach {
  own,       ///< the task's group, or by needs alone: held as soon as the task is granted
  mandatory, ///< by a request, with no optional request on the path
  optional   ///< with an optional request on the path
};
inline constexpr Reach all_reaches[] = {Reach::own, Reach::mandatory, Reach::optional};

/// The last step of a path, and how the group is reached from which it leads.
struct LastStep {
  ChainStep step;
  Reach reach_from = Reach::own;
};

struct Claim {
  Region region;         ///< under which it may happen
  std::size_t steps = 0; ///< on a shortest path; 0: the task's own
  LastStep last; ///< of that path, which may only lead on: by a request of a group that its requester needs anyway
  std::optional<LastStep> held; ///< of the first path by which it is held; empty: it only leads on
};

/// One edge down from a group, and the states with which it can be used.
struct Branch {
  GroupId to{};
  bool by_need = false;
  bool mandatory = false, optional = false; ///< levels of a request; a need is neither
  bool needed_too = false; ///< a request of a group that the provider needs: it is held by the need already
  Span span{};
  Region region;
};

/// How long a request counts. It belongs to the group: if this changes to another provider, that one has it until it
/// requests something itself.
enum class Requested {
  by_provider, ///< while the provider is active that requests it
  by_group     ///< while any provider of its group is
};

/// The edges down from each group, found on first use.
class Branches {
public:
  using Filter = std::function<bool(ProviderId)>;
  /// Which providers count: those that may run for a task, or at least be chosen for a need. `is_pushed`: those that
  /// may also be active because of a push, whatever the states are that they cause; empty: none.
  struct Counted {
    Filter runs, is_picked, is_pushed;
    Requested requested = Requested::by_provider;
  };
  Branches(const Model& model, Counted counted);
  Branches(const Model& model, const Filter& counts) : Branches(model, {counts, counts, {}}) {}
  Requested requested() const { return counted_.requested; }
  const Model& model() const { return model_; }
  const std::vector<Branch>& from(GroupId group) const;
  /// The states with which some counted provider of the group can be active.
  const Region& grantable(GroupId group) const;
  /// The same while this provider of its group runs, and requests only this pack; null: nothing. These must outlive it.
  Branches with(ProviderId id, const Pack* pack) const;

private:
  /// Of one group it has these, and of the others those of `all`.
  struct Only {
    const Branches& all;
    GroupId group{};
    std::vector<Branch> from;
    Region grantable;
  };
  Branches(const Model& model, Counted counted, Only only);

  const Model& model_;
  Counted counted_;
  std::optional<Only> only_;
  mutable IdTable<GroupId, std::optional<std::vector<Branch>>> from_;
  mutable IdTable<GroupId, std::optional<Region>> grantable_;
};

class Claims {
public:
  /// Ends the search early. Called with a group, how it is reached, and its claim, which may still grow.
  using Enough = std::function<bool(GroupId, Reach, const Claim&)>;

  /// Only over groups that are not in `without`.
  Claims(const Branches& branches, GroupId task, const std::vector<GroupId>& without = {}, const Enough& enough = {});

  /// Null: it never claims the group in this way.
  const Claim* find(GroupId group, Reach reach) const {
    const Claim* out = on_path(group, reach);
    return out != nullptr && out->held ? out : nullptr;
  }
  /// Also one that only leads on.
  const Claim* on_path(GroupId group, Reach reach) const {
    const auto& claims = claims_[static_cast<std::size_t>(reach)];
    const auto at = claims.find(group);
    return at == claims.end() ? nullptr : &at->second;
  }
  /// Under which it holds the group, which `find` finds: less than the claim's region where it only leads on under
  /// others. Only by Requested::by_group; else the whole region.
  const Region& held_region(GroupId group, Reach reach) const;
  /// All claimed groups, in order.
  const std::vector<GroupId>& groups() const { return groups_; }
  bool contains(GroupId group) const { return std::binary_search(groups_.begin(), groups_.end(), group); }
  /// How many edges were followed.
  std::size_t effort() const { return effort_; }
  /// A shortest path to the group, of those by which it is held; empty for the task's own.
  std::vector<ChainStep> path(GroupId group, Reach reach) const;
  /// The same by the first reach in which it claims the group; empty if there is none.
  std::vector<ChainStep> path(GroupId group) const;

private:
  void add_held(const Branch& branch, Reach reach, const Claim* before, const Region& region);

  std::unordered_map<GroupId, Claim> claims_[3];
  std::map<std::pair<Reach, GroupId>, std::optional<Region>> held_; ///< where it is not the claim's region
  std::vector<GroupId> groups_;
  std::size_t effort_ = 0;
};

/// The claims of each task, found on first use.
class ClaimsCache {
public:
  explicit ClaimsCache(const Branches& branches) : branches_(branches), claims_(branches.model().groups.size()) {}
  const Claims& of(GroupId task) const;

private:
  const Branches& branches_;
  mutable IdTable<GroupId, std::unique_ptr<const Claims>> claims_;
};

} // namespace director::analysis
