// Header: compiler/checks/check.hpp. Test: tests/compiler/checks/run_checks_test.cpp.
// SPDX-License-Identifier: MIT
// The head of a check's page: the lines between its title and its first paragraph.
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace director::checks {

namespace {

/// The rest of the line of the page with this beginning.
std::string_view header_of(const Registered& check, std::string_view label) {
  const std::string_view head = check.page.substr(0, check.page.find("\n\n"));
  const std::size_t at = head.find(label);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = head.substr(at + label.size());
  return rest.substr(0, rest.find('\n'));
}

} // namespace

dsl::Level level_of(const Registered& check) {
  const std::string_view text = header_of(check, "\nLevel: ");
  for (const dsl::Level level : {dsl::Level::error, dsl::Level::warning, dsl::Level::lint}) {
    if (text == dsl::name_of(level)) return level;
  }
  throw std::logic_error(fmt::format("{}.md says no level", check.id));
}

std::string_view certainty_of(const Registered& check) {
  const std::string_view text = header_of(check, "\nCertainty: ");
  for (const std::string_view known : {"exact", "may miss", "may over-report", "may miss, may over-report"}) {
    if (text == known) return text;
  }
  throw std::logic_error(fmt::format("{}.md does not say how certain it is", check.id));
}

bool may_over_report(const Registered& check) { return certainty_of(check).ends_with("may over-report"); }

std::string summary_of(const Registered& check) {
  // The first paragraph after the title and the lines of the head.
  const std::size_t begin = check.page.find("\n\n");
  const std::string_view rest = begin == std::string_view::npos ? "" : check.page.substr(begin + 2);
  std::string out(rest.substr(0, rest.find("\n\n")));
  std::replace(out.begin(), out.end(), '\n', ' ');
  const std::size_t stop = out.find(". ");
  return stop == std::string::npos ? out : out.substr(0, stop + 1);
}

Consequence consequence_of(const Registered& check) {
  static constexpr std::pair<std::string_view, Consequence> known[] = {
      {"", Consequence::none},
      {"a provider stands in", Consequence::stand_in},
      {"nothing runs", Consequence::nothing_runs},
      {"nothing is explored", Consequence::nothing_is_explored}};
  const std::string_view text = header_of(check, "\nConsequence: ");
  for (const auto& [words, consequence] : known) {
    if (text == words) return consequence;
  }
  throw std::logic_error(fmt::format("{}.md names an unknown consequence", check.id));
}

bool reports_never(const Registered& check) { return header_of(check, "\nSays: ") == "never"; }

} // namespace director::checks
