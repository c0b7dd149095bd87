// Header: compiler/checks/check.hpp. Test: compiler/checks/unreachable_causing.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/promises.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <utility>

namespace director::checks {

void unreachable_causing(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const NeverKept& promise : input.shared.promises().never_kept) {
    if (!promise.pushable) continue;
    dsl::Diagnostic& finding = findings.add(
        promise.promise.span, fmt::format("{} can never run, so nothing ever causes {}", name_of(model, promise.causer),
                                          name_of(model, promise.promise.id)));
    finding.rules_out = {promise.promise.span};
    for (const NeverKept::Waiting& waiting : promise.waiting) {
      finding.rules_out.push_back(waiting.condition.span);
      finding.notes.push_back({waiting.condition.span, fmt::format("{} waits for {}", name_of(model, waiting.provider),
                                                                   name_of(model, waiting.condition.id))});
    }
    auto link = dsl::Note::Link::first;
    Idleness idleness = explain_idle(input, promise.causer);
    for (dsl::Note& note : idleness.notes) {
      note.link = std::exchange(link, dsl::Note::Link::next);
      finding.notes.push_back(std::move(note));
    }
    const GroupId group = model.providers[promise.causer].group;
    if (idleness.deadlock) {
      // It is not the first provider of its group that can run.
      const bool to_push =
          idleness.deadlock->kept->target == group && model.groups[group].providers.front() != promise.causer;
      finding.help = apart_help(model, *idleness.deadlock, to_push);
    } else if (model.groups[group].requesters.empty()) {
      finding.help = fmt::format("request {} wherever the state is waited for, `apart` and with a lower priority: a "
                                 "push never starts a group",
                                 name_of(model, group));
    } else if (!input.facts.requested.contains(group)) {
      finding.help = fmt::format("let something that runs without {}, and ranks after what waits for it, request {}",
                                 name_of(model, promise.promise.id), name_of(model, group));
    } else {
      finding.help = "the last note is what all the others rest on: mend that";
    }
  }
}

} // namespace director::checks
