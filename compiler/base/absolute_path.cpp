// Header: compiler/base/absolute_path.hpp. Test: tests/compiler/base/absolute_path_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/absolute_path.hpp"

#include <system_error>

namespace director::compiler {

std::filesystem::path absolute_path(const std::filesystem::path& path) {
  const std::filesystem::path given = path.empty() ? "." : path;
  std::error_code fault;
  std::filesystem::path out = std::filesystem::absolute(given, fault);
  return fault ? given : out;
}

} // namespace director::compiler
