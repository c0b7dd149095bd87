#pragma once
// SPDX-License-Identifier: MIT
// The hunks of a unified diff, as GNU diff writes them.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

inline constexpr std::size_t diff_context = 3; ///< equal lines shown around a difference

struct DiffLine {
  char sign; ///< ' ', '-' or '+'
  std::string_view line;
};

/// The lines of all hunks, each hunk behind its `@@`: what differs between both files, and the lines close to that.
/// `all`: the lines of both files in order.
std::vector<std::string> hunks(const std::vector<DiffLine>& all);

} // namespace director::compiler
