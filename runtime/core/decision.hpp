#pragma once
// SPDX-License-Identifier: MIT
// A decision of a component, as it is written down: rows of Index.

#include "runtime/core/state.hpp"

#include <cstddef>
#include <span>

namespace director {

// A decision is written down as the groups' standings, a bit for each whose outdated orders counted, why each edge is
// queued, the order, and the plans.
inline constexpr std::size_t standing_rows = 7;
inline constexpr std::size_t count_rows = 4; ///< of 16 bits
inline constexpr std::size_t why_rows = 2;
static_assert(sizeof(Standing) == standing_rows * sizeof(Index));

/// A word of the state, whichever it is.
using AnyWord [[gnu::may_alias]] = Index;

/// One decision of a component.
class Decision {
public:
  Decision(const Index* rows, const Component& component)
      : rows_(rows),
        groups_(component.groups.size()),
        edges_(component.edges.size()) {}

  Standing standing(std::size_t place) const {
    const Index* const row = rows_ + standing_rows * place;
    return {row[0], row[1], row[2], row[3], {row[4], row[5], row[6]}};
  }
  const Index* standing_row(std::size_t place) const { return rows_ + standing_rows * place; }
  bool counts(std::size_t place) const { return (rows_[standing_rows * groups_ + place / 16] >> place % 16 & 1) != 0; }
  Queued queued(std::size_t place) const {
    const Index* const row = rows_ + standing_rows * groups_ + count_rows + why_rows * place;
    return {static_cast<Why>(row[0]), row[1]};
  }
  std::span<const Index> order() const {
    const Index* const row = rows_ + standing_rows * groups_ + count_rows + why_rows * edges_;
    return {row + 1, row[0]};
  }
  const Index* plans() const { return order().data() + groups_; }

private:
  const Index* rows_;
  std::size_t groups_, edges_;
};

inline std::size_t place_of(Index group, std::span<const Index> groups) {
  std::size_t place = 0;
  while (groups[place] != group) ++place;
  return place;
}

} // namespace director
