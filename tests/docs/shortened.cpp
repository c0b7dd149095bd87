// Header: tests/docs/shortened.hpp. Test: tests/docs/shortened_test.cpp.
// SPDX-License-Identifier: MIT
// The cheapest alignment of two texts, as in diff, but a line `…` matches any lines without cost.
#include "tests/docs/shortened.hpp"

#include <algorithm>

namespace director::tests {

namespace {

bool is_ellipsis(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first != std::string::npos && line.substr(first) == "…";
}

/// 0: the same line; 2: another one, which costs as much as removing the one and adding the other.
double change(const std::string& from, const std::string& to) {
  if (from == to) return 0;
  const auto head = std::ranges::mismatch(from, to).in1 - from.begin();
  const std::size_t most = std::min(from.size(), to.size()) - static_cast<std::size_t>(head);
  std::size_t tail = 0;
  while (tail < most && from[from.size() - 1 - tail] == to[to.size() - 1 - tail]) ++tail;
  const double longest = static_cast<double>(std::max(from.size(), to.size()));
  return 2 * (1 - (static_cast<double>(head) + static_cast<double>(tail)) / longest);
}

enum class Move { none, both, drop, take };

struct Cell {
  double cost = 0;
  Move move = Move::none;
};

} // namespace

Lines shortened(const Lines& whole, const Lines& shown) {
  const std::size_t rows = shown.size(), columns = whole.size();
  std::vector<std::vector<Cell>> cells(rows + 1, std::vector<Cell>(columns + 1));
  for (std::size_t i = rows + 1; i-- > 0;) {
    for (std::size_t j = columns + 1; j-- > 0;) {
      if (i == rows && j == columns) continue;
      const bool ellipsis = i < rows && is_ellipsis(shown[i]);
      Cell best{1e9, Move::none};
      const auto offer = [&best](double cost, Move move) {
        if (cost < best.cost) best = {cost, move};
      };
      if (i < rows && j < columns && !ellipsis)
        offer(change(shown[i], whole[j]) + cells[i + 1][j + 1].cost, Move::both);
      if (i < rows) offer((ellipsis ? 0 : 1) + cells[i + 1][j].cost, Move::drop);
      if (j < columns) offer((ellipsis ? 0 : 1) + cells[i][j + 1].cost, Move::take);
      cells[i][j] = best;
    }
  }
  Lines lines;
  for (std::size_t i = 0, j = 0; i < rows || j < columns;) {
    const bool ellipsis = i < rows && is_ellipsis(shown[i]);
    const Move move = cells[i][j].move;
    if (ellipsis && move == Move::drop) lines.push_back(shown[i]);
    if (!ellipsis && move != Move::drop) lines.push_back(whole[j]);
    if (move != Move::take) ++i;
    if (move != Move::drop) ++j;
  }
  return lines;
}

} // namespace director::tests
