// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/cli/commands/scenario_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/ranks/print_priorities.hpp"
#include "compiler/cli/input/load.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/lower/print_tables.hpp"
#include "compiler/model/print_model.hpp"
#include "dsl/reading/print_spec.hpp"

#include <fmt/format.h>

namespace director::compiler::cli {

int run(const Dump& request, Console& console) {
  dsl::Sources sources;
  const std::optional<Checked> checked = load(request.file, only_errors(), sources, console, request.cpp);
  if (!checked) return misused;
  const bool spec = request.stage == "spec", tables = request.stage == "tables";
  // The spec exists even with errors; later stages only if they can be computed.
  const bool possible = spec || (tables ? checked->lowerable : checked->resolved);
  const std::vector<dsl::Diagnostic>& errors = checked->findings;
  if (spec || !possible) print_findings(errors, sources, console.err, console.err_colours, console.err_width);
  if (spec) {
    console.out << dsl::print_spec(checked->spec, sources);
  } else if (!possible) {
    if (errors.empty())
      print_message(console, fmt::format("directorc: `{}` has no `roots`: a module alone has no tables\n",
                                         shown_path(request.file)));
    return errors.empty() ? misused : found;
  } else if (request.stage == "model") {
    console.out << print_model(checked->model);
  } else if (request.stage == "graph") {
    console.out << print_graph(checked->model, checked->graph);
  } else {
    console.out << print_tables(checked->model, lower(checked->model)) << '\n'
                << analysis::print_priorities(checked->model);
  }
  return spec && dsl::has_errors(errors) ? found : clean;
}

} // namespace director::compiler::cli
