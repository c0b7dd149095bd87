#pragma once
// SPDX-License-Identifier: MIT
// The points that scenarios can exercise in a behaviour, and those that they did exercise. A point that the checks
// prove impossible does not count. Source: docs/scenarios.md, "Coverage".

#include "compiler/analysis/chains/claims.hpp"
#include "compiler/analysis/chains/unit_places.hpp"
#include "compiler/analysis/ranks/contention.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"

#include <array>
#include <compare>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace director::compiler {

struct CoveragePoint {
  enum class Kind {
    provider, ///< `first`: provider; it ran
    pack,     ///< `first`: provider, `second`: place of the pack; requested
    level,    ///< `first`: edge, `second`: place among its levels; requested
    when, ///< `first`: provider, `second`: condition, `third`: 1 it was true, 0 it was not, while the group was wanted
    stay, ///< likewise, while the provider was active
    push, ///< `first`: the group that waits, `second`: the causing provider; pushed
    take_over, ///< `first`, `second`: edges of one requester; by its rank the first took something from the second
  };
  struct Key {
    Kind kind = Kind::provider;
    std::uint32_t first = 0, second = 0, third = 0;
    auto operator<=>(const Key&) const = default;
  };
  Key key;
  Span span{}; ///< where it is declared
  bool covered = false;
};

/// Classes for the report: both kinds of conditions are one.
enum class CoverageClass { providers, packs, levels, conditions, pushes, take_overs };
inline constexpr std::array all_coverage_classes{CoverageClass::providers, CoverageClass::packs,
                                                 CoverageClass::levels,    CoverageClass::conditions,
                                                 CoverageClass::pushes,    CoverageClass::take_overs};
std::string_view name_of(CoverageClass of);
CoverageClass class_of(CoveragePoint::Kind kind);

struct Coverage {
  std::vector<CoveragePoint> points; ///< class after class, in order of declaration

  std::size_t covered() const;
  /// Whole percents, rounded down; of nothing 100.
  int percent() const;
  /// Covered here or there. Both are of the same behaviour.
  void merge(const Coverage& other);
};

/// Every point of a deployment, none covered.
Coverage coverage_of(const Model& model, const Graph& graph);

/// What the first edge may take from the second.
struct PossibleTake {
  EdgeId taker{}, loser{};
  std::vector<bool> groups;          ///< by number
  std::set<analysis::Winning> ranks; ///< by which it may: then the take-over is a point of coverage
  /// Members of the loser's unit at whose place that goes first nevertheless.
  std::set<analysis::Leader> except;
  std::set<analysis::Leader> leaders; ///< likewise of the taker's unit, if the taker's own rank is not enough
  std::set<std::int32_t> led_over;    ///< then: the priorities of the loser
};
struct TakeLimits {
  struct Among {
    IdSet<GroupId> both, either;
  };
  std::size_t most = std::numeric_limits<std::size_t>::max();
  std::optional<Among> among{}; ///< both tasks are for a group of `both`, or one for one of `either`; empty: any tasks
};
/// Their number is quadratic in the number of tasks that want the same. If there are more than the limit, there is one
/// more than that in the result: enough to know it.
std::vector<PossibleTake> possible_takes(const Model& model, const Graph& graph, const TakeLimits& limits = {});

/// Two entries that may be requested at once, a level of each, and a group that both may claim then.
struct Rivalry {
  std::optional<ProviderId> provider;         ///< of whose pack they are; empty: root
  std::string_view pack;                      ///< empty for root and flat `tasks`
  const std::vector<Task>* entries = nullptr; ///< of that pack
  const Task *taker = nullptr, *loser = nullptr;
  const Task::NamedLevel *taker_level = nullptr, *loser_level = nullptr;
  GroupId group{};
  analysis::Reach takes{}, loses{}; ///< how each of the two comes to claim the group
  analysis::Winning ranks;
  bool wins = false; ///< by these ranks the taker goes before the loser
};
/// Finds every one that is possible, also those that do not win: `possible_takes` has those that do. Model and graph
/// have to outlive it.
class Rivalries {
public:
  Rivalries(const Model& model, const Graph& graph);
  ~Rivalries();
  Rivalries(const Rivalries&) = delete;
  Rivalries& operator=(const Rivalries&) = delete;
  void between(EdgeId taker, EdgeId loser, const std::function<void(const Rivalry&)>& visit);

private:
  struct Finder;
  std::unique_ptr<Finder> finder_;
};

} // namespace director::compiler
