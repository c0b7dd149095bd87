// Header: compiler/lower/steps.hpp. Test: tests/compiler/lower/traits_test.cpp.
// SPDX-License-Identifier: MIT
//
// What the engine asks so often that it is worked out once: how simple a group is, and whether two edges that lead
// to it can be equal (docs/semantics.md, 4.1, rule 4).

#include "compiler/lower/steps.hpp"

#include <map>
#include <span>
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

/// To which groups two equal edges may lead. Edges are equal where their chains part at two edges of one requester that
/// go by one priority: so these are the groups below both of such a pair.
class Equals {
public:
  explicit Equals(const Lowered& out)
      : out_(out),
        is_below_pair_(out.groups.size()),
        found_by_(out.groups.size(), nil) {}

  /// The edges of one requester.
  void look_at(std::span<const Index> edges) {
    std::map<Index, std::vector<Index>> by_urgency;
    const auto add = [&](Index urgency, Index edge) {
      std::vector<Index>& like = by_urgency[urgency];
      if (like.empty() || like.back() != edge) like.push_back(edge);
    };
    for (const Index edge : edges) {
      const Range levels = out_.edges[edge].levels;
      add(out_.edges[edge].need_urgency, edge);
      for (Index level = levels.begin; level != levels.end; ++level) add(out_.levels[level].urgency, edge);
    }
    for (const auto& [urgency, like] : by_urgency) {
      if (like.size() > 1) meet(like);
    }
  }

  /// When all were looked at. Of a group to which one edge leads nobody else asks.
  bool lead_to(Index group) const { return is_below_pair_[group] && out_.groups[group].requesters.size() > 1; }

private:
  /// Where one of them leads to what another one has led to.
  void meet(const std::vector<Index>& like) {
    for (const Index edge : like) {
      enter_below(edge, [&](Index group) {
        Index& by = found_by_[group];
        if (is_below_pair_[group] || by == edge) return false;
        if (by != nil) {
          is_below_pair_[group] = true;
          for (Index e = out_.groups[group].edges.begin; e != out_.groups[group].edges.end; ++e) // and all below it
            enter_below(e, [&](Index below) { return !is_below_pair_[below] && (is_below_pair_[below] = true); });
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

  /// Calls enter(group) for the target of the edge, and for the targets of each group for which it is true.
  template <class Enter>
  void enter_below(Index edge, const Enter& enter) const {
    std::vector<Index> open{out_.edges[edge].target};
    while (!open.empty()) {
      const Index group = open.back();
      open.pop_back();
      if (!enter(group)) continue;
      for (Index e = out_.groups[group].edges.begin; e != out_.groups[group].edges.end; ++e)
        open.push_back(out_.edges[e].target);
    }
  }

  const Lowered& out_;
  std::vector<bool> is_below_pair_;
  std::vector<Index> found_by_; ///< group: the edge in hand that led to it first; nil
  std::vector<Index> found_;    ///< those that have one
};

} // namespace

void lower_traits(Lowered& out) {
  for (director::Group& group : out.groups) find_shape(out, group);
  Equals equals(out);
  std::vector<Index> edges;
  for (Index e = 0; e < out.edges.size(); ++e) { // those of one requester stand together
    edges.push_back(e);
    if (e + 1 < out.edges.size() && out.edges[e + 1].requester == out.edges[e].requester) continue;
    equals.look_at(edges);
    edges.clear();
  }
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
