// Door: compiler/cli/load.hpp. Test: tests/cli/check_test.cpp.
#include "compiler/cli/load.hpp"

#include "dsl/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
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

std::optional<Checked> load(const std::string& file, const CheckOptions& options, dsl::Sources& sources,
                            Console& console) {
  Checked checked = check(shown_path(file), console.files, sources, options);
  const bool unreadable =
      checked.spec.files.empty() && !checked.findings.empty() && checked.findings.front().id == "import_not_found";
  if (!unreadable) return checked;
  console.err << fmt::format("directorc: {}\n", checked.findings.front().message);
  return {};
}

void print_findings(const std::vector<dsl::Diagnostic>& findings, const dsl::Sources& sources, std::ostream& out,
                    bool colours) {
  dsl::RenderOptions options;
  options.colours = colours;
  out << dsl::render(findings, sources, options);
}

bool print_undecided(const Checked& checked, Console& console) {
  for (const std::string& line : checked.undecided) console.err << fmt::format("directorc: not decided: {}\n", line);
  return !checked.undecided.empty();
}

std::vector<dsl::Diagnostic> errors_of(const std::vector<dsl::Diagnostic>& findings) {
  std::vector<dsl::Diagnostic> errors;
  std::copy_if(findings.begin(), findings.end(), std::back_inserter(errors),
               [](const dsl::Diagnostic& finding) { return finding.level == dsl::Level::error; });
  return errors;
}

} // namespace director::compiler::cli
