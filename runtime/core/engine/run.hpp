#pragma once
// SPDX-License-Identifier: MIT
// What a provider body, and a start or stop handler, gets from the engine: typed contexts of generated code are thin
// layers over these. Everything that a body asks for is staged and takes effect together when it returns.

#include "runtime/core/base/state.hpp"
#include "runtime/core/base/words.hpp"

namespace director {

class Engine;
namespace testing {
struct Access;
}

/// Where the data of a group's task are (docs/bounds.md: each edge has a slot and a staging slot, each group one slot).
struct DataPlace {
  enum class Slot : std::uint8_t { edge, staging, group };
  Slot slot = Slot::group;
  Index index = 0; ///< edge, or group
};

class Run {
public:
  Index provider() const { return provider_; }
  Index group() const { return group_; }
  Reasons reasons() const { return reasons_; }
  Time now() const;
  bool triggered(Index trigger) const; ///< this trigger fired since the last run
  RunState state(Index edge) const;    ///< of the target of an edge of this group
  bool done(Index edge) const;         ///< it said done or failed; only while running
  bool failed(Index edge) const;       ///< it said failed; only while running
  DataPlace data() const;              ///< of the task that this run is for

  void set(Index state, std::int32_t value);    ///< the last one counts; the caller checks that it is declared
  void refuse(Index state, std::int32_t value); ///< tells the observer of a value that is not declared
  void wait(Time duration);                     ///< above 0; the last one counts
  /// Asks for an edge of this group at a level (of Tables::levels). Asked twice, the last one counts. True if this is a
  /// new task for the target; false if `keep` leaves a request of that level as it is.
  bool request(Index edge, Index level, bool keep = false) {
    const bool leave = keep && request_[edge].level == level;
    staged_[edge - first_edge_] = {level, leave};
    return !leave;
  }

  /// What was requested, and nothing else. `number`: which of the provider's packs that is; only tests of bodies ask.
  Outcome pack(std::uint16_t number = 0) {
    pack_ = number;
    return Outcome{Outcome::Kind::pack};
  }
  Outcome done() const { return Outcome{Outcome::Kind::done}; }
  Outcome fail() const { return Outcome{Outcome::Kind::failed}; }
  Outcome keep() const { return Outcome{Outcome::Kind::keep}; }   ///< Continue
  Outcome fault() const { return Outcome{Outcome::Kind::fault}; } ///< it threw: counts as Continue, nothing was set

private:
  friend class Engine;
  friend struct testing::Access;
  Run(Engine& engine, const State& state, Index first_edge, Index group, Index provider, Reasons reasons)
      : engine_(engine),
        request_(state.request),
        staged_(state.staged_request),
        first_edge_(first_edge),
        group_(group),
        provider_(provider),
        reasons_(reasons) {}
  Engine& engine_;
  const Requested* request_;
  Staged* staged_;
  Index first_edge_; ///< of its group
  Index group_, provider_;
  Reasons reasons_;
  std::uint16_t pack_ = 0;
  Time wait_ = 0;
};

/// A start or stop handler's context.
class Handling {
public:
  Index group() const { return group_; }
  Reasons reasons() const { return reasons_; } ///< started or stopped
  DataPlace data() const;                      ///< of the task that the group was given last
  void set(Index state, std::int32_t value);
  void refuse(Index state, std::int32_t value);
  void fault() { faulted_ = true; } ///< the handler threw

private:
  friend class Engine;
  friend struct testing::Access;
  Handling(Engine& engine, Index group, Reasons reasons) : engine_(engine), group_(group), reasons_(reasons) {}
  Engine& engine_;
  Index group_;
  Reasons reasons_;
  bool faulted_ = false;
};

/// What the engine calls. `self` is given back to each function; what the others get says whose body is meant.
struct Bodies {
  /// What happens to task data; the engine itself moves none. Null where no task has data.
  enum class Data : std::uint8_t {
    accept, ///< of root edge `edge`: from slot `handle` of the program's inputs (nil: no data) to the edge's staging
            ///< slot; the slot of the inputs is free again
    settle, ///< from the staging slot of `edge` to its slot
    retain, ///< from the slot of `edge` to the slot of its target group: a new request is about to take its place
  };
  void* self = nullptr;
  Outcome (*run)(void* self, Run& run) = nullptr;          ///< the body of `run.provider()`
  void (*start)(void* self, Handling& handling) = nullptr; ///< of `handling.group()`, which has Group::start
  void (*stop)(void* self, Handling& handling) = nullptr;  ///< of `handling.group()`, which has Group::stop
  void (*data)(void* self, Data what, Index edge, Index handle) = nullptr;
};

} // namespace director
