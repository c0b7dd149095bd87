// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/cli/commands/why_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/why/why.hpp"

#include "compiler/cli/input/load_scenario.hpp"
#include "compiler/play/play.hpp"
#include "compiler/play/scenario/names.hpp"
#include "runtime/core/inspect/view.hpp"

#include <fmt/format.h>

namespace director::compiler::cli {

int run(const Why& request, Console& console) {
  dsl::Sources sources;
  const LoadedScenario loaded = load_scenario(request.scenario, sources, console, request.cpp);
  if (loaded.status != clean) return loaded.status;
  std::vector<dsl::Diagnostic> findings;
  const std::optional<GroupId> group = Names(loaded.model, findings).group({request.group, {}});
  if (!group) {
    const dsl::Diagnostic& wrong = findings.front();
    print_message(console,
                  fmt::format("directorc: {}{}\n", wrong.message, wrong.help.empty() ? "" : "; " + wrong.help));
    return misused;
  }
  if (!has_moment(loaded, request.scenario, request.step, request.time, console)) return misused;
  Reasoning reasoning;
  const auto end = [&](const Engine& engine) {
    reasoning = reason_why(view_of(engine), *group, loaded.model, loaded.lowered);
  };
  const std::optional<Played> played = play_to(loaded, request.step, request.time, end, sources, console);
  if (!played) return found;
  if (request.format == Format::json) {
    console.out << to_line(to_json(reasoning, sources)) << '\n';
  } else {
    console.out << to_text(reasoning, sources, console.out_colours);
  }
  return played->budget_exhausted ? found : clean;
}

} // namespace director::compiler::cli
