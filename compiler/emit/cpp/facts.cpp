// Header: compiler/emit/cpp/cpp.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
//
// What the C++ compiler needs of the behaviour: numbers of rows, and what each body may request.
#include "compiler/emit/cpp/cpp.hpp"
#include "compiler/emit/cpp/parts.hpp"
#include "runtime/core/base/state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace director::compiler {

namespace {

bool has_data(const CppEmission& e, GroupId group) { return !e.model.groups[group].data.empty(); }

/// The members of Data, and functions that select them by the type of a task. No base classes: with thousands of bases
/// a C++ compiler takes minutes for one class.
void data_facts(Code& code, const CppEmission& e) {
  std::vector<bool> is_root(e.model.groups.size(), false);
  for (const Task& root : e.model.roots) is_root[root.target.value] = true;
  std::vector<GroupId> with_data;
  for (const GroupId id : e.model.groups.ids())
    if (has_data(e, id)) with_data.push_back(id);
  code.comment("The data of all tasks: those of requests, and those that wait in the inbox.");
  if (with_data.empty()) {
    code.line("struct Data final {};");
    return code.blank();
  }
  code.open("struct Data final {");
  for (const GroupId id : with_data) {
    const std::string name = group_in(e.model, id);
    code.line(fmt::format("director::Slots<{}, {}> slots_{};", name, std::max(1U, data_places(e.model, id)), id.value));
    if (is_root[id.value]) code.line(fmt::format("director::Waiting<{}> waiting_{};", name, id.value));
  }
  code.line("template <class Task>");
  code.open("auto& of() {");
  code.line("return this->*Facts<Task>::slots;");
  code.close("}");
  code.line("template <class Task>");
  code.open("auto& waiting() {");
  code.line("return this->*Facts<Task>::waiting;");
  code.close("}");
  code.close("};");
  for (const GroupId id : with_data) {
    code.line("template <>");
    code.open(fmt::format("struct Facts<{}> {{", group_in(e.model, id)));
    code.line(fmt::format("{} auto slots = &Data::slots_{};", own_constant, id.value));
    if (is_root[id.value]) code.line(fmt::format("{} auto waiting = &Data::waiting_{};", own_constant, id.value));
    code.close("};");
  }
  code.blank();
}

void setting(Code& code, const CppEmission& e, StateId id) {
  const State& state = e.model.states[id];
  const std::string type = state_in(e.model, id);
  code.open(fmt::format("static constexpr director::Setting setting({} value) {{", type));
  if (state.type) {
    code.line("switch (value) {");
    for (std::size_t i = 0; i < state.values.size(); ++i) {
      code.line(fmt::format("case {}::{}: return {{{}, {}}};", type, state.values[i], id.value, i),
                state.value_spans[i]);
    }
    code.line("}");
    code.line(fmt::format("return {{{}, director::unset}};", id.value));
  } else if (state.is_range) {
    code.line(fmt::format("return {{{}, value.value}};", id.value));
  } else {
    code.line(fmt::format("return {{{}, static_cast<std::int32_t>(value)}};", id.value));
  }
  code.close("}");
}

void state_facts(Code& code, const CppEmission& e) {
  std::vector<std::string> rows;
  for (const StateId id : e.model.states.ids())
    rows.push_back(fmt::format("director::Row<{}, {}>", state_in(e.model, id), id.value));
  const bool typed = std::any_of(e.model.states.begin(), e.model.states.end(), [](const State& s) { return !!s.type; });
  if (typed) {
    code.comment("An enumerator that the behaviour does not list is an error in `setting`.", "//");
    code.line("#pragma GCC diagnostic push");
    code.line("#pragma GCC diagnostic error \"-Wswitch\"");
  }
  code.open_list("struct States final : director::Table<", rows, "> {");
  code.open(fmt::format("{} std::array<director::Domain, {}> domains{{{{", own_constant, rows.size()));
  for (const State& state : e.model.states) {
    code.line(fmt::format("{{.low = {}, .high = {}, .external = {}}}, // {}", state.low, state.high, state.external,
                          state.name.value));
  }
  code.close("}};");
  for (const StateId id : e.model.states.ids()) setting(code, e, id);
  code.close("};");
  if (typed) code.line("#pragma GCC diagnostic pop");
  code.blank();
}

void whole_facts(Code& code, const CppEmission& e) {
  const auto [groups, provider_count, edges, conditions, states, promises, plan_slots, listen_slots, most_edges,
              components, lacking, pushable, altered] = Shape::of(e.tables);
  const std::size_t externals = static_cast<std::size_t>(
      std::count_if(e.model.states.begin(), e.model.states.end(), [](const State& s) { return s.external; }));
  const std::size_t widest_input = std::max(externals, e.model.roots.size());
  code.comment("The behaviour as a whole.");
  code.open("struct Whole final {");
  code.list(fmt::format("{} director::Shape shape{{", own_constant),
            {fmt::format(".groups = {}", groups), fmt::format(".providers = {}", provider_count),
             fmt::format(".edges = {}", edges), fmt::format(".conditions = {}", conditions),
             fmt::format(".states = {}", states), fmt::format(".promises = {}", promises),
             fmt::format(".plan_slots = {}", plan_slots), fmt::format(".listen_slots = {}", listen_slots),
             fmt::format(".most_edges = {}", most_edges), fmt::format(".components = {}", components),
             fmt::format(".lacking = {}", lacking), fmt::format(".pushable = {}", pushable),
             fmt::format(".altered = {}", altered)},
            "};");
  code.line("static const director::Tables& tables();");
  code.line("static std::uint64_t fingerprint();");
  code.line("static void called_from_inside();");
  code.line(fmt::format("static constexpr std::size_t inbox_cells = {};",
                        std::max(std::size_t{64}, std::bit_ceil(2 * widest_input))));
  std::vector<std::string> places, roots, triggers, providers, group_rows;
  for (const EdgeId id : e.model.edges.ids()) places.push_back(std::to_string(data_place(e.model, id)));
  for (const Task& root : e.model.roots) roots.push_back(member_text(e, root));
  for (const TriggerId id : e.model.triggers.ids()) {
    if (!e.model.triggers[id].promise)
      triggers.push_back(fmt::format("director::Row<{}, {}>", trigger_in(e.model, id), id.value));
  }
  for (const ProviderId id : e.model.providers.ids())
    providers.push_back(fmt::format("director::Row<{}, {}>", provider_in(e.model, id), id.value));
  code.list(fmt::format("{} std::array<std::uint16_t, {}> places{{", own_constant, places.size()), places, "};");
  code.line("using Data = detail::Data;");
  code.line("using States = detail::States;");
  code.list("using Roots = director::Pack<", roots, ">;");
  code.list("using Triggers = director::Table<", triggers, ">;");
  code.list("using Providers = director::Table<", providers, ">;");
  for (const GroupId id : e.model.groups.ids())
    group_rows.push_back(fmt::format("director::Row<{}, {}>", group_in(e.model, id), id.value));
  code.list("using Groups = director::Table<", group_rows, ">;");
  code.close("};");
  code.blank();
}

void sets_facts(Code& code, const CppEmission& e, const std::vector<const ConditionUse*>& uses) {
  std::vector<std::string> rows;
  for (const ConditionUse* use : uses) {
    const Condition& condition = e.model.conditions[use->id];
    for (const ValueSet::Interval& interval : condition.accepts.intervals())
      rows.push_back(fmt::format("{{{}, {}, {}}}", condition.state.value, interval.low, interval.high));
  }
  if (rows.empty()) return;
  code.list(fmt::format("{} std::array<director::Allowed, {}> sets{{{{", own_constant, rows.size()), rows, "}};");
}

std::vector<const ConditionUse*> settable(const Provider& provider) {
  std::vector<const ConditionUse*> uses;
  for (const ConditionUse& use : provider.causing) uses.push_back(&use);
  for (const ConditionUse& use : provider.sets) uses.push_back(&use);
  return uses;
}

std::vector<const ConditionUse*> settable(const Handler& handler) {
  std::vector<const ConditionUse*> uses;
  for (const ConditionUse& use : handler.sets) uses.push_back(&use);
  return uses;
}

void open_facts(Code& code, const CppEmission& e, GroupId group, const std::string& context) {
  const std::string task = group_in(e.model, group);
  code.line("template <>");
  code.open(fmt::format("struct Facts<{}::{}> : director::NothingDeclared {{", task, context));
  code.line("using Behaviour = Whole;");
  code.line(fmt::format("using Module = {};", module_in(e.model, e.model.groups[group].module)));
  code.line(fmt::format("using Task = {};", task));
}

void handler_facts(Code& code, const CppEmission& e, GroupId group, const std::optional<Handler>& handler,
                   const std::string& context) {
  if (!handler) return;
  open_facts(code, e, group, context);
  sets_facts(code, e, settable(*handler));
  code.close("};");
}

void packs_facts(Code& code, const CppEmission& e, const Provider& provider) {
  std::vector<std::string> types, names;
  code.line("static constexpr bool flat = false;");
  for (const Pack& pack : provider.packs) {
    std::vector<std::string> members;
    for (const Task& task : pack.tasks) members.push_back(member_text(e, task));
    types.push_back(fmt::format("pack_{}", types.size()));
    names.push_back(fmt::format("\"{}\"", pack.name));
    code.list(fmt::format("using {} = director::Pack<", types.back()), members, ">;");
  }
  code.list("using Packs = director::Packs<", types, ">;");
  code.list(fmt::format("{} std::array<const char*, {}> pack_names{{", own_constant, names.size()), names, "};");
}

void provider_facts(Code& code, const CppEmission& e, ProviderId id) {
  const Provider& provider = e.model.providers[id];
  open_facts(code, e, provider.group, context_name(provider));
  sets_facts(code, e, settable(provider));
  std::vector<std::string> uses, triggers, tasks;
  for (const Use<GroupId>& use : provider.uses) {
    std::string edge = "director::nil"; // it neither requests nor needs it
    for (const EdgeId to : e.model.groups[provider.group].edges) {
      if (e.model.edges[to].target == use.id) edge = std::to_string(to.value);
    }
    uses.push_back(fmt::format("director::Row<{}, {}>", group_in(e.model, use.id), edge));
  }
  for (const Use<TriggerId>& trigger : provider.triggers)
    triggers.push_back(fmt::format("director::Row<{}, {}>", trigger_in(e.model, trigger.id), trigger.id.value));
  if (!uses.empty()) code.list("using Uses = director::Table<", uses, ">;");
  if (!triggers.empty()) code.list("using Triggers = director::Table<", triggers, ">;");
  if (provider.has_packs) {
    packs_facts(code, e, provider);
  } else if (!provider.packs.empty()) {
    for (const Task& task : provider.packs.front().tasks) tasks.push_back(member_text(e, task));
    code.list("using Tasks = director::Pack<", tasks, ">;");
  }
  code.close("};");
}

} // namespace

Code facts(const Deployment& deployment) {
  const CppEmission e{deployment};
  Code code = first_lines(e);
  code.comment("", "//");
  code.comment(fmt::format("What the C++ compiler must know of the behaviour: rows of tables, and what each body may "
                           "request. Only {} includes it, behind the types that it is about.",
                           header_name(e.model.name)),
               "//");
  code.line("#pragma once");
  code.blank();
  code.line(fmt::format("namespace {} {{", e.model.name_space));
  code.blank();
  for (const ModuleId id : e.model.modules.ids()) code.line(fmt::format("class {};", module_type(e.model, id)));
  code.blank();
  code.line("namespace detail {");
  code.blank();
  code.line("template <class Of>");
  code.line("struct Facts;");
  data_facts(code, e);
  state_facts(code, e);
  whole_facts(code, e);
  for (const GroupId id : e.model.groups.ids()) {
    const Group& group = e.model.groups[id];
    handler_facts(code, e, id, group.start, "Start");
    handler_facts(code, e, id, group.stop, "Stop");
    for (const ProviderId provider : group.providers) provider_facts(code, e, provider);
  }
  code.blank();
  code.line("} // namespace detail");
  code.blank();
  code.line(fmt::format("}} // namespace {}", e.model.name_space));
  return code;
}

} // namespace director::compiler
