#pragma once
// SPDX-License-Identifier: MIT
// Replays a trace on the engine: recorded inputs are posted as they came, bodies and handlers give their recorded
// answers, and every event of the engine must equal the recorded one. If a version of the behaviour decides differently
// the replay ends, because the further answers of bodies are unknown.

#include "compiler/model/model.hpp"
#include "compiler/trace/trace_lines.hpp"
#include "runtime/core/base/observer.hpp"
#include "runtime/core/inspect/view.hpp"
#include "runtime/core/inspect/why.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace director::compiler {

struct Replayed {
  /// The first difference.
  struct Difference {
    std::size_t event = 1; ///< counts from 1
    std::size_t line = 0;  ///< of the trace; counts from 1
    Time time = 0;
    std::string recorded, replayed;           ///< in words
    std::string recorded_line, replayed_line; ///< as in a trace; empty: the behaviour has no such event
    /// Nothing was decided: what was recorded is an input, or an answer of a body, that this version cannot have.
    /// `replayed` says why, and `help` what to do, if anything is to be said.
    bool is_impossible = false;
    std::string help;
  };

  std::size_t events = 0; ///< that are the same
  std::optional<Difference> difference;
  std::uint64_t dropped = 0;    ///< not 0: so many events are missing from the trace, and the replay ended there
  std::string problem;          ///< why a line cannot be read, where the replay ended; empty: all could
  std::size_t problem_line = 0; ///< which line; counts from 1
  bool begins_later = false;    ///< the trace does not begin with the first step
};

/// Callbacks of a replay.
class ReplayWatch {
public:
  /// An event that equals the one in this line of the trace.
  virtual void event(const Event& event, std::size_t line) = 0;
  /// A micro-step has ended; all its events were equal.
  virtual void stepped(const View& view) = 0;

protected:
  ~ReplayWatch() = default;
};

/// `lines`: behind the header. `model`, `names`: of the behaviour to play, with tables. `watch`: null: none.
/// `recorded`: of the recorded behaviour if that is another version, to distinguish a damaged line; null: the same one.
Replayed replay(TraceLines& lines, const Model& model, const director::Names& names, ReplayWatch* watch = nullptr,
                const director::Names* recorded = nullptr);

} // namespace director::compiler
