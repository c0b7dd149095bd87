// Header: compiler/cli/input/load_trace.hpp. Test: tests/compiler/cli/commands/trace_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/input/load_trace.hpp"

#include "compiler/base/for_shell.hpp"
#include "compiler/cli/input/load.hpp"
#include "compiler/cli/input/named_file.hpp"
#include "runtime/hosted/trace/fingerprint.hpp"
#include "runtime/hosted/trace/json_lines.hpp"

#include <fmt/format.h>

#include <limits>
#include <string_view>

namespace director::compiler::cli {

namespace {
constexpr std::size_t most_bytes = std::numeric_limits<std::int32_t>::max(); ///< that are held in memory
} // namespace

void print_unreadable(const std::string& file, std::size_t line, const std::string& problem, Console& console) {
  print_message(console,
                fmt::format("{0}:{1}: error: this line cannot be read: {2}\n"
                            "  help: expected is one JSON object a line, an event each, as a recorder writes them; the "
                            "lines before are good: `head -n {3} {4}` prints them\n",
                            shown_path(file), line, problem, line - 1, for_shell(shown_path(file))));
}

void print_out_of_order(const std::string& file, std::size_t line, const std::string& problem, Console& console) {
  print_message(console, fmt::format("{0}:{1}: error: {2}\n"
                                     "  help: a recorder writes every event, in the order in which it happened, and "
                                     "says where it dropped some; what is printed behind this line may be wrong\n",
                                     shown_path(file), line, problem));
}

LoadedTrace load_trace(const std::string& file, Console& console) {
  LoadedTrace out;
  auto read = console.files.read(file, most_bytes);
  if (!read) {
    print_message(console, fmt::format("directorc: cannot read `{}`: {}{}\n", shown_path(file), read.error().message,
                                       file_instead(shown_path(file), is_called_trace, console)));
    if (read.error().kind == dsl::FileError::Kind::too_large)
      console.err << fmt::format("  help: a trace has at most 2 GB; `(head -n 1 {0}; tail -n 1000000 {0}) > end.jsonl` "
                                 "writes its end with the header, which `directorc trace` reads\n",
                                 for_shell(shown_path(file)));
    out.status = misused;
    return out;
  }
  out.text = std::move(read.value());
  TraceLines lines(out.text);
  const std::string_view no_header = "this is no trace: its first line is not the header of one";
  std::string problem(no_header);
  if (const std::optional<TraceLine> header = lines.next()) {
    out.header = header->text;
    out.recorded = RecordedNames::read(header->json, problem);
  }
  if (out.text.empty()) problem = "the trace is empty: nothing was recorded, or nothing of it was written";
  if (lines.cut_off() && out.text.starts_with("{\"director_trace\""))
    problem = "the trace is cut off within its first line";
  if (!out.recorded) {
    print_message(console, fmt::format("{}:1: error: {}\n", shown_path(file), problem));
    if (problem == no_header)
      console.err << "  help: expected are the JSON lines of a recorder or of `directorc simulate --trace`; a "
                     ".perfetto-trace is opened on https://ui.perfetto.dev\n";
    out.status = found;
  }
  return out;
}

std::optional<bool> is_of_version(const LoadedTrace& trace, const std::string& file, const director::Names& names,
                                  const std::string& behaviour, Console& console) {
  if (fingerprint_text(names) != trace.recorded->fingerprint) return false;
  director::Names recorded = names;
  // The fingerprint is independent of the behaviour's own name, which may be another one now.
  recorded.behaviour = trace.recorded->behaviour().c_str();
  std::string written;
  append_header(recorded, trace.recorded->file, written);
  if (written == trace.header) return true;
  // Programs generated before did not record who requests which level. If that differs, the version is another one.
  recorded.level_uses = {};
  written.clear();
  append_header(recorded, trace.recorded->file, written);
  if (written == trace.header) return true;
  written.back() = ',';
  if (trace.header.starts_with(written + "\"level_uses\":")) return false;
  print_message(console,
                fmt::format("{0}:1: error: the header of the trace was changed: it has the fingerprint of "
                            "`{1}`, but does not name what that behaviour has\n"
                            "  help: the header of any other trace of this version may replace it, such as one "
                            "of `directorc simulate --trace`\n",
                            shown_path(file), behaviour));
  return {};
}

Lookup::Found event_of(const TraceLine& line, const Lookup& lookup, const director::Names& names) {
  Lookup::Found out = lookup.event(line.json);
  if (!out.problem.empty()) return out;
  std::string written;
  append_event(out.event, names, written);
  if (written != line.text) out.problem = "a recorder would have written it as " + written;
  return out;
}

namespace {

std::string file_of(const RecordedNames& recorded, const std::string& trace, Console& console) {
  const std::string file = recorded.file.empty() ? recorded.behaviour() + ".yaml" : recorded.file;
  const std::size_t folder = trace.rfind('/');
  const std::string beside = folder == std::string::npos ? file : trace.substr(0, folder + 1) + file;
  constexpr std::size_t any = 1 << 30;
  return console.files.read(file, any, dsl::Kinds::ordinary) || !console.files.read(beside, any, dsl::Kinds::ordinary)
             ? file
             : beside;
}

} // namespace

RecordedBehaviour load_behaviour(const RecordedNames& recorded, const std::string& trace, const std::string& named,
                                 const CheckOptions& options, dsl::Sources& sources, Console& console,
                                 const CppSource& cpp) {
  RecordedBehaviour out;
  out.file = shown_path(named.empty() ? file_of(recorded, trace, console) : named);
  std::optional<Checked> checked = load(out.file, options, sources, console, cpp);
  if (!checked) {
    if (named.empty())
      console.err << fmt::format("  help: {}; where it is neither there nor beside the trace, say where it is with "
                                 "--behaviour FILE\n",
                                 recorded.file.empty()
                                     ? "the trace has the behaviour's name, and no file: that of the name is taken"
                                     : "the trace names this behaviour");
    out.status = misused;
  } else if (checked->lowerable) {
    out.checked = std::move(*checked);
  } else {
    const std::vector<dsl::Diagnostic> errors = errors_of(checked->findings);
    print_findings(errors, sources, console.err, console.err_colours, console.err_width);
    if (errors.empty())
      print_message(console,
                    fmt::format("directorc: `{}` has no `roots`: a module alone cannot be played\n", out.file));
    out.status = errors.empty() ? misused : found;
  }
  return out;
}

bool print_end(const TraceLines& lines, const std::string& file, Console& console) {
  if (lines.cut_off())
    print_message(console, fmt::format("{}:{}: note: the last line is cut off, and was left out\n", shown_path(file),
                                       lines.number()));
  if (lines.problem().empty()) return true;
  print_unreadable(file, lines.number(), lines.problem(), console);
  return false;
}

} // namespace director::compiler::cli
