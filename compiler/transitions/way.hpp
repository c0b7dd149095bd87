#pragma once
// SPDX-License-Identifier: MIT
// How a group is brought to run: by which chain of requests from the program, with which provider of each group on it,
// and which values the outside has to give.

#include "compiler/model/model.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace director::compiler::transitions {

/// A provider that asks for what comes next on the way.
struct Link {
  ProviderId provider{};
  std::size_t pack = 0; ///< of Provider::packs
  const Task* next = nullptr;
};

/// The provider of each link belongs to what the one before asks for; that of the first, to what the program asks for.
struct Way {
  const Task* root = nullptr;
  std::vector<Link> links;
  GroupId target{};
  ProviderId runs{}; ///< of the target

  const Task& last() const { return links.empty() ? *root : *links.back().next; }
  GroupId group(std::size_t link) const { return link == 0 ? root->target : links[link - 1].next->target; }
  bool passes(GroupId id) const; ///< above the target
};

/// The shortest chain, ties by declaration, and for each choice of providers on it one way; behind these the ways
/// through its other requesters. None where no chain leads there.
std::vector<Way> find_ways(const Model& model, GroupId target);

using Values = std::map<StateId, std::int64_t>;

/// What the outside has to say for these providers to be the ones that run.
struct Outside {
  std::map<StateId, ValueSet> wanted; ///< what their conditions accept
  Values values;                      ///< of those states that do not begin so, the first value in order of declaration
  Values given;                       ///< likewise of states that only bodies set: what it begins with
};

/// Whether states that only bodies set may begin with what is wanted, or all of them with what is declared.
enum class Assume : bool { nothing, inside };

/// Nothing where no values do.
std::optional<Outside> outside_for(const Model& model, const Way& way, Assume assume);

} // namespace director::compiler::transitions
