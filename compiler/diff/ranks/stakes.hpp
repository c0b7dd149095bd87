#pragma once
// SPDX-License-Identifier: MIT
// What the tasks of one of two compared behaviours may come to hold and may push: what is decided by an order of
// declaration, where it is decided by nothing else.

#include "compiler/analysis/chains/claims.hpp"
#include "compiler/diff/side.hpp"
#include "compiler/diff/ranks/takes_by_name.hpp"
#include "compiler/pipeline.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace director::compiler::diff {

/// What the order of two tasks of equal rank decides if they are requested at once.
struct Stake {
  std::vector<bool> groups;     ///< by number: both may want it at the same time, and the first one gets it
  std::set<std::string> pushed; ///< each of the two may push another provider of it
  bool empty() const { return pushed.empty() && std::find(groups.begin(), groups.end(), true) == groups.end(); }
};

class Stakes {
public:
  /// All have to outlive it.
  Stakes(const Checked& checked, const Possible& possible, const TakesByName& takes);
  Stakes(const Stakes&) = delete;
  Stakes& operator=(const Stakes&) = delete;

  Stake between(const Edge& one, const Edge& other);

private:
  void add(const Edge& one, const Level& a, const Edge& other, const Level& b, Stake& out);
  /// A unit is tried at the place of its first member: this one's unit, against one that is apart.
  void add_led(const Edge& leader, const Level& level, const Place& place, const Edge& rival, Stake& out);
  bool has_choice(GroupId task) const;
  /// The providers that a task and those below it may push. `optional`: with something optional on the chain to the
  /// task that pushes.
  const std::set<ProviderId>& pushed_by(GroupId task, bool is_optional, bool optional);

  const Model& model_;
  const Graph& graph_;
  const TakesByName& takes_;
  const bool is_closed_; ///< it has roots: all requests are known
  const analysis::Facts& facts_;
  const analysis::Branches branches_;
  const analysis::ClaimsCache claims_{branches_};
  const std::map<GroupId, std::set<ProviderId>>& pushes_; ///< by the group that waits
  std::map<std::tuple<GroupId, bool, bool>, std::set<ProviderId>> pushed_by_;
};

} // namespace director::compiler::diff
