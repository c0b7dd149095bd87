#pragma once
// SPDX-License-Identifier: MIT
// Enumerations for bodies and programs: why a body runs, its tasks, its answer. Source: semantics.md, sections 3 and 6.

#include <cstdint>

namespace director {

/// Why a provider is called.
enum class Reason : std::uint8_t {
  new_task = 1,     ///< its task was requested, got another holder, or was given to this provider
  pushed = 2,       ///< a stronger task waits for a state that this provider causes
  subtask_done = 4, ///< a task that it requested was answered with done or fail
  wait = 8,         ///< the time that it requested with `wait` has passed
  trigger = 16,     ///< a trigger that it listens to was fired, or the time of its `every` has passed
  started = 32,     ///< only in a start handler
  stopped = 64,     ///< only in a stop handler
};

/// A set of reasons.
class Reasons {
public:
  constexpr Reasons() = default;
  /// Bits of Reason.
  constexpr explicit Reasons(std::uint8_t bits) : bits_(bits) {}
  /// Whether it is among them.
  constexpr bool has(Reason reason) const { return (bits_ & static_cast<std::uint8_t>(reason)) != 0; }
  /// As a number: the bits of Reason.
  constexpr std::uint8_t bits() const { return bits_; }
  /// The same reasons.
  constexpr bool operator==(const Reasons&) const = default;

private:
  std::uint8_t bits_ = 0;
};

/// The state of a task or need in `uses`, for a body.
enum class RunState : std::uint8_t {
  none,    ///< not requested by this group
  queued,  ///< requested by this group, not granted
  running, ///< granted to the edge of this group
};

/// The answer of a body, made by the context of a run. A path without one does not compile (behaviour.hpp).
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

/// The result of `step`.
enum class StepResult : std::uint8_t {
  quiescent,        ///< nothing is left to do before the next input or due time
  budget_exhausted, ///< a budget of one step is used up; call again to go on
  fault,            ///< a body requested a level that is not declared; call again to go on. Only of an Engine, also: a
                    ///< body, handler or observer threw, which the step of a Behaviour throws on
  refused,          ///< called from inside a body, handler or observer, in a program without assertions
};

/// Why a requested task does not run (semantics.md 4.4, Refuse).
enum class Why : std::uint8_t {
  none,     ///< it runs, or is not requested
  blocked,  ///< other edges hold groups that it needs
  waiting,  ///< a condition is false
  outdated, ///< its requester is stale and may withdraw it
  deferred, ///< a stronger stale group is about to run and may take what it needs
};

/// The rule of semantics.md 4.1 by which one task goes before another.
enum class Precedence : std::uint8_t {
  above,    ///< it requested the other, directly or not
  optional, ///< the other is optional below the common requester
  priority, ///< it has the higher priority there
  equal,    ///< none: equals never take from each other, and it was granted first
};

} // namespace director
