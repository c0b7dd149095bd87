// Door: compiler/cli/summary.hpp. Test: tests/cli/scenario_test.cpp.
#include "compiler/cli/summary.hpp"

#include <algorithm>

namespace director::compiler::cli {

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

} // namespace director::compiler::cli
