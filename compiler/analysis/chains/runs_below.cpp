// Header: compiler/analysis/chains/runs_below.hpp. Test: tests/compiler/analysis/chains/claims_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/chains/runs_below.hpp"

#include <algorithm>
#include <iterator>

namespace director::analysis {

namespace {

bool may_use(const Claims& claims, GroupId from, const Branch& branch) {
  return std::any_of(std::begin(all_reaches), std::end(all_reaches), [&](Reach reach) {
    const Claim* claim = claims.on_path(from, reach);
    return claim != nullptr && compatible(claim->region, branch.region);
  });
}

} // namespace

RunsBelow::RunsBelow(const Branches& branches, const Claims& claims, GroupId task) : task_(task) {
  std::vector<GroupId> open{task};
  last_.emplace(task, ChainStep{});
  for (std::size_t next = 0; next < open.size(); ++next) {
    const GroupId from = open[next];
    for (const Branch& branch : branches.from(from)) {
      if (branch.by_need || !claims.contains(branch.to) || !may_use(claims, from, branch)) continue;
      if (last_.emplace(branch.to, ChainStep{from, branch.to, false, branch.span}).second) open.push_back(branch.to);
    }
  }
}

std::vector<GroupId> RunsBelow::groups() const {
  std::vector<GroupId> out;
  for (const auto& [group, step] : last_) out.push_back(group);
  return out;
}

std::vector<ChainStep> RunsBelow::path(GroupId group) const {
  std::vector<ChainStep> out;
  for (GroupId at = group; at != task_; at = out.back().from) out.push_back(last_.at(at));
  std::reverse(out.begin(), out.end());
  return out;
}

} // namespace director::analysis
