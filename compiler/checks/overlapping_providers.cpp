// Header: compiler/checks/check.hpp. Test: compiler/checks/overlapping_providers.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

namespace {

/// Where both can run, each state by itself; empty: nowhere.
std::optional<Region> find_overlap(const Input& input, ProviderId a, ProviderId b) {
  const Model& model = input.model;
  Region out = region_of(model, model.providers[a].when);
  out.meet(region_of(model, model.providers[b].when));
  for (const auto& [state, values] : out.states) {
    if (!values.overlaps(input.facts.values[state])) return std::nullopt;
  }
  return out;
}

std::string overlap_in_words(const Input& input, const Region& overlap) {
  std::vector<std::string> things;
  for (const auto& [state, values] : overlap.states)
    things.push_back(
        fmt::format("{} is {}", name_of(input.model, state),
                    values_in_words(input.model.states[state], values.intersected(input.facts.values[state]))));
  return list_of(things);
}

/// Whether the second one can run wherever the first one can, but not the reverse: the first is more specific, so its
/// place before the second is intended.
bool is_special_case(const Model& model, const Provider& first, const Provider& second) {
  const Region narrow = region_of(model, first.when), wide = region_of(model, second.when);
  return narrow.states != wide.states && std::all_of(wide.states.begin(), wide.states.end(), [&](const auto& entry) {
           const auto at = narrow.states.find(entry.first);
           return at != narrow.states.end() && at->second.subset_of(entry.second);
         });
}

void look_at(const Input& input, ProviderId later, Findings& findings) {
  const Model& model = input.model;
  const Provider& row = model.providers[later];
  dsl::Diagnostic* finding = nullptr;
  for (const ProviderId earlier : model.groups[row.group].providers) {
    if (earlier == later) break;
    const Provider& preferred = model.providers[earlier];
    if (preferred.when.empty() || !input.facts.active.contains(earlier)) continue;
    const auto overlap = find_overlap(input, earlier, later);
    if (!overlap || is_special_case(model, preferred, row)) continue;
    const std::string where = overlap_in_words(input, *overlap);
    if (finding == nullptr) {
      finding = &findings.add(row.when.front().span,
                              fmt::format("{} and {} can both run while {}: the one that is written first is preferred",
                                          name_of(model, earlier), name_of(model, later), where));
      finding->help = "where the order is not meant to decide, write in `when` the conditions that distinguish them";
    } else {
      finding->notes.push_back({preferred.when.front().span,
                                fmt::format("{} is preferred as well, while {}", name_of(model, earlier), where)});
      continue;
    }
    finding->notes.push_back({preferred.when.front().span, fmt::format("{} is preferred", name_of(model, earlier))});
  }
}

} // namespace

void overlapping_providers(const Input& input, Findings& findings) {
  for (const ProviderId id : input.model.providers.ids()) {
    // A provider without conditions is the fallback: its place at the end is intended.
    if (!input.model.providers[id].when.empty() && input.facts.active.contains(id)) look_at(input, id, findings);
  }
}

} // namespace director::checks
