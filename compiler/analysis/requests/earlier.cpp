// Header: compiler/analysis/requests/earlier.hpp. Test: tests/compiler/analysis/requests/earlier_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/requests/earlier.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace director::analysis {

namespace {

/// Limit for the requests that are followed upwards for one question; there may be exponentially many paths.
constexpr std::size_t most_followed = 256;

} // namespace

std::vector<Region> Earlier::before(ProviderId provider, const Box& box) const {
  if (facts_.pushed.contains(provider)) return {};
  Region around;
  for (const auto& [state, possible] : box) {
    if (!possible.unset) around.meet(state, possible.values);
  }
  const auto counts = [&](const Rival& rival) {
    const auto faults = facts_.impossible_of(rival.provider);
    return facts_.plans[rival.provider] == PlanVerdict::found &&
           std::all_of(faults.begin(), faults.end(), [](const Impossible& fault) { return fault.stay; });
  };
  std::vector<Region> out;
  for (Rival& rival : rivals_.that_meet(provider, around, counts)) {
    if (counts(rival)) std::move(rival.ways.begin(), rival.ways.end(), std::back_inserter(out));
  }
  return out;
}

bool Earlier::may_exist(const Request& request, const Box& box) const {
  Search search;
  return may_exist(request, box, search);
}

bool Earlier::may_exist(const Request& request, const Box& box, Search& search) const {
  if (!request.requester || ++search.steps > most_followed) return true;
  const GroupId group = model_.providers[*request.requester].group;
  if (std::find(search.path.begin(), search.path.end(), group) != search.path.end()) return false;
  const std::vector<Request>& above = requests_.of(group);
  for (const Region& region : requests_.regions(request)) {
    Box here = box;
    if (!meet(facts_, here, region)) continue;
    const std::size_t taken = search.taken.size();
    for (Region& each : before(*request.requester, here)) search.taken.push_back(std::move(each));
    bool found =
        search.taken.empty() || find_covering(model_, facts_.values, here, search.taken, budget_) != Covering::covered;
    if (found && !above.empty()) {
      search.path.push_back(group);
      found =
          std::any_of(above.begin(), above.end(), [&](const Request& each) { return may_exist(each, here, search); });
      search.path.pop_back();
    }
    search.taken.resize(taken);
    if (found) return true;
  }
  return false;
}

} // namespace director::analysis
