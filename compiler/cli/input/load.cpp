// Header: compiler/cli/input/load.hpp. Test: tests/compiler/cli/commands/check_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/input/load.hpp"

#include "compiler/base/absolute_path.hpp"
#include "compiler/cli/input/fact_store.hpp"
#include "compiler/cli/input/named_file.hpp"
#include "compiler/facts/scanned_types.hpp"
#include "dsl/source/load_file.hpp"
#include "dsl/source/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <system_error>

namespace director::compiler::cli {

namespace fs = std::filesystem;

std::string shown_path(const std::string& path) {
  const fs::path given(path);
  if (!given.is_absolute()) return path;
  std::error_code error;
  const fs::path here = fs::current_path(error);
  const fs::path relative = given.lexically_normal().lexically_relative(here);
  const bool inside = !error && !relative.empty() && *relative.begin() != "..";
  return inside ? relative.string() : path;
}

namespace {

TypeFlags flags_of_build(LoadedCommands build) {
  return {std::move(build.commands), std::move(build.fault), fmt::format("`{}`", build.path)};
}

TypeFlags flags_of_file(const std::string& path, Console& console) {
  TypeFlags out;
  out.source = fmt::format("`{}`", path);
  const auto text = console.files.read(path, dsl::largest_file);
  if (!text) {
    out.fault = fmt::format("cannot read `{}`: {}", path, text.error().message);
    return out;
  }
  std::error_code fault;
  CompileCommand command{{}, fs::current_path(fault).string(), {}};
  std::istringstream lines(text.value());
  constexpr std::string_view several = "SHELL:"; // of CMake: an option of several words
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.starts_with(several)) {
      const std::vector<std::string> words = split_command(std::string_view(line).substr(several.size()));
      command.words.insert(command.words.end(), words.begin(), words.end());
    } else if (!line.empty()) {
      command.words.push_back(line);
    }
  }
  out.commands.push_back(std::move(command));
  return out;
}

TypeFlags flags_near(const std::string& file, Console& console) {
  LoadedCommands build = find_compile_commands(absolute_path(file).parent_path().string(), console.files);
  if (!build.was_read) {
    build.fault =
        "how the headers are compiled is not known; `-p FOLDER` names a build's folder with compile_commands.json";
  }
  return flags_of_build(std::move(build));
}

/// The folder of the cache: that of the build, or of the file with the flags, which a build wrote.
std::string home_of(const CppSource& cpp) {
  if (!cpp.build.empty() || cpp.flags.empty()) return cpp.build;
  const std::string folder = fs::path(cpp.flags).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// Searches for flags only when types are requested.
class TypesWhenAsked final : public TypeReader {
public:
  TypesWhenAsked(const std::string& file, const CppSource& cpp, dsl::Sources& sources, Console& console)
      : file_(file),
        cpp_(cpp),
        console_(console),
        code_files_(console.files, sources, shown_path),
        scanner_(console.scanner, console.programs),
        store_(facts_folder(home_of(cpp))) {}

  bool thorough() const override { return !cpp_.build.empty() || !cpp_.flags.empty(); }
  Types read(const Question& question) override {
    TypeFlags flags = !cpp_.flags.empty()   ? flags_of_file(cpp_.flags, console_)
                      : !cpp_.build.empty() ? flags_of_build(load_compile_commands(cpp_.build, console_.files))
                                            : flags_near(file_, console_);
    if (thorough()) fault_ = flags.fault;
    return ScannedTypes(std::move(flags), scanner_, console_.programs, console_.files, store_).read(question);
  }
  dsl::Span span(const CodePlace& place) override { return code_files_.span(place); }
  /// What was wrong with the named flags; empty: nothing, or no types were requested.
  const std::string& fault() const { return fault_; }

private:
  const std::string& file_;
  const CppSource& cpp_;
  Console& console_;
  CodeFiles code_files_;
  Scanner scanner_;
  DiskFacts store_;
  std::string fault_;
};

/// Of the named flags; empty: they can be read, as far as can be decided without reading them.
std::string fault_of(const CppSource& cpp, dsl::FileAccess& files) {
  const std::string file = !cpp.flags.empty()   ? cpp.flags
                           : !cpp.build.empty() ? (fs::path(cpp.build) / "compile_commands.json").string()
                                                : std::string{};
  if (file.empty()) return {};
  const auto text = files.read(file, 0, dsl::Kinds::ordinary);
  using Kind = dsl::FileError::Kind;
  const bool is_pipe =
      !text && text.error().kind == Kind::pipe && !cpp.flags.empty(); // which is read when it is needed
  if (text || text.error().kind == Kind::too_large || is_pipe) return {};
  if (cpp.flags.empty()) return fault_of_build(cpp.build, text.error(), files);
  return fmt::format("cannot read `{}`: {}", file, text.error().message);
}

} // namespace

Checked check_file(const std::string& path, CheckOptions options, dsl::Sources& sources, Console& console,
                   const CppSource& cpp, std::string& fault) {
  TypesWhenAsked types(path, cpp, sources, console);
  options.types = &types;
  Checked out = check(path, console.files, sources, options);
  fault = types.fault().empty() ? fault_of(cpp, console.files) : types.fault();
  return out;
}

std::optional<Checked> load(const std::string& file, const CheckOptions& options, dsl::Sources& sources,
                            Console& console, const CppSource& cpp) {
  const std::string path = shown_path(file);
  std::string fault;
  Checked checked = check_file(path, options, sources, console, cpp, fault);
  if (checked.spec.files.empty() && !checked.findings.empty() && checked.findings.front().id == "import_not_found")
    fault = checked.findings.front().message + file_instead(path, is_called_behaviour, console);
  if (fault.empty()) return checked;
  print_message(console, fmt::format("directorc: {}\n", fault));
  return {};
}

void print_findings(const std::vector<dsl::Diagnostic>& findings, const dsl::Sources& sources, std::ostream& out,
                    bool colours, std::size_t width) {
  constexpr std::size_t before_source = 8, least = 20;
  dsl::RenderOptions options;
  options.colours = colours;
  if (width != 0) options.width = std::max(width, before_source + least) - before_source;
  out << dsl::render(findings, sources, options);
}

bool print_undecided(const std::vector<std::string>& lines, Console& console) {
  for (const std::string& line : lines) print_message(console, fmt::format("directorc: not decided: {}\n", line));
  return !lines.empty();
}

/// A build passes `--flags` whether or not director-clang is installed, and it may generate the headers only later.
void print_unchecked_types(const Checked& checked, const CppSource& cpp, Console& console) {
  if (cpp.build.empty() || checked.types_fault.empty() || dsl::has_errors(checked.findings)) return;
  print_message(console, fmt::format("directorc: types of C++ are not checked: {}\n", checked.types_fault));
}

std::vector<dsl::Diagnostic> errors_of(const std::vector<dsl::Diagnostic>& findings) {
  std::vector<dsl::Diagnostic> errors;
  std::copy_if(findings.begin(), findings.end(), std::back_inserter(errors),
               [](const dsl::Diagnostic& finding) { return finding.level == dsl::Level::error; });
  return errors;
}

} // namespace director::compiler::cli
