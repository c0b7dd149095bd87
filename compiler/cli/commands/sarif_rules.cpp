// Header: compiler/cli/commands/sarif_rules.hpp. Test: tests/compiler/cli/commands/check_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/commands/sarif_rules.hpp"

#include "compiler/checks/check.hpp"

namespace director::compiler::cli {

std::vector<SarifRule> sarif_rules() {
  std::vector<SarifRule> out;
  for (const checks::Registered& check : checks::registered())
    out.push_back({std::string(check.id), checks::level_of(check), checks::summary_of(check), std::string(check.page)});
  return out;
}

} // namespace director::compiler::cli
