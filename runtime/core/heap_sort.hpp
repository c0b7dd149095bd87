#pragma once
// Sorting in place without memory, library or recursion. What comes sorted, as most does here, costs one comparison a
// row.

#include "runtime/core/tables.hpp"

namespace director {

/// `goes_first(a, b)`: a strict order of rows.
template <class GoesFirst>
void heap_sort(std::span<Index> rows, GoesFirst&& goes_first) {
  bool sorted = true;
  for (std::size_t i = 1; i < rows.size() && sorted; ++i) sorted = !goes_first(rows[i], rows[i - 1]);
  if (sorted) return;
  const auto swap = [&](std::size_t a, std::size_t b) {
    const Index moved = rows[a];
    rows[a] = rows[b];
    rows[b] = moved;
  };
  const auto sink = [&](std::size_t at, std::size_t end) {
    for (std::size_t child = 2 * at + 1; child < end; child = 2 * at + 1) {
      if (child + 1 < end && goes_first(rows[child], rows[child + 1])) ++child;
      if (!goes_first(rows[at], rows[child])) return;
      swap(at, child);
      at = child;
    }
  };
  for (std::size_t i = rows.size() / 2; i-- > 0;) sink(i, rows.size());
  for (std::size_t end = rows.size(); end-- > 1;) {
    swap(0, end);
    sink(0, end);
  }
}

} // namespace director
