// Header: compiler/cli/commands/trace_page.hpp. Test: tests/compiler/cli/commands/trace_page_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/commands/trace_page.hpp"

#include "compiler/base/counted.hpp"
#include "compiler/base/packed.hpp"
#include "compiler/base/seconds.hpp"
#include "compiler/cli/commands/make_page.hpp"
#include "compiler/cli/input/load.hpp"
#include "compiler/explore/limits.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/lower/row_names.hpp"
#include "compiler/trace/lookup.hpp"
#include "compiler/trace/recording.hpp"
#include "runtime/hosted/trace/event_text.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <utility>

namespace director::compiler::cli {

namespace {

/// `to` is not earlier. The longest duration is longer than a Time can hold.
std::uint64_t between(Time from, Time to) { return static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from); }

constexpr std::size_t first_events = 40; ///< that are in the page as text

/// Why the answers of `why` end early; empty: they do not.
std::string end_of(const Waits& waits) {
  const Replayed& replayed = waits.replayed;
  if (replayed.dropped != 0)
    return fmt::format("{} missing before: why something waits is not known from there on",
                       counted_are(replayed.dropped, "event"));
  if (!replayed.problem.empty())
    return fmt::format("line {} of the trace cannot be read: why something waits is not known from there on",
                       replayed.problem_line);
  if (replayed.difference && replayed.begins_later)
    return "the trace begins in the middle, so that it cannot be played again: why something waits is not known";
  if (replayed.difference && replayed.difference->is_impossible)
    return fmt::format("from {} s on it cannot be played again, since {}; why something waits is not known",
                       in_seconds(replayed.difference->time), replayed.difference->replayed);
  if (replayed.difference)
    return fmt::format(
        "from {} s on it is decided otherwise when it is played again, so why something waits is not known",
        in_seconds(replayed.difference->time));
  return {};
}

/// The lines behind the header, up to the first fault.
class Reading {
public:
  Reading(const director::Names& names, Recording& recording, PageRecording& page)
      : names_(names),
        lookup_(names),
        recording_(recording),
        page_(page) {}

  /// False: the fault of a line was printed.
  bool read(TraceLines& lines, const std::string& file, Console& console) {
    std::string unused;
    while (const std::optional<TraceLine> line = lines.next()) {
      if (line->dropped != 0) {
        recording_.dropped(line->dropped, unused);
        add(recording_.ends(), counted_are(line->dropped, "event") + " missing");
        continue;
      }
      const Lookup::Found event = event_of(*line, lookup_, names_);
      if (!event.problem.empty()) {
        print_unreadable(file, line->number, event.problem, console);
        return false;
      }
      recording_.event(event.event, unused);
      if (std::string words = to_text(event.event, names_); !words.empty()) add(event.event.time, std::move(words));
    }
    return print_end(lines, file, console);
  }

private:
  void add(Time time, std::string words) {
    if (page_.first.size() == first_events)
      ++page_.more;
    else
      page_.first.push_back({in_seconds(time), std::move(words)});
  }

  const director::Names names_;
  const Lookup lookup_;
  Recording& recording_;
  PageRecording& page_;
};

} // namespace

std::pair<std::string, int> trace_page(const Trace& request, const LoadedTrace& trace, Console& console) {
  dsl::Sources sources;
  CheckOptions checks;
  checks.decide = states_of_check;
  const RecordedBehaviour of =
      load_behaviour(*trace.recorded, request.file, request.behaviour, checks, sources, console, request.cpp);
  if (of.status != clean) return {{}, of.status};
  const Lowered lowered = lower(of.checked.model);
  const RowNames rows(of.checked.model, lowered);
  const std::optional<bool> same = is_of_version(trace, request.file, rows.names(), of.file, console);
  if (!same) return {{}, found};
  if (!*same) {
    print_message(
        console,
        fmt::format("{}:1: error: this is a trace of another version of `{}`\n  help: --behaviour names the version "
                    "that was recorded; `directorc replay` says what this one decides otherwise\n",
                    shown_path(request.file), of.file));
    return {{}, found};
  }
  TraceLines replayed(trace.text), lines(trace.text);
  const std::optional<TraceLine> header = lines.next();
  replayed.next();
  const Waits waits = find_waits(replayed, of.checked.model, lowered, sources);
  const std::string why_ends = end_of(waits);
  Recording recording(rows.names(), waits, why_ends);
  PageRecording page;
  bool whole = Reading(rows.names(), recording, page).read(lines, request.file, console);
  if (whole && waits.replayed.difference) // otherwise the fault is in the line
    print_message(
        console, fmt::format("{}:{}: note: {}\n", shown_path(request.file), waits.replayed.difference->line, why_ends));
  if (whole && !waits.replayed.problem.empty()) { // only playing it finds that
    print_unreadable(request.file, waits.replayed.problem_line, waits.replayed.problem, console);
    whole = false;
  }
  page.about = fmt::format("{} in {}, from {}{}.{}", many_counted(recording.events(), "event"),
                           as_duration(between(recording.begins(), recording.ends())), shown_path(request.file),
                           lines.cut_off() ? ", whose last line is cut off" : "",
                           waits.replayed.begins_later ? " The trace begins in the middle: what runs, and the value of "
                                                         "a state, is not known before an event tells it."
                                                       : "");
  page.data = base64(packed(recording.bytes(header->json)));
  PageWish wish;
  wish.link = request.link;
  wish.requested = "--to=html";
  wish.instead = "--to=text";
  wish.recording = &page;
  const std::optional<std::string> text = make_page(of.file, of.checked, sources, wish, console);
  if (!text) return {{}, misused};
  return {*text, whole ? clean : found};
}

} // namespace director::compiler::cli
