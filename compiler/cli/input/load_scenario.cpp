// Header: compiler/cli/input/load_scenario.hpp. Test: tests/compiler/cli/commands/scenario_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/input/load_scenario.hpp"

#include "compiler/base/counted.hpp"
#include "compiler/base/seconds.hpp"
#include "compiler/cli/input/named_file.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/play/scenario/resolve_scenario.hpp"
#include "dsl/reading/read_scenario.hpp"
#include "dsl/source/load_file.hpp"
#include "dsl/source/render.hpp"

#include <fmt/format.h>

namespace director::compiler::cli {

namespace {

using Findings = std::vector<dsl::Diagnostic>;

/// The errors that prevent the behaviour from being played; empty if there are none. Other errors do not matter here.
Findings obstacles(const Checked& checked, const dsl::Word& behaviour) {
  if (!checked.spec.files.empty() && checked.lowerable) return {};
  if (checked.spec.files.empty() && checked.findings.size() == 1) {
    dsl::Diagnostic finding = checked.findings.front(); // the file cannot be read: the scenario names it
    finding.span = behaviour.span;
    if (finding.help == dsl::relative_to_program) finding.help = dsl::relative_to_file;
    return {finding};
  }
  Findings errors = checked.findings;
  if (errors.empty()) {
    errors.push_back(
        {"missing_key",
         dsl::Level::error,
         behaviour.span,
         fmt::format("`{}` has no `roots`: it is a module, and nothing can be requested of it", behaviour.value),
         {},
         {}});
  }
  return errors;
}

/// Returns those that were not printed yet, and marks them as printed: several scenarios may share one behaviour.
Findings not_among(std::set<std::string>& printed, const Findings& findings, const dsl::Sources& sources) {
  Findings out;
  for (const dsl::Diagnostic& finding : findings) {
    if (printed.insert(dsl::render(finding, sources, {})).second) out.push_back(finding);
  }
  return out;
}

} // namespace

LoadedScenario load_scenario(const std::string& file, dsl::Sources& sources, Console& console, const CppSource& cpp,
                             std::set<std::string>* printed) {
  LoadedScenario out;
  const auto stop = [&](int status, const Findings& findings) {
    const Findings anew = printed == nullptr ? findings : not_among(*printed, findings, sources);
    print_findings(anew, sources, console.err, console.err_colours, console.err_width);
    if (anew.size() < findings.size())
      print_message(console, fmt::format("directorc: `{}` cannot be played either: {} printed above\n",
                                         shown_path(file), counted_are(findings.size() - anew.size(), "error")));
    out.status = status;
    out.findings = findings;
  };
  const std::string path = shown_path(file);
  const dsl::ReadScenarioResult read = dsl::read_scenario(path, console.files, sources);
  if (!read.diagnostics.empty() && read.diagnostics.front().id == "import_not_found") {
    print_message(console, fmt::format("directorc: {}{}\n", read.diagnostics.front().message,
                                       file_instead(path, is_called_scenario, console)));
    out.status = misused;
    return out;
  }
  if (dsl::has_errors(read.diagnostics)) return stop(found, read.diagnostics), out;

  std::string fault;
  Checked checked = check_file(read.scenario.behaviour_path, only_errors(), sources, console, cpp, fault);
  if (!fault.empty()) {
    print_message(console, fmt::format("directorc: {}\n", fault));
    out.status = misused;
    return out;
  }
  if (const Findings why = obstacles(checked, read.scenario.behaviour); !why.empty()) return stop(found, why), out;

  out.file = read.scenario.file;
  out.behaviour = read.scenario.behaviour_path;
  out.model = std::move(checked.model);
  out.graph = std::move(checked.graph);
  ResolvedScenario resolved = resolve_scenario(read.scenario, out.model);
  if (dsl::has_errors(resolved.findings)) return stop(found, resolved.findings), out;
  print_findings(resolved.findings, sources, console.err, console.err_colours, console.err_width);
  out.findings = resolved.findings;
  out.lowered = lower(out.model);
  out.scenario = std::move(resolved.scenario);
  return out;
}

bool has_moment(const LoadedScenario& loaded, const std::string& file, std::uint32_t step,
                std::optional<std::int64_t> time, Console& console) {
  const std::size_t steps = loaded.scenario.steps.size();
  const Time end = time_after(loaded.scenario, steps);
  std::string ends;
  if (step > steps) ends = "has " + counted(steps, "step");
  if (time && *time > end) ends = fmt::format("ends at {}, before {}", exact_seconds(end), exact_seconds(*time));
  if (!ends.empty()) print_message(console, fmt::format("directorc: `{}` {}\n", file, ends));
  return ends.empty();
}

std::optional<Played> play_to(const LoadedScenario& loaded, std::uint32_t step, std::optional<Time> time,
                              std::function<void(const Engine&)> end, const dsl::Sources& sources, Console& console) {
  PlayOptions options;
  options.steps = step;
  options.until = time;
  options.end = std::move(end);
  Played played = play(loaded.scenario, loaded.model, loaded.lowered, options, [](const Happening&) {});
  if (played.refused) {
    print_findings({*played.refused}, sources, console.err, console.err_colours, console.err_width);
    return std::nullopt;
  }
  if (played.budget_exhausted) print_early_end(played, sources[loaded.file].path(), console);
  if (step > played.last_step) return std::nullopt;
  return played;
}

void print_early_end(const Played& played, const std::string& file, Console& console) {
  const std::string why =
      played.too_many_stops
          ? fmt::format("something is due at more than {} times within it; advance by less", stops_of_advance)
          : "the engine does not come to rest" + words_of_round(played);
  print_message(console, fmt::format("directorc: `{}` ends in step {}: {}\n", shown_path(file), played.last_step, why));
}

} // namespace director::compiler::cli
