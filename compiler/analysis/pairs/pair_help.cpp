// Header: compiler/analysis/pairs/pair_help.hpp. Test: compiler/checks/possible_pack_conflict.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/pairs/pair_help.hpp"

#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace director::analysis {

namespace {

bool waits_for(const Model& model, const Task& waiting, const Task& causing) {
  const std::vector<ProviderId>& causers = model.groups[causing.target].providers;
  const auto is_promised = [&](const ConditionUse& use) {
    return std::any_of(causers.begin(), causers.end(), [&](ProviderId id) { return model.causes(id, use.id); });
  };
  const std::vector<ProviderId>& waiters = model.groups[waiting.target].providers;
  return std::any_of(waiters.begin(), waiters.end(), [&](ProviderId id) {
    return std::any_of(model.providers[id].when.begin(), model.providers[id].when.end(), is_promised);
  });
}

bool is_requested_elsewhere(const Input& input, const Task& task) {
  return input.shared.requests().of(task.target).size() > 1;
}

/// It goes first then, and a unit goes as early as its first member.
std::string set_apart(const Model& model, const Pack& pack, const Task& task, const Task& other) {
  const auto priority = [&](const Task& one) {
    return model.edges[one.edge].levels[one.levels.front().level].priority;
  };
  const std::vector<const Task*> members = unit_members(model, pack);
  const std::string apart = fmt::format("make {} `apart`", name_of(model, task.target));
  if (std::all_of(members.begin(), members.end(),
                  [&](const Task* one) { return one == &task || priority(*one) < priority(task); }))
    return apart;
  return members.size() == 2 ? fmt::format("{}, with a higher priority than {}", apart, name_of(model, other.target))
                             : apart + ", with the highest priority here";
}

/// The providers that never run even alone, since others of their group come first.
std::vector<std::string> find_superfluous(const Input& input, const Side& side) {
  std::vector<std::string> out;
  std::set<ProviderId> useful;
  for (std::size_t i = 0; i < side.ways.size(); ++i) {
    if (comes_first(input, side.ways, i)) useful.insert(side.ways[i].provider());
  }
  for (const ProviderId id : input.model.groups[side.task.target].providers) {
    const bool is_tried =
        std::any_of(side.ways.begin(), side.ways.end(), [&](const Way& way) { return way.provider() == id; });
    if (!is_tried && is_requested_elsewhere(input, side.task)) continue;
    if (input.facts.active.contains(id) && useful.count(id) == 0) out.push_back(name_of(input.model, id));
  }
  return out;
}

/// The providers without which the two do not clash, if there are such, and neither task is requested elsewhere.
std::vector<std::string> find_left_out(const Input& input, const Sides& sides, const ClashingWays& clash) {
  std::vector<std::string> out;
  if (is_requested_elsewhere(input, sides.first.task) || is_requested_elsewhere(input, sides.second.task)) return out;
  std::vector<Way> first = sides.first.ways, second = sides.second.ways;
  std::vector<ProviderId> losers = clash.losers;
  while (!losers.empty()) {
    const auto is_it = [&](const Way& way) { return way.provider() == losers.front(); };
    out.push_back(name_of(input.model, losers.front()));
    first.erase(std::remove_if(first.begin(), first.end(), is_it), first.end());
    second.erase(std::remove_if(second.begin(), second.end(), is_it), second.end());
    const auto next = PairSearch(input, {{sides.first.task, first}, {sides.second.task, second}}).run();
    if (!next) return out;
    losers = next->losers;
  }
  return {};
}

} // namespace

std::string apart_to_be_pushed(const Model& model, const Task& a, const Task& b) {
  for (const auto& [waiting, causing] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    if (waits_for(model, *waiting, *causing))
      return fmt::format("make {} `apart`, with a lower priority than {}", name_of(model, causing->target),
                         name_of(model, waiting->target));
  }
  return {};
}

std::string propose(const Input& input, const Pack& pack, const Sides& sides, const ClashingWays& clash) {
  const Model& model = input.model;
  const Side& first = sides.first;
  const Side& second = sides.second;
  if (std::string help = apart_to_be_pushed(input.model, first.task, second.task); !help.empty()) return help;
  std::vector<std::string> out;
  if (find_superfluous(input, second).empty() &&
      leaves_all(input, second.ways, first.ways, is_requested_elsewhere(input, first.task))) {
    out.push_back(set_apart(model, pack, second.task, first.task));
  } else if (find_superfluous(input, first).empty() &&
             leaves_all(input, first.ways, second.ways, is_requested_elsewhere(input, second.task))) {
    out.push_back(set_apart(model, pack, first.task, second.task));
  }
  const bool of_first =
      std::find(clash.losers.begin(), clash.losers.end(), clash.first->provider()) != clash.losers.end();
  const Side& changed = of_first ? first : second;
  const Side& other = of_first ? second : first;
  const std::string provider = name_of(model, (of_first ? clash.first : clash.second)->provider());
  if (find_superfluous(input, changed).empty() && run_beside(input, changed.ways, other.ways)) {
    std::vector<std::string> groups;
    for (const GroupId each : groups_in_common(*clash.first, *clash.second)) groups.push_back(name_of(model, each));
    out.push_back(
        fmt::format("give {} needs that leave {} to {}", provider, list_of(groups), name_of(model, other.task.target)));
  } else if (const std::vector<std::string> left_out = find_left_out(input, sides, clash); !left_out.empty()) {
    out.push_back(fmt::format("leave {} out", list_of(left_out)));
  }
  std::vector<std::string> superfluous; // alone
  for (const Side* side : {&first, &second}) {
    for (std::string& each : find_superfluous(input, *side)) superfluous.push_back(std::move(each));
  }
  const bool elsewhere = is_requested_elsewhere(input, first.task) || is_requested_elsewhere(input, second.task);
  if (out.empty() || (out.size() == 1 && (superfluous.empty() || !elsewhere)))
    out.push_back("request the two in two packs" +
                  (superfluous.empty() ? "" : fmt::format(" and leave {} out", list_of(superfluous))));
  return fmt::format("{}", fmt::join(out, ", or "));
}

} // namespace director::analysis
