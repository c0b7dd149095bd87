// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/cli/commands/generate_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/input/load.hpp"
#include "compiler/emit/artefact/notice.hpp"
#include "compiler/emit/depfile.hpp"
#include "compiler/emit/emit.hpp"
#include "compiler/lower/lower.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace director::compiler::cli {

int run(const Generate& request, Console& console) {
  dsl::Sources sources;
  CheckOptions options;
  options.decide = request.bound;
  options.selection = request.selection;
  const std::optional<Checked> checked = load(request.file, options, sources, console, request.cpp);
  if (!checked) return misused;
  print_findings(checked->findings, sources, console.err, console.err_colours, console.err_width);
  const bool is_open = print_undecided(checked->undecided, console);
  print_unchecked_types(*checked, request.cpp, console);
  if (dsl::has_errors(checked->findings)) return found;
  if (is_open) return undecided;
  if (!checked->model.deployment) {
    print_message(console,
                  fmt::format("directorc: `{}` has no `roots`: it is a module for others to import, and nothing can be "
                              "generated from it alone\n",
                              shown_path(request.file)));
    return misused;
  }

  const Lowered lowered = lower(checked->model);
  std::vector<Output> outputs;
  std::vector<std::string> paths;
  for (Artefact& artefact : emit({sources, checked->model, lowered})) {
    paths.push_back((std::filesystem::path(request.folder) / artefact.path).string());
    outputs.push_back({paths.back(), std::move(artefact.text), has_notice});
  }
  if (!request.depfile.empty()) {
    const std::vector<std::string> targets = request.target.empty() ? paths : std::vector{request.target};
    if (const auto path = inexpressible_path(targets, sources, checked->headers)) {
      print_message(console, no_depfile(*path, request.depfile, "nothing is written"));
      return misused;
    }
    outputs.push_back({request.depfile, depfile(targets, sources, checked->headers), is_depfile, true});
  }
  // The header is replaced last. After an interruption between two files it is the old one: `verify` reports that, and
  // a build whose rule names it makes all of them again.
  std::rotate(outputs.begin(), outputs.begin() + 1, outputs.end());
  return write(outputs, console, "nothing is written; ") ? clean : misused;
}

} // namespace director::compiler::cli
