#pragma once
// SPDX-License-Identifier: MIT
// The options of a picture: which groups, which arrows, and what is folded.

#include "compiler/analysis/ranks/contention.hpp"
#include "compiler/model/ids.hpp"
#include "dsl/source/span.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace director::compiler {

/// The task of one edge may take something by rank from that of another; both of one requester.
struct TakeOver {
  EdgeId taker{}, loser{};
  std::set<analysis::Winning> ranks; ///< by which it may
  std::vector<bool> groups{};        ///< what it may take, by group
};

/// What holds at some moment of a scenario.
struct Moment {
  enum class Mark {
    inactive,
    running,
    queued, ///< it is requested, and waits
    pushed, ///< it runs because a waiting task has pushed it
    held,   ///< not requested yet by the group that needs it
  };
  struct Standing {
    Mark mark = Mark::inactive;
    std::optional<ProviderId> active;
    std::string note; ///< what it waits for, or the task for which it is pushed
    bool operator==(const Standing&) const = default;
  };
  struct Push {
    GroupId waits{}, pushed{};
    ProviderId to{};
    std::string condition, words;
  };
  std::string title;               ///< `after step 2, at 1.5 s`
  std::vector<std::string> values; ///< `Motion == still`
  std::vector<Standing> groups;    ///< by group
  std::vector<Mark> edges;         ///< by edge: running, queued, held or inactive
  /// By edge: the level at which it is requested, an index into Edge::levels; nothing: it is not requested.
  std::vector<std::optional<std::uint32_t>> levels;
  std::vector<Push> pushes;
};

/// Faults that a picture shows.
struct PictureFlaws {
  /// A name that no group has.
  struct Request {
    std::optional<GroupId> from; ///< nothing: the program
    std::optional<std::size_t> row;
    bool need = false;
    std::string name;
    dsl::Span span{};
    std::string priorities{}; ///< of the program's request; empty: it has none
  };
  struct Line {
    GroupId group{};
    std::optional<std::size_t> row;
    bool is_error = false;
    std::string key, text;
  };
  std::vector<Request> requests;
  std::vector<Line> lines;
  std::vector<std::string> elsewhere; ///< about no group
};

struct PictureOptions {
  enum class View { all, tasks, needs, pushes, takes };
  enum class Fold { nothing, modules, layers };
  View view = View::all;
  Fold fold = Fold::nothing;
  std::vector<GroupId> focus;       ///< only what is related to these; empty: everything
  std::optional<std::size_t> depth; ///< ... no more than so many arrows away
  std::vector<TakeOver> take_overs; ///< for View::takes
  std::optional<Moment> moment;     ///< empty: all that is possible, not the state at a moment
  std::vector<Moment> frames;       ///< moments of which each box is to have one place; with `moment` among them
  PictureFlaws flaws;
};

} // namespace director::compiler
