#pragma once
// SPDX-License-Identifier: MIT
// What is asked of a picture: which groups, which arrows, and what is folded.

#include "compiler/model/ids.hpp"
#include "dsl/span.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

/// By its rank the task of one edge may take something from that of another; both of one requester.
struct TakeOver {
  EdgeId taker{}, loser{};
};

/// What holds at some moment of a scenario.
struct Moment {
  enum class Mark {
    inactive,
    running,
    queued, ///< somebody asks for it, and it waits
    pushed, ///< it runs, and somebody who waits has pushed it
    held,   ///< not asked for yet by who needs it
  };
  struct Standing {
    Mark mark = Mark::inactive;
    std::optional<ProviderId> active;
    std::string note; ///< what it waits for, or for whom it is pushed
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
  std::vector<Push> pushes;
};

/// What is wrong.
struct PictureFlaws {
  /// A name that no group has.
  struct Request {
    std::optional<GroupId> from; ///< nothing: the program
    std::optional<std::size_t> row;
    bool need = false;
    std::string name;
    dsl::Span span{};
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
  std::vector<GroupId> focus;       ///< only what has to do with these; empty: everything
  std::optional<std::size_t> depth; ///< ... no more than so many arrows away
  std::vector<TakeOver> take_overs; ///< for View::takes
  std::optional<Moment> moment;     ///< nothing: all that can be, and not what is
  std::vector<Moment> frames;       ///< moments of which each box is to have one place; with `moment` among them
  PictureFlaws flaws;
};

} // namespace director::compiler
