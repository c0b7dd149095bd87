// Door: compiler/checks/check.hpp. Test: compiler/checks/unused_causing.md.
// SPDX-License-Identifier: MIT
#include "compiler/checks/analysis/shared.hpp"
#include "compiler/checks/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <set>

namespace director::checks {

void unused_causing(const Input& input, Findings& findings) {
  const Model& model = input.model;
  std::set<dsl::Span> waited;
  for (const Graph::Causing& arrow : input.graph.causing) waited.insert(arrow.promise.span);
  for (const Imprecise& fault : input.shared.imprecise()) waited.insert(fault.promise.span); // waited for, and told of
  for (const ProviderId id : model.providers.ids()) {
    for (const ConditionUse& use : model.providers[id].causing) {
      if (waited.count(use.span) != 0) continue;
      findings.add(use.span, fmt::format("nothing waits for {}", name_of(model, use.id))).help =
          "what a provider sets without a promise to anybody stands in `sets`";
    }
  }
}

} // namespace director::checks
