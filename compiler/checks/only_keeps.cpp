// Header: compiler/checks/code_check.hpp. Test: compiler/checks/only_keeps.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/code/code_words.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/code_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

namespace director::checks {

namespace {

struct Reader {
  ProviderId provider{};
  dsl::Span span{}; ///< of the group, in `uses`
};

/// The first provider whose body may read whether this group is done.
std::optional<Reader> reader_of(const Model& model, GroupId group) {
  for (const ProviderId id : model.providers.ids()) {
    for (const Use<GroupId>& use : model.providers[id].uses) {
      if (use.id == group) return Reader{id, use.span};
    }
  }
  return std::nullopt;
}

} // namespace

void only_keeps(const CodeInput& input, Findings& findings) {
  const Model& model = input.model;
  for (const Body& body : input.bodies) {
    if (!body.of.provider || !body.is_whole() || body.is_unwritten() || !only_keeps_going(body)) continue;
    const Provider& provider = model.providers[*body.of.provider];
    const bool may_request =
        std::any_of(provider.packs.begin(), provider.packs.end(), [](const Pack& pack) { return !pack.tasks.empty(); });
    const std::optional<Reader> reader = reader_of(model, body.of.group);
    // A group that acts while it is requested, and that nothing waits for, needs no other answer.
    if (!may_request && !reader) continue;
    dsl::Diagnostic& finding = findings.add(
        provider.span, fmt::format("every path of {} ends in `keep()`: it never {}", name_of(model, body.of),
                                   may_request ? "requests anything, and is never done" : "says that it is done"));
    finding.notes.push_back({body.function->span, "its body"});
    if (may_request) {
      finding.help = "let it request its tasks, or leave them out of the behaviour";
    } else {
      const std::string by = name_of(model, reader->provider);
      const std::string group = name_of(model, body.of.group);
      finding.help =
          fmt::format("let it say `done()`; or `allow` this here, if {} reads only whether {} runs", by, group);
      finding.notes.push_back({reader->span, fmt::format("{} may read here whether {} is done", by, group)});
    }
  }
}

} // namespace director::checks
