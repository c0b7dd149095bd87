// Header: compiler/checks/code_check.hpp. Test: compiler/checks/handler_without_provider.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/code_check.hpp"
#include "dsl/lexical/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace director::checks {

namespace {

/// `soccer::Walk::Gone`, of `const soccer::Walk::Gone& run`.
std::string type_in(const std::string& wrote) {
  std::string type = wrote.substr(0, wrote.find('&'));
  if (type.starts_with("const ")) type.erase(0, 6);
  type.erase(std::remove(type.begin(), type.end(), ' '), type.end());
  return type;
}

/// The group whose name in C++ stands in front of the last `::`.
std::optional<GroupId> group_in(const Model& model, const std::string& type) {
  const std::size_t end = type.rfind("::");
  if (end == std::string::npos) return {};
  const std::string before = type.substr(0, end);
  const std::size_t colons = before.rfind("::");
  const std::string name = colons == std::string::npos ? before : before.substr(colons + 2);
  for (const GroupId id : model.groups.ids()) {
    if (dsl::capitalised(model.groups[id].name.value) == name) return id;
  }
  return {};
}

/// Functions that others call, or may call.
std::set<std::string_view> called_functions(const CodeFacts& code) {
  std::set<std::string_view> out;
  for (const CodeFunction& function : code.functions) {
    for (const CodeCall& call : function.calls) {
      if (call.to != function.key) out.insert(call.to);
    }
  }
  return out;
}

} // namespace

void handler_without_provider(const CodeInput& input, Findings& findings) {
  const Model& model = input.model;
  const std::set<std::string_view> called = called_functions(input.code);
  for (const CodeClass& each : input.code.classes) {
    for (const CodeClass::Stray& stray : each.stray) {
      if (called.count(stray.key) > 0) continue;
      const auto of = input.names.contexts.find(stray.context);
      if (!stray.context.empty() && of == input.names.contexts.end()) continue; // of another behaviour
      if (!stray.context.empty()) {
        const std::string name = name_of(model, of->second);
        const Module& module = model.modules[model.groups[of->second.group].module];
        if (!stray.unlike.empty()) {
          dsl::Diagnostic& finding =
              findings.add(stray.span, fmt::format("nothing calls this body for {}: {}, so it overrides nothing", name,
                                                   stray.unlike));
          finding.notes.push_back({span_of(model, of->second), fmt::format("{} is here", name)});
          finding.help = fmt::format("declare it as `{}`", declaration_of(of->second, stray.context));
          continue;
        }
        dsl::Diagnostic& finding = findings.add(
            stray.span,
            fmt::format("nothing calls this body for {}: it belongs to the module `{}`, which `{}` does not "
                        "implement here",
                        name, module.name, each.name));
        finding.notes.push_back({span_of(model, of->second), fmt::format("{} is here", name)});
        finding.help = fmt::format("move it into the class that implements `{}`", module.name);
        continue;
      }
      const std::string type = type_in(stray.wrote);
      const std::optional<GroupId> group = group_in(model, type);
      if (!group) continue; // its purpose is unknown
      dsl::Diagnostic& finding =
          findings.add(stray.span, fmt::format("the behaviour has nothing for this body: there is no `{}`", type));
      finding.notes.push_back({model.groups[*group].name.span, fmt::format("{} is here", name_of(model, *group))});
      finding.help = "remove it, or declare in the behaviour what it is for";
    }
  }
}

} // namespace director::checks
