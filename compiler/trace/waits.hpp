#pragma once
// SPDX-License-Identifier: MIT
// Finds by a replay what a trace does not contain: the reason why each waiting group waits, at every moment, which
// groups are only held, which continue although their request waits, and which pushes have no effect. why() is called
// whenever its answer may change; few answers differ, so each is stored once.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "compiler/trace/replay.hpp"
#include "dsl/source/source_file.hpp"

#include <compare>
#include <string>
#include <vector>

namespace director::compiler {

struct Waits {
  /// From the event in this line of the trace on.
  struct Change {
    std::size_t line = 0;
    Index group = nil;
    std::uint32_t text = 0; ///< index in `texts`, plus 1; 0: it does not wait
    bool operator==(const Change&) const = default;
  };
  /// A group that ran and is now only held, after the event in this line. The engine has no event for this if the group
  /// was no longer requested and only kept for a possible requester.
  struct Held {
    std::size_t line = 0;
    Index group = nil;
    bool operator==(const Held&) const = default;
  };
  /// A group without a request in force, as it was queued, withdrawn or not repeated, that continues as a need of its
  /// requester: it keeps its own requests. After the event in this line. The engine has no event for this either.
  using Stays = Held;
  /// A group that runs in the provider of its push, but not because of it: from the event in this line on. The engine
  /// has no event for this.
  using WithoutEffect = Held;
  /// A group that was WithoutEffect and runs because of its push again, without a release of the push in between: from
  /// the event in this line on.
  using InForce = Held;
  /// What blocks a waiting group.
  struct Blocker {
    Index group = nil; ///< a held group; nil: none
    Index edge = nil;  ///< by which
    auto operator<=>(const Blocker&) const = default;
  };
  std::vector<std::string> texts;            ///< as `directorc why` prints them
  std::vector<Blocker> blockers;             ///< of each text
  std::vector<Change> changes;               ///< by line
  std::vector<Held> held;                    ///< by line
  std::vector<Stays> stays;                  ///< likewise
  std::vector<WithoutEffect> without_effect; ///< likewise
  std::vector<InForce> in_force;             ///< likewise
  std::size_t last_line = 0;                 ///< unknown after it; 0: nothing is known at all
  Replayed replayed;
};

/// `lines`: behind the header of a trace of this behaviour.
Waits find_waits(TraceLines& lines, const Model& model, const Lowered& lowered, const dsl::Sources& sources);

} // namespace director::compiler
