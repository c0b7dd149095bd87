// Header: compiler/analysis/words/proposals.hpp. Test: tests/compiler/checks/helps_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/proposals.hpp"

#include <algorithm>

namespace director::analysis {

using namespace director::compiler;

std::string put_last(const Model& model, ProviderId id, const std::function<bool(const ConditionUse&)>& removed) {
  const Provider& provider = model.providers[id];
  const bool is_last = model.groups[provider.group].providers.back() == id;
  if (is_last || !provider.needs.empty() || !std::all_of(provider.when.begin(), provider.when.end(), removed))
    return {};
  return ", and put it last";
}

} // namespace director::analysis
