#pragma once
// SPDX-License-Identifier: MIT
// Sorting in place, without memory, library or recursion. Nearly sorted rows, which most are here, cost little more
// than one comparison a row: it is an insertion sort that changes to a heap sort after many moves.

#include "runtime/core/base/tables.hpp"

#include <utility>

namespace director {

/// `goes_first(a, b)`: a strict order of rows.
template <class GoesFirst>
void heap_sort(std::span<Index> rows, GoesFirst&& goes_first) {
  std::size_t moves = 0;
  for (std::size_t i = 1; i < rows.size() && moves <= 4 * rows.size(); ++i) {
    const Index row = rows[i];
    std::size_t at = i;
    for (; at > 0 && goes_first(row, rows[at - 1]); --at) rows[at] = rows[at - 1];
    rows[at] = row;
    moves += i - at;
  }
  if (moves <= 4 * rows.size()) return;
  const auto sink = [&](std::size_t at, std::size_t end) {
    for (std::size_t child = 2 * at + 1; child < end; child = 2 * at + 1) {
      if (child + 1 < end && goes_first(rows[child], rows[child + 1])) ++child;
      if (!goes_first(rows[at], rows[child])) return;
      std::swap(rows[at], rows[child]);
      at = child;
    }
  };
  for (std::size_t i = rows.size() / 2; i-- > 0;) sink(i, rows.size());
  for (std::size_t end = rows.size(); end-- > 1;) {
    std::swap(rows[0], rows[end]);
    sink(0, end);
  }
}

} // namespace director
