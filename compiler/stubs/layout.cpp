// Header: compiler/stubs/layout.hpp. Test: tests/compiler/stubs/layout_test.cpp.
// SPDX-License-Identifier: MIT
//
// The answer of a stub is keep(): done() would let a requester continue although nothing has happened, fail() would let
// it give up, and a request would move a robot. A task that only keeps waits, holds its group, and requests nothing;
// and `directorc verify` reports that such a provider only keeps.
#include "compiler/stubs/layout.hpp"

#include "compiler/base/list_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace director::compiler::stubs {

namespace {

using Kind = WantedFunction::Kind;

void declare_class(Code& code, const WantedModule& module) {
  code.open(fmt::format("class {} final : public {} {{", module.class_name, module.interface));
  code.outdented("public:");
  for (const WantedFunction& function : module.functions)
    code.line(head(function, "director::Outcome", "") + " override;");
  code.close("};");
}

} // namespace

std::string head(const WantedFunction& function, std::string_view result, std::string_view qualifier) {
  const bool provides = function.kind == Kind::provide;
  return fmt::format("{} {}{}({}{}& run)", provides ? result : "void", qualifier, name_of(function.kind),
                     function.from_outside ? "::" : "", function.context);
}

Code definition(const WantedFunction& function, std::string_view head) {
  Code code;
  for (const std::string& line : function.words) code.comment(line);
  if (function.kind == Kind::provide) {
    code.open(fmt::format("{} {{", head));
    code.line(fmt::format("return run.keep(); // {}", unwritten));
    code.close("}");
  } else {
    code.open(fmt::format("{} {{", head));
    code.line(fmt::format("static_cast<void>(run); // {}", unwritten));
    code.close("}");
  }
  return code;
}

std::string as_insertion(const Code& code, std::string_view line_break, std::string_view indent,
                         std::string_view step) {
  std::string out;
  for (const Code::Line& line : code.lines()) {
    out += line_break;
    if (line.text.empty()) continue;
    out += indent;
    for (std::uint32_t level = 0; level < line.indent; ++level) out += step;
    out += line.text;
  }
  return out;
}

std::vector<Artefact> first_files(const Wanted& wanted, const WantedModule& module) {
  Code header;
  header.line("#pragma once");
  header.comment(fmt::format("The module {} of the behaviour {}.", module.name, wanted.behaviour), "//");
  header.blank();
  header.line(fmt::format("#include \"{}\"", wanted.header));
  header.blank();
  declare_class(header, module);

  Code source;
  source.line(fmt::format("#include \"{}.hpp\"", module.stem));
  const bool answers = std::any_of(module.functions.begin(), module.functions.end(),
                                   [](const WantedFunction& each) { return each.kind == Kind::provide; });
  if (answers) {
    source.blank();
    source.comment("Each body ends with an answer: g++ requires one also after a switch over all values of an enum.",
                   "//");
  }
  for (const WantedFunction& function : module.functions) {
    source.blank();
    source.append(definition(function, head(function, "director::Outcome", module.class_name + "::")));
  }
  return {{module.stem + ".hpp", header.text()}, {module.stem + ".cpp", source.text()}};
}

Artefact main_file(const Wanted& wanted, const std::vector<ModuleClass>& classes) {
  Code code;
  code.comment(fmt::format("Runs the behaviour {}.", wanted.behaviour), "//");
  std::set<std::string> includes{wanted.header};
  for (const ModuleClass& module : classes) includes.insert(module.include);
  for (const std::string& include : includes) code.line(fmt::format("#include \"{}\"", include));
  code.blank();
  code.line("#include <chrono>");
  code.line("#include <csignal>");
  code.line("#include <cstdio>");
  code.line("#include <thread>");
  code.blank();
  code.open("int main() {");
  code.comment("Ctrl-C, or SIGTERM, ends the loop below; a second one ends the program at once.", "//");
  code.line("static volatile std::sig_atomic_t stopping = 0;");
  code.open("const auto stop = [](int signal) {");
  code.line("stopping = 1;");
  code.line("std::signal(signal, SIG_DFL);");
  code.close("};");
  code.line("std::signal(SIGINT, stop);");
  code.line("std::signal(SIGTERM, stop);");
  code.blank();
  std::vector<std::string> names;
  std::set<std::string> made; // one class may implement several modules
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const auto same = std::find_if(classes.begin(), classes.end(),
                                   [&](const ModuleClass& other) { return other.name == classes[i].name; });
    names.push_back(wanted.modules[static_cast<std::size_t>(same - classes.begin())].name + "_part");
    if (made.insert(classes[i].name).second) code.line(fmt::format("{} {};", classes[i].name, names.back()));
  }
  code.list(fmt::format("{}::Behaviour behaviour{{", wanted.name_space), names, "};");
  code.blank();
  std::vector<std::string> with_data;
  for (const WantedRoot& root : wanted.roots) {
    if (root.data) with_data.push_back(fmt::format("behaviour.request({}{{data}})", root.task));
    if (!root.data) code.line(fmt::format("behaviour.request<{}>();", root.task));
  }
  if (!with_data.empty()) code.comment(fmt::format("With data of their own: {}.", list_of(with_data)), "//");
  code.line("const auto start = std::chrono::steady_clock::now();");
  code.line("const auto step = [&] { return behaviour.step(std::chrono::steady_clock::now() - start); };");
  code.open("while (stopping == 0) {");
  code.open("if (step() == director::StepResult::fault) {");
  code.line("std::fputs(\"a body requested a level that its group does not declare\\n\", stderr);");
  code.close("}");
  code.line("std::this_thread::sleep_for(std::chrono::milliseconds(10));");
  code.close("}");
  code.blank();
  code.comment(
      "What runs is stopped: the end of the behaviour calls no stop handler. End threads that post before this.", "//");
  code.line("behaviour.cancel_all();");
  code.line("while (step() != director::StepResult::quiescent) {}");
  code.close("}");
  return {"main.cpp", code.text()};
}

} // namespace director::compiler::stubs
