// Door: compiler/diff/side.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
//
// From what to what control can change, as the engine plays it. Only of behaviours that are small enough to play twice
// while somebody waits; of larger ones take-overs and pushes tell the same, without having been played.
#include "compiler/diff/side.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/transitions/matrix.hpp"

#include <fmt/format.h>

#include <map>
#include <tuple>

namespace director::compiler::diff {

namespace {

using Kind = Transition::Kind;

/// A matrix grows with the square of these.
constexpr std::size_t most_played = 24;

std::size_t rows_of(const Model& model) {
  return static_cast<std::size_t>(
      std::count_if(model.groups.begin(), model.groups.end(), [](const Group& group) { return !group.edges.empty(); }));
}

struct Cell {
  Transition transition;
  Span span{}; ///< of the second
};
using Cells = std::map<std::pair<std::string, std::string>, Cell>;

Cells play(const Model& model) {
  Cells out;
  const TransitionMatrix matrix = find_transitions(model, lower(model), "behaviour.yaml");
  for (const TransitionMatrix::Row& row : matrix.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const GroupId to = matrix.rows[i].group;
      out.emplace(std::pair(name_of(model, row.group), name_of(model, to)),
                  Cell{row.cells[i], model.groups[to].name.span});
    }
  }
  return out;
}

std::string bound_text(const std::optional<Microseconds>& bound) {
  return bound ? "at most " + dsl::time_text(*bound) : std::string("any time");
}

} // namespace

void compare_transitions(const Pair& pair, Changes& changes) {
  if (!pair.before.lowerable || !pair.after.lowerable) return;
  if (std::max(rows_of(pair.old_model), rows_of(pair.new_model)) > most_played) return;
  const Cells was = play(pair.old_model), is = play(pair.new_model);
  struct Told {
    std::vector<std::string> to;
    Span before{}, after{};
  };
  std::map<std::tuple<ChangeKind, std::string, std::string>, Told> told; // what, from, sentence
  for (const auto& each : is) {
    const auto& ends = each.first; // no binding: clang has none of these in lambdas
    const Cell& now = each.second;
    const auto old = was.find(ends);
    if (old == was.end()) continue;
    const Transition &before = old->second.transition, &after = now.transition;
    const auto tell = [&](ChangeKind kind, const std::string& words) {
      Told& one = told[{kind, ends.first, words}];
      one.to.push_back(ends.second);
      if (one.to.size() == 1) one.before = old->second.span, one.after = now.span;
    };
    if (before.kind != after.kind) {
      // What can or cannot be brought to run at all is told of the group itself.
      if (before.kind == Kind::unreachable || after.kind == Kind::unreachable) continue;
      const ChangeKind kind = before.kind == Kind::soft && after.kind == Kind::hard   ? ChangeKind::hardened
                              : before.kind == Kind::hard && after.kind == Kind::soft ? ChangeKind::softened
                                                                                      : ChangeKind::transition_changed;
      tell(kind, fmt::format("{} now, before {}", name_of(after.kind), name_of(before.kind)));
    } else if (after.kind == Kind::soft && before.bound != after.bound) {
      tell(bound_change(before.bound, after.bound),
           fmt::format("soft, and may take {}, before {}", bound_text(after.bound), bound_text(before.bound)));
    }
  }
  for (const auto& [what, one] : told) {
    const auto& [kind, from, words] = what;
    changes.add(kind, from, fmt::format("from `{}` to {}: {}", from, ticked_list(one.to), words), one.before,
                one.after);
  }
}

} // namespace director::compiler::diff
