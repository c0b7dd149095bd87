// Header: dsl/source/diagnostic.hpp. Test: tests/dsl/source/diagnostic_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/source/diagnostic.hpp"

#include <algorithm>
#include <tuple>

namespace director::dsl {

std::string_view name_of(Level level) {
  switch (level) {
  case Level::error: return "error";
  case Level::warning: return "warning";
  case Level::lint: return "lint";
  }
  return "";
}

void sort_by_place(std::vector<Diagnostic>& diagnostics) {
  const auto key = [](const Diagnostic& d) { return std::tie(d.span, d.id, d.message); };
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return key(a) < key(b); });
  diagnostics.erase(std::unique(diagnostics.begin(), diagnostics.end()), diagnostics.end());
}

bool has_errors(const std::vector<Diagnostic>& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.level == Level::error; });
}

} // namespace director::dsl
