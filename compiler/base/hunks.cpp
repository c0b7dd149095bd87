// Header: compiler/base/hunks.hpp. Test: tests/compiler/base/hunks_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/hunks.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

namespace {

/// Of each line, whether it is shown: it differs, or is close to one that does.
std::vector<bool> shown(const std::vector<DiffLine>& all) {
  std::vector<bool> out(all.size(), false);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].sign == ' ') continue;
    const std::size_t end = std::min(all.size(), i + diff_context + 1);
    for (std::size_t k = i - std::min(i, diff_context); k < end; ++k) out[k] = true;
  }
  return out;
}

/// `4,7`: from line 4 on, 7 lines; without lines, the one before them.
std::string extent(std::size_t before, std::size_t count) {
  const std::size_t first = count == 0 ? before : before + 1;
  return count == 1 ? std::to_string(first) : fmt::format("{},{}", first, count);
}

} // namespace

std::vector<std::string> hunks(const std::vector<DiffLine>& all) {
  const std::vector<bool> visible = shown(all);
  std::vector<std::string> out;
  std::size_t before_old = 0, before_new = 0;
  for (std::size_t i = 0; i < all.size();) {
    if (!visible[i]) {
      ++i, ++before_old, ++before_new; // only equal lines are left out
      continue;
    }
    const std::size_t head = out.size();
    std::size_t removed = 0, added = 0;
    out.emplace_back();
    for (; i < all.size() && visible[i]; ++i) {
      out.push_back(all[i].sign + std::string(all[i].line));
      if (all[i].sign != '+') ++removed;
      if (all[i].sign != '-') ++added;
    }
    out[head] = fmt::format("@@ -{} +{} @@", extent(before_old, removed), extent(before_new, added));
    before_old += removed;
    before_new += added;
  }
  return out;
}

} // namespace director::compiler
