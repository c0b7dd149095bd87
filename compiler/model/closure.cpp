// Header: compiler/model/closure.hpp. Test: tests/compiler/model/closure_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/closure.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace director::compiler {

namespace {

/// `next`: calls its second argument with each group that the first one leads to.
template <class Next>
void close_over(std::vector<GroupId>& groups, const Next& next) {
  std::unordered_set<GroupId> seen;
  const std::vector<GroupId> first = std::exchange(groups, {});
  const auto add = [&](GroupId group) {
    if (seen.insert(group).second) groups.push_back(group);
  };
  for (const GroupId group : first) add(group);
  for (std::size_t i = 0; i < groups.size(); ++i) next(groups[i], add);
}

} // namespace

void add_needed(const Model& model, std::vector<GroupId>& groups) {
  close_over(groups, [&](GroupId group, const auto& add) {
    for (const ProviderId id : model.groups[group].providers) {
      for (const Use<GroupId>& need : model.providers[id].needs) add(need.id);
    }
  });
}

std::vector<GroupId> needed_by(const Model& model, GroupId group) {
  std::vector<GroupId> out{group};
  add_needed(model, out);
  out.erase(out.begin());
  std::sort(out.begin(), out.end());
  return out;
}

void add_led_to(const Model& model, std::vector<GroupId>& groups) {
  close_over(groups, [&](GroupId group, const auto& add) {
    for (const EdgeId edge : model.groups[group].edges) add(model.edges[edge].target);
  });
}

} // namespace director::compiler
