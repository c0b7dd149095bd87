// Header: compiler/emit/cpp/parts.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
//
// The interfaces that a program implements, one for each module.
#include "compiler/emit/cpp/parts.hpp"

#include <fmt/format.h>

namespace director::compiler {

Code modules_part(const CppEmission& e) {
  Code code;
  code.comment("Modules: what the program implements", "//");
  code.blank();
  for (const ModuleId id : e.model.modules.ids()) {
    const std::string name = module_type(e.model, id);
    code.open(fmt::format("class {} {{", name));
    code.outdented("public:");
    for (const GroupId group_id : e.model.modules[id].groups) {
      const Group& group = e.model.groups[group_id];
      const std::string task = group_name(e.model, group_id);
      if (group.start) code.line(fmt::format("virtual void start({}::Start& run) = 0;", task), group.start->span);
      if (group.stop) code.line(fmt::format("virtual void stop({}::Stop& run) = 0;", task), group.stop->span);
      for (const ProviderId provider : group.providers) {
        code.line(fmt::format("virtual director::Outcome provide({}& run) = 0;", provider_name(e.model, provider)),
                  e.model.providers[provider].span);
      }
    }
    code.blank();
    code.outdented("protected:");
    code.line(fmt::format("~{}() = default; // not virtual: no object is deleted through this interface", name));
    code.close("};");
    code.blank();
  }
  return code;
}

} // namespace director::compiler
