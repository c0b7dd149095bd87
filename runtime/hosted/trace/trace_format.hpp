#pragma once
// SPDX-License-Identifier: MIT
// The file formats of a recorder. The bytes of each event are complete by themselves: a file that ends in the middle of
// one can be read up to there.

#include "runtime/core/base/observer.hpp"
#include "runtime/core/inspect/why.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace director {

/// A format. It allocates memory, so it is not for the thread that steps.
class TraceFormat {
public:
  TraceFormat() = default;
  TraceFormat(const TraceFormat&) = delete;
  TraceFormat& operator=(const TraceFormat&) = delete;
  virtual ~TraceFormat() = default;

  // Each appends to `out`.
  /// The beginning of the file.
  virtual void begin(std::string& out) = 0;
  /// One event, complete by itself.
  virtual void event(const Event& event, std::string& out) = 0;
  /// `count` events are missing here.
  virtual void dropped(std::uint64_t count, std::string& out) = 0;
  /// The end of the file, if its writer ends it.
  virtual void end(std::string&) {}
};

/// JSON lines (docs/traces.md; schemas/trace.schema.json). `file`: the path of the YAML file, for readers of the trace;
/// may be empty. `names` must have tables, and outlive the format.
std::unique_ptr<TraceFormat> json_lines(const Names& names, std::string file = {});

/// Packets of Perfetto's protobuf: https://ui.perfetto.dev opens the file.
std::unique_ptr<TraceFormat> perfetto(const Names& names);

/// `.jsonl` and all others: JSON lines; `.perfetto-trace` and `.pftrace`: Perfetto. `file`: as above.
std::unique_ptr<TraceFormat> trace_format_of(const std::string& path, const Names& names, std::string file = {});

} // namespace director
