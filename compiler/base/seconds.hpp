#pragma once
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace director::compiler {

/// "1.500000".
inline std::string in_seconds(std::int64_t microseconds) {
  return fmt::format("{:.6f}", static_cast<double>(microseconds) / 1e6);
}

} // namespace director::compiler
