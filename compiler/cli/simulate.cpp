// Door: compiler/cli/commands.hpp. Test: tests/compiler/cli/scenario_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/load_scenario.hpp"
#include "compiler/play/play.hpp"
#include "compiler/play/row_names.hpp"
#include "runtime/hosted/trace/json_lines.hpp"

namespace director::compiler::cli {

namespace {

/// All events as JSON lines.
struct Tape {
  const RowNames rows;
  director::Names names;
  std::string text;

  Observer begin(const std::string& file) {
    names = rows.names();
    append_header(names, file, text);
    text += '\n';
    return {[](void* self, const Event& event) {
              auto& tape = *static_cast<Tape*>(self);
              append_event(event, tape.names, tape.text);
              tape.text += '\n';
            },
            this};
  }
};

} // namespace

int run(const Simulate& request, Console& console) {
  dsl::Sources sources;
  const LoadedScenario loaded = load_scenario(request.file, sources, console);
  if (loaded.status != clean) return loaded.status;
  const ShowTimes times = request.times ? ShowTimes::yes : ShowTimes::no;
  const Sink sink = [&](const Happening& happening) {
    console.out << (request.format == Format::json ? to_json(happening, times) : to_text(happening, times, console.out_colours))
                << '\n';
  };
  PlayOptions options;
  options.decisions = request.decisions;
  Tape tape{RowNames(loaded.model, loaded.lowered), {}, {}};
  if (!request.trace.empty()) options.events = tape.begin(loaded.behaviour);
  const Played played = play(loaded.scenario, loaded.model, loaded.lowered, options, sink);
  if (!request.trace.empty()) {
    if (const auto wrong = console.outputs.write({{request.trace, std::move(tape.text)}})) {
      console.err << "directorc: " << *wrong << '\n';
      return misused;
    }
  }
  if (played.refused) {
    console.out.flush();
    print_findings({*played.refused}, sources, console.err, console.err_colours);
  }
  return played.refused || played.budget_exhausted ? found : clean;
}

} // namespace director::compiler::cli
