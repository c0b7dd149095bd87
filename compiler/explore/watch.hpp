#pragma once
// SPDX-License-Identifier: MIT
// What a search looks for beside new states: whether an assertion is refuted (can_run: whether it comes true), and what
// never happens. Definitions: the language page, assertions.

#include "compiler/explore/machine.hpp"

#include <cstdint>
#include <vector>

namespace director::compiler {

/// What happened at least once.
struct Happened {
  std::vector<bool> ran;       ///< provider
  std::vector<bool> requested; ///< edge
  std::vector<bool> granted;   ///< edge: its target, while it was requested
  std::vector<bool> requested; ///< edge: requested, and a provider of its target met its conditions

  explicit Happened(const Tables& tables);
  void add(const Happened& other);
};

/// What is true in one of them.
void unite(std::vector<bool>& all, const std::vector<bool>& more);

/// More assertions of the kind `soft` are not watched at once: each takes two bits of a state.
inline constexpr std::size_t most_soft = 32;

class Watch {
public:
  /// `assertions`: of the Model, those to look at.
  Watch(const Ground& ground, const std::vector<std::size_t>& assertions);

  /// Before the micro-steps that all begin in this state.
  void before(const Machine& machine, std::uint64_t bits);
  /// After one of them; what is to be remembered now. Assertions that were refuted (can_run: came true) by it are added
  /// to `seen`.
  std::uint64_t after(const Machine& machine, std::vector<std::size_t>& seen);

  /// What is remembered depends on what bodies set, not only on the values that states have then.
  bool minds_puts() const { return minds_puts_; }

  Happened happened;
  /// Of the Model's assertions: a task of the winner's side was blocked while the loser's side held what it may take,
  /// but others were in its way as well.
  std::vector<bool> doubted;

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
  bool hard_cut(const One& one, const Machine& machine) const;
  std::uint64_t remember(const One& one, const Machine& machine, std::uint64_t bits) const;
  bool requested(Index group, const Machine& machine) const;
  bool keeps_promise(Index provider, const Put& put) const;
  bool causes(Index provider) const { return !ground_.tables.providers[provider].causing.empty(); }
  void note(const Machine& machine);

  const Ground& ground_;
  bool minds_puts_ = false;
  std::vector<One> watched_;
  std::vector<Held> before_;
  std::vector<Index> waiting_; ///< edges whose target was never granted for them yet
  std::uint64_t bits_ = 0;
};

/// `group` holds, or is held for, something that `edge` leads to: it is in the chain of the edge's holders.
bool under(const Engine& engine, Index edge, Index group);

} // namespace director::compiler
