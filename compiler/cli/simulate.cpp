// Door: compiler/cli/commands.hpp. Test: tests/compiler/cli/scenario_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/load_scenario.hpp"
#include "compiler/play/play.hpp"

namespace director::compiler::cli {

int run(const Simulate& request, Console& console) {
  dsl::Sources sources;
  const LoadedScenario loaded = load_scenario(request.file, sources, console);
  if (loaded.status != clean) return loaded.status;
  const ShowTimes times = request.times ? ShowTimes::yes : ShowTimes::no;
  const Sink sink = [&](const Happening& happening) {
    console.out << (request.format == Format::json ? to_json(happening, times) : to_text(happening, times, console.out_colours))
                << '\n';
  };
  const Played played = play(loaded.scenario, loaded.model, loaded.lowered, {.decisions = request.decisions}, sink);
  if (played.refused) {
    console.out.flush();
    print_findings({*played.refused}, sources, console.err, console.err_colours);
  }
  return played.refused || played.budget_exhausted ? found : clean;
}

} // namespace director::compiler::cli
