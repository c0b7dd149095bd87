// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/cli/commands/trace_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/counted.hpp"
#include "compiler/cli/commands/trace_page.hpp"
#include "compiler/cli/input/load.hpp"
#include "compiler/cli/input/load_trace.hpp"
#include "compiler/emit/artefact/notice.hpp"
#include "compiler/trace/lookup.hpp"
#include "compiler/trace/trace_order.hpp"
#include "dsl/source/harmless.hpp"
#include "runtime/hosted/decision_printer.hpp"
#include "runtime/hosted/trace/event_text.hpp"
#include "runtime/hosted/trace/trace_format.hpp"

#include <fmt/format.h>

#include <array>

namespace director::compiler::cli {

namespace {

/// The output of `simulate --decisions --times`.
class Text final : public TraceFormat {
public:
  explicit Text(const director::Names& names) : names_(names) {}
  void begin(std::string&) override {}
  void event(const Event& event, std::string& out) override {
    std::array<char, 40> time{};
    const std::string line = to_text(event, names_);
    if (!line.empty()) out.append(time_text(event.time, time)).append(dsl::harmless(line)).append("\n");
  }
  void dropped(std::uint64_t count, std::string& out) override {
    out += "... " + counted_are(count, "event") + " missing\n";
  }

private:
  const director::Names names_;
};

std::unique_ptr<TraceFormat> format_of(const std::string& word, const director::Names& names) {
  if (word == "perfetto") return perfetto(names);
  return std::make_unique<Text>(names);
}

/// Writes to the file, or to the terminal.
int put(const Trace& request, std::string text, int status, Console& console) {
  if (request.output.empty()) {
    console.out << text;
    return status;
  }
  const auto is_own = request.to == "html" ? is_document : is_trace;
  if (!write({{request.output, std::move(text), is_own}}, console)) return misused;
  if (request.to == "perfetto" && console.err_width != 0)
    print_message(console,
                  fmt::format("directorc: wrote `{}`; `Open trace file` on https://ui.perfetto.dev shows it, and keeps "
                              "it on this machine\n",
                              shown_path(request.output)));
  return status;
}

} // namespace

int run(const Trace& request, Console& console) {
  if (!request.output.empty() && console.files.identity(request.output) == console.files.identity(request.file)) {
    print_message(console, fmt::format("directorc: `{}` is the trace that is read; name another file with -o\n",
                                       shown_path(request.output)));
    return misused;
  }
  if (request.to == "perfetto" && request.output.empty() && console.out_width != 0) {
    console.err << "directorc: --to=perfetto writes bytes that a terminal cannot show: -o FILE.perfetto-trace writes "
                   "them to a file, for https://ui.perfetto.dev\n";
    return misused;
  }
  LoadedTrace trace = load_trace(request.file, console);
  if (trace.status != clean) return trace.status;
  if (request.to == "html") {
    auto [page, result] = trace_page(request, trace, console);
    return page.empty() ? result : put(request, std::move(page), result, console);
  }
  const director::Names names = trace.recorded->names();
  const Lookup lookup(names);
  const std::unique_ptr<TraceFormat> format = format_of(request.to, names);
  const bool as_it_is = request.to == "json"; // except for what cannot be read
  std::string out;
  TraceLines lines(trace.text);
  const std::optional<TraceLine> header = lines.next();
  const auto copy = [&](const TraceLine& line) { out.append(line.text).append("\n"); };
  if (as_it_is)
    copy(*header);
  else
    format->begin(out);
  int status = clean;
  TraceOrder order;
  bool is_in_order = true;
  while (const std::optional<TraceLine> line = lines.next()) {
    const Lookup::Found event = line->dropped == 0 ? event_of(*line, lookup, names) : Lookup::Found{};
    if (!event.problem.empty()) {
      print_unreadable(request.file, line->number, event.problem, console);
      status = found;
      break;
    }
    if (line->dropped != 0) {
      order.gap();
    } else if (const std::string problem = order.problem_of(event.event); !problem.empty() && is_in_order) {
      print_out_of_order(request.file, line->number, problem, console);
      is_in_order = false;
      status = found;
    }
    if (as_it_is)
      copy(*line);
    else if (line->dropped != 0)
      format->dropped(line->dropped, out);
    else
      format->event(event.event, out);
  }
  if (!as_it_is) format->end(out);
  if (!print_end(lines, request.file, console)) status = found;
  return put(request, std::move(out), status, console);
}

} // namespace director::compiler::cli
