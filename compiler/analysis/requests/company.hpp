#pragma once
// SPDX-License-Identifier: MIT
// Finds what is certainly requested together with a task: by the same pack, or by one above it. Other
// roots count as requested too.

#include "compiler/analysis/chains/sparse_set.hpp"
#include "compiler/analysis/requests/requests.hpp"

#include <map>
#include <optional>
#include <set>
#include <vector>

namespace director::analysis {

/// For a set of groups: whether any of them is certainly requested. Of a flat list any part may be requested, so its
/// entries are no company; but for a mandatory member with a flat list all of that is assumed to be requested.
class Company {
public:
  Company(const Model& model, const Facts& facts, const Requests& requests, std::vector<GroupId> wanted)
      : model_(model),
        facts_(facts),
        requests_(requests),
        wanted_(std::move(wanted)) {
    find_leading();
  }

  /// The entries from this one up to a root that request none of the groups while it waits; empty: there is always one.
  std::vector<const Task*> find_bare_chain(const Request& request);

  /// Two entries of one named pack.
  struct Rank {
    const std::vector<Task>* list = nullptr;
    const Task* waits = nullptr; ///< leads to what waits
    const Task* first = nullptr; ///< certainly leads to a wanted group, and does not rank after it
    /// Instead: their requester needs the only wanted group, and claims it before anything that it requests is tried.
    const Use<GroupId>* need = nullptr;
    std::optional<ProviderId> needer;
  };
  /// The entries, if on some path up the nearest company of this request is of that kind and no other.
  std::optional<Rank> find_outranking(const Request& request);
  /// Whether at no level `a` ranks after `b`, according to their entries.
  static bool goes_first(const Model& model, const Task& a, const Task& b);

  /// Entries that would lead to one, but are granted only together with what waits.
  const std::set<const Task*>& held_back() const { return held_back_; }

  /// The lists in which one was found beside the chains that were examined so far.
  const std::set<const std::vector<Task>*>& found_in() const { return found_in_; }

private:
  void find_leading();
  bool is_wanted(GroupId group) const;
  std::vector<const Task*> find_bare_chain(const Request& request, bool waits);
  bool is_covered(const Request& request, bool waits);
  std::optional<Rank> find_outranking(const Request& request, bool waits);
  bool brings(const Task& entry);
  bool brings_firmly(const Task& entry);
  bool always_requests(GroupId group);

  const Model& model_;
  const Facts& facts_;
  const Requests& requests_;
  std::vector<GroupId> wanted_;
  SparseSet<GroupId> leading_; ///< from which requests lead to a wanted group: few of many roots
  std::set<GroupId> visited_;
  std::map<GroupId, bool> always_, firm_;
  std::set<const std::vector<Task>*> found_in_;
  std::set<const Task*> held_back_;
};

/// Whether none of the groups need be requested where the task is: that is reported there (causer_not_running).
bool need_not_be_requested(const Model& model, const Facts& facts, const Requests& requests, const Request& request,
                           const std::vector<GroupId>& groups);

} // namespace director::analysis
