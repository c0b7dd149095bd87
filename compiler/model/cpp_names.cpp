// Header: compiler/model/cpp_names.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/cpp_names.hpp"

#include "dsl/lexical/names.hpp"

#include <fmt/format.h>

namespace director::compiler {

std::string header_name(std::string_view behaviour) { return fmt::format("{}.hpp", behaviour); }

std::string facts_name(std::string_view behaviour) { return fmt::format("{}.facts.hpp", behaviour); }

std::string type_name(std::string_view name) { return dsl::capitalised(name); }

std::string context_name(const Provider& provider) { return type_name(provider.name); }

std::string group_name(const Model& model, GroupId group) { return type_name(model.groups[group].name.value); }

std::string provider_name(const Model& model, ProviderId provider) {
  const Provider& row = model.providers[provider];
  return fmt::format("{}::{}", group_name(model, row.group), context_name(row));
}

std::string module_type(const Model& model, ModuleId module) { return type_name(model.modules[module].name); }

std::string trigger_type(const Model& model, TriggerId trigger) {
  const Trigger& row = model.triggers[trigger];
  if (row.promise) return fmt::format("director::Broken<{}>", provider_name(model, *row.promise));
  return type_name(row.name);
}

std::string state_type(const Model& model, StateId state) { return type_name(model.states[state].name.value); }

} // namespace director::compiler
