#pragma once
// SPDX-License-Identifier: MIT
// From what to what can control change, and how: the transition matrix. Rows and columns are the groups that ask for
// something or need something. Row A: A is brought to run as the program's only wish, with as few values from outside
// as that takes. Column B: B is asked for beside it. What the real engine does then is the cell, and the scenario that
// shows it is part of it.

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
    never,          ///< nor then
    same_chain,     ///< one leads to the other, or they are the same
    replaced,       ///< who asks for both withdraws the first one
    condition_lost, ///< what the second wants from outside ends the first one
    unreachable,    ///< one of them cannot be brought to run at all
  };
  struct Push {
    ProviderId to{};
    std::string condition;              ///< for which it was made
    std::optional<Microseconds> within; ///< what it promises
  };
  Kind kind = Kind::unreachable;
  std::string words;                 ///< what happens, in sentences
  std::vector<Push> pushes;          ///< in the order in which they were made
  std::optional<Microseconds> bound; ///< soft: the sum of what they promise; nothing: one of them promises no time
  std::vector<GroupId> stops;        ///< what ran for the first and does not run any more
  std::vector<GroupId> taken;        ///< what ran for the first and now runs for somebody else
  std::vector<std::string> states;   ///< `Ball == near`: what the outside says for the second
  std::vector<std::size_t> scenario; ///< of TransitionMatrix::pieces, one after another; empty: nothing was played
};

struct TransitionMatrix {
  struct Row {
    GroupId group{};
    bool reached = false;
    std::string words;               ///< how it is brought to run, or why not
    std::vector<std::string> states; ///< what the outside says for it
    std::vector<std::string> given;  ///< of states that only bodies set: what it begins with, against what is declared
    std::vector<GroupId> chain;      ///< from the program down to its requester
    std::vector<Transition> cells;   ///< by column
  };
  std::vector<Row> rows; ///< the columns are the same groups in the same order
  std::vector<std::string> pieces;
  std::vector<GroupId> not_requested; ///< no rows of their own: nothing that the program requests leads to them
  std::string left_out;               ///< in a sentence, why there are no rows; empty: there are
  bool limited = false;               ///< only some groups were asked for
};

/// With more rows than this no matrix is played: its time and size grow with the square of them.
constexpr std::size_t most_rows = 100;

/// `behaviour`: what its scenarios call the file. `only`: no rows and columns but these; empty: all.
TransitionMatrix find_transitions(const Model& model, const Lowered& lowered, const std::string& behaviour,
                                  const std::vector<GroupId>& only = {});

/// Cells one by one, of behaviours that are too large for all of them.
class TransitionPlays {
public:
  TransitionPlays(const Model& model, const Lowered& lowered);
  ~TransitionPlays();
  /// Unreachable too where nothing that the program requests leads to one of them.
  Transition between(GroupId first, GroupId second);
  /// How much was played so far: it grows with the time that it took.
  std::size_t work() const;

private:
  struct Finder;
  std::unique_ptr<Finder> finder_;
};

/// `soft`, `condition lost`.
std::string_view name_of(Transition::Kind kind);

} // namespace director::compiler
