#pragma once
// SPDX-License-Identifier: MIT
// Finds out whether two entries of one list of tasks compete at equal rank: what both may want, and by which chains.

#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/conflicts/takers.hpp"
#include "compiler/analysis/shared/shared.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace director::analysis {

/// A task that is blocked while the other one has the group, and would push for its condition if it went before that:
/// the two exclude each other, but not for good.
struct BlockedPusher {
  bool second = false; ///< by the first task; else the first by the second
  GroupId task{};      ///< the last one of its chain that is requested
  const Want* want = nullptr;
};

/// A group that two tasks may want at the same time, at equal rank, with both chains.
struct Contest {
  GroupId group{};
  Reach first = Reach::own, second = Reach::own;
  std::size_t steps = 0;
  std::vector<ChainStep> first_path, second_path;
  std::optional<BlockedPusher> unpushed; ///< if their conditions exclude each other
};

/// What the first one may hold while it waits for the contested group, and what the second one, which holds that, waits
/// for.
struct MutualWait {
  GroupId held{};
  std::vector<ChainStep> first_path, second_path; ///< to what is held
};

/// The group that two tasks want, and the priority that both have.
using Stake = std::pair<GroupId, std::int32_t>;

/// Two entries of one list and what they compete for.
struct Rivalling {
  Meeting meeting;
  Contest contest;
  std::optional<MutualWait> mutual_wait;
  std::vector<Stake> stakes; ///< all that they may compete for
};

/// For all pairs of a behaviour: their cost is counted together.
class Contests {
public:
  Contests(const Model& model, const Shared& shared, Takers& takers)
      : model_(model),
        shared_(shared),
        takers_(takers) {}

  /// One contest for a pair, at all its levels. `first`: the winner if both are requested at once.
  std::optional<Rivalling> look_at(const Together& together, const Task& first, const Task& second);
  /// The same for two levels, the first of which is a member of a unit that is tried at a place of equal rank. Only
  /// what is granted with the unit is tried there.
  std::optional<Rivalling> look_at_place(const Meeting& meeting);

private:
  /// A task's claim for the contested group, and all others of that task.
  struct Side {
    const Claims& claims;
    const Claim* claim = nullptr; ///< null: it does not claim it
    Reach reach = Reach::own;
  };
  /// The last step before a contested group on the first chain, and what is known above it.
  struct Above {
    bool leads_through = false;    ///< the second chain leads through it
    std::optional<Claims> without; ///< what the second task reaches without it
  };
  /// Of one pair, by that step, if there is one: many groups depend on the same one.
  using Lookups = std::map<std::tuple<bool, GroupId, Reach>, Above>;

  /// The groups that the entry may hold while its requester runs.
  const Claims& claims(const Meeting& meeting, const Task& entry) const;
  bool match(const Meeting& meeting, const Side& first, const Side& second, Contest& contest) const;
  std::optional<BlockedPusher> find_unpushed(GroupId group, const Side& waiting, const Region& other) const;
  std::vector<Contest> find_candidates(const Meeting& meeting) const; ///< whatever their priorities
  std::optional<Contest> find(const Meeting& meeting, const std::vector<Contest>& candidates);
  std::optional<MutualWait> find_mutual_wait(const Meeting& meeting, const std::vector<Contest>& candidates,
                                             const Contest& contest);
  std::set<GroupId> held_before(const std::vector<ChainStep>& chain) const;
  bool find_paths(const Meeting& meeting, Contest& contest, Lookups& lookups);
  void leave_open(const Meeting& meeting);

  const Model& model_;
  const Shared& shared_;
  Takers& takers_;
  std::size_t effort_ = 0;
  bool is_open_ = false;
};

} // namespace director::analysis
