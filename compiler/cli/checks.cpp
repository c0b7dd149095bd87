// Door: compiler/cli/commands.hpp. Test: tests/compiler/cli/scenario_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/commands.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler::cli {

int run(const ListChecks&, Console& console) {
  std::size_t width = 0;
  for (const checks::Registered& check : checks::registered()) width = std::max(width, check.id.size());
  for (const checks::Registered& check : checks::registered()) {
    console.out << fmt::format("{:<{}}  {:<7}  {:<25}  {}\n", check.id, width, dsl::name_of(checks::level_of(check)),
                               checks::certainty_of(check), checks::summary_of(check));
  }
  return clean;
}

} // namespace director::compiler::cli
