// Header: compiler/analysis/ranks/print_priorities.hpp. Test: tests/compiler/lower/print_tables_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/ranks/print_priorities.hpp"

#include "compiler/analysis/ranks/contention.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace director::analysis {

namespace {

/// Limit for one pair of edges. Many levels and many paths have many decisions, all at the same few requesters.
constexpr std::size_t most_decisions_shown = 30;

/// A level of one edge at its rank in its requester's order.
struct Ranked {
  EdgeId edge{};
  Level level;
};

bool goes_before(const Ranked& a, const Ranked& b) {
  if (a.level.optional != b.level.optional) return b.level.optional;
  return a.level.priority > b.level.priority;
}

class PrioritiesPrinter {
public:
  explicit PrioritiesPrinter(const Model& model) : model_(model), contentions_(model) {}

  std::string print() {
    out_ += "priorities\n";
    std::vector<EdgeId> of_root;
    for (const EdgeId id : model_.edges.ids()) {
      if (!model_.edges[id].requester) of_root.push_back(id);
    }
    print_requester("root", of_root);
    for (const Group& group : model_.groups) print_requester(group.name.value, group.edges);
    out_ += "\ncontended groups (where the chains to two edges part; optional: that edge or one below it)\n";
    for (const GroupId id : model_.groups.ids()) print_contended(id);
    return out_;
  }

private:
  const std::string& name(GroupId id) const { return model_.groups[id].name.value; }

  void print_requester(std::string_view requester, const std::vector<EdgeId>& edges) {
    std::vector<Ranked> ranked;
    std::string needed;
    for (const EdgeId id : edges) {
      for (const Level& level : model_.edges[id].levels) ranked.push_back({id, level});
      if (model_.edges[id].levels.empty()) needed += (needed.empty() ? "" : ", ") + name(model_.edges[id].target);
    }
    if (edges.empty()) return;
    std::stable_sort(ranked.begin(), ranked.end(), goes_before);
    fmt::format_to(std::back_inserter(out_), "  {}\n", requester);
    int rank = 0;
    for (std::size_t i = 0; i < ranked.size(); ++i) {
      const Level& level = ranked[i].level;
      if (i > 0 && goes_before(ranked[i - 1], ranked[i])) ++rank;
      fmt::format_to(std::back_inserter(out_), "    {:>2}  {}, priority {}{}{}\n", rank,
                     name(model_.edges[ranked[i].edge].target), level.priority, level.optional ? ", optional" : "",
                     level.apart ? ", apart" : "");
    }
    if (!needed.empty()) fmt::format_to(std::back_inserter(out_), "        only needs {}\n", needed);
  }

  void print_contended(GroupId id) {
    if (model_.groups[id].requesters.size() < 2) return;
    fmt::format_to(std::back_inserter(out_), "  {}\n", name(id));
    bool complete = true;
    for (const Contention& contention : contentions_.at(id)) {
      complete = complete && contention.complete;
      fmt::format_to(std::back_inserter(out_), "    {} and {}{}\n", model_.edge_name(contention.first),
                     model_.edge_name(contention.second),
                     contention.decisions.empty() && contention.complete ? ": never both" : "");
      const std::size_t shown = std::min(contention.decisions.size(), most_decisions_shown);
      for (std::size_t i = 0; i < shown; ++i) print_decision(contention, contention.decisions[i]);
      if (shown < contention.decisions.size()) {
        fmt::format_to(std::back_inserter(out_), "      and {} more\n", contention.decisions.size() - shown);
      }
    }
    if (!complete) {
      fmt::format_to(std::back_inserter(out_), "    cut after {} pairs of tasks: there may be more\n", most_edge_pairs);
    }
  }

  void print_decision(const Contention& contention, const Decision& decision) {
    const int order = order_of(decision);
    const std::string verdict =
        order == 0 ? "equal" : model_.edge_name(order < 0 ? contention.first : contention.second) + " first";
    fmt::format_to(
        std::back_inserter(out_), "      at {}: {}, {}: {}\n", decision.requester ? name(*decision.requester) : "root",
        side(decision.first_sibling, decision.first), side(decision.second_sibling, decision.second), verdict);
  }

  std::string side(EdgeId sibling, const SideRank& rank) const {
    return fmt::format("{} {}{}", name(model_.edges[sibling].target), rank.priority, rank.optional ? " optional" : "");
  }

  const Model& model_;
  Contentions contentions_;
  std::string out_;
};

} // namespace

std::string print_priorities(const Model& model) { return PrioritiesPrinter(model).print(); }

} // namespace director::analysis
