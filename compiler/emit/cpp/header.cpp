// Header: compiler/emit/cpp/cpp.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/cpp/cpp.hpp"
#include "compiler/emit/cpp/parts.hpp"
#include "dsl/lexical/cpp_type.hpp"

#include <fmt/format.h>

namespace director::compiler {

Code header(const Deployment& deployment) {
  const CppEmission e{deployment};
  const Model& model = e.model;
  Code code = first_lines(e);
  code.comment("", "//");
  code.comment(
      "In this order: states, triggers and tasks; what the body of each provider gets; the modules that a program "
      "implements; the behaviour itself.",
      "//");
  code.line("#pragma once");
  code.blank();
  for (const std::string& each : model.headers) code.line(dsl::include_line(each));
  code.line("#include \"runtime/core/behaviour.hpp\"");
  code.blank();
  code.line("#ifdef __cpp_exceptions");
  code.line("#include <exception>");
  code.line("#endif");
  code.blank();
  const std::string opened = fmt::format("namespace {} {{", model.name_space);
  const std::string closed = fmt::format("}} // namespace {}", model.name_space);
  code.line(opened);
  code.blank();
  for (const Code& part : {states_part(e), triggers_part(e), tasks_part(e)}) code.append(part);
  code.line(closed);
  code.blank();
  code.comment("Details for the C++ compiler: numbers of rows, and what each body may request.", "//");
  code.line(fmt::format("#include \"{}\"", facts_name(model.name)));
  code.blank();
  code.append(contexts_part(e));
  code.line(opened);
  code.blank();
  for (const Code& part : {modules_part(e), behaviour_part(e)}) code.append(part);
  code.blank();
  code.append(name_declarations(e));
  code.blank();
  code.line(closed);
  return code;
}

} // namespace director::compiler
