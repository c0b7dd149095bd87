#pragma once
// SPDX-License-Identifier: MIT
// A part of a behaviour that is decided independently (semantics.md, section 4): groups that request or need each
// other, or wait for promises of others. Its tables have so few rows that a Moment fits into few bytes. The value of a
// state only counts by the conditions that it satisfies.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/model/model.hpp"

#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

namespace director::analysis {

using Row = std::uint8_t;
using Rows = std::uint64_t; ///< a set of rows of one table
inline constexpr Row nothing = 255;
constexpr Rows bit(Row row) { return Rows{1} << row; }

class RowRange {
public:
  explicit constexpr RowRange(Rows rows) : rows_(rows) {}
  constexpr RowRange begin() const { return *this; }
  constexpr RowRange end() const { return RowRange(0); }
  constexpr Row operator*() const { return static_cast<Row>(std::countr_zero(rows_)); }
  constexpr RowRange& operator++() {
    rows_ &= rows_ - 1;
    return *this;
  }
  constexpr bool operator==(const RowRange&) const = default;

private:
  Rows rows_;
};
/// The rows of a set, in order: for (const Row edge : each(edges)).
constexpr RowRange each(Rows rows) { return RowRange(rows); }

struct Component {
  // Limits, beyond which a component is not examined: a Moment has a fixed size, and there would be too many of them.
  static constexpr std::size_t most_groups = 10, most_edges = 32, most_states = 6, most_providers = 40,
                               most_conditions = 60, most_plans = 12, most_values = 12, most_roots = 4;

  struct EdgeRow {
    EdgeId id{};
    Row requester = nothing, target = 0; ///< nothing: root
    std::vector<Level> levels;
    Level as_need{};
  };
  struct Planned {
    Row group = 0, provider = 0, needer = 0, edge = 0;
    bool operator==(const Planned&) const = default;
  };
  using Plan = std::vector<Planned>;
  /// What a handler or body may set: one of the values, or unset.
  struct Setting {
    Row state = 0;
    std::vector<Row> values;
  };
  struct Entry {
    Row edge = 0;
    std::vector<Row> levels; ///< of its edge
    bool may_lack = false;   ///< a body may leave it out
  };
  struct PackRow {
    std::vector<Entry> entries;
    std::vector<Row> members; ///< edges of a named pack that are granted together or not at all; empty if there are
                              ///< fewer than two
  };
  struct ProviderRow {
    ProviderId id{};
    Row group = 0;
    std::vector<Row> when, stay; ///< conditions
    bool unsure = false;         ///< its `when` is reported as contradictory: it may hold at any time
    std::vector<Plan> plans;
    Rows causes = 0;        ///< conditions that its promises satisfy
    Rows causes_states = 0; ///< states that they are about
    std::vector<Setting> sets;
    std::vector<PackRow> packs;
  };
  struct GroupRow {
    GroupId id{};
    std::vector<Row> providers, edges, requesters;
    Rows may_request = 0; ///< by requests and needs, transitively
    Rows below = 0;       ///< that, and itself
    std::vector<Setting> start, stop;
    std::vector<Row> owned; ///< states that belong to it
  };
  struct StateRow {
    StateId id{};
    Row values = 0; ///< kinds of values, from 0; `values` itself is unset
    Row initial = 0;
    std::vector<Row> from_outside; ///< at rest: set from outside, or expired
    std::vector<Row> at_any_time;  ///< from other components, or missing and reported
  };
  struct ConditionRow {
    ConditionId id{};
    Row state = 0;
    Rows accepts = 0; ///< values of its state
  };

  std::vector<GroupRow> groups;
  std::vector<ProviderRow> providers;
  std::vector<EdgeRow> edges; ///< those of root first
  std::vector<StateRow> states;
  std::vector<ConditionRow> conditions;
  Row roots = 0; ///< edges of root
};

/// Empty: it is above the limits.
std::optional<Component> make_component(const Model& model, const Facts& facts, Reported reported,
                                        const IdTable<StateId, std::vector<Source>>& sources,
                                        const std::vector<GroupId>& groups);

/// The groups of each component, in order; only of those that are small enough.
std::vector<std::vector<GroupId>> small_components(const Model& model);

} // namespace director::analysis
