// Header: compiler/cli/input/named_groups.hpp. Test: tests/compiler/cli/commands/graph_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/input/named_groups.hpp"

#include "compiler/play/scenario/names.hpp"

#include <fmt/format.h>

namespace director::compiler::cli {

std::optional<std::vector<GroupId>> named_groups(const std::vector<std::string>& names, std::string_view option,
                                                 const Model& model, Console& console) {
  std::vector<GroupId> out;
  for (const std::string& name : names) {
    std::vector<dsl::Diagnostic> findings;
    const std::optional<GroupId> group = Names(model, findings).group({name, {}});
    if (group) {
      out.push_back(*group);
      continue;
    }
    const dsl::Diagnostic& wrong = findings.front();
    print_message(console, fmt::format("directorc: {}: {}{}\n", option, wrong.message,
                                       wrong.help.empty() ? "" : "; " + wrong.help));
    return {};
  }
  return out;
}

std::optional<std::vector<GroupId>> named_rows(const std::vector<std::string>& names, const Model& model,
                                               Console& console) {
  std::optional<std::vector<GroupId>> out = named_groups(names, "--transitions", model, console);
  if (!out) return {};
  for (const GroupId id : *out) {
    if (!model.groups[id].edges.empty()) continue;
    print_message(console, fmt::format("directorc: --transitions: `{}` requests and needs nothing, so it has no row or "
                                       "column in the matrix; name a group that requests or needs it\n",
                                       model.groups[id].name.value));
    return {};
  }
  return out;
}

} // namespace director::compiler::cli
