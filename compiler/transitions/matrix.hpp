#pragma once
// SPDX-License-Identifier: MIT
// Finds how control can pass between groups: the transition matrix. Rows and columns are the groups that request or
// need something. Row A: A is brought to run as the program's only request, with as few values from outside as
// possible. Column B: B is requested beside it. The cell is what the real engine does then, with the scenario that
// shows it.

#include "compiler/lower/lowered.hpp"
#include "compiler/transitions/way.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

struct Transition {
  enum class Kind {
    both,           ///< they run beside each other
    soft,           ///< the second waits, something is pushed, then the second takes over
    hard,           ///< the second takes at once what the first one holds
    waits,          ///< the second runs when the first one is done
    never,          ///< not even then
    endless,        ///< the engine does not come to rest
    same_chain,     ///< one leads to the other, or they are the same
    replaced,       ///< the requester of both withdraws the first one
    condition_lost, ///< a value that the second needs from outside, or that a body sets, ends the first one
    unreachable,    ///< one of them is not made to run
  };
  struct Push {
    ProviderId to{};
    std::string condition;              ///< for which it was made
    std::optional<Microseconds> within; ///< what it promises
    bool is_further = false;            ///< no push of its own: the one before it is also waited on for this condition
  };
  Kind kind = Kind::unreachable;
  std::string words;                 ///< the events, in sentences
  std::vector<Push> pushes;          ///< in the order in which they were made
  std::optional<Microseconds> bound; ///< soft: the sum of the longest promised time of each push; empty: a condition
                                     ///< has no time
  std::vector<GroupId> stops;        ///< what ran for the first, or leads to it, and no longer runs
  std::vector<GroupId> taken;        ///< what ran for the first and now runs for another requester, without a stop
  std::vector<GroupId> again;        ///< what ran for the first, or leads to it, stops, and then runs again
  std::vector<std::string> states;   ///< `Ball == near`: set from outside for the second
  std::string asserted;              ///< the verdict of the assertion that it is soft; empty: there is none
  std::vector<std::size_t> scenario; ///< of TransitionMatrix::pieces, one after another; empty: nothing was played
};

struct TransitionMatrix {
  struct Row {
    GroupId group{};
    bool reached = false;
    std::string words;               ///< how it is brought to run, or why not
    std::vector<std::string> states; ///< set from outside for it
    std::vector<std::string> given;  ///< of states that only bodies set: assumed initial values that differ from the
                                     ///< declared ones
    std::vector<GroupId> chain;      ///< from the program down to its requester
    std::vector<Transition> cells;   ///< by column
  };
  std::vector<Row> rows; ///< the columns are the same groups in the same order
  std::vector<std::string> pieces;
  std::vector<GroupId> not_requested; ///< without rows of their own: no request of the program leads to them
  std::string left_out;               ///< a sentence why there are no rows; empty: there are
  bool limited = false;               ///< only some groups were requested
};

/// Limit for rows: the time and size of the matrix are quadratic.
constexpr std::size_t most_rows = 100;

/// Limit for the work of all plays of the matrix, in units of TransitionPlays: some twenty seconds.
constexpr std::size_t most_matrix_work = 60'000'000;

/// `behaviour`: the path in its scenarios. `only`: these rows and columns; empty: all.
TransitionMatrix find_transitions(const Model& model, const Lowered& lowered, const std::string& behaviour,
                                  const std::vector<GroupId>& only = {}, std::size_t most_work = most_matrix_work);

/// Computes single cells, for behaviours that are too large for all of them.
class TransitionPlays {
public:
  TransitionPlays(const Model& model, const Lowered& lowered);
  ~TransitionPlays();
  /// Unreachable also if no request of the program leads to one of them.
  Transition between(GroupId first, GroupId second);
  /// Whether it is made to run alone: otherwise all its transitions are unreachable.
  bool reaches(GroupId group);
  /// A measure of the time that all plays so far took.
  std::size_t work() const;

private:
  struct Finder;
  std::unique_ptr<Finder> finder_;
};

/// `soft`, `condition lost`.
std::string_view name_of(Transition::Kind kind);

} // namespace director::compiler
