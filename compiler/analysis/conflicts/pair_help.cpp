// Header: compiler/analysis/conflicts/pair_help.hpp. Test: compiler/checks/possible_pack_conflict.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/pair_help.hpp"

#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
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

} // namespace

std::string apart_to_be_pushed(const Model& model, const Task& a, const Task& b) {
  for (const auto& [waiting, causing] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    if (waits_for(model, *waiting, *causing))
      return fmt::format("make {} `apart`, with a lower priority than {}", name_of(model, causing->target),
                         name_of(model, waiting->target));
  }
  return {};
}

} // namespace director::analysis
