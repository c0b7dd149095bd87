#pragma once
// SPDX-License-Identifier: MIT
// The small words that provider bodies and programs meet: why a body runs, what it sees of its tasks, what it answers.
// Source: semantics.md, sections 3 and 6.

#include <cstdint>

namespace director {

/// Why a provider is called.
enum class Reason : std::uint8_t {
  new_task = 1,     ///< its task was requested, granted to someone else, or given to this provider
  pushed = 2,       ///< a stronger task waits for a state that this provider causes
  subtask_done = 4, ///< a task that it requested said done or failed
  wait = 8,         ///< the time that it asked for with `wait` has passed
  trigger = 16,     ///< a trigger that it listens to was fired, or its `every` came round
  started = 32,     ///< only in a start handler
  stopped = 64,     ///< only in a stop handler
};

/// A set of reasons.
class Reasons {
public:
  constexpr Reasons() = default;
  /// Bits of Reason.
  constexpr explicit Reasons(std::uint8_t bits) : bits_(bits) {}
  /// It is among them.
  constexpr bool has(Reason reason) const { return (bits_ & static_cast<std::uint8_t>(reason)) != 0; }
  /// As a number: the bits of Reason.
  constexpr std::uint8_t bits() const { return bits_; }
  /// The same reasons.
  constexpr bool operator==(const Reasons&) const = default;

private:
  std::uint8_t bits_ = 0;
};

/// What a body sees of a task or need that stands in its `uses`.
enum class RunState : std::uint8_t {
  none,    ///< not requested from here
  queued,  ///< requested from here, not granted
  running, ///< granted to the edge from here
};

/// What a body answers. Only the context of a run makes one. A path without an answer does not compile (behaviour.hpp).
class [[nodiscard]] Outcome {
public:
  /// A request, done, fail, keep, or a level that is not declared.
  enum class Kind : std::uint8_t { pack, done, failed, keep, fault };
  /// For tests of bodies.
  constexpr Kind kind() const { return kind_; }

private:
  friend class Run;
  constexpr explicit Outcome(Kind kind) : kind_(kind) {}
  Kind kind_;
};

/// What `step` came to.
enum class StepResult : std::uint8_t {
  quiescent,        ///< nothing is left to do before the next input or due time
  budget_exhausted, ///< more micro-steps than allowed in one step; call again to go on
  fault,            ///< a body, handler or observer threw; the engine is consistent, call again to go on
  refused,          ///< called from inside a body, handler or observer, in a program without assertions
};

/// Why a requested task does not run (semantics.md 4.4, Refuse).
enum class Why : std::uint8_t {
  none,     ///< it runs, or nobody asks for it
  blocked,  ///< others hold what it takes
  waiting,  ///< for a condition
  outdated, ///< its requester is about to run and may not want it any more
  deferred, ///< someone stronger is about to run and may take what it needs
};

/// By which rule of semantics.md 4.1 one task goes before another.
enum class Precedence : std::uint8_t {
  above,    ///< it requested the other, directly or not
  optional, ///< the other is optional below the common requester
  priority, ///< it has the higher priority there
  equal,    ///< by none: equals never take from each other, and it was there first
};

} // namespace director
