#pragma once
// SPDX-License-Identifier: MIT
// The difference of two lists of lines, as a unified diff: everything outside of their longest common subsequence. By
// the simple quadratic table, because a step has few lines.

#include "compiler/base/hunks.hpp"

namespace director::compiler {

inline constexpr std::size_t most_diff_cells =
    4'000'000; ///< of the table; above it everything between the equal ends differs

/// The lines of both lists in order, each with its sign.
std::vector<DiffLine> line_diff(const std::vector<std::string>& from, const std::vector<std::string>& to);

/// "--- expected", "+++ happened", then hunks; empty if they are equal. At most `most_lines` of them, and then the
/// number of the rest.
std::vector<std::string> unified_diff(const std::vector<std::string>& expected,
                                      const std::vector<std::string>& happened, std::size_t most_lines = 200);

} // namespace director::compiler
