// Header: compiler/emit/cpp/parts.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
//
// The contexts of bodies and handlers: their common part is in runtime/core/api/body.hpp, the packs are here.
#include "compiler/base/list_of.hpp"
#include "compiler/emit/cpp/parts.hpp"
#include "dsl/lexical/duration.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

std::string groups_text(const Model& model, const std::vector<Use<GroupId>>& uses) {
  std::string out;
  for (const Use<GroupId>& use : uses) out += (out.empty() ? "" : ", ") + group_name(model, use.id);
  return out;
}

std::string triggers_text(const Model& model, const Provider& provider) {
  std::string out;
  for (const Use<TriggerId>& use : provider.triggers) out += (out.empty() ? "" : ", ") + model.triggers[use.id].name;
  if (provider.every) out += fmt::format("{}every {}", out.empty() ? "" : ", ", dsl::time_text(*provider.every));
  return out;
}

/// The declarations of a provider, a line for each key.
void describe(Code& code, const Model& model, const Provider& provider) {
  for (const std::string& line : words_of(model, provider)) code.comment(line);
}

void open_class(Code& code, const CppEmission& e, const std::string& name, std::string_view base,
                const dsl::Span& span) {
  const std::string& in = e.model.name_space;
  // Qualified from the global namespace: a module may have the name of the namespace.
  code.open(fmt::format("class {}::{} final : public director::{}<::{}::detail::Facts<::{}::{}>> {{", in, name, base,
                        in, in, name),
            span);
}

/// `number`: index among the provider's packs.
void define_pack(Code& code, const CppEmission& e, const Pack& pack, ProviderId provider, std::size_t number) {
  const std::string packed = fmt::format("{}::pack_{}", facts_in(e, provider), number);
  const std::string requests = pack.tasks.empty() ? "Requests nothing." : tasks_text(e.model, pack.tasks) + ".";
  code.blank();
  document(code, e, pack.doc.empty() ? requests : requests + " " + pack.doc, pack.span);
  if (pack.tasks.empty()) {
    code.open(fmt::format("director::Outcome {}() {{", pack.name), pack.span);
    code.line(fmt::format("return Body::ask<{}, {}>();", packed, number));
    return code.close("}");
  }
  const std::string_view given = pack.name == "Given" ? "More" : "Given";
  code.line(fmt::format("template <class... {}>", given));
  code.open(fmt::format("director::Outcome {}({}... tasks) {{", pack.name, given), pack.span);
  code.line(fmt::format("using Pack = {};", packed));
  std::vector<std::string> names;
  for (const Task& task : pack.tasks) names.push_back(group_name(e.model, task.target));
  code.line(
      fmt::format("static_assert(Pack::takes<{}...>, \"{} requests {} only\");", given, pack.name, list_of(names)));
  code.line(fmt::format("static_assert(Pack::once<{}...>, \"{} is given a task twice\");", given, pack.name));
  for (const Task& task : pack.tasks) {
    if (e.model.may_be_left_out(task)) continue;
    code.line(fmt::format("static_assert(director::given<{}, {}...>, \"{} must be given its task {}\");",
                          group_in(e, provider, task.target), given, pack.name, group_name(e.model, task.target)));
  }
  code.line(fmt::format("return Body::ask<Pack, {}>(tasks...);", number));
  code.close("}");
}

void define_context(Code& code, const CppEmission& e, ProviderId id) {
  const Provider& provider = e.model.providers[id];
  const std::string name = provider_name(e.model, id);
  document(code, e, provider.direct ? std::string{} : provider.doc, provider.span);
  describe(code, e.model, provider);
  open_class(code, e, name, "Body", provider.span);
  code.outdented("public:");
  code.line(fmt::format("using director::Body<{}>::Body;", facts_in(e, id)));
  if (provider.has_packs) {
    std::size_t number = 0;
    for (const Pack& pack : provider.packs) define_pack(code, e, pack, id, number++);
  }
  code.close("};");
  code.blank();
}

void define_handler(Code& code, const CppEmission& e, GroupId group, const std::optional<Handler>& handler,
                    std::string_view context) {
  if (!handler) return;
  const std::string name = fmt::format("{}::{}", group_name(e.model, group), context);
  document(code, e, {}, handler->span);
  const std::string sets = conditions_text(e.model, handler->sets);
  if (!sets.empty()) code.comment("- sets: " + sets);
  open_class(code, e, name, "Handler", handler->span);
  code.outdented("public:");
  code.line(fmt::format("using director::Handler<detail::Facts<{}::{}>>::Handler;", group_in(e.model, group), context));
  code.close("};");
  code.blank();
}

} // namespace

std::string conditions_text(const Model& model, const std::vector<ConditionUse>& uses) {
  std::string out;
  for (const ConditionUse& use : uses) {
    if (!out.empty()) out += ", ";
    out += model.conditions[use.id].text;
    if (use.within) out += fmt::format(" within {}", dsl::time_text(*use.within));
  }
  return out;
}

std::vector<std::string> words_of(const Model& model, const Provider& provider) {
  std::vector<std::string> lines;
  const auto add_line = [&](std::string_view word, const std::string& text) {
    if (!text.empty()) lines.push_back(fmt::format("- {}: {}", word, text));
  };
  add_line("when", conditions_text(model, provider.when));
  add_line("stay", conditions_text(model, provider.stay));
  add_line("needs", groups_text(model, provider.needs));
  add_line("causing", conditions_text(model, provider.causing));
  add_line("sets", conditions_text(model, provider.sets));
  add_line("uses", groups_text(model, provider.uses));
  add_line("triggers", triggers_text(model, provider));
  if (!provider.has_packs && !provider.packs.empty())
    add_line("tasks", tasks_text(model, provider.packs.front().tasks));
  return lines;
}

Code contexts_part(const CppEmission& e) {
  Code code;
  code.comment("What the bodies of providers, and start and stop handlers, get. Defined from outside of the namespace: "
               "GCC walks all names of one that is open each time that it instantiates a template.",
               "//");
  code.blank();
  for (const GroupId id : e.model.groups.ids()) {
    const Group& group = e.model.groups[id];
    define_handler(code, e, id, group.start, "Start");
    define_handler(code, e, id, group.stop, "Stop");
    for (const ProviderId provider : group.providers) define_context(code, e, provider);
  }
  return code;
}

} // namespace director::compiler
