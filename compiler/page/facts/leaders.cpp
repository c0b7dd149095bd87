// Header: compiler/page/facts/leaders.hpp. Test: tests/compiler/page/facts/ranks_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/page/facts/leaders.hpp"

#include <algorithm>

namespace director::compiler {

const Task* entry_of(const Pack& pack, EdgeId edge) {
  const auto at =
      std::find_if(pack.tasks.begin(), pack.tasks.end(), [&](const Task& task) { return task.edge == edge; });
  return at == pack.tasks.end() ? nullptr : &*at;
}

const Leaders& LeaderFinder::of(const analysis::Decision& decision, bool first) {
  static const Leaders none;
  const analysis::SideRank& own = first ? decision.first : decision.second;
  const analysis::SideRank& rivals = first ? decision.second : decision.first;
  const bool behind = !own.optional && !rivals.optional && own.priority <= rivals.priority;
  if (!decision.requester || !behind) return none;
  const auto [at, fresh] = known_.try_emplace({decision, first});
  if (fresh) at->second = find(decision, first);
  return at->second;
}

Leaders LeaderFinder::find(const analysis::Decision& decision, bool first) const {
  Leaders out{{}, true};
  const EdgeId member = first ? decision.first_sibling : decision.second_sibling;
  const EdgeId rival = first ? decision.second_sibling : decision.first_sibling;
  for (const ProviderId id : model_.groups[*decision.requester].providers) {
    for (const Pack& pack : model_.providers[id].packs)
      look(pack, member, first ? decision.first : decision.second, rival, first ? decision.second : decision.first,
           out);
  }
  std::sort(out.all.begin(), out.all.end());
  out.all.erase(std::unique(out.all.begin(), out.all.end()), out.all.end());
  return out;
}

void LeaderFinder::look(const Pack& pack, EdgeId member, const analysis::SideRank& rank, EdgeId rival,
                        const analysis::SideRank& rivals, Leaders& out) const {
  const auto may_be = [&](const Task& task, std::int32_t priority, auto kind) {
    return model_.any_level(task, [&](const Level& level) { return level.priority == priority && kind(level); });
  };
  const Task *const own = entry_of(pack, member), *const others = entry_of(pack, rival);
  if (own == nullptr || others == nullptr) return;
  const auto in_unit = [](const Level& each) { return each.shares_unit(); };
  const auto alone = [](const Level& each) { return !each.shares_unit(); };
  const auto apart = [](const Level& each) { return each.apart && !each.optional; };
  if (may_be(*own, rank.priority, alone)) out.always = false;
  if (may_be(*others, rivals.priority, in_unit)) out.always = false;
  if (!may_be(*own, rank.priority, in_unit) || !may_be(*others, rivals.priority, apart)) return;
  const bool whole = !pack.name.empty(); // of an unnamed pack any part may be requested
  const Leaders here = analysis::find_leaders(model_, pack.tasks, whole, member, rank.priority, rival, rivals.priority);
  out.all.insert(out.all.end(), here.all.begin(), here.all.end());
  out.always = out.always && here.always;
}

Ways::Ways(const Model& model)
    : model_(model),
      needs_(model.groups.size()),
      all_(model.groups.size()),
      known_(model.groups.size()) {
  for (const Edge& edge : model.edges) {
    if (!edge.requester) continue;
    if (edge.needed) needs_[edge.requester->value].push_back(edge.target.value);
    all_[edge.requester->value].push_back(edge.target.value);
  }
}

const Ways::Paths& Ways::paths(GroupId from) {
  std::optional<Paths>& known = known_[from];
  if (known) return *known;
  Paths out{reachable(needs_, from.value), {}};
  out.needs[from.value] = true;
  std::vector<Node> requested;
  for (const Edge& edge : model_.edges) {
    if (edge.requester && !edge.levels.empty() && out.needs[edge.requester->value])
      requested.push_back(edge.target.value);
  }
  out.asks = reachable(all_, requested);
  for (const Node node : requested) out.asks[node] = true;
  return known.emplace(std::move(out));
}

} // namespace director::compiler
