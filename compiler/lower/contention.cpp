// Door: compiler/lower/contention.hpp. Test: tests/compiler/lower/contention_test.cpp.
// SPDX-License-Identifier: MIT
//
// A chain never meets a group twice, because a group has one holder. For the same reason two chains that parted never
// meet again: they share their beginning from root, and below it no group but the contended one.

#include "compiler/lower/contention.hpp"

#include <algorithm>
#include <set>

namespace director::compiler {

namespace {

using Chain = std::vector<EdgeId>; ///< from root down

/// All chains that end in `edge`, found in at most `most_steps` steps upwards.
class Chains {
public:
  Chains(const Model& model, EdgeId edge, std::size_t most_steps)
      : model_(model),
        steps_left_(most_steps),
        met_(model.groups.size(), false) {
    met_[model.edges[edge].target] = true;
    climb(edge);
  }
  std::vector<Chain> all;
  bool complete = true;

private:
  void climb(EdgeId edge) {
    if (steps_left_ == 0) {
      complete = false;
      return;
    }
    --steps_left_;
    path_.push_back(edge);
    const std::optional<GroupId> requester = model_.edges[edge].requester;
    if (!requester) {
      all.emplace_back(path_.rbegin(), path_.rend());
    } else if (!met_[*requester]) {
      met_[*requester] = true;
      for (const EdgeId above : model_.groups[*requester].requesters) climb(above);
      met_[*requester] = false;
    }
    path_.pop_back();
  }

  const Model& model_;
  std::size_t steps_left_;
  IdTable<GroupId, char> met_;
  Chain path_;
};

/// Every way in which an edge can hold. As a need it counts as mandatory, with the priority of its first level.
std::set<Standing> ways(const Edge& edge) {
  std::set<Standing> out;
  for (const Level& level : edge.levels) out.insert({level.priority, level.optional});
  if (edge.needed) out.insert({edge.levels.empty() ? 0 : edge.levels.front().priority, false});
  return out;
}

/// The ways of the sibling at `at`, with what may be optional below it.
std::set<Standing> standings(const Model& model, const Chain& chain, std::size_t at) {
  bool firm = true, loose = false; // can all below be mandatory, can some of it be optional
  for (std::size_t i = at + 1; i < chain.size(); ++i) {
    const std::set<Standing> below = ways(model.edges[chain[i]]);
    firm = firm && std::any_of(below.begin(), below.end(), [](const Standing& way) { return !way.optional; });
    loose = loose || std::any_of(below.begin(), below.end(), [](const Standing& way) { return way.optional; });
  }
  std::set<Standing> out;
  for (const Standing& way : ways(model.edges[chain[at]])) {
    if (!way.optional && firm) out.insert({way.priority, false});
    if (way.optional || loose) out.insert({way.priority, true});
  }
  return out;
}

/// Where two chains to one group part; nothing where they could not stand side by side.
std::optional<std::size_t> split(const Model& model, const Chain& a, const Chain& b) {
  std::size_t at = 0;
  while (at < a.size() && at < b.size() && a[at] == b[at]) ++at;
  if (at == a.size() || at == b.size()) return std::nullopt;
  for (std::size_t i = at; i + 1 < a.size(); ++i) {
    for (std::size_t j = at; j + 1 < b.size(); ++j) {
      if (model.edges[a[i]].target == model.edges[b[j]].target) return std::nullopt;
    }
  }
  return at;
}

void add(std::vector<Decision>& decisions, const Decision& decision) {
  if (std::find(decisions.begin(), decisions.end(), decision) == decisions.end()) decisions.push_back(decision);
}

void decide(const Model& model, const Chain& a, const Chain& b, std::vector<Decision>& out) {
  const std::optional<std::size_t> at = split(model, a, b);
  if (!at) return;
  for (const Standing& first : standings(model, a, *at)) {
    for (const Standing& second : standings(model, b, *at)) {
      add(out, {model.edges[a[*at]].requester, a[*at], b[*at], first, second});
    }
  }
}

} // namespace

int order_of(const Decision& decision) {
  const Standing &first = decision.first, &second = decision.second;
  if (first.optional != second.optional) return first.optional ? 1 : -1;
  if (first.priority != second.priority) return first.priority > second.priority ? -1 : 1;
  return 0;
}

std::vector<Contention> contentions(const Model& model, GroupId group, std::size_t most_pairs) {
  const std::vector<EdgeId>& edges = model.groups[group].requesters;
  std::vector<Chains> chains;
  for (const EdgeId edge : edges) chains.emplace_back(model, edge, most_pairs);
  std::vector<Contention> out;
  std::size_t left = most_pairs;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      Contention contention{edges[i], edges[j], {}, chains[i].complete && chains[j].complete};
      for (const Chain& a : chains[i].all) {
        for (const Chain& b : chains[j].all) {
          if (left == 0) {
            contention.complete = false;
            break;
          }
          --left;
          decide(model, a, b, contention.decisions);
        }
      }
      out.push_back(std::move(contention));
    }
  }
  return out;
}

} // namespace director::compiler
