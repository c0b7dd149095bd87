// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/cli/commands/graph_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/seconds.hpp"
#include "compiler/cli/input/load_scenario.hpp"
#include "compiler/cli/input/named_groups.hpp"
#include "compiler/cli/system/draw_svg.hpp"
#include "compiler/cli/system/earlier_outputs.hpp"
#include "compiler/emit/artefact/notice.hpp"
#include "compiler/emit/graph/formats.hpp"
#include "compiler/emit/graph/picture/flaws.hpp"
#include "compiler/emit/graph/picture/focus.hpp"
#include "compiler/explore/limits.hpp"
#include "compiler/page/facts/facts.hpp"
#include "compiler/play/play.hpp"
#include "compiler/play/why/moment.hpp"
#include "runtime/core/inspect/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace director::compiler::cli {

namespace {

/// Limit for the arrows of --view=takes: tasks that all want the same have quadratically many. A real team's robot has
/// thirty.
constexpr std::size_t most_takes_drawn = 2'000;

PictureOptions::View view_of(const std::string& name) {
  using View = PictureOptions::View;
  static const std::map<std::string, View> views{
      {"tasks", View::tasks}, {"needs", View::needs}, {"pushes", View::pushes}, {"takes", View::takes}};
  const auto found = views.find(name);
  return found == views.end() ? View::all : found->second;
}

/// What is drawn: a behaviour, or the one that a scenario plays.
struct Subject {
  const Model& model;
  const Graph& graph;
  const Graph& drawn; ///< only with pushes that are possible
  bool lowerable = false;
  const std::vector<dsl::Diagnostic>* findings = nullptr; ///< null: they were not requested
  const std::vector<Verdict>* verdicts = nullptr;         ///< of the assertions; null: not decided
};

/// Empty, and prints why, if a named group does not exist.
std::optional<PictureOptions> options_of(const DrawGraph& request, const Subject& subject, Console& console) {
  PictureOptions out;
  out.view = view_of(request.view);
  if (request.collapse == "module") out.fold = PictureOptions::Fold::modules;
  if (request.collapse == "layer") out.fold = PictureOptions::Fold::layers;
  out.depth = request.depth;
  std::optional<std::vector<GroupId>> focus = named_groups(request.focus, "--focus", subject.model, console);
  if (!focus) return {};
  out.focus = std::move(*focus);
  const bool takes = out.view == PictureOptions::View::takes;
  if ((takes || request.page) && !subject.lowerable) {
    print_message(console,
                  fmt::format("directorc: {} needs a behaviour that can run: with `roots` and without errors\n",
                              takes ? "--view=takes" : "--page"));
    return {};
  }
  if (!takes) return out;
  const bool folds = out.fold != PictureOptions::Fold::nothing;
  const std::size_t most = folds ? most_takes : most_takes_drawn;
  const TakeLimits::Among among{groups_in_focus(subject.model, subject.graph, out),
                                leading_to_focus(subject.model, subject.graph, out)};
  out.take_overs = take_overs_of(subject.model, subject.graph, {most, among});
  if (out.take_overs.size() <= most) return out;
  print_message(console,
                fmt::format("directorc: --view=takes would draw more than {} pairs of tasks: draw fewer groups, "
                            "with --focus and --depth{}\n",
                            most, folds ? "" : ", or fewer boxes, with --collapse"));
  return {};
}

std::optional<std::string> drawn(const Subject& subject, const dsl::Sources& sources, const DrawGraph& request,
                                 const PictureOptions& options, Console& console) {
  const Picture picture = make_picture(subject.model, subject.drawn, sources, options);
  const PictureLinks links{request.link};
  const std::string name = std::filesystem::path(request.file).filename().string();
  switch (request.format) {
  case Format::json: {
    Json data = graph_json({subject.model, subject.graph, sources, options.flaws,
                            options.moment ? &*options.moment : nullptr, subject.findings});
    const std::optional<std::vector<GroupId>> transitions = named_rows(request.transitions, subject.model, console);
    if (!transitions) return {};
    if (request.page) add_page_facts(data, subject.model, subject.graph, name, *transitions, subject.verdicts);
    return to_lines(data);
  }
  case Format::svg: {
    const std::optional<std::string> text = draw_svg(picture, links, "--format=svg", "--format=dot", console);
    return text ? std::optional(svg_with_notice(name, *text)) : text;
  }
  case Format::mermaid: return with_notice(name, "%% ", mermaid(picture, links));
  case Format::dot:
  case Format::sarif:
  case Format::html:
  case Format::markdown:
  case Format::text: break;
  }
  return with_notice(name, "// ", dot(picture, links));
}

/// Writes to the requested file, or to the terminal.
int hand_over(const std::string& text, const std::string& output, Console& console) {
  if (!output.empty()) return write({{output, text, is_document}}, console) ? clean : misused;
  console.out << text;
  return clean;
}

struct Reached {
  Moment moment;
  bool ended_early = false; ///< in its step; no other one follows
};

/// The moment after that step (0: at the end), or at that time. Empty, and prints why, if it is not reached.
std::optional<Reached> moment_in(const LoadedScenario& loaded, std::uint32_t step, std::optional<std::int64_t> time,
                                 const dsl::Sources& sources, Console& console) {
  Moment out;
  const auto end = [&](const Engine& engine) { out = moment_of(view_of(engine), loaded.model, loaded.lowered); };
  const std::optional<Played> played = play_to(loaded, step, time, end, sources, console);
  if (!played) return std::nullopt;
  if (played->last_step == 0) return Reached{out};
  const std::vector<std::string>& shown = loaded.scenario.steps[played->last_step - 1].shown;
  Microseconds now = time_after(loaded.scenario, played->last_step);
  if (time) now = std::min(now, *time);
  out.title = fmt::format("{} step {} ({}), at {}", time ? "in" : "after", played->last_step, fmt::join(shown, ", "),
                          exact_seconds(now));
  return Reached{out, played->budget_exhausted};
}

std::string_view ending_of(Format format) {
  switch (format) {
  case Format::svg: return "svg";
  case Format::json: return "json";
  case Format::mermaid: return "mmd";
  default: return "dot";
  }
}

int draw_moments(const DrawGraph& request, Console& console) {
  dsl::Sources sources;
  const LoadedScenario loaded = load_scenario(request.file, sources, console, request.cpp);
  if (loaded.status != clean) return loaded.status;
  const auto steps = static_cast<std::uint32_t>(loaded.scenario.steps.size());
  if (!has_moment(loaded, request.file, request.step, request.time, console)) return misused;
  if (request.frames && steps == 0) {
    print_message(console, fmt::format("directorc: `{}` has no steps, so there is nothing to draw after them\n",
                                       shown_path(request.file)));
    return misused;
  }
  const Graph graph = with_possible_pushes(loaded.model, loaded.graph);
  const Subject subject{loaded.model, loaded.graph, graph, true, nullptr};
  std::optional<PictureOptions> options = options_of(request, subject, console);
  if (!options) return misused;
  std::vector<Moment> moments;
  int status = clean;
  const std::uint32_t last = request.frames ? steps : request.step;
  for (std::uint32_t step = request.frames ? 1 : request.step; step <= last && status == clean; ++step) {
    std::optional<Reached> reached = moment_in(loaded, step, request.time, sources, console);
    if (!reached) return found;
    moments.push_back(std::move(reached->moment));
    if (reached->ended_early) status = found;
  }
  if (request.frames && (request.format == Format::dot || request.format == Format::svg)) options->frames = moments;
  std::vector<Output> frames;
  const std::size_t digits = std::to_string(steps).size();
  for (const Moment& moment : moments) {
    options->moment = moment;
    const std::optional<std::string> text = drawn(subject, sources, request, *options, console);
    if (!text) return misused;
    if (!request.frames) return std::max(status, hand_over(*text, request.output, console));
    const std::string name = fmt::format("step_{:0{}}.{}", frames.size() + 1, digits, ending_of(request.format));
    frames.push_back({(std::filesystem::path(request.output) / name).string(), *text, is_document});
  }
  if (!write(frames, console)) return misused;
  const auto is_frame = [&](std::string_view name, std::string_view) {
    constexpr std::string_view begin = "step_";
    const std::string end = fmt::format(".{}", ending_of(request.format));
    if (!name.starts_with(begin) || !name.ends_with(end) || name.size() <= begin.size() + end.size()) return false;
    const std::string_view number = name.substr(begin.size(), name.size() - begin.size() - end.size());
    return number.find_first_not_of("0123456789") == std::string_view::npos;
  };
  print_earlier_outputs(request.output, frames, is_frame, "frame", console);
  return status;
}

} // namespace

int run(const DrawGraph& request, Console& console) {
  if (request.step != 0 || request.time || request.frames) return draw_moments(request, console);
  dsl::Sources sources;
  const bool wants_all = request.findings || request.page;
  CheckOptions checks = wants_all ? CheckOptions{} : only_errors();
  checks.decide = wants_all ? states_of_check : 0;
  const std::optional<Checked> checked = load(request.file, checks, sources, console, request.cpp);
  if (!checked) return misused;
  const bool whole = checked->resolved;
  const std::vector<dsl::Diagnostic> errors = errors_of(checked->findings);
  print_findings(errors, sources, console.err, console.err_colours, console.err_width);
  if (!whole && checked->model.groups.empty()) return found;
  const Graph graph = whole ? Graph{} : make_graph(checked->model);
  const Graph& all = whole ? checked->graph : graph;
  const Graph drawable = checked->lowerable ? with_possible_pushes(checked->model, all) : all;
  const Subject subject{
      checked->model,         all, drawable, checked->lowerable, wants_all ? &checked->findings : nullptr,
      checked->verdicts.get()};
  std::optional<PictureOptions> options = options_of(request, subject, console);
  if (!options) return misused;
  if (!whole) options->flaws = find_missing(checked->spec, checked->model, sources, errors);
  if (request.findings) add_findings(options->flaws, checked->spec, checked->model, sources, checked->findings);
  const std::optional<std::string> text = drawn(subject, sources, request, *options, console);
  if (!text) return misused;
  const bool is_open = print_undecided(checked->undecided, console);
  const int status = hand_over(*text, request.output, console);
  if (status != clean || (errors.empty() && !is_open)) return status;
  return errors.empty() ? undecided : found;
}

} // namespace director::compiler::cli
