#pragma once
// SPDX-License-Identifier: MIT
// What a search checks beside new states: whether an assertion is refuted (can_run: whether it comes true), and what
// never happens. Definitions: the language page, assertions.

#include "compiler/explore/machine/machine.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace director::compiler {

/// What happened at least once.
struct Happened {
  std::vector<bool> ran;       ///< provider
  std::vector<bool> requested; ///< edge
  std::vector<bool> granted;   ///< edge: its target, while it was requested
  std::vector<bool> runnable;  ///< edge: requested, and a provider of its target met its conditions

  explicit Happened(const Tables& tables);
  void add(const Happened& other);
};

/// Adds what is true in the other.
void unite(std::vector<bool>& all, const std::vector<bool>& more);

/// Limit for assertions of the kind `soft` in one Watch: each takes two bits of a state. search() checks more of them
/// in further searches.
inline constexpr std::size_t most_soft = 32;

/// What a group that is granted takes from another one, or from what that one holds or is requested by.
struct Cut {
  Index group = nil;  ///< that is taken
  Index edge = nil;   ///< that held it
  bool stops = false; ///< the other one stops
};

class Watch {
public:
  /// `assertions`: of the Model, those to check; at most `most_soft` of them are of the kind `soft`.
  Watch(const Ground& ground, const std::vector<std::size_t>& assertions);

  /// Called before the micro-steps that begin in this state.
  void before(const Machine& machine, std::uint64_t bits);
  /// Called after one of them; returns what is to be remembered. Assertions that it refuted (can_run: fulfilled) are
  /// added to `seen`.
  std::uint64_t after(const Machine& machine, std::vector<std::size_t>& seen);

  /// Whether what is remembered depends on what bodies set, not only on the resulting values.
  bool depends_on_puts() const { return depends_on_puts_; }

  Happened happened;
  /// Of the Model's assertions: a task of the winner's side was blocked while the loser's side held what it may take,
  /// but others blocked it as well.
  std::vector<bool> doubted;
  /// Of a refuted `beats`, the last one seen: the request that is blocked.
  Index blocked_request = nil;
  /// Of a refuted `soft`, the last one seen.
  Cut cut;

private:
  struct One {
    std::size_t assertion = 0;
    Assertion::Kind kind = Assertion::Kind::can_run;
    std::vector<Index> groups;
    std::uint64_t ran_since = 0, active_since = 0; ///< bits
  };
  struct Held {
    Index holder = nil, active = nil;
    bool granted = false;
  };
  bool together(const One& one, const Machine& machine) const;
  bool blocked(const One& one, const Machine& machine);
  bool hard_cut(const One& one, const Machine& machine);
  std::vector<Index> passed_on(Index from, Index to, const Engine& engine) const;
  std::optional<Index> kept_without(Index to, Index from, const std::vector<Index>& groups, const Machine& machine);
  bool was_needed(Index edge) const;
  std::uint64_t remember(const One& one, const Machine& machine, std::uint64_t bits) const;
  bool requested(Index group, const Machine& machine) const;
  bool keeps_promise(Index provider, const Put& put) const;
  bool causes(Index provider) const { return !ground_.tables.providers[provider].causing.empty(); }
  void note(const Machine& machine);

  const Ground& ground_;
  bool depends_on_puts_ = false;
  std::vector<One> watched_;
  std::vector<Held> before_;   ///< of groups, before the micro-step
  std::vector<Index> waiting_; ///< edges whose target was never granted for them yet
  std::uint64_t bits_ = 0;
  std::unique_ptr<Machine> again_; ///< for micro-steps as they would have been without a group
};

/// Whether `group` holds, or is held for, something that `edge` leads to: it is in the chain of the edge's holders.
bool under(const Engine& engine, Index edge, Index group);

} // namespace director::compiler
