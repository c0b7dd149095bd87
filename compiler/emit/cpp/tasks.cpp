// Door: compiler/emit/cpp/parts.hpp. Test: tests/compiler/emit/emit_test.cpp.
//
// The task types: what is requested, and the name space of a group's contexts and levels.
#include "compiler/emit/cpp/parts.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

void declare_task(Code& code, const CppEmission& e, GroupId id) {
  const Group& group = e.model.groups[id];
  const std::string name = group_name(e.model, id);
  const bool data = !group.data.empty();
  document(code, e, group.doc, group.name.span);
  const std::string base = fmt::format("director::Task<{}{}>", name, data ? ", " + group.data : "");
  code.open(fmt::format("struct {} final : {} {{", name, base), group.name.span);
  if (data) {
    code.line(fmt::format("using {}::Task;", base), group.data_span);
  } else {
    code.line(fmt::format("using {}::Task;", base));
  }
  const std::vector<std::string>& levels = e.levels[id];
  for (std::size_t i = 0; i < levels.size(); ++i)
    code.line(fmt::format("static constexpr director::LevelOf<{}> {}{{{}}};", name, levels[i], i));
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
