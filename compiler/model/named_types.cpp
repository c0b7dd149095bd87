// Header: compiler/model/named_types.hpp. Test: tests/compiler/model/resolve/types_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/named_types.hpp"

#include <algorithm>

namespace director::compiler {

namespace {

void add_once(std::vector<std::string>& list, const std::string& word) {
  if (std::find(list.begin(), list.end(), word) == list.end()) list.push_back(word);
}

} // namespace

std::optional<TypeReader::Question> named_types(const dsl::Spec& spec, bool thorough) {
  if (spec.files.empty()) return {};
  TypeReader::Question out;
  const dsl::BehaviourSpec& main = spec.files.back();
  out.name_space = main.cpp.name_space ? main.cpp.name_space->value : main.name.value;
  bool needed = thorough;
  for (const dsl::BehaviourSpec& file : spec.files) {
    for (const dsl::Word& header : file.cpp.headers) add_once(out.headers, header.value);
    for (const dsl::StateSpec& state : file.states) {
      if (!state.type) continue;
      add_once(out.names, state.type->value);
      needed = needed || (!state.values && !state.range);
    }
    for (const dsl::GroupSpec& group : file.groups) {
      if (group.data) add_once(out.names, group.data->value);
    }
  }
  if (!needed || (out.names.empty() && (!thorough || out.headers.empty()))) return {};
  return out;
}

} // namespace director::compiler
