// Header: compiler/analysis/requests/gaps.hpp. Test: tests/compiler/analysis/requests/gaps_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/requests/gaps.hpp"

#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::analysis {

namespace {

/// Limit: more would not help the reader.
constexpr std::size_t most_boxes = 256;
/// A group with more different ways to run is assumed to be always able to run.
constexpr std::size_t most_open_ways = 512;
/// The same for a provider with more combinations of its own ways and those of its needs.
constexpr std::size_t most_combined = 4'096;

/// The number of boxes that subtract adds, without computing them: each is as large as the region.
std::size_t count_outside(const Box& box, const Region& region) {
  std::size_t out = 0;
  for (const auto& [state, accepted] : region.states) {
    const auto at = box.find(state);
    const Possible here = at == box.end() ? Possible{} : at->second;
    if (!here.values.subset_of(accepted) || here.unset) ++out;
    if (!here.values.overlaps(accepted)) return out;
  }
  return out;
}

/// The parts of the box that are outside the region.
void subtract(const Box& box, const Region& region, std::vector<Box>& out) {
  Box rest = box;
  for (const auto& [state, accepted] : region.states) {
    Possible& here = rest[state];
    const Possible outside{here.values.without(accepted), here.unset};
    here = {here.values.intersected(accepted), false};
    if (outside.empty()) continue;
    const Possible inside = here;
    here = outside;
    out.push_back(rest);
    rest[state] = inside;
    if (inside.empty()) return;
  }
}

/// Adds a way unless another one includes it.
void add_way(std::vector<Region>& ways, Region way) {
  if (way.empty()) return;
  if (std::any_of(ways.begin(), ways.end(), [&](const Region& other) { return contains(other, way); })) return;
  ways.erase(std::remove_if(ways.begin(), ways.end(), [&](const Region& other) { return contains(way, other); }),
             ways.end());
  ways.push_back(std::move(way));
}

/// Merges two ways that differ only in what they accept of one state.
void unite(std::vector<Region>& ways) {
  std::vector<Region> out;
  for (Region& way : ways) {
    const auto same = std::find_if(out.begin(), out.end(), [&](const Region& other) {
      if (other.states.size() != way.states.size()) return false;
      std::size_t different = 0;
      auto b = other.states.begin();
      for (const auto& [state, values] : way.states) {
        if (state != b->first) return false;
        if (values != b->second) ++different;
        ++b;
      }
      return different == 1;
    });
    if (same == out.end()) {
      out.push_back(std::move(way));
      continue;
    }
    for (auto& [state, values] : same->states) values = values.united(way.states.at(state));
  }
  ways = std::move(out);
}

/// If there are too many to list.
Gaps find_one_gap(const Model& model, const Facts& facts, const Box& start, const std::vector<Region>& ways,
                  Budget& budget) {
  Box gap;
  switch (find_covering(model, facts.values, start, ways, budget, &gap)) {
  case Covering::covered: return {};
  case Covering::open: return {{std::move(gap)}, false, true};
  case Covering::undecided: break;
  }
  return {{}, false, false};
}

} // namespace

Possible& possible_in(const Model& model, const Facts& facts, StateId state, Box& box) {
  return box.try_emplace(state, Possible{facts.values[state], model.states[state].may_be_unset()}).first->second;
}

bool meet(const Facts& facts, Box& box, const Region& region) {
  for (const auto& [state, accepted] : region.states) {
    Possible& here = box.try_emplace(state, Possible{facts.values[state], false}).first->second;
    here = {here.values.intersected(accepted), false};
    if (here.empty()) return false;
  }
  return true;
}

Gaps find_gaps(const Model& model, const Facts& facts, const Box& start, const std::vector<Region>& ways,
               Budget& budget) {
  Box whole = start;
  for (const Region& way : ways) {
    for (const auto& [state, accepted] : way.states) possible_in(model, facts, state, whole);
  }
  if (std::any_of(whole.begin(), whole.end(), [](const auto& entry) { return entry.second.empty(); })) return {};
  std::vector<Box> boxes{std::move(whole)};
  for (const Region& way : ways) {
    std::size_t count = 0;
    for (const Box& box : boxes) count += count_outside(box, way);
    if (count > most_boxes) return find_one_gap(model, facts, start, ways, budget);
    std::vector<Box> next;
    for (const Box& box : boxes) subtract(box, way, next);
    boxes = std::move(next);
  }
  return {std::move(boxes)};
}

std::string gap_in_words(const Model& model, const Facts& facts, const Box& box) {
  std::vector<std::string> parts;
  for (const auto& [id, possible] : box) {
    const State& state = model.states[id];
    if (possible == Possible{facts.values[id], state.may_be_unset()}) continue;
    parts.push_back(
        fmt::format("{} is {}", name_of(model, id), values_in_words(state, possible.values, possible.unset)));
  }
  return parts.empty() ? std::string(everywhere) : "while " + list_of(parts);
}

Ways::Ways(const Model& model, const Facts& facts, bool with_stay,
           std::function<bool(ProviderId, const ConditionUse&)> counts)
    : model_(model),
      facts_(facts),
      with_stay_(with_stay),
      counts_(std::move(counts)) {}

const std::vector<Region>& Ways::of(GroupId group, bool with_stay) {
  static const std::vector<Region> always{Region{}};
  if (!facts_.may_wait.contains(group)) return always;
  const auto [at, is_new] = ways_.try_emplace({group, with_stay});
  if (!is_new) return at->second; // in a cycle of needs: no way
  std::vector<Region> out;
  for (const ProviderId id : model_.groups[group].providers) {
    for (Region& way : of(id, with_stay)) add_way(out, std::move(way));
    if (out.size() > most_open_ways) unite(out);
    if (out.size() > most_open_ways) {
      out = {Region{}};
      break;
    }
  }
  return ways_[{group, with_stay}] = std::move(out);
}

std::vector<Region> Ways::of(ProviderId id, bool with_stay) {
  const Provider& provider = model_.providers[id];
  // What another check reports is treated as corrected.
  if (facts_.plans[id] != PlanVerdict::found) return {Region{}};
  const auto region_by = [&](const std::vector<ConditionUse>& uses, bool stay) {
    Region region;
    for (const ConditionUse& use : uses) {
      const Condition& condition = model_.conditions[use.id];
      const auto faults = facts_.impossible_of(id);
      const bool corrected = std::any_of(faults.begin(), faults.end(), [&](const Impossible& fault) {
        return fault.stay == stay && fault.state == condition.state;
      });
      if (!corrected && (stay || counts_(id, use))) region.meet(condition.state, condition.accepts);
    }
    return region;
  };
  std::vector<Region> out;
  add_way(out, region_by(provider.when, false));
  if (with_stay && !provider.stay.empty()) add_way(out, region_by(provider.stay, true));
  for (const Use<GroupId>& need : provider.needs) {
    std::vector<Region> both;
    const bool also = with_stay && is_requested(provider.group, need.id);
    if (out.size() * of(need.id, also).size() > most_combined) return {Region{}};
    for (const Region& own : out) {
      for (const Region& below : of(need.id, also)) {
        Region way = own;
        way.meet(below);
        add_way(both, std::move(way));
      }
    }
    if (both.size() > most_open_ways) unite(both);
    if (both.size() > most_open_ways) return {Region{}};
    out = std::move(both);
  }
  return out;
}

bool Ways::is_requested(GroupId from, GroupId need) const {
  const std::vector<EdgeId>& edges = model_.groups[from].edges;
  return std::any_of(edges.begin(), edges.end(),
                     [&](EdgeId id) { return model_.edges[id].target == need && !model_.edges[id].levels.empty(); });
}

} // namespace director::analysis
