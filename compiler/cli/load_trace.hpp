#pragma once
// SPDX-License-Identifier: MIT
// A trace whose header has been read.

#include "compiler/cli/commands.hpp"
#include "compiler/trace/recorded_names.hpp"
#include "compiler/trace/trace_lines.hpp"

namespace director::compiler::cli {

struct LoadedTrace {
  int status = clean; ///< not clean: it has been said why, and nothing else is good
  std::string text;
  std::optional<RecordedNames> recorded;
};

LoadedTrace load_trace(const std::string& file, Console& console);

/// What ended the lines of the trace before its end, or that its last one was left out; on the error stream. False: it
/// is no trace from that line on.
bool say_end(const TraceLines& lines, const std::string& file, Console& console);

/// That one line is wrong.
void say_problem(const std::string& file, std::size_t line, const std::string& problem, Console& console);

} // namespace director::compiler::cli
