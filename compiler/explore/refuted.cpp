// Header: compiler/explore/refuted.hpp. Test: compiler/checks/assertion_failed.md.
// SPDX-License-Identifier: MIT
#include "compiler/explore/refuted.hpp"

#include <fmt/format.h>

#include <string_view>

namespace director::compiler {

std::vector<dsl::Diagnostic> refuted_assertions(const Model& model, const std::vector<Verdict>& verdicts) {
  std::vector<dsl::Diagnostic> out;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i].kind != Verdict::Kind::refuted) continue;
    const Assertion& assertion = model.assertions[i];
    dsl::Diagnostic finding;
    finding.id = "assertion_failed";
    finding.level = dsl::Level::error;
    finding.span = assertion.span;
    finding.message = fmt::format("`{}` is not true: {}", words_of(assertion, model), verdicts[i].why);
    finding.notes = verdicts[i].notes;
    if (verdicts[i].scenario) {
      finding.help = "`directorc explore FILE --output FOLDER` writes a scenario that shows it";
    } else {
      const std::string& group = model.groups[assertion.groups.front().id].name.value;
      finding.help =
          verdicts[i].explored
              ? fmt::format(
                    "`directorc why SCENARIO {}`, with a scenario that requests it, prints what keeps it from running",
                    group)
              : fmt::format("`directorc check FILE --explain-reachable={}` prints what is missing", group);
    }
    out.push_back(std::move(finding));
  }
  return out;
}

std::vector<std::string> undecided_assertions(const Model& model, const std::vector<Verdict>& verdicts) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i].kind != Verdict::Kind::undecided) continue;
    const std::string_view cure = "; `--bound N` of `directorc explore`, `check`, `generate` and `docs` tries more";
    out.push_back(fmt::format("{}: {}{}", words_of(model.assertions[i], model), verdicts[i].why,
                              verdicts[i].more_states ? cure : ""));
  }
  return out;
}

} // namespace director::compiler
