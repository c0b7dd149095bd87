// Door: compiler/checks/check.hpp. Test: compiler/checks/unused_causing.md.
#include "compiler/checks/analysis/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

void unused_causing(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const ProviderId id : model.providers.ids()) {
    for (const ConditionUse& use : model.providers[id].causing) {
      const bool waited =
          std::any_of(input.graph.causing.begin(), input.graph.causing.end(),
                      [&](const Graph::Causing& arrow) { return arrow.causer == id && arrow.promise.id == use.id; });
      if (waited) continue;
      findings.add(use.span, fmt::format("nothing waits for {}", name_of(model, use.id))).help =
          "what a provider sets without a promise to anybody stands in `sets`";
    }
  }
}

} // namespace director::checks
