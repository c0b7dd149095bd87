// Header: compiler/emit/cpp/parts.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/artefact/notice.hpp"
#include "compiler/emit/cpp/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace director::compiler {

namespace {

/// Names with a capital letter that are declared in `detail`, in base classes of generated classes, or as template
/// parameters around generated code.
constexpr std::array<std::string_view, 37> inner_names{
    "Behaviour", "BehaviourView",   "Bodies", "Body",    "Call",     "Context", "Core",    "Data",
    "Edge",      "Event",           "Facts",  "Fault",   "Given",    "Groups",  "Handler", "Module",
    "More",      "NothingDeclared", "Now",    "Of",      "Pack",     "Packs",   "Post",    "Program",
    "Providers", "Roots",           "Row",    "Slots",   "Snapshot", "States",  "Table",   "Task",
    "Tasks",     "Triggers",        "Uses",   "Waiting", "Whole"};
static_assert(std::is_sorted(inner_names.begin(), inner_names.end()));

std::string from_outside(const Model& model, const std::string& name) {
  return fmt::format("::{}::{}", model.name_space, name);
}

/// The first word of a name with `::` in it, which is the one that is looked up.
std::string_view first_word(std::string_view name) { return name.substr(0, name.find(':')); }

/// `name` is that of a type, with what follows behind `::`.
std::string inside(const Model& model, const std::string& name) {
  const bool hidden = std::binary_search(inner_names.begin(), inner_names.end(), first_word(name));
  return hidden ? from_outside(model, name) : name;
}

/// Whether the context of this provider, or the task type that it is a member of, has another member of that name.
bool hidden_in(const CppEmission& e, const Provider& context, const std::string& name) {
  const std::vector<std::string>& levels = e.levels[context.group];
  if (std::find(levels.begin(), levels.end(), name) != levels.end()) return true;
  const auto& providers = e.model.groups[context.group].providers;
  return std::any_of(context.packs.begin(), context.packs.end(), [&](const Pack& pack) { return pack.name == name; }) ||
         std::any_of(providers.begin(), providers.end(),
                     [&](ProviderId other) { return context_name(e.model.providers[other]) == name; });
}

} // namespace

Code first_lines(const CppEmission& e) {
  Code code;
  code.line(fmt::format("// {}", notice_words(portable_path(e.from, e.model.name_span.file))));
  // Without a licence, which the user chooses for it: docs/faq.md.
  return code;
}

std::string group_in(const Model& model, GroupId group) { return inside(model, group_name(model, group)); }

std::string provider_in(const Model& model, ProviderId provider) {
  return inside(model, provider_name(model, provider));
}

std::string group_in(const CppEmission& e, ProviderId context, GroupId group) {
  const std::string name = group_name(e.model, group);
  return hidden_in(e, e.model.providers[context], name) ? from_outside(e.model, name) : inside(e.model, name);
}

std::string facts_in(const CppEmission& e, ProviderId provider) {
  const Provider& row = e.model.providers[provider];
  const bool hidden = hidden_in(e, row, group_name(e.model, row.group));
  return fmt::format("detail::Facts<{}>",
                     hidden ? from_outside(e.model, provider_name(e.model, provider)) : provider_in(e.model, provider));
}

std::string module_in(const Model& model, ModuleId module) { return inside(model, module_type(model, module)); }

std::string trigger_in(const Model& model, TriggerId trigger) {
  const auto& promise = model.triggers[trigger].promise;
  if (promise) return fmt::format("director::Broken<{}>", provider_in(model, *promise));
  return inside(model, trigger_type(model, trigger));
}

std::string state_in(const Model& model, StateId state) { return inside(model, state_type(model, state)); }

void document(Code& code, const CppEmission& e, std::string_view doc, const dsl::Span& span) {
  while (doc.ends_with('\n')) doc.remove_suffix(1);
  const std::string place = fmt::format("({})", place_text(e.from, span));
  code.comment(doc.empty() ? place : fmt::format("{} {}", doc, place));
}

std::string member_text(const CppEmission& e, const Task& task) {
  const Index first_row = e.tables.edges[task.edge.value].levels.begin;
  const auto row = [&](const Task::NamedLevel& level) { return std::to_string(first_row + level.level); };
  std::string rows = row(task.levels.front());
  std::size_t skipped = 0;
  for (const std::string& name : e.levels[task.target]) {
    const auto* found = static_cast<const Task::NamedLevel*>(nullptr);
    for (const Task::NamedLevel& level : task.levels) {
      if (level.name == name) found = &level;
    }
    if (found == nullptr) {
      ++skipped; // none behind the last existing one
      continue;
    }
    for (; skipped > 0; --skipped) rows += ", director::nil";
    rows += ", " + row(*found);
  }
  return fmt::format("director::Member<{}, {}, {}>", group_in(e.model, task.target), task.edge.value, rows);
}

std::string tasks_text(const Model& model, const std::vector<Task>& tasks) {
  std::string out;
  for (const Task& task : tasks) {
    if (!out.empty()) out += ", ";
    out += group_name(model, task.target);
    if (model.may_be_left_out(task)) out += " (optional)";
    if (model.edges[task.edge].levels[task.levels.front().level].apart) out += " (apart)";
  }
  return out;
}

} // namespace director::compiler
