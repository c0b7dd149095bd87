// Header: compiler/emit/cpp/parts.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
//
// The task types: what is requested, and the namespace of a group's contexts and levels.
#include "compiler/emit/cpp/parts.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

void declare_task(Code& code, const CppEmission& e, GroupId id) {
  const Group& group = e.model.groups[id];
  const std::string name = group_name(e.model, id);
  const bool data = !group.data.empty();
  const bool hides_base = name == "Task";
  // The struct does not name the type of the data: a member may have the same name.
  if (hides_base && data) {
    code.line("namespace detail {");
    code.line(fmt::format("using task_data = {};", group.data), group.data_span);
    code.line("} // namespace detail");
  }
  document(code, e, group.doc, group.name.span);
  const std::string base = fmt::format("director::Task<{}{}>", name,
                                       !data        ? ""
                                       : hides_base ? ", detail::task_data"
                                                    : ", " + group.data);
  code.open(fmt::format("struct {} final : {} {{", name, base), group.name.span);
  const std::string constructors =
      hides_base ? fmt::format("using {}::Task;", base) : fmt::format("using {}::Task::Task;", name);
  data ? code.line(constructors, group.data_span) : code.line(constructors);
  const std::vector<std::string>& levels = e.levels[id];
  for (std::size_t i = 0; i < levels.size(); ++i)
    code.line(fmt::format("{} director::LevelOf<{}> {}{{{}}};", own_constant, name, levels[i], i));
  if (group.start) code.line("class Start;");
  if (group.stop) code.line("class Stop;");
  for (const ProviderId provider : group.providers)
    code.line(fmt::format("class {};", context_name(e.model.providers[provider])));
  code.close("};");
  code.blank();
}

} // namespace

Code tasks_part(const CppEmission& e) {
  Code code;
  code.comment("Tasks", "//");
  code.blank();
  for (const GroupId id : e.model.groups.ids()) declare_task(code, e, id);
  return code;
}

} // namespace director::compiler
