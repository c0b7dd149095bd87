// Header: compiler/lower/steps.hpp. Test: tests/compiler/lower/traits_test.cpp.
// SPDX-License-Identifier: MIT
//
// Precomputes what the engine reads often: how simple a group is, and whether two edges that lead to it can be equal
// (docs/semantics.md, 4.1, rule 4).

#include "compiler/lower/steps.hpp"

#include <map>
#include <vector>

namespace director::compiler {

namespace {

bool is_simple(const Lowered& out, const director::Group& group) {
  return group.providers.size() == 1 && out.providers[group.providers.begin].needs.empty();
}

void find_shape(const Lowered& out, director::Group& group) {
  group.simple = is_simple(out, group);
  for (Index p = group.providers.begin; p != group.providers.end; ++p) {
    const director::Provider& provider = out.providers[p];
    group.conditional = group.conditional || !provider.when.empty() || !provider.stay.empty();
  }
}

/// Finds the groups that two equal edges may lead to. Edges are equal if their chains part at two edges of one
/// requester with one priority: so these are the groups below both of such a pair.
class Equals {
public:
  explicit Equals(const Lowered& out)
      : out_(out),
        is_below_pair_(out.groups.size()),
        found_by_(out.groups.size(), nil) {}

  /// The edges of one requester.
  void look_at(Range edges) {
    std::map<Index, std::vector<Index>> by_urgency;
    const auto add = [&](Index urgency, Index edge) {
      std::vector<Index>& like = by_urgency[urgency];
      if (like.empty() || like.back() != edge) like.push_back(edge);
    };
    for (const Index edge : edges.rows()) {
      const Range levels = out_.edges[edge].levels;
      add(out_.edges[edge].need_urgency, edge);
      for (const Index level : levels.rows()) add(out_.levels[level].urgency, edge);
    }
    for (const auto& [urgency, like] : by_urgency) {
      if (like.size() > 1) meet(like);
    }
  }

  /// Call it after all were examined. A group with only one incoming edge has no second requester.
  bool lead_to(Index group) const { return is_below_pair_[group] && out_.groups[group].requesters.size() > 1; }

private:
  /// Marks where one of them leads to groups that another one has led to.
  void meet(const std::vector<Index>& like) {
    for (const Index edge : like) {
      enter(out_.edges[edge].target, [&](Index group) {
        Index& by = found_by_[group];
        if (is_below_pair_[group] || by == edge) return false;
        if (by != nil) {
          mark(group);
          return false;
        }
        by = edge;
        found_.push_back(group);
        return true;
      });
    }
    for (const Index group : found_) found_by_[group] = nil;
    found_.clear();
  }

  /// Marks the group with all below it.
  void mark(Index group) {
    enter(group, [&](Index each) {
      if (is_below_pair_[each]) return false;
      is_below_pair_[each] = true;
      return true;
    });
  }

  /// Calls goes_on(group) for the group, and for the targets of each for which it is true.
  template <class GoesOn>
  void enter(Index first, const GoesOn& goes_on) const {
    std::vector<Index> open{first};
    while (!open.empty()) {
      const Index group = open.back();
      open.pop_back();
      if (!goes_on(group)) continue;
      for (const Index edge : out_.groups[group].edges.rows()) open.push_back(out_.edges[edge].target);
    }
  }

  const Lowered& out_;
  std::vector<bool> is_below_pair_;
  std::vector<Index> found_by_; ///< group: the first current edge that led to it; nil
  std::vector<Index> found_;    ///< those that have one
};

} // namespace

void lower_traits(Lowered& out) {
  for (director::Group& group : out.groups) find_shape(out, group);
  Equals equals(out);
  equals.look_at({0, out.root_edges});
  for (const director::Group& group : out.groups) equals.look_at(group.edges);
  for (Index g = 0; g < out.groups.size(); ++g) {
    director::Group& group = out.groups[g];
    group.equals = equals.lead_to(g);
    for (Index i = group.users.begin; group.equals && i != group.users.end; ++i)
      out.groups[out.lists[i]].deniable = true;
    director::Component& component = out.components[group.component];
    component.alternatives = component.alternatives || !group.slots.empty();
  }
}

} // namespace director::compiler
