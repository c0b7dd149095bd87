#pragma once
// SPDX-License-Identifier: MIT
// The lines of a trace, one after another. Faulty lines are normal input: the last one of a killed program is cut off,
// and a disk may be damaged.

#include "compiler/base/json.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace director::compiler {

/// One line behind the header.
struct TraceLine {
  std::size_t number = 0; ///< counts from 1, the header is the first
  std::string text;       ///< without blanks between its members, which other programs add and which are no damage
  Json json;
  std::uint64_t dropped = 0; ///< not 0: so many events are missing here, and the line is no event
};

class TraceLines {
public:
  /// The text must outlive this.
  explicit TraceLines(std::string_view text) : rest_(text) {}

  /// The next line; empty at the end, or at a fault.
  std::optional<TraceLine> next();

  std::size_t number() const { return number_; }          ///< of the line that was read last
  const std::string& problem() const { return problem_; } ///< of that line; empty: there is none
  bool cut_off() const { return cut_off_; }               ///< the last line was, and was left out

private:
  std::string_view rest_;
  std::size_t number_ = 0;
  std::string problem_;
  bool cut_off_ = false;
};

} // namespace director::compiler
