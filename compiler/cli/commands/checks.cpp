// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/cli/commands/scenario_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/options/commands.hpp"
#include "compiler/cli/system/page_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler::cli {

namespace {

/// Columns for a sentence beside the other words; with fewer it is below them.
constexpr std::size_t least_beside = 40;

} // namespace

int run(const ListChecks&, Console& console) {
  std::size_t width = 0;
  for (const checks::Registered& check : checks::registered()) width = std::max(width, check.id.size());
  for (const checks::Registered& check : checks::registered()) {
    const std::string head = fmt::format("{:<{}}  {:<7}  {:<25}", check.id, width,
                                         dsl::name_of(checks::level_of(check)), checks::certainty_of(check));
    const std::string summary = checks::summary_of(check);
    if (console.out_width == 0) {
      console.out << head << "  " << summary << "\n";
    } else if (console.out_width < head.size() + least_beside) {
      const std::string words = head.substr(0, head.find_last_not_of(' ') + 1);
      console.out << (words.size() <= console.out_width ? words : in_lines(words, console.out_width, 0, 4)) << "\n    "
                  << in_lines(summary, console.out_width, 4, 4) << "\n";
    } else {
      const std::size_t column = head.size() + 2;
      console.out << head << "  " << in_lines(summary, console.out_width, column, column) << "\n";
    }
  }
  return clean;
}

} // namespace director::compiler::cli
