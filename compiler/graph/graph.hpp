#pragma once
// SPDX-License-Identifier: MIT
// The Graph: which group leads to which, derived from a Model. Nodes are groups, by the number of their id.

#include "compiler/graph/algorithms.hpp"
#include "compiler/model/model.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

struct Graph {
  Arrows tasks;  ///< requester -> what it may request
  Arrows needs;  ///< group -> what one of its providers needs
  Arrows claims; ///< both

  /// A provider's promise that satisfies a condition of another provider.
  struct Causing {
    ProviderId causer{};
    ConditionUse promise{};
    ProviderId waiter{};
    ConditionUse condition{}; ///< in the waiter's `when`
    bool operator==(const Causing& other) const;
  };
  std::vector<Causing> causing; ///< in order of waiter, condition, causer

  std::vector<std::vector<Node>> task_cycles;  ///< components of `tasks`
  std::vector<std::vector<Node>> needs_cycles; ///< components of `needs`
  std::vector<Node> order; ///< groups, requesters first, over `claims`
  /// The last group before this one that every chain of requests from a root passes; empty: there is none, or no chain.
  IdTable<GroupId, std::optional<GroupId>> gate;
  IdSet<GroupId> requestable; ///< some chain of requests from a root leads to it
};

Graph make_graph(const Model& model);

/// All edges of the model as arrows between groups; a root's edge begins at `root_node`, which follows the groups.
Arrows edge_arrows(const Model& model);
inline Node root_node(const Model& model) { return static_cast<Node>(model.groups.size()); }

/// The group, and all that it leads to by requests and needs; by number.
std::vector<bool> led_to(const Graph& graph, GroupId from);

/// As text: one line for each arrow.
std::string print_graph(const Model& model, const Graph& graph);

} // namespace director::compiler
