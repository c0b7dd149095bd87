#pragma once
// SPDX-License-Identifier: MIT
// A trace played again on the engine: what was recorded of the outside comes in as it came then, bodies and handlers
// answer what they answered, and every event that the engine tells must be the one that was recorded. Where a version
// of the behaviour decides otherwise the replay ends, because from there on nobody recorded what bodies would have
// answered.

#include "compiler/trace/trace_lines.hpp"
#include "runtime/core/base/observer.hpp"
#include "runtime/core/inspect/view.hpp"
#include "runtime/core/inspect/why.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace director::compiler {

struct Replayed {
  /// The first thing that is not as it was.
  struct Difference {
    std::size_t event = 1; ///< counts from 1
    std::size_t line = 0;  ///< of the trace; counts from 1
    Time time = 0;
    std::string recorded, replayed;           ///< in words
    std::string recorded_line, replayed_line; ///< as in a trace; empty: the behaviour tells nothing, or could not
  };

  std::size_t events = 0; ///< that are the same
  std::optional<Difference> difference;
  std::uint64_t dropped = 0;    ///< not 0: so many events are missing from the trace, and the replay ended there
  std::string problem;          ///< why a line cannot be read, where the replay ended; empty: none was met
  std::size_t problem_line = 0; ///< which line; counts from 1
};

/// Who looks on.
class ReplayWatch {
public:
  /// An event that is the one in this line of the trace.
  virtual void event(const Event& event, std::size_t line) = 0;
  /// A micro-step is over; all that it told was the same.
  virtual void stepped(const View& view) = 0;

protected:
  ~ReplayWatch() = default;
};

/// `lines`: behind the header. `names`: of the behaviour that is to play, with tables. `watch`: null: nobody looks on.
/// `recorded`: of the behaviour that was recorded, by which a line that is damaged is told from one that only another
/// version could have written; null: it is the same one.
Replayed replay(TraceLines& lines, const director::Names& names, ReplayWatch* watch = nullptr,
                const director::Names* recorded = nullptr);

} // namespace director::compiler
