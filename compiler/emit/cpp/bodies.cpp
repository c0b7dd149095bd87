// Header: compiler/emit/cpp/parts.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
//
// The functions that the engine calls: untyped ones that find the module and the context, and catch exceptions.
#include "compiler/emit/cpp/parts.hpp"
#include "compiler/lower/row_names.hpp"
#include "runtime/hosted/trace/fingerprint.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

namespace {

/// The same in every behaviour.
constexpr std::string_view common =
    R"(/// An exception of the user's code is kept in the behaviour until the micro-step is over.
template <class Call, class Fault>
static auto guarded([[maybe_unused]] Behaviour& behaviour, Call call, [[maybe_unused]] Fault fault) {
#ifdef __cpp_exceptions
  try {
    return call();
  } catch (...) {
    if (!behaviour.thrown_) behaviour.thrown_ = std::current_exception();
    return fault();
  }
#else
  return call();
#endif
}

// The body is chosen by its exact type: to resolve a call among the bodies of a large module costs the compiler much more.
template <class Context>
[[gnu::always_inline]] static director::Outcome provide(Behaviour& behaviour, director::Run& run) {
  using Module = typename Facts<Context>::Module;
  constexpr director::Outcome (Module::*body)(Context&) = &Module::provide;
  Context context{run, behaviour.data()};
  return (behaviour.modules_.template of<Module>().*body)(context);
}
)";

constexpr std::string_view handler = R"(
template <class Context>
[[gnu::always_inline]] static void {0}(Behaviour& behaviour, director::Handling& handling) {{
  using Module = typename Facts<Context>::Module;
  constexpr void (Module::*body)(Context&) = &Module::{0};
  Context context{{handling, behaviour.data()}};
  (behaviour.modules_.template of<Module>().*body)(context);
}}
)";

constexpr std::string_view throwing = R"(void Behaviour::throw_on() {
#ifdef __cpp_exceptions
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
#endif
}

#ifdef __cpp_exceptions
/// An exception of an observer is kept as well, and ends the step.
void Behaviour::tell(void* self, const director::Event& event) {
  Behaviour& behaviour = *static_cast<Behaviour*>(self);
  const director::Observer to = behaviour.observer_;
  detail::Bodies::guarded(
      behaviour, [&] { to.tell(to.self, event); }, [&] { behaviour.observer_threw(); });
}
#endif
)";

constexpr std::string_view called_from_inside = R"(void Whole::called_from_inside() {
#if __STDC_HOSTED__
  assert(false && "from inside a body, handler or observer only `post` reaches the behaviour");
#endif
}
)";

bool any_handler(const Model& model, std::optional<Handler> Group::*which) {
  return std::any_of(model.groups.begin(), model.groups.end(), [&](const Group& group) { return !!(group.*which); });
}

bool any_data(const Model& model) {
  return std::any_of(model.groups.begin(), model.groups.end(), [](const Group& group) { return !group.data.empty(); });
}

void data_function(Code& code, const CppEmission& e) {
  code.blank();
  code.open(
      "static void data(void* self, director::Bodies::Data what, director::Index edge, director::Index handle) {");
  code.line("Data& all = static_cast<Behaviour*>(self)->data();");
  code.line("const director::Index place = Whole::places[edge];");
  code.line("switch (edges[edge].target) {");
  for (const GroupId id : e.model.groups.ids()) {
    if (e.model.groups[id].data.empty()) continue;
    const bool root =
        std::any_of(e.model.roots.begin(), e.model.roots.end(), [&](const Task& task) { return task.target == id; });
    code.line(fmt::format("case {}: return director::move_data<{}, {}>(all, what, place, handle);", id.value,
                          group_in(e.model, id), root));
  }
  code.line("default: return;");
  code.line("}");
  code.close("}");
}

/// The start or the stop handlers. `word`: start or stop.
void call_handlers(Code& code, const CppEmission& e, std::string_view word, std::optional<Handler> Group::*which) {
  if (!any_handler(e.model, which)) return;
  code.block(fmt::format(fmt::runtime(handler), word));
  code.blank();
  code.open(fmt::format("static void {}(void* self, director::Handling& handling) {{", word));
  code.line("Behaviour& behaviour = *static_cast<Behaviour*>(self);");
  code.open("const auto call = [&] {");
  code.line("switch (handling.group()) {");
  for (const GroupId id : e.model.groups.ids()) {
    if (!(e.model.groups[id].*which)) continue;
    code.line(fmt::format("case {}: return {}<{}::{}>(behaviour, handling);", id.value, word, group_in(e.model, id),
                          type_name(word)));
  }
  code.line("default: return;");
  code.line("}");
  code.close("};");
  code.line("guarded(behaviour, call, [&] { handling.fault(); });");
  code.close("}");
}

/// How many bodies one function calls: with one function for each, or one for thousands, the C++ compiler takes several
/// times as long.
constexpr std::uint32_t block = 32;

/// Exceptions are caught here and not for each provider, which would cost the C++ compiler a third of the time.
void call_bodies(Code& code, const CppEmission& e) {
  std::vector<std::string> blocks;
  code.blank();
  for (std::size_t first = 0; first < e.model.providers.size(); first += block) {
    blocks.push_back(fmt::format("&run_{}", first));
    code.line(fmt::format("static director::Outcome run_{}(Behaviour& behaviour, director::Run& run);", first));
  }
  code.open("static director::Outcome run(void* self, director::Run& run) {");
  code.list(fmt::format("static constexpr std::array<director::Outcome (*)(Behaviour&, director::Run&), {}> blocks{{",
                        blocks.size()),
            blocks, "};");
  code.line("Behaviour& behaviour = *static_cast<Behaviour*>(self);");
  code.line("return guarded(");
  code.line(fmt::format("    behaviour, [&] {{ return blocks[run.provider() / {}](behaviour, run); }},", block));
  code.line("    [&] { return run.fault(); });");
  code.close("}");
}

void define_blocks(Code& code, const CppEmission& e) {
  for (const ProviderId id : e.model.providers.ids()) {
    if (id.value % block == 0) {
      code.open(fmt::format("director::Outcome {}::detail::Bodies::run_{}(Behaviour& behaviour, director::Run& run) {{",
                            e.model.name_space, id.value));
      code.line("switch (run.provider()) {");
    }
    code.line(fmt::format("case {}: return provide<{}>(behaviour, run);", id.value, provider_in(e.model, id)));
    if (id.value % block != block - 1 && id.value + 1 != e.model.providers.size()) continue;
    code.line("default: return run.fault();");
    code.line("}");
    code.close("}");
    code.blank();
  }
}

void functions_of(Code& code, const CppEmission& e) {
  code.blank();
  code.open("static director::Bodies of(Behaviour& behaviour) {");
  std::vector<std::string> members{".self = &behaviour", ".run = &run"};
  if (any_handler(e.model, &Group::start)) members.push_back(".start = &start");
  if (any_handler(e.model, &Group::stop)) members.push_back(".stop = &stop");
  if (any_data(e.model)) members.push_back(".data = &data");
  code.list("return {", members, "};");
  code.close("}");
}

} // namespace

std::uint64_t fingerprint(const CppEmission& e) {
  return director::fingerprint(RowNames(e.model, e.from.lowered).names());
}

Code bodies_part(const CppEmission& e) {
  Code code;
  code.line("namespace detail {");
  code.blank();
  code.line("const director::Tables& Whole::tables() { return rows; }");
  code.line(fmt::format("std::uint64_t Whole::fingerprint() {{ return 0x{:016x}; }}", fingerprint(e)));
  code.blank();
  code.block(called_from_inside);
  code.blank();
  code.comment("What the engine calls.");
  code.open("struct [[gnu::visibility(\"hidden\")]] Bodies {");
  code.block(common);
  call_bodies(code, e);
  call_handlers(code, e, "start", &Group::start);
  call_handlers(code, e, "stop", &Group::stop);
  if (any_data(e.model)) data_function(code, e);
  functions_of(code, e);
  code.close("};");
  code.blank();
  code.line("} // namespace detail");
  code.line(fmt::format("}} // namespace {}", e.model.name_space));
  code.blank();
  define_blocks(code, e);
  code.line(fmt::format("namespace {} {{", e.model.name_space));
  code.blank();
  std::vector<std::string> parameters{fmt::format("detail::{}", constructor_tag(e))}, modules;
  for (const ModuleId id : e.model.modules.ids()) {
    modules.push_back(fmt::format("module_{}", id.value));
    parameters.push_back(fmt::format("{}& {}", module_in(e.model, id), modules.back()));
  }
  code.list("Behaviour::Behaviour(", parameters, ")");
  code.list("    : Program(detail::Bodies::of(*this)), modules_(", modules, ") {}");
  code.blank();
  code.block(throwing);
  return code;
}

} // namespace director::compiler
