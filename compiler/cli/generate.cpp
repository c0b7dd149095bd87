// Door: compiler/cli/commands.hpp. Test: tests/cli/generate_test.cpp.
#include "compiler/cli/load.hpp"
#include "compiler/emit/depfile.hpp"
#include "compiler/emit/emit.hpp"
#include "compiler/lower/lower.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace director::compiler::cli {

namespace {

/// False, and says why, where a file cannot be written.
bool wrote(const std::string& path, const std::optional<std::string>& fault, Console& console) {
  if (fault) console.err << fmt::format("directorc: cannot write `{}`: {}\n", path, *fault);
  return !fault;
}

} // namespace

int run(const Generate& request, Console& console) {
  dsl::Sources sources;
  CheckOptions options;
  options.decide = true;
  options.selection = request.selection;
  const std::optional<Checked> checked = load(request.file, options, sources, console, {request.build, request.flags});
  if (!checked) return misused;
  print_findings(checked->findings, sources, console.err, console.err_colours);
  if (dsl::has_errors(checked->findings)) return found;
  if (print_undecided(checked->undecided, console)) return undecided;
  if (!checked->model.deployment) {
    console.err << fmt::format(
        "directorc: `{}` has no `roots`: it is a module for others to import, and nothing can be "
        "generated from it alone\n",
        shown_path(request.file));
    return misused;
  }

  const Lowered lowered = lower(checked->model);
  std::vector<std::string> paths;
  for (const Artefact& artefact : emit({sources, checked->model, lowered})) {
    paths.push_back((std::filesystem::path(request.folder) / artefact.path).string());
    if (!wrote(paths.back(), console.outputs.write(paths.back(), artefact.text), console)) return misused;
  }
  if (request.depfile.empty()) return clean;
  const std::vector<std::string> targets = request.target.empty() ? paths : std::vector{request.target};
  const std::string text = depfile(targets, sources, checked->headers);
  return wrote(request.depfile, console.outputs.renew(request.depfile, text), console) ? clean : misused;
}

} // namespace director::compiler::cli
