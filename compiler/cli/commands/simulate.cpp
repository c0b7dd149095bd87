// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/cli/commands/scenario_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/input/load_scenario.hpp"
#include "compiler/emit/artefact/notice.hpp"
#include "compiler/lower/row_names.hpp"
#include "compiler/play/play.hpp"
#include "runtime/hosted/trace/trace_format.hpp"

namespace director::compiler::cli {

namespace {

/// All events, as a robot's recorder writes them.
class TraceText {
public:
  TraceText(const LoadedScenario& loaded, const std::string& path)
      : rows_(loaded.model, loaded.lowered),
        format_(trace_format_of(path, rows_.names(), loaded.behaviour)) {
    format_->begin(text_);
  }
  Observer observer() {
    return {[](void* self, const Event& event) {
              auto& trace = *static_cast<TraceText*>(self);
              trace.format_->event(event, trace.text_);
            },
            this};
  }
  std::string take() {
    format_->end(text_);
    return std::move(text_);
  }

private:
  const RowNames rows_;
  const std::unique_ptr<TraceFormat> format_;
  std::string text_;
};

} // namespace

int run(const Simulate& request, Console& console) {
  dsl::Sources sources;
  const LoadedScenario loaded = load_scenario(request.file, sources, console, request.cpp);
  if (loaded.status != clean) return loaded.status;
  const ShowTimes times = request.times ? ShowTimes::yes : ShowTimes::no;
  const Sink sink = [&](const Happening& happening) {
    console.out << (request.format == Format::json ? to_json(happening, times)
                                                   : to_text(happening, times, console.out_colours))
                << '\n';
  };
  PlayOptions options;
  options.decisions = request.decisions;
  std::optional<TraceText> trace;
  if (!request.trace.empty()) options.events = trace.emplace(loaded, request.trace).observer();
  const Played played = play(loaded.scenario, loaded.model, loaded.lowered, options, sink);
  if (trace && !write({{request.trace, trace->take(), is_trace}}, console)) return misused;
  if (played.refused || played.budget_exhausted) console.out.flush();
  if (played.budget_exhausted) print_early_end(played, request.file, console);
  if (played.refused) {
    print_findings({*played.refused}, sources, console.err, console.err_colours, console.err_width);
  }
  return played.refused || played.budget_exhausted ? found : clean;
}

} // namespace director::compiler::cli
