#pragma once
// SPDX-License-Identifier: MIT
// Graph algorithms on adjacency lists: node i has an arrow to each of arrows[i]. All of them are linear or nearly so,
// and safe on chains of any length. Only algorithms.cpp includes Boost.Graph.

#include <cstdint>
#include <optional>
#include <vector>

namespace director::compiler {

using Node = std::uint32_t;
using Arrows = std::vector<std::vector<Node>>;

/// Strongly connected components, each sorted, in order of their smallest node. Those of one node without an arrow to
/// itself are left out: the rest are the parts with cycles.
std::vector<std::vector<Node>> cycles(const Arrows& arrows);

/// Nodes, each before those that it has arrows to; the nodes of a cycle are adjacent. Equal input gives equal output.
std::vector<Node> topological_order(const Arrows& arrows);

/// The last node before each one that every path from `start` to it passes; empty for `start` and unreachable nodes.
std::vector<std::optional<Node>> immediate_dominators(const Arrows& arrows, Node start);

/// The nodes that can be reached from `start`, or from one of several, by one arrow or more.
std::vector<bool> reachable(const Arrows& arrows, Node start);
std::vector<bool> reachable(const Arrows& arrows, std::vector<Node> starts);

/// A shortest path of at least one arrow, both ends included; empty if there is none. Only through `within`, if given.
std::vector<Node> shortest_path(const Arrows& arrows, Node from, Node to, const std::vector<bool>* within = nullptr);

} // namespace director::compiler
