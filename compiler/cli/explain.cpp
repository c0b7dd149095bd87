// Door: compiler/cli/commands.hpp. Test: tests/cli/scenario_test.cpp.
#include "compiler/cli/commands.hpp"
#include "dsl/suggest.hpp"

#include <fmt/format.h>

namespace director::compiler::cli {

int run(const Explain& request, Console& console) {
  if (const checks::Registered* check = checks::find_registered(request.id)) {
    console.out << check->page;
    return clean;
  }
  std::vector<std::string> known;
  for (const checks::Registered& check : checks::registered()) known.emplace_back(check.id);
  const std::optional<std::string> near = dsl::suggest(request.id, known);
  console.err << fmt::format("directorc: there is no check `{}`{}\n", request.id,
                             near ? fmt::format("; did you mean `{}`?", *near)
                                  : std::string("; `directorc checks` lists all"));
  return misused;
}

} // namespace director::compiler::cli
