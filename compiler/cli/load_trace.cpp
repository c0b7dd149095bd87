// Door: compiler/cli/load_trace.hpp. Test: tests/compiler/cli/trace_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/load_trace.hpp"

#include "compiler/cli/load.hpp"

#include <fmt/format.h>

#include <limits>

namespace director::compiler::cli {

void say_problem(const std::string& file, std::size_t line, const std::string& problem, Console& console) {
  console.err << fmt::format("{}:{}: error: {}\n", shown_path(file), line, problem);
}

LoadedTrace load_trace(const std::string& file, Console& console) {
  LoadedTrace out;
  auto read = console.files.read(file, std::numeric_limits<std::int32_t>::max());
  if (!read) {
    console.err << fmt::format("directorc: `{}` cannot be read: {}\n", shown_path(file), read.error().message);
    out.status = misused;
    return out;
  }
  out.text = std::move(read.value());
  TraceLines lines(out.text);
  std::string problem = "this is no trace: its first line is not the header of one";
  if (const std::optional<TraceLine> header = lines.next()) out.recorded = RecordedNames::read(header->json, problem);
  if (!out.recorded) {
    say_problem(file, 1, problem, console);
    out.status = found;
  }
  return out;
}

bool say_end(const TraceLines& lines, const std::string& file, Console& console) {
  if (lines.cut_off())
    console.err << fmt::format("{}:{}: note: the last line is cut off, and was left out\n", shown_path(file), lines.number());
  if (lines.problem().empty()) return true;
  say_problem(file, lines.number(), lines.problem(), console);
  return false;
}

} // namespace director::compiler::cli
