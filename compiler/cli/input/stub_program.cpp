// Header: compiler/cli/input/stub_program.hpp. Test: tests/compiler/clang/stubs/command_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/input/stub_program.hpp"

#include "compiler/base/absolute_path.hpp"
#include "compiler/emit/artefact/notice.hpp"
#include "compiler/facts/flags.hpp"
#include "compiler/stubs/merge.hpp"
#include "compiler/stubs/relevance.hpp"
#include "dsl/source/load_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace director::compiler::cli {

namespace {

namespace fs = std::filesystem;

std::string whole_path(const fs::path& path) {
  const fs::path absolute = absolute_path(path);
  std::error_code fault;
  const fs::path out = fs::weakly_canonical(absolute, fault);
  return fault ? absolute.lexically_normal().string() : out.string();
}

/// Reads the commands that the user names, or those near the program. Without any, files are read with `default_flags`.
void read_commands(const Stubs& request, Console& console, Program& out) {
  LoadedCommands loaded = request.build.empty() ? find_compile_commands(out.folder, console.files)
                                                : load_compile_commands(request.build, console.files);
  if (loaded.was_read || !request.build.empty()) out.fault = std::move(loaded.fault);
  Compilers compilers(console.programs);
  for (const CompileCommand& each : loaded.commands) {
    if (is_of_c(each)) continue; // its flags are none for a file beside it
    out.compiled.push_back({whole_path(each.file), each.directory, compilers.complete(fit_for_clang(each))});
  }
}

/// The number of common folders of two paths.
std::size_t nearness(const fs::path& a, const fs::path& b) {
  const auto apart = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
  return static_cast<std::size_t>(std::distance(a.begin(), apart));
}

} // namespace

stubs::Unit unit_for(const Program& program, const std::string& path) {
  const Compiled* best = nullptr;
  const auto worth = [&](const Compiled& each) {
    return each.path == path ? ~std::size_t{0} : nearness(each.path, path);
  };
  for (const Compiled& each : program.compiled)
    if (best == nullptr || worth(each) > worth(*best)) best = &each;
  stubs::Unit out{path, program.folder, program.default_flags, stubs::is_header(path)};
  if (best != nullptr) {
    out.directory = best->directory;
    out.flags = best->flags;
    out.flags.insert(out.flags.end(), program.default_flags.begin() + 1, program.default_flags.end());
  }
  // CUDA is read as C++: its headers may not be there, and what only they declare is reported.
  if (stubs::is_header(path) || path.ends_with(".cu")) out.flags.insert(out.flags.end(), {"-x", "c++"});
  return out;
}

Program read_program(const Stubs& request, const stubs::Wanted& wanted, Console& console) {
  Program out;
  out.folder = whole_path(request.folder);
  for (const std::string& path : console.outputs.list(out.folder)) {
    if (!stubs::is_cpp(path)) continue;
    if (const auto text = console.files.read(path, dsl::largest_file, dsl::Kinds::ordinary))
      out.texts[whole_path(path)] = text.value();
    else
      out.unread.push_back(
          {{path, 1, 1},
           fmt::format("this file cannot be read, so what it has counts as missing: {}", text.error().message)});
  }
  read_commands(request, console, out);
  out.default_flags = {"-std=c++20", "-I" + whole_path(fs::path(request.file).parent_path())};
  for (const std::string& folder : request.includes) out.default_flags.push_back("-I" + whole_path(folder));
  if (!console.headers.empty()) out.default_flags.insert(out.default_flags.end(), {"-isystem", console.headers});

  for (const bool headers : {false, true}) {
    const stubs::Words words = headers ? stubs::interface_words(wanted) : stubs::identifying_words(wanted);
    for (const auto& [path, text] : out.texts) {
      const bool generated = fs::path(path).filename() == wanted.header && has_notice(text);
      if (stubs::is_header(path) == headers && !generated && stubs::mentions(text, words))
        out.units.push_back(unit_for(out, path));
    }
  }
  return out;
}

bool add_heirs(Program& program, const std::vector<stubs::FoundClass>& classes) {
  stubs::Words names;
  for (const stubs::FoundClass& type : classes) names.insert(type.name.substr(type.name.rfind(':') + 1));
  std::vector<stubs::Unit> heirs;
  for (const auto& [path, text] : program.texts) {
    const auto same = [&wanted = path](const stubs::Unit& unit) { return unit.path == wanted; };
    const bool is_known = has_notice(text) || std::any_of(program.units.begin(), program.units.end(), same);
    if (!is_known && stubs::derives(text, names)) heirs.push_back(unit_for(program, path));
  }
  // Sources first: one may include the header in question.
  std::stable_partition(heirs.begin(), heirs.end(),
                        [](const stubs::Unit& unit) { return !stubs::is_header(unit.path); });
  program.units.insert(program.units.end(), heirs.begin(), heirs.end());
  return !heirs.empty();
}

} // namespace director::compiler::cli
