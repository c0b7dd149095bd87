// Door: compiler/checks/analysis/notes.hpp. Test: compiler/checks/equal_priority.md.
#include "compiler/checks/analysis/notes.hpp"

#include "compiler/checks/analysis/words.hpp"

#include <fmt/format.h>

namespace director::checks {

void add_chain(const Model& model, const std::vector<ClaimStep>& chain, dsl::Diagnostic& finding) {
  for (const ClaimStep& step : chain)
    finding.notes.push_back({step.span, fmt::format("{} {} {}", name_of(model, step.from),
                                                    step.by_need ? "needs" : "requests", name_of(model, step.to))});
}

void add_chain(const Model& model, const std::vector<NeedStep>& chain, dsl::Diagnostic& finding) {
  for (const NeedStep& step : chain)
    finding.notes.push_back(
        {step.span, fmt::format("{} needs {}", name_of(model, step.from), name_of(model, step.to))});
}

} // namespace director::checks
