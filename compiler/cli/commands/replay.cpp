// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/cli/commands/trace_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/trace/replay.hpp"

#include "compiler/base/counted.hpp"
#include "compiler/base/seconds.hpp"
#include "compiler/cli/input/load.hpp"
#include "compiler/cli/input/load_trace.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/lower/row_names.hpp"
#include "dsl/source/harmless.hpp"

#include <fmt/format.h>

namespace director::compiler::cli {

namespace {

/// Text of several lines.
std::string to_text(const Replayed& replayed, const std::string& trace, const std::string& behaviour, bool other) {
  std::string out;
  const std::string version = other ? fmt::format(" by `{}`, another version than the one recorded", behaviour) : "";
  if (replayed.difference && replayed.begins_later) {
    out += fmt::format("{}:{}: the trace begins in the middle, at {} s: its first event is not `begin`, so the state "
                       "before it is not known, and it cannot be replayed\n",
                       trace, replayed.difference->line, in_seconds(replayed.difference->time));
    out += "  its recorder was made later than the first step, the program loaded a saved state before that, or lines "
           "at the beginning of the trace are missing\n";
  } else if (replayed.difference) {
    const Replayed::Difference& it = *replayed.difference;
    out += fmt::format("{}:{}: event {}, at {} s, {}{}\n", trace, it.line, it.event, in_seconds(it.time),
                       it.is_impossible ? "cannot be replayed" : "is decided otherwise",
                       it.is_impossible && !other ? fmt::format(" by `{}`", behaviour) : version);
    out += fmt::format("  recorded: {}\n  replayed: {}\n", it.recorded, it.replayed);
    if (!it.help.empty()) out += fmt::format("  help: {}\n", it.help);
    out += fmt::format("  {} before it {} the same\n", many_counted(replayed.events, "event"),
                       replayed.events == 1 ? "is" : "are");
    if (!other && it.is_impossible)
      out += "  it decides as the version that was recorded, but declares something else, or the line was changed\n";
    else if (!other) // which decides the same every time
      out +=
          "  it is the version that was recorded: lines of the trace are missing or were changed, the program loaded "
          "another state there, or another version of Director recorded it\n";
  } else if (!replayed.problem.empty()) {
    out += fmt::format("{}: {} the same{}, up to line {}, which cannot be read\n", trace,
                       many_counted(replayed.events, "event"), version, replayed.problem_line);
  } else if (replayed.dropped != 0) {
    out += fmt::format("{}: {} the same{}, up to where {} missing\n", trace, many_counted(replayed.events, "event"),
                       version, counted_are(replayed.dropped, "event"));
  } else if (replayed.events == 0) {
    out += fmt::format("{}: the trace has no events behind its header: nothing was replayed\n", trace);
  } else {
    out += fmt::format("{}: {}, all the same{}\n", trace, many_counted(replayed.events, "event"), version);
  }
  return out;
}

Json to_json(const Replayed& replayed, const std::string& trace, const std::string& behaviour, bool other) {
  Json out = Json::object({{"trace", Json::text(trace)},
                           {"behaviour", Json::text(behaviour)},
                           {"other_version", Json::boolean(other)},
                           {"events", Json::count(replayed.events)},
                           {"dropped", Json::number(static_cast<std::int64_t>(replayed.dropped))}});
  if (replayed.difference && replayed.begins_later) {
    out.add("begins_in_the_middle", Json::object({{"line", Json::count(replayed.difference->line)},
                                                  {"time_us", Json::number(replayed.difference->time)}}));
  } else if (replayed.difference) {
    const Replayed::Difference& it = *replayed.difference;
    const auto event = [](const std::string& line) { return parse_json(line).value_or(Json{}); };
    out.add("difference", Json::object({{"line", Json::count(it.line)},
                                        {"event", Json::count(it.event)},
                                        {"time_us", Json::number(it.time)},
                                        {"recorded", event(it.recorded_line)},
                                        {"replayed", event(it.replayed_line)}}));
    if (it.is_impossible) out.add("cannot_be_replayed", Json::text(it.replayed));
    if (!it.help.empty()) out.add("help", Json::text(it.help));
  }
  if (!replayed.problem.empty())
    out.add("unreadable",
            Json::object({{"line", Json::count(replayed.problem_line)}, {"problem", Json::text(replayed.problem)}}));
  return out;
}

} // namespace

int run(const Replay& request, Console& console) {
  LoadedTrace trace = load_trace(request.trace, console);
  if (trace.status != clean) return trace.status;
  dsl::Sources sources;
  const RecordedBehaviour of =
      load_behaviour(*trace.recorded, request.trace, request.behaviour, only_errors(), sources, console, request.cpp);
  if (of.status != clean) return of.status;
  const Lowered lowered = lower(of.checked.model);
  const RowNames rows(of.checked.model, lowered);
  const std::optional<bool> same = is_of_version(trace, request.trace, rows.names(), of.file, console);
  if (!same) return found;
  const bool other = !*same;
  TraceLines lines(trace.text);
  lines.next(); // the header
  const director::Names recorded = trace.recorded->names();
  const Replayed replayed = replay(lines, of.checked.model, rows.names(), nullptr, other ? &recorded : nullptr);
  // A replay reads ahead: a fault behind its end is not reported.
  if (!replayed.problem.empty())
    print_unreadable(request.trace, replayed.problem_line, replayed.problem, console);
  else if (!replayed.difference && replayed.dropped == 0)
    print_end(lines, request.trace, console);
  const std::string shown = shown_path(request.trace);
  if (request.format == Format::json)
    console.out << to_line(to_json(replayed, shown, of.file, other)) << '\n';
  else
    console.out << dsl::harmless_lines(to_text(replayed, shown, of.file, other));
  return replayed.difference || !replayed.problem.empty() || replayed.events == 0 ? found : clean;
}

} // namespace director::compiler::cli
