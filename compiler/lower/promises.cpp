// Header: compiler/lower/steps.hpp. Test: tests/compiler/lower/lower_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/lower/steps.hpp"

namespace director::compiler {

namespace {

Index trigger_of_promise(const Model& model, ProviderId provider) {
  for (const TriggerId id : model.triggers.ids()) {
    if (model.triggers[id].promise == provider) return row(id);
  }
  return nil;
}

} // namespace

void lower_promises(const Model& model, Lowered& out) {
  std::vector<std::vector<Index>> listeners(model.triggers.size());
  for (const ProviderId id : model.providers.ids()) {
    const Provider& provider = model.providers[id];
    Range& promises = out.providers[id.value].promises;
    promises.begin = static_cast<Index>(out.promises.size());
    for (const ConditionUse& promise : provider.causing) {
      if (!promise.within) continue;
      out.promises.push_back(
          {row(id), *condition_row(out, promise.id), *promise.within, trigger_of_promise(model, id)});
    }
    promises.end = static_cast<Index>(out.promises.size());
    for (const Use<TriggerId>& trigger : provider.triggers) {
      std::vector<Index>& rows = listeners[trigger.id.value];
      if (rows.empty() || rows.back() != row(id)) rows.push_back(row(id));
    }
  }
  for (const std::vector<Index>& rows : listeners) out.triggers.push_back({add_list(out, rows)});
}

} // namespace director::compiler
