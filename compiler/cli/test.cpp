// Door: compiler/cli/commands.hpp. Test: tests/cli/scenario_test.cpp.
#include "compiler/cli/load_scenario.hpp"
#include "compiler/play/test_scenario.hpp"

#include <fmt/format.h>

namespace director::compiler::cli {

namespace {

int test(const std::string& file, Console& console) {
  dsl::Sources sources;
  const LoadedScenario loaded = load_scenario(file, sources, console);
  if (loaded.status != clean) return loaded.status;
  const ScenarioResult result = test_scenario(loaded.scenario, loaded.model, loaded.lowered);
  const std::string& title = loaded.scenario.title;
  console.out << fmt::format("{:<5} {}{}\n", result.holds() ? "holds" : "fails", shown_path(file),
                             title.empty() ? "" : ": " + title);
  console.out << render(result, sources);
  if (result.played.refused) {
    console.out.flush();
    print_findings({*result.played.refused}, sources, console.err, console.err_colours);
  }
  return result.holds() ? clean : found;
}

} // namespace

int run(const Test& request, Console& console) {
  int status = clean;
  std::size_t holding = 0;
  for (const std::string& file : request.files) {
    const int one = test(file, console);
    status = std::max(status, one);
    if (one == clean) ++holding;
  }
  if (request.files.size() > 1) console.out << fmt::format("{} of {} hold\n", holding, request.files.size());
  return status;
}

} // namespace director::compiler::cli
