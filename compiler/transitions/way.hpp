#pragma once
// SPDX-License-Identifier: MIT
// Finds how a group is brought to run: the chain of requests from the program, the provider of each group on it, and
// the values that are needed from outside.

#include "compiler/model/model.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace director::compiler::transitions {

/// A provider that requests the next task of the chain.
struct Link {
  ProviderId provider{};
  std::size_t pack = 0; ///< of Provider::packs
  const Task* next = nullptr;
  bool operator==(const Link&) const = default;
};

/// The provider of each link belongs to the group that the link before requests; that of the first, to the program's
/// request.
struct Way {
  const Task* root = nullptr;
  std::vector<Link> links;
  GroupId target{};
  ProviderId runs{}; ///< of the target

  const Task& last() const { return links.empty() ? *root : *links.back().next; }
  GroupId group(std::size_t link) const { return link == 0 ? root->target : links[link - 1].next->target; }
  bool passes(GroupId id) const; ///< above the target
  bool operator==(const Way&) const = default;
};

/// The groups with ways: those that some chain of requests leads to.
IdSet<GroupId> find_led_to(const Model& model);

/// The shortest chain, ties by declaration, with one way for each choice of providers on it; then the ways through its
/// other requesters; then all of these by the other packs of the providers. None if no chain leads there.
std::vector<Way> find_ways(const Model& model, GroupId target);

using Values = std::map<StateId, std::int64_t>;

/// The values from outside with which these providers are the ones that run.
struct Outside {
  std::map<StateId, ValueSet> wanted; ///< what their conditions accept
  Values values;                      ///< of those states that begin otherwise, the first value in order of declaration
  Values given;                       ///< likewise the initial values of states that only bodies set
};

/// Whether states that only bodies set may begin with the wanted values, if bodies set them, or all with the declared
/// ones.
enum class Assume : bool { nothing, inside };

/// What each state may have: its initial value, and what something sets.
using PossibleValues = IdTable<StateId, ValueSet>;
PossibleValues find_possible_values(const Model& model);

/// The values to try, the likeliest first; empty if none are suitable. At most `most_outsides`.
std::vector<Outside> outsides_for(const Model& model, const PossibleValues& possible, const Way& way, Assume assume);

/// Limit for one way.
constexpr std::size_t most_outsides = 8;

} // namespace director::compiler::transitions
