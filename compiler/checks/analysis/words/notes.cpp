// Door: compiler/checks/analysis/words/notes.hpp. Test: compiler/checks/equal_priority.md.
#include "compiler/checks/analysis/words/notes.hpp"

#include "compiler/checks/analysis/states/sources.hpp"
#include "compiler/checks/analysis/words/words.hpp"

#include <fmt/format.h>

namespace director::checks {

using dsl::Note;

void add_chain(const Model& model, const std::vector<ChainStep>& chain, std::vector<Note>& notes, Note::Link begins) {
  for (const ChainStep& step : chain) {
    notes.push_back({step.span,
                     fmt::format("{} {} {}", name_of(model, step.from), step.by_need ? "needs" : "requests",
                                 name_of(model, step.to)),
                     begins});
    begins = Note::Link::next;
  }
}

dsl::Note causes(const Model& model, ProviderId causer, ConditionId condition) {
  const ConditionUse& promise = promise_of(model, causer, condition);
  return {promise.span, fmt::format("{} causes {}", name_of(model, causer), name_of(model, promise.id))};
}

dsl::Note runs_only_while(const Model& model, ProviderId provider, const ConditionUse& condition) {
  return {condition.span, fmt::format("{} runs only while {}", name_of(model, provider), name_of(model, condition.id))};
}

} // namespace director::checks
