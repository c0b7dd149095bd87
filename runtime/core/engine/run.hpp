#pragma once
// SPDX-License-Identifier: MIT
// The untyped contexts of provider bodies and of start and stop handlers; the typed ones of generated code are thin
// layers over these. Requests and values of a body are staged and take effect together when it returns.

#include "runtime/core/base/state.hpp"

namespace director {

class Engine;
namespace testing {
struct Access;
}

/// The place of a task's data (runtime/core/README.md, The memory): a slot of the edge, its staging slot, or the slot
/// of the group.
struct DataPlace {
  enum class Slot : std::uint8_t { edge, staging, group };
  Slot slot = Slot::group;
  Index index = 0; ///< edge, or group
};

/// What the contexts of bodies and of handlers have in common.
class Call {
public:
  Index group() const { return group_; }
  Reasons reasons() const { return reasons_; } ///< of a handler: started or stopped
  DataPlace data() const; ///< of the task that the run is for; of a handler: that the group got last
  void refuse(Index state, std::int32_t value); ///< reports a value that is not declared

protected:
  Call(Engine& engine, Index group, Index provider, Reasons reasons)
      : engine_(engine),
        group_(group),
        provider_(provider),
        reasons_(reasons) {}
  Engine& engine_;
  Index group_, provider_; ///< a handler has no provider: nil
  Reasons reasons_;
};

class Run : public Call {
public:
  Index provider() const { return provider_; }
  Time now() const;
  bool triggered(Index trigger) const; ///< this trigger fired since the last run
  RunState state(Index edge) const;    ///< of the target of an edge of this group
  bool done(Index edge) const;         ///< its answer was done or fail; only while running
  bool failed(Index edge) const;       ///< its answer was fail; only while running

  void set(Index state, std::int32_t value); ///< the last value counts; the caller checks that it is declared
  void wait(Time duration);                  ///< above 0; the last call counts
  /// Begins an answer that requests tasks: what an earlier one of this run requested does not count.
  void begin_pack() {
    if (begun_) forget_pack();
    begun_ = true;
  }
  /// Requests the target of an edge of this group at a level (of Tables::levels); the last call for an edge counts.
  /// True: this is a new task for the target; false: `keep` leaves a request of that level as it is.
  bool request(Index edge, Index level, bool keep = false) {
    const bool leave = keep && request_[edge].level == level;
    staged_[edge - first_edge_] = {level, leave};
    return !leave;
  }

  /// The answer that requests these tasks, and no others. `number`: place of the pack, for tests of bodies.
  Outcome pack(std::uint16_t number = 0) {
    pack_ = number;
    return Outcome{Outcome::Kind::pack};
  }
  Outcome done() const { return Outcome{Outcome::Kind::done}; }
  Outcome fail() const { return Outcome{Outcome::Kind::failed}; }
  Outcome keep() const { return Outcome{Outcome::Kind::keep}; }   ///< all requests stay
  Outcome fault() const { return Outcome{Outcome::Kind::fault}; } ///< the body threw: all requests stay, nothing is set

private:
  friend class Engine;
  friend struct testing::Access;
  Run(Engine& engine, const State& state, Index first_edge, Index group, Index provider, Reasons reasons)
      : Call(engine, group, provider, reasons),
        request_(state.request),
        staged_(state.staged_request),
        first_edge_(first_edge) {}
  [[gnu::cold]] void forget_pack();
  const Requested* request_;
  Staged* staged_;
  Index first_edge_;   ///< the first edge of its group
  bool begun_ = false; ///< an answer that requests tasks was begun
  std::uint16_t pack_ = 0;
  Time wait_ = 0;
};

class Handling : public Call {
public:
  void set(Index state, std::int32_t value);
  void fault() { faulted_ = true; } ///< the handler threw

private:
  friend class Engine;
  friend struct testing::Access;
  Handling(Engine& engine, Index group, Reasons reasons) : Call(engine, group, nil, reasons) {}
  bool faulted_ = false;
};

/// The functions that the engine calls. `self` is the first argument of each; the others name the body.
struct Bodies {
  /// Moves of task data; the engine itself moves none. Null if no task has data.
  enum class Data : std::uint8_t {
    accept, ///< of an edge of root: from slot `handle` of the program's inputs (nil: no data), which becomes free, to
            ///< its staging slot
    settle, ///< from the staging slot of `edge` to its slot
    retain, ///< from the slot of `edge` to the slot of its target group, because a new request is about to replace it
  };
  void* self = nullptr;
  Outcome (*run)(void* self, Run& run) = nullptr;          ///< the body of `run.provider()`
  void (*start)(void* self, Handling& handling) = nullptr; ///< of `handling.group()`, which has Group::start
  void (*stop)(void* self, Handling& handling) = nullptr;  ///< of `handling.group()`, which has Group::stop
  void (*data)(void* self, Data what, Index edge, Index handle) = nullptr;
};

} // namespace director
