#pragma once
// SPDX-License-Identifier: MIT
// What a trace does not tell and its replay does: why each group that waits does so, at every moment, what is only held
// any more, and what goes on though its request waits. `why` is asked whenever its answer may have become another; few
// answers differ, so each is kept once.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "compiler/trace/replay.hpp"
#include "dsl/source_file.hpp"

#include <compare>
#include <string>
#include <vector>

namespace director::compiler {

struct Waits {
  /// From the event in this line of the trace on.
  struct Change {
    std::size_t line = 0;
    Index group = nil;
    std::uint32_t text = 0; ///< place among `texts`, plus 1; 0: it does not wait
    bool operator==(const Change&) const = default;
  };
  /// A group that ran, and is only held any more: behind the event in this line. The engine does not tell it where
  /// nobody had asked for the group any more and it was only kept for who might.
  struct Held {
    std::size_t line = 0;
    Index group = nil;
    bool operator==(const Held&) const = default;
  };
  /// A group that nobody asks for, as its request was queued, withdrawn or made no more, and that goes on as what its
  /// requester needs: it keeps what it asks for. Behind the event in this line. The engine does not tell it either.
  using Stays = Held;
  /// What is in the way of who waits.
  struct Blocker {
    Index group = nil; ///< that is held; nil: nothing is
    Index edge = nil;  ///< by which
    auto operator<=>(const Blocker&) const = default;
  };
  std::vector<std::string> texts; ///< as `directorc why` prints them
  std::vector<Blocker> blockers;  ///< of each text
  std::vector<Change> changes;    ///< by line
  std::vector<Held> held;         ///< by line
  std::vector<Stays> stays;       ///< likewise
  std::size_t last_line = 0;      ///< behind it nothing is known; 0: nothing is known at all
  Replayed replayed;
};

/// `lines`: behind the header of a trace of this behaviour.
Waits find_waits(TraceLines& lines, const Model& model, const Lowered& lowered, const dsl::Sources& sources);

} // namespace director::compiler
