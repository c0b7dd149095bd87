// Door: compiler/checks/code_check.hpp. Test: compiler/checks/handler_without_provider.md.
#include "compiler/checks/analysis/words/words.hpp"
#include "compiler/checks/code_check.hpp"
#include "dsl/names.hpp"

#include <fmt/format.h>

#include <algorithm>

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

} // namespace

void handler_without_provider(const CodeInput& input, Findings& findings) {
  const Model& model = input.model;
  for (const CodeClass& each : input.code.classes) {
    for (const CodeClass::Stray& stray : each.stray) {
      const auto of = input.names.contexts.find(stray.context);
      if (!stray.context.empty() && of == input.names.contexts.end()) continue; // of another behaviour
      if (!stray.context.empty()) {
        const std::string name = name_of(model, of->second);
        const Module& module = model.modules[model.groups[of->second.group].module];
        dsl::Diagnostic& finding = findings.add(
            stray.span, fmt::format("nobody calls this body for {}: it belongs to the module `{}`, which `{}` does not "
                                    "implement here",
                                    name, module.name, each.name));
        finding.notes.push_back({span_of(model, of->second), fmt::format("{} is here", name)});
        finding.help = fmt::format("move it into the class that implements `{}`", module.name);
        continue;
      }
      const std::string type = type_in(stray.wrote);
      const std::optional<GroupId> group = group_in(model, type);
      if (!group) continue; // nobody knows what it is meant for
      dsl::Diagnostic& finding =
          findings.add(stray.span, fmt::format("the behaviour has nothing for this body: there is no `{}`", type));
      finding.notes.push_back({model.groups[*group].name.span, fmt::format("{} is here", name_of(model, *group))});
      finding.help = "remove it, or declare in the behaviour what it is for";
    }
  }
}

} // namespace director::checks
