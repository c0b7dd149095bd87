#pragma once
// SPDX-License-Identifier: MIT
// A trace whose header has been read, and its behaviour.

#include "compiler/cli/options/commands.hpp"
#include "compiler/pipeline.hpp"
#include "compiler/trace/lookup.hpp"
#include "compiler/trace/recorded_names.hpp"
#include "compiler/trace/trace_lines.hpp"

namespace director::compiler::cli {

struct LoadedTrace {
  int status = clean; ///< not clean: the reason was printed, and nothing else is valid
  std::string text;
  std::string header; ///< its first line, as TraceLine::text
  std::optional<RecordedNames> recorded;
};

LoadedTrace load_trace(const std::string& file, Console& console);

struct RecordedBehaviour {
  int status = clean; ///< not clean: the reason was printed, and nothing else is valid
  std::string file;   ///< as it is printed
  Checked checked{};  ///< it can be played
};

/// Loads the file `named`; if empty: the one that the trace names, otherwise a file with the behaviour's name; relative
/// to the working directory, or to the trace.
RecordedBehaviour load_behaviour(const RecordedNames& recorded, const std::string& trace, const std::string& named,
                                 const CheckOptions& options, dsl::Sources& sources, Console& console,
                                 const CppSource& cpp);

/// Whether the trace is of the version with these names. Nothing, and prints why, if the header has its fingerprint,
/// but is not what a recorder of that version writes: then it was changed, or other behaviours' lines are behind it.
std::optional<bool> is_of_version(const LoadedTrace& trace, const std::string& file, const director::Names& names,
                                  const std::string& behaviour, Console& console);

/// The event; or the fault of a line that no recorder writes, such as a time that is a text: such damage would
/// otherwise be shown as an event.
Lookup::Found event_of(const TraceLine& line, const Lookup& lookup, const director::Names& names);

/// Prints on the error stream why the lines of the trace ended early, or that the last one was left out. False: it is
/// no trace from that line on.
bool print_end(const TraceLines& lines, const std::string& file, Console& console);

/// Prints that a line behind the header cannot be read, why, and what to do.
void print_unreadable(const std::string& file, std::size_t line, const std::string& problem, Console& console);

/// Prints that lines are missing in front of this one, or in another order.
void print_out_of_order(const std::string& file, std::size_t line, const std::string& problem, Console& console);

} // namespace director::compiler::cli
