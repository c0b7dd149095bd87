#pragma once
// SPDX-License-Identifier: MIT
// A trace whose header has been read, and the behaviour that it was recorded of.

#include "compiler/cli/commands.hpp"
#include "compiler/pipeline.hpp"
#include "compiler/trace/recorded_names.hpp"
#include "compiler/trace/trace_lines.hpp"

namespace director::compiler::cli {

struct LoadedTrace {
  int status = clean; ///< not clean: it has been said why, and nothing else is good
  std::string text;
  std::optional<RecordedNames> recorded;
};

LoadedTrace load_trace(const std::string& file, Console& console);

struct RecordedBehaviour {
  int status = clean; ///< not clean: it has been said why, and nothing else is good
  std::string file;   ///< as it is shown to people
  Checked checked{};  ///< it can be played
};

/// From the file `named`; empty: where the trace says, else a file of the behaviour's name; as seen from here, or
/// beside the trace.
RecordedBehaviour load_behaviour(const RecordedNames& recorded, const std::string& trace, const std::string& named,
                                 const CheckOptions& options, dsl::Sources& sources, Console& console);

/// What ended the lines of the trace before its end, or that its last one was left out; on the error stream. False: it
/// is no trace from that line on.
bool print_end(const TraceLines& lines, const std::string& file, Console& console);

/// That a line behind the header cannot be read, why, and what can be done.
void print_unreadable(const std::string& file, std::size_t line, const std::string& problem, Console& console);

} // namespace director::compiler::cli
