// Door: compiler/cli/commands.hpp. Test: tests/cli/check_test.cpp.
#include "compiler/cli/load.hpp"
#include "compiler/emit/findings_json.hpp"

namespace director::compiler::cli {

int run(const Check& request, Console& console) {
  dsl::Sources sources;
  CheckOptions options;
  options.selection = request.selection;
  const std::optional<Checked> checked = load(request.file, options, sources, console);
  if (!checked) return misused;
  if (request.format == Format::json) {
    console.out << to_lines(findings_json(checked->findings, sources));
  } else {
    print_findings(checked->findings, sources, console.out, console.out_colours);
  }
  return dsl::has_errors(checked->findings) ? found : clean;
}

} // namespace director::compiler::cli
