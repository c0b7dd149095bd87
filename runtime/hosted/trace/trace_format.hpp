#pragma once
// SPDX-License-Identifier: MIT
// How a recorder's events become bytes of a file. What is written for one event is whole by itself: of a file that ends
// in the middle of it, all that stands before can be read.

#include "runtime/core/base/observer.hpp"
#include "runtime/core/inspect/why.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace director {

/// Not for the thread that steps: it takes memory.
class TraceFormat {
public:
  TraceFormat() = default;
  TraceFormat(const TraceFormat&) = delete;
  TraceFormat& operator=(const TraceFormat&) = delete;
  virtual ~TraceFormat() = default;

  // Each appends to `out`.
  /// What the file begins with.
  virtual void begin(std::string& out) = 0;
  /// One event, whole by itself.
  virtual void event(const Event& event, std::string& out) = 0;
  /// `count` events are missing here.
  virtual void dropped(std::uint64_t count, std::string& out) = 0;
  /// What the file ends with, where its writer comes to its end.
  virtual void end(std::string&) {}
};

/// JSON lines (docs/traces.md; schemas/trace.schema.json). `file`: where the behaviour is written, for who reads the
/// trace; may be empty. `names` must have tables, and outlive the format.
std::unique_ptr<TraceFormat> json_lines(const Names& names, std::string file = {});

/// Packets of Perfetto's protobuf: https://ui.perfetto.dev opens the file.
std::unique_ptr<TraceFormat> perfetto(const Names& names);

/// `.jsonl` and all others: JSON lines; `.perfetto-trace` and `.pftrace`: Perfetto. `file`: as above.
std::unique_ptr<TraceFormat> trace_format_of(const std::string& path, const Names& names, std::string file = {});

} // namespace director
