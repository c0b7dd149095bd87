// Door: compiler/cli/commands.hpp. Test: tests/cli/scenario_test.cpp.
#include "compiler/cli/commands.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler::cli {

namespace {

/// The first sentence of a page's first paragraph behind its heading and its level.
std::string summary(std::string_view page) {
  std::string out;
  while (!page.empty()) {
    const std::size_t end = std::min(page.find('\n'), page.size());
    const std::string_view line = page.substr(0, end);
    page.remove_prefix(std::min(end + 1, page.size()));
    if (line.empty() && !out.empty()) break;
    if (line.empty() || line.starts_with('#') || line.starts_with("Level:")) continue;
    if (!out.empty()) out += ' ';
    out += line;
  }
  const std::size_t stop = out.find(". ");
  return stop == std::string::npos ? out : out.substr(0, stop + 1);
}

} // namespace

int run(const ListChecks&, Console& console) {
  std::size_t width = 0;
  for (const checks::Registered& check : checks::registered()) width = std::max(width, check.id.size());
  for (const checks::Registered& check : checks::registered()) {
    console.out << fmt::format("{:<{}}  {:<7}  {}\n", check.id, width, dsl::name_of(checks::level_of(check)),
                               summary(check.page));
  }
  return clean;
}

} // namespace director::compiler::cli
