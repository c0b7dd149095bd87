#pragma once
// SPDX-License-Identifier: MIT
// Finds the order between tasks (semantics.md, 4.1, rules 1 to 4): two tasks meet below their closest common requester,
// at two entries of one pack, of one flat list, or of the roots, and the ranks of these two decide.

#include "compiler/analysis/chains/sparse_set.hpp"
#include "compiler/graph/dominators.hpp"
#include "compiler/model/model.hpp"

#include <functional>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace director::analysis {

using namespace director::compiler;

/// Entries that may be requested at the same time.
struct Together {
  std::optional<ProviderId> provider; ///< empty: the roots
  const std::vector<Task>* tasks = nullptr;
  std::string_view pack; ///< empty for roots and flat `tasks`
  bool whole = false;    ///< a named pack: with one of them all mandatory ones are requested
};

/// Every pack and list of these providers, and the roots, first.
std::vector<Together> find_together(const Model& model, const std::function<bool(ProviderId)>& counts);

/// Two entries and one level of each.
struct Meeting {
  const Together* together = nullptr;
  const Task* first = nullptr;
  const Task* second = nullptr;
  Level first_level, second_level;
  bool first_optional = false; ///< some edge of the first chain is, from this entry down
  bool second_optional = false;

  /// Whether they are members of one unit: granted together or not at all.
  bool one_unit() const { return together->provider && first_level.shares_unit() && second_level.shares_unit(); }
  bool first_goes_before() const {
    if (first_optional != second_optional) return second_optional;
    return first_level.priority > second_level.priority;
  }
  bool equal() const { return first_optional == second_optional && first_level.priority == second_level.priority; }
};

/// The groups that chains of requests lead to, if each provider of a chain is one of those that count.
class Chains {
public:
  /// An entry from which a chain leads to a group: without an optional edge below it, with one, or both.
  struct Entry {
    const Together* together = nullptr;
    const Task* task = nullptr;
    bool mandatory = false, optional = false;
  };

  enum class End {
    requested, ///< the group is requested
    held,      ///< or only needed
    pushing    ///< it is needed by a group that was itself granted by a request: a group that is only needed pushes
               ///< nothing
  };
  /// Only in places that request something else too, in order of place and task.
  const std::vector<Entry>& entries_above(GroupId group, End end = End::requested) const;

  Chains(const Model& model, std::function<bool(ProviderId)> counts);

  /// Visits every way in which a task for `waiter` and a request for one of `others` meet.
  void visit(GroupId waiter, const std::vector<GroupId>& others,
             const std::function<void(const Meeting&, GroupId other)>& visitor) const;

  /// Whether a task for `waiter` may push the other group: an edge requests that group which the task may go before,
  /// and which is not granted in one unit with the task or with what is above it. True for itself if another requester
  /// requests it too. `by_optional`: for something to which it leads by an optional request.
  bool may_beat(GroupId waiter, GroupId other, bool by_optional = false) const;

  /// Whether every chain to the group, of requests and needs, passes the other one.
  bool always_below(GroupId group, GroupId other) const;

  const std::vector<Together>& together() const { return together_; }

private:
  /// A group from which a chain leads to another one.
  struct Above {
    GroupId group{};
    bool optional = false; ///< an edge between the two is
    bool direct = false;   ///< it requests the group itself, in the sense of End::pushing
  };
  std::vector<Above> above(GroupId group, End end) const;
  bool beats(const Entry& waiting, const Entry& entry, GroupId other, bool by_optional) const;
  /// The entries beside this one that lead to one of `others`, in order of the entries.
  std::vector<std::pair<const Entry*, GroupId>> siblings(const Together& together, const Task& task, GroupId waiter,
                                                         const std::vector<GroupId>& others) const;
  void visit_pair(Meeting& meeting, bool optional_above, const Entry& second, GroupId other,
                  const std::function<void(const Meeting&, GroupId other)>& visitor) const;

  const Model& model_;
  std::function<bool(ProviderId)> counts_;
  std::vector<Together> together_;
  std::vector<std::vector<std::pair<const Together*, const Task*>>> entries_; ///< by target
  mutable std::unordered_map<GroupId, std::vector<Entry>> entries_above_[3];
  mutable std::optional<DominatorTree> below_;
};

} // namespace director::analysis
