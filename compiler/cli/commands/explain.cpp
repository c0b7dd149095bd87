// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/cli/commands/scenario_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/options/commands.hpp"
#include "compiler/cli/system/page_text.hpp"
#include "compiler/reference/explain_key.hpp"
#include "dsl/lexical/suggest.hpp"
#include "dsl/reading/slips.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace director::compiler::cli {

namespace {

std::string shown(std::string_view page, const Console& console) {
  if (console.out_width == 0) return std::string(page);
  return page_text(page, console.out_width, console.out_colours);
}

/// The right key, if it is a key of other tools.
const std::string* help_for_slip(std::string_view key) {
  using namespace dsl;
  for (const Slips* slips : {&slips_of_group(), &slips_of_state(), &slips_of_task(), &slips_of_file(), &slips_of_cpp(),
                             &slips_of_step(), &slips_of_scenario_file()})
    if (const std::string* help = help_for(*slips, key)) return help;
  return nullptr;
}

} // namespace

int run(const Explain& request, Console& console) {
  if (const checks::Registered* check = checks::find_registered(request.id)) {
    console.out << shown(page_without_links(check->page), console);
    return clean;
  }
  const std::string page = reference();
  if (const std::optional<std::string> text = explain_key(page, request.id)) {
    console.out << shown(*text, console);
    return clean;
  }
  if (const std::string* help = help_for_slip(request.id)) {
    print_message(console, fmt::format("directorc: there is no check and no key `{}`: {}\n", request.id, *help));
    return misused;
  }
  std::vector<std::string> known = keys_of(page);
  for (const checks::Registered& check : checks::registered()) known.emplace_back(check.id);
  const std::optional<std::string> near = dsl::suggest(request.id, known);
  print_message(console, fmt::format("directorc: there is no check and no key `{}`{}\n", request.id,
                                     near ? fmt::format("; did you mean `{}`?", *near)
                                          : fmt::format("; `directorc checks` lists all checks; the keys are {}",
                                                        fmt::join(keys_of(page), ", "))));
  return misused;
}

} // namespace director::compiler::cli
