// Header: compiler/play/expect/line_diff.hpp. Test: tests/compiler/play/expect/line_diff_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/expect/line_diff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace director::compiler {

namespace {

using Lines = std::vector<std::string>;

} // namespace

/// What both begin and end with is equal in any shortest difference.
std::vector<DiffLine> line_diff(const Lines& from, const Lines& to) {
  const std::size_t shorter = std::min(from.size(), to.size());
  std::size_t head = 0, tail = 0;
  while (head < shorter && from[head] == to[head]) ++head;
  while (tail < shorter - head && from[from.size() - 1 - tail] == to[to.size() - 1 - tail]) ++tail;
  const std::size_t rows = from.size() - head - tail, columns = to.size() - head - tail;

  std::vector<DiffLine> out;
  for (std::size_t i = 0; i < head; ++i) out.push_back({' ', from[i]});
  std::size_t i = 0, j = 0;
  if (columns == 0 || rows <= most_diff_cells / columns) {
    // common[i][j]: the length of the longest common subsequence of the rest behind i and j.
    std::vector<std::uint32_t> common((rows + 1) * (columns + 1), 0);
    const auto at = [&](std::size_t row, std::size_t column) -> std::uint32_t& {
      return common[row * (columns + 1) + column];
    };
    for (std::size_t row = rows; row-- > 0;) {
      for (std::size_t column = columns; column-- > 0;) {
        at(row, column) = from[head + row] == to[head + column] ? at(row + 1, column + 1) + 1
                                                                : std::max(at(row + 1, column), at(row, column + 1));
      }
    }
    while (i < rows && j < columns) {
      if (from[head + i] == to[head + j]) {
        out.push_back({' ', from[head + i]});
        ++i, ++j;
      } else if (at(i + 1, j) >= at(i, j + 1)) {
        out.push_back({'-', from[head + i++]});
      } else {
        out.push_back({'+', to[head + j++]});
      }
    }
  }
  for (; i < rows; ++i) out.push_back({'-', from[head + i]});
  for (; j < columns; ++j) out.push_back({'+', to[head + j]});
  for (std::size_t k = from.size() - tail; k < from.size(); ++k) out.push_back({' ', from[k]});
  return out;
}

std::vector<std::string> unified_diff(const Lines& expected, const Lines& happened, std::size_t most_lines) {
  if (expected == happened) return {};
  Lines out{"--- expected", "+++ happened"};
  const Lines all = hunks(line_diff(expected, happened));
  out.insert(out.end(), all.begin(), all.end());
  if (out.size() > most_lines) {
    const std::size_t more = out.size() - most_lines;
    out.resize(most_lines);
    out.push_back(fmt::format("... and {} more lines", more));
  }
  return out;
}

} // namespace director::compiler
