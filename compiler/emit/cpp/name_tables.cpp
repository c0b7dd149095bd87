// Header: compiler/emit/cpp/parts.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
//
// The names for the numbers in an observer's events.
#include "compiler/emit/cpp/parts.hpp"
#include "compiler/lower/level_names.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

void table(Code& code, std::string_view word, const std::vector<std::string>& names) {
  std::vector<std::string> quoted;
  for (const std::string& name : names) quoted.push_back(fmt::format("\"{}\"", name));
  code.blank();
  code.open(fmt::format("const char* {}(director::Index row) {{", word));
  code.list(fmt::format("static constexpr std::array<const char*, {}> all{{", quoted.size()), quoted, "};");
  code.line("return name_at(all, row);");
  code.close("}");
}

void level_uses(Code& code, const CppEmission& e) {
  std::vector<std::string> rows;
  for (const LevelUse& use : director::compiler::level_uses(e.model, e.from.lowered)) {
    const std::string provider = use.provider == nil ? "director::nil" : std::to_string(use.provider);
    rows.push_back(fmt::format("{{{}, {}, {}, {}, \"{}\", \"{}\"}}", use.edge, use.level, provider, use.pack,
                               use.pack_name, use.name));
  }
  code.list(fmt::format("static constexpr std::array<director::LevelUse, {}> uses{{{{", rows.size()), rows, "}};");
}

void values(Code& code, const Model& model) {
  code.blank();
  code.open("const char* value(director::Index state, std::int32_t number) {");
  code.line("if (number == director::unset) return \"unset\";");
  code.line("switch (state) {");
  for (const StateId id : model.states.ids()) {
    const State& state = model.states[id];
    if (state.is_range) continue;
    code.open(fmt::format("case {}: {{", id.value));
    std::vector<std::string> quoted;
    for (const std::string& value : state.values) quoted.push_back(fmt::format("\"{}\"", value));
    code.list(fmt::format("static constexpr std::array<const char*, {}> all{{", quoted.size()), quoted, "};");
    code.line("return name_at(all, static_cast<std::size_t>(number));");
    code.close("}");
  }
  code.line("default: return \"\";");
  code.line("}");
  code.close("}");
}

} // namespace

Code name_declarations(const CppEmission&) {
  Code code;
  code.block(R"(/// The names of the rows in a director::Event; empty if there is no such row.
namespace names {
const char* group(director::Index row);
const char* provider(director::Index row);  ///< `halting`; `default` if the group declares the provider directly
const char* edge(director::Index row);      ///< `root>Walk`
const char* state(director::Index row);
const char* value(director::Index state, std::int32_t number); ///< `unset` too; empty for a number of a range
const char* trigger(director::Index row);
const char* condition(director::Index row); ///< `Stability == standing`
const char* level(director::Index row);     ///< of other than root tasks empty for the first one
using director::name_of;                    // of kinds of events and inputs, of reasons, and why something does not run

/// All of them, for printers of events of any behaviour.
const director::Names& all();

/// The answer of `why` as one line of text. Written into `buffer`, cut off where that is too small.
const char* why(const director::Because& because, std::span<char> buffer);
} // namespace names
)");
  return code;
}

Code name_definitions(const CppEmission& e) {
  std::vector<std::string> groups, providers, edges, states, triggers, conditions;
  for (const Group& group : e.model.groups) groups.push_back(group.name.value);
  for (const Provider& provider : e.model.providers) providers.push_back(provider.name);
  for (const EdgeId edge : e.model.edges.ids()) edges.push_back(e.model.edge_name(edge));
  for (const State& state : e.model.states) states.push_back(state.name.value);
  for (const Trigger& trigger : e.model.triggers) triggers.push_back(trigger.name);
  for (const ConditionId id : e.from.lowered.condition_ids) conditions.push_back(e.model.conditions[id].text);
  Code code;
  code.line("namespace names {");
  code.line("namespace {");
  code.line("template <std::size_t count>");
  code.open("const char* name_at(const std::array<const char*, count>& all, std::size_t row) {");
  code.line("return row < count ? all[row] : \"\";");
  code.close("}");
  code.line("} // namespace");
  table(code, "group", groups);
  table(code, "provider", providers);
  table(code, "edge", edges);
  table(code, "state", states);
  values(code, e.model);
  table(code, "trigger", triggers);
  table(code, "condition", conditions);
  table(code, "level", level_names(e.model, e.from.lowered));
  code.blank();
  std::vector<std::string> functions{".self = nullptr"};
  const auto add = [&](std::string_view word) {
    functions.push_back(fmt::format(".{} = [](const void*, director::Index row) {{ return {}(row); }}", word, word));
  };
  for (const std::string_view word : {"group", "provider", "edge", "condition"}) add(word);
  code.open("const char* why(const director::Because& because, std::span<char> buffer) {");
  code.list("static constexpr director::Names some{", functions, "};");
  code.line("return director::to_text(because, some, buffer);");
  code.close("}");
  code.blank();
  add("state");
  functions.emplace_back(
      ".value = [](const void*, director::Index row, std::int32_t number) { return value(row, number); }");
  add("trigger");
  add("level");
  functions.emplace_back(".tables = &rows");
  functions.push_back(fmt::format(".behaviour = \"{}\"", e.model.name));
  functions.emplace_back(".level_uses = uses");
  code.open("const director::Names& all() {");
  level_uses(code, e);
  code.list("static constexpr director::Names every{", functions, "};");
  code.line("return every;");
  code.close("}");
  code.blank();
  code.line("} // namespace names");
  return code;
}

} // namespace director::compiler
