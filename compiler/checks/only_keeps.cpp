// Header: compiler/checks/code_check.hpp. Test: compiler/checks/only_keeps.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/code/code_words.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/code_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

namespace {

/// A requester whose body depends on whether this group is done; null: there is none.
const Use<GroupId>* waiter(const Model& model, GroupId group) {
  for (const Provider& provider : model.providers) {
    for (const Use<GroupId>& use : provider.uses) {
      if (use.id == group) return &use;
    }
  }
  return nullptr;
}

} // namespace

void only_keeps(const CodeInput& input, Findings& findings) {
  const Model& model = input.model;
  for (const Body& body : input.bodies) {
    if (!body.of.provider || !body.is_whole() || body.is_unwritten() || !only_keeps_going(body)) continue;
    const Provider& provider = model.providers[*body.of.provider];
    const bool may_request =
        std::any_of(provider.packs.begin(), provider.packs.end(), [](const Pack& pack) { return !pack.tasks.empty(); });
    const Use<GroupId>* use = waiter(model, body.of.group);
    // A group that acts while it is requested, and that nothing waits for, needs no other answer.
    if (!may_request && use == nullptr) continue;
    dsl::Diagnostic& finding = findings.add(
        provider.span, fmt::format("every path of {} ends in `keep()`: it never {}", name_of(model, body.of),
                                   may_request ? "requests anything, and is never done" : "says that it is done"));
    finding.help = may_request ? "let it request its tasks, or leave them out of the behaviour"
                               : "let it say `done()`, or leave the group out of `uses`";
    finding.notes.push_back({body.function->span, "its body"});
    if (!may_request)
      finding.notes.push_back({use->span, fmt::format("{} is looked at here", name_of(model, body.of.group))});
  }
}

} // namespace director::checks
