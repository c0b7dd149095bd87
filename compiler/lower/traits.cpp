// Header: compiler/lower/steps.hpp. Test: tests/compiler/lower/traits_test.cpp.
// SPDX-License-Identifier: MIT
//
// What the engine asks so often that it is worked out once: how simple a group is, and where two edges can be equal
// (docs/semantics.md, 4.1, rule 5): only where a requester has two that go by one priority.

#include "compiler/lower/steps.hpp"

#include <map>

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

/// Edges of one requester with one priority part the chains of all that is below them. Where nothing is below either,
/// they lead to two groups, and never compete for one.
class Equals {
public:
  explicit Equals(const Lowered& out) : out_(out) {}

  /// Of the requester of the edges before.
  void begin() { first_.clear(); }
  /// It goes by the priority of another edge of the same requester, and they may be equal.
  bool add(Index edge) {
    bool found = look(edge, out_.edges[edge].need_urgency);
    const Range levels = out_.edges[edge].levels;
    for (Index level = levels.begin; level != levels.end; ++level)
      found = look(edge, out_.levels[level].urgency) || found;
    return found;
  }

private:
  bool leads_on(Index edge) const { return !out_.groups[out_.edges[edge].target].edges.empty(); }
  bool look(Index edge, Index urgency) {
    const Index other = first_.try_emplace(urgency, edge).first->second;
    return other != edge && (leads_on(other) || leads_on(edge));
  }

  const Lowered& out_;
  std::map<Index, Index> first_; ///< urgency -> the first edge that goes by it
};

} // namespace

void lower_traits(Lowered& out) {
  for (director::Group& group : out.groups) find_shape(out, group);
  Equals equals(out);
  for (director::Component& component : out.components) {
    equals.begin(); // edges of root come first
    for (Index i = component.edges.begin; i != component.edges.end; ++i) {
      const Index edge = out.lists[i];
      if (out.edges[edge].requester == nil) component.equals = equals.add(edge) || component.equals;
    }
    for (Index i = component.groups.begin; i != component.groups.end; ++i) {
      const director::Group& group = out.groups[out.lists[i]];
      component.alternatives = component.alternatives || !group.slots.empty();
      equals.begin();
      for (Index edge = group.edges.begin; edge != group.edges.end; ++edge)
        component.equals = equals.add(edge) || component.equals;
    }
  }
}

} // namespace director::compiler
