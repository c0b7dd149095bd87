// Header: compiler/stubs/leftovers.hpp. Test: tests/compiler/stubs/leftovers_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/stubs/leftovers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler::stubs {

namespace {

const WantedModule* module_of(const Wanted& wanted, const FoundFunction& row) {
  for (const WantedModule& module : wanted.modules) {
    for (const WantedFunction& function : module.functions)
      if (function.context == row.context && name_of(function.kind) == row.name) return &module;
  }
  return nullptr;
}

/// Interfaces of the behaviour that the class of a function implements. None if its interface is gone too.
std::vector<std::string> interfaces_of(const Found& found, const FoundFunction& row) {
  const auto at = std::find_if(found.classes.begin(), found.classes.end(),
                               [&](const FoundClass& type) { return type.place == row.class_place; });
  return at == found.classes.end() ? std::vector<std::string>{} : at->interfaces;
}

} // namespace

std::vector<Remark> leftovers(const Wanted& wanted, const Found& found) {
  std::vector<Remark> out;
  const std::string prefix = wanted.name_space + "::";
  for (const FoundFunction& row : found.functions) {
    const std::vector<std::string> interfaces = interfaces_of(found, row);
    const bool concerns = row.context.starts_with(prefix) || row.context.starts_with("::" + prefix);
    const bool ours = !interfaces.empty() || (concerns && (row.overrides || !row.within));
    if (!ours || (row.known && !concerns)) continue;
    const WantedModule* const module = row.known ? module_of(wanted, row) : nullptr;
    if (module != nullptr && row.for_any) continue;
    const bool served = module != nullptr && std::count(interfaces.begin(), interfaces.end(), module->interface) > 0;
    if (served) continue;
    const std::string why = module != nullptr
                                ? fmt::format("it belongs to the module {}, `{}`", module->name, module->interface)
                                : fmt::format("{} has no such provider or handler", wanted.behaviour);
    out.push_back({row.place, fmt::format("`{}({}&)` of `{}` is left over: {}", row.name, row.context, row.of, why)});
  }
  return out;
}

} // namespace director::compiler::stubs
