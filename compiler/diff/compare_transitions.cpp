// Header: compiler/diff/side.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
//
// Compares how control can pass between groups, as played by the engine, for any two groups of which one has another
// situation than before. For large behaviours these may be too many to play interactively: then pairs in which both
// changed come first, and the number of the rest is reported.
#include "compiler/diff/situations.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/transitions/matrix.hpp"

#include <fmt/format.h>

#include <array>
#include <compare>
#include <map>
#include <optional>
#include <set>

namespace director::compiler::diff {

namespace {

using Kind = Transition::Kind;
using Names = std::pair<std::string, std::string>; ///< from, to

/// For both sides, in units of TransitionPlays: some three seconds.
constexpr std::size_t most_work = 10'000'000;

struct Row {
  std::string name;
  std::set<std::string> reaches; ///< itself, and everything that it may request or need, at any depth
  bool has_changed = false;
};

std::set<std::string> reached_from(const Model& model, GroupId group) {
  std::set<std::string> out{name_of(model, group)};
  std::vector<GroupId> open{group};
  while (!open.empty()) {
    const GroupId id = open.back();
    open.pop_back();
    for (const EdgeId edge : model.groups[id].edges) {
      const GroupId target = model.edges[edge].target;
      if (out.insert(name_of(model, target)).second) open.push_back(target);
    }
  }
  return out;
}

/// The groups on both sides that request or need something.
std::vector<Row> common_rows(const Pair& pair) {
  const std::set<std::string> changed = changed_situations(pair);
  std::set<std::string> old;
  for (const Group& group : pair.old_model.groups) {
    if (!group.edges.empty()) old.insert(group.name.value);
  }
  std::vector<Row> out;
  if (changed.empty()) return out;
  for (const GroupId id : pair.new_model.groups.ids()) {
    const std::string& name = name_of(pair.new_model, id);
    if (!pair.new_model.groups[id].edges.empty() && old.contains(name))
      out.push_back({name, reached_from(pair.new_model, id), changed.contains(name)});
  }
  return out;
}

bool share(const Row& one, const Row& other) {
  return std::any_of(one.reaches.begin(), one.reaches.end(),
                     [&](const std::string& name) { return other.reaches.contains(name); });
}

/// All pairs that may have changed: first those that may want the same group, of these first those in which both have
/// changed.
std::vector<Names> choose(const Pair& pair) {
  const std::vector<Row> rows = common_rows(pair);
  std::array<std::vector<Names>, 4> by_rank;
  for (const Row& from : rows) {
    for (const Row& to : rows) {
      if (&from == &to || (!from.has_changed && !to.has_changed)) continue;
      const std::size_t rank = (share(from, to) ? 0U : 2U) + (from.has_changed && to.has_changed ? 0U : 1U);
      by_rank[rank].emplace_back(from.name, to.name);
    }
  }
  std::vector<Names> out;
  for (const std::vector<Names>& each : by_rank) out.insert(out.end(), each.begin(), each.end());
  return out;
}

/// One of the two behaviours.
class Played {
public:
  Played(const Model& model, const Possible& possible)
      : model_(model),
        possible_(possible),
        lowered_(lower(model)),
        plays_(model, lowered_) {
    for (const GroupId id : model.groups.ids()) ids_.emplace(name_of(model, id), id);
  }
  Transition between(const Names& ends) { return plays_.between(ids_.at(ends.first), ids_.at(ends.second)); }
  bool reaches(const std::string& name) { return plays_.reaches(ids_.at(name)); }
  /// False: it is proven that the group never runs.
  bool may_run(const std::string& name) const {
    const GroupId id = ids_.at(name);
    const analysis::Facts& facts = possible_.facts();
    return facts.requested.contains(id) && model_.has_any(id, facts.active);
  }
  Span span(const std::string& name) const { return model_.groups[ids_.at(name)].name.span; }
  std::size_t work() const { return plays_.work(); }

private:
  const Model& model_;
  const Possible& possible_;
  Lowered lowered_;
  TransitionPlays plays_;
  std::map<std::string, GroupId> ids_;
};

std::string bound_text(const std::optional<Microseconds>& bound) {
  return bound ? "at most " + dsl::time_text(*bound) : std::string("any time");
}

/// A sentence about the transitions between one group and others.
struct Sentence {
  ChangeKind kind{};
  std::string group;
  bool is_second = false; ///< they lead to the group, not from it
  std::string words;
  auto operator<=>(const Sentence&) const = default;
};

/// For a transition that is unreachable on one side. Nothing is reported if no control passes on the other one either,
/// or if it is reported for one of the groups: that it never runs is proven on one side only.
std::optional<Sentence> unreachable_sentence(const Names& ends, Kind before, Kind after, Played& was, Played& is) {
  if (before == Kind::same_chain || after == Kind::same_chain) return {};
  const bool now = after == Kind::unreachable;
  std::vector<std::string> names;
  for (const std::string& name : {ends.first, ends.second}) {
    if ((now ? is : was).reaches(name)) continue;
    if (is.may_run(name) != was.may_run(name)) return {};
    names.push_back(name);
  }
  if (names.empty()) return {};
  const std::string& name = names.front();
  return Sentence{ChangeKind::transition_changed, name, name == ends.second,
                  now ? fmt::format("unreachable now, as `{}` is not made to run; before {}", name, name_of(before))
                      : fmt::format("{} now; before unreachable, as `{}` was not made to run", name_of(after), name)};
}

} // namespace

TransitionsPlayed compare_transitions(const Pair& pair, Changes& changes) {
  TransitionsPlayed count;
  if (!pair.before.lowerable || !pair.after.lowerable) return count;
  const std::vector<Names> pairs = choose(pair);
  count.wanted = pairs.size();
  if (pairs.empty()) return count;
  Played was(pair.old_model, pair.possible_before), is(pair.new_model, pair.possible_after);
  std::map<Sentence, std::vector<std::string>> changed; // the other groups
  for (const Names& ends : pairs) {
    if (was.work() + is.work() > most_work) break;
    ++count.played;
    const Transition before = was.between(ends), after = is.between(ends);
    const auto add = [&](ChangeKind kind, const std::string& words) {
      changed[{kind, ends.first, false, words}].push_back(ends.second);
    };
    if (before.kind != after.kind) {
      if (before.kind == Kind::unreachable || after.kind == Kind::unreachable) {
        if (const auto sentence = unreachable_sentence(ends, before.kind, after.kind, was, is))
          changed[*sentence].push_back(sentence->is_second ? ends.first : ends.second);
        continue;
      }
      const ChangeKind kind = before.kind == Kind::soft && after.kind == Kind::hard   ? ChangeKind::hardened
                              : before.kind == Kind::hard && after.kind == Kind::soft ? ChangeKind::softened
                                                                                      : ChangeKind::transition_changed;
      add(kind, fmt::format("{} now, before {}", name_of(after.kind), name_of(before.kind)));
    } else if (after.kind == Kind::soft && before.bound != after.bound) {
      add(bound_change(before.bound, after.bound),
          fmt::format("soft, and may take {}, before {}", bound_text(after.bound), bound_text(before.bound)));
    }
  }
  for (auto& [what, others] : changed) {
    std::sort(others.begin(), others.end());
    const std::string group = ticked(what.group), list = ticked_list(others);
    const std::string& at = what.is_second ? what.group : others.front();
    changes.add(
        what.kind, what.group,
        fmt::format("from {} to {}: {}", what.is_second ? list : group, what.is_second ? group : list, what.words),
        was.span(at), is.span(at));
  }
  return count;
}

} // namespace director::compiler::diff
