#pragma once
// SPDX-License-Identifier: MIT
// Whether two entries of one list of tasks compete at equal rank: what both may want, and how each comes to it.

#include "compiler/analysis/chains/meetings.hpp"
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

/// A group that two tasks may want at the same time, at equal rank, and how each comes to it.
struct Contest {
  GroupId group{};
  Reach first = Reach::own, second = Reach::own;
  std::size_t steps = 0;
  std::vector<ChainStep> first_path, second_path;
};

/// What the first one may hold while it waits for the group of the contest, and the second one waits for that while it
/// holds the group of the contest.
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
  std::vector<Stake> stakes; ///< all that it may be about
};

/// For all pairs of a behaviour: what they cost is counted together.
class Contests {
public:
  Contests(const Model& model, const Shared& shared) : model_(model), shared_(shared) {}

  /// One for a pair, whatever its levels. `first`: who wins if both ask at once.
  std::optional<Rivalling> look_at(const Together& together, const Task& first, const Task& second);

private:
  /// The last step before a contested group on the first one's way, and what is known of what is above that.
  struct Above {
    bool leads_through = false;    ///< the second one is there
    std::optional<Claims> without; ///< what the second one comes to by none of it
  };
  /// Of one pair, by whether there is such a step, and from where and how it goes: many groups hang on the same one.
  using Lookups = std::map<std::tuple<bool, GroupId, Reach>, Above>;

  /// What the entry may come to hold while who requests it runs.
  const Claims& claims(const Meeting& meeting, const Task& entry) const;
  std::vector<Contest> find_candidates(const Meeting& meeting) const;
  std::optional<Contest> find(const Meeting& meeting, const std::vector<Contest>& candidates);
  std::optional<MutualWait> find_mutual_wait(const Meeting& meeting, const std::vector<Contest>& candidates,
                                             const Contest& contest);
  std::set<GroupId> held_before(const std::vector<ChainStep>& chain) const;
  bool find_paths(const Meeting& meeting, Contest& contest, Lookups& lookups);
  void leave_open(const Meeting& meeting);

  const Model& model_;
  const Shared& shared_;
  std::size_t effort_ = 0;
  bool is_open_ = false;
};

} // namespace director::analysis
