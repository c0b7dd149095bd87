#pragma once
// SPDX-License-Identifier: MIT
// What is asked of graphs, on bare adjacency lists: node i has an arrow to each of arrows[i]. All of it linear or
// nearly so, and safe on chains of any length. algorithms.cpp is the one place that knows Boost.Graph.

#include <cstdint>
#include <optional>
#include <vector>

namespace director::compiler {

using Node = std::uint32_t;
using Arrows = std::vector<std::vector<Node>>;

/// Strongly connected components, each sorted, in order of their smallest node. Those of one node without an arrow to
/// itself are left out: what remains is what cycles are made of.
std::vector<std::vector<Node>> cycles(const Arrows& arrows);

/// Of each node, the smallest of those that arrows connect it with, whichever way they point.
std::vector<Node> connected(const Arrows& arrows);

/// Nodes, each before those that it has arrows to; where a cycle makes that impossible, its nodes stand together. Equal
/// input gives equal output.
std::vector<Node> topological_order(const Arrows& arrows);

/// The last node before each one that every path from `start` to it passes; nothing for `start` and what it does not
/// reach.
std::vector<std::optional<Node>> immediate_dominators(const Arrows& arrows, Node start);

/// What can be reached from `start`, or from one of several, by one arrow or more.
std::vector<bool> reachable(const Arrows& arrows, Node start);
std::vector<bool> reachable(const Arrows& arrows, std::vector<Node> starts);

/// A shortest path of at least one arrow, both ends included; empty if there is none. Through `within` alone, if given.
std::vector<Node> shortest_path(const Arrows& arrows, Node from, Node to, const std::vector<bool>* within = nullptr);

} // namespace director::compiler
