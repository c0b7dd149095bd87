// Header: compiler/emit/cpp/parts.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
//
// The class that a program instantiates. Its functions for inputs are in runtime/core/api/post.hpp and
// behaviour_view.hpp.
#include "compiler/emit/cpp/parts.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

void define_steps(Code& code, const CppEmission& e) {
  code.comment(
      "Takes the inputs that were posted before, then all that is due up to `now` (a duration since a start of your "
      "choice; an earlier time counts as the last one), until nothing is left to do. An exception of a body, handler "
      "or observer is rethrown after its micro-step; call step() again to continue. Not to be called by one of these: "
      "an assertion fails.");
  code.line("template <director::Duration Now>");
  code.open("director::StepResult step(Now now) {");
  code.line("return hand_on(step_to(director::microseconds_begun(now)));");
  code.close("}");
  if (e.model.uses_time()) return;
  code.blank();
  code.comment("The same, where no body waits: nothing in the behaviour uses time.");
  code.open("director::StepResult step() {");
  code.line("return hand_on(step_on());");
  code.close("}");
}

/// The constructor that the public ones call, and what keeps an exception until a step ends. `parameters`: the modules.
void define_private_part(Code& code, std::vector<std::string> parameters, const std::vector<std::string>& modules,
                         const std::string& tag) {
  code.outdented("private:");
  code.line("friend struct detail::Bodies;");
  parameters.insert(parameters.begin(), fmt::format("detail::{}", tag));
  code.list("Behaviour(", parameters, ");");
  code.open("director::StepResult hand_on(director::StepResult result) {");
  code.line("if (result == director::StepResult::fault) throw_on();");
  code.line("return result;");
  code.close("}");
  code.line("void throw_on();");
  code.line("template <bool reports>");
  code.open("void observe(director::Observer observer) {");
  code.line("#ifdef __cpp_exceptions");
  code.line("observer_ = observer;");
  code.line("if (observer.tell != nullptr) observer = {&tell, this};");
  code.line("#endif");
  code.line("Program::observe<reports>(observer);");
  code.close("}");
  code.blank();
  code.list("director::Modules<", modules, "> modules_;");
  code.line("#ifdef __cpp_exceptions");
  code.line("static void tell(void* self, const director::Event& event);");
  code.line("std::exception_ptr thrown_; ///< the first that was thrown since the last step");
  code.line("director::Observer observer_;");
  code.line("#endif");
}

} // namespace

std::string constructor_tag(const CppEmission& e) {
  return fmt::format("{}_behaviour_{:016x}", e.model.name, fingerprint(e));
}

Code behaviour_part(const CppEmission& e) {
  Code code;
  code.line("namespace detail {");
  code.line("struct Bodies;");
  // The symbol of the constructor has this name in it, so a linker that has another behaviour's objects opens these
  // too.
  const std::string tag = constructor_tag(e);
  code.comment("Which behaviour is constructed: two different ones of one namespace cannot be linked into one program, "
               "nor files of which some are compiled with DIRECTOR_SMALL_INDEX.");
  code.line(fmt::format("inline namespace DIRECTOR_INDEX_NAMESPACE {{ struct {} {{}}; }}", tag));
  code.line("} // namespace detail");
  code.blank();
  document(code, e, e.model.doc, e.model.name_span);
  code.comment(
      "Holds all memory of its own. The modules must live as long as it does. The destructor calls no handler: groups "
      "that run then are not stopped. Before it, call cancel_all(), then step() until it returns `quiescent`. All that "
      "includes this header must be compiled either with exceptions or without.");
  code.open("class Behaviour final : public director::Program<detail::Whole> {");
  code.outdented("public:");
  std::vector<std::string> parameters, arguments, modules;
  for (const ModuleId id : e.model.modules.ids()) {
    modules.push_back(module_in(e.model, id));
    arguments.push_back(fmt::format("module_{}", id.value));
    parameters.push_back(fmt::format("{}& {}", modules.back(), arguments.back()));
  }
  const auto constructor = [&](std::string_view behind) {
    code.list(parameters.size() == 1 ? "explicit Behaviour(" : "Behaviour(", parameters, behind);
  };
  constructor(")");
  std::vector<std::string> with_tag = arguments;
  with_tag.insert(with_tag.begin(), fmt::format("detail::{}{{}}", tag));
  code.list("    : Behaviour(", with_tag, ") {}");
  code.comment(
      "With an observer, which is called for every event. Without one, the code that reports events is not linked.");
  code.line("template <bool reports = director::observable>");
  parameters.push_back("director::Observer observer");
  constructor(")");
  code.list("    : Behaviour(", arguments, ") {");
  code.line("  observe<reports>(observer);");
  code.line("}");
  code.blank();
  define_steps(code, e);
  code.blank();
  parameters.pop_back();
  define_private_part(code, std::move(parameters), modules, tag);
  code.close("};");
  return code;
}

} // namespace director::compiler
