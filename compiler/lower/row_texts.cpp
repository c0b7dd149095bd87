// Header: compiler/lower/row_texts.hpp. Test: tests/compiler/cli/commands/trace_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/lower/row_texts.hpp"

namespace director::compiler {

namespace {

const char* text_at(const std::vector<std::string>& texts, std::size_t place) {
  return place < texts.size() ? texts[place].c_str() : "";
}

template <std::vector<std::string> RowTexts::*all>
const char* find(const void* self, Index row) {
  return text_at(static_cast<const RowTexts*>(self)->*all, row);
}

const char* find_value(const void* self, Index state, std::int32_t number) {
  if (number == unset) return "unset";
  return text_at(static_cast<const RowTexts*>(self)->values[state], static_cast<std::size_t>(number));
}

} // namespace

void RowTexts::add(LevelUse use) {
  use.pack_name = kept_.emplace(use.pack_name).first->c_str();
  use.name = kept_.emplace(use.name).first->c_str();
  level_uses.push_back(use);
}

director::Names RowTexts::names(const Tables& tables) const {
  return {.self = this,
          .group = &find<&RowTexts::groups>,
          .provider = &find<&RowTexts::providers>,
          .edge = &find<&RowTexts::edges>,
          .condition = &find<&RowTexts::conditions>,
          .state = &find<&RowTexts::states>,
          .value = &find_value,
          .trigger = &find<&RowTexts::triggers>,
          .level = &find<&RowTexts::levels>,
          .tables = &tables,
          .behaviour = behaviour.c_str(),
          .level_uses = level_uses};
}

} // namespace director::compiler
