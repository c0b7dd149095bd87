// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/cli/commands/explore_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/absolute_path.hpp"
#include "compiler/cli/input/load.hpp"
#include "compiler/cli/input/named_file.hpp"
#include "compiler/cli/system/earlier_outputs.hpp"
#include "compiler/cli/system/progress.hpp"
#include "compiler/emit/artefact/notice.hpp"
#include "compiler/explore/report.hpp"
#include "dsl/source/harmless.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace director::compiler::cli {

namespace {

namespace fs = std::filesystem;

/// The path with the links on it followed, as far as it exists: the system follows them before `..`.
fs::path without_links(const std::string& path) {
  std::error_code failed;
  fs::path out = fs::weakly_canonical(absolute_path(path), failed);
  return failed ? absolute_path(path).lexically_normal() : out;
}

/// The relative path from the scenarios' folder to the behaviour. Links to the file itself are kept: what it imports is
/// beside the link.
std::string path_from(const std::string& folder, const std::string& file) {
  const fs::path from = without_links(folder);
  const fs::path named = absolute_path(file);
  const fs::path to = without_links(named.parent_path().string()) / named.filename();
  const fs::path relative = to.lexically_relative(from);
  return relative.empty() ? to.string() : relative.string();
}

/// False, and prints why, if they cannot be written.
bool write_scenarios(const Explore& request, const std::vector<std::pair<std::string, std::string>>& scenarios,
                     Console& console) {
  const std::string behaviour = fs::path(request.file).filename().string();
  std::vector<Output> outputs;
  for (const auto& [name, text] : scenarios)
    outputs.push_back({(fs::path(request.output) / name).string(), with_notice(behaviour, "# ", text), is_document});
  if (!write(outputs, console, "no scenario is written; ")) return false;
  for (const Output& output : outputs) console.out << fmt::format("wrote {}\n", dsl::harmless(output.path));
  const std::string from = fmt::format(" from {}. DO NOT EDIT.\n", behaviour); // others may have the same folder
  print_earlier_outputs(
      request.output, outputs,
      [&](std::string_view name, std::string_view text) {
        return is_called_scenario(name) && text.substr(0, text.find('\n') + 1).ends_with(from);
      },
      "scenario", console);
  return true;
}

bool any(const Exploration& exploration, Verdict::Kind kind) {
  return std::any_of(exploration.verdicts.begin(), exploration.verdicts.end(),
                     [&](const Verdict& verdict) { return verdict.kind == kind; });
}

/// In a cycle that does not depend on how long it takes to keep a promise.
bool never_rests(const Exploration& exploration) {
  return std::any_of(exploration.oscillations.begin(), exploration.oscillations.end(),
                     [](const Oscillation& each) { return !each.keeps_promises; });
}

} // namespace

int run(const Explore& request, Console& console) {
  dsl::Sources sources;
  const std::optional<Checked> checked = load(request.file, only_errors(), sources, console, request.cpp);
  if (!checked) return misused;
  if (!checked->lowerable) {
    print_findings(checked->findings, sources, console.err, console.err_colours, console.err_width);
    if (dsl::has_errors(checked->findings)) return found;
    print_message(console,
                  fmt::format("directorc: `{}` has no `roots`: it is a module for others to import, and nothing can "
                              "be explored in it alone\n",
                              shown_path(request.file)));
    return misused;
  }
  const Ground ground(checked->model);
  ExploreOptions options;
  options.bound = request.bound;
  options.behaviour = path_from(request.output, request.file);
  const Exploration exploration = [&] {
    Progress progress(console, request.bound);
    options.progress = progress.shown();
    return explore(ground, options);
  }();
  console.out << dsl::harmless_lines(to_text(exploration, ground));
  if (!request.output.empty() && !write_scenarios(request, scenarios_of(exploration, ground), console)) return misused;
  if (any(exploration, Verdict::Kind::refuted) || never_rests(exploration)) return found;
  return any(exploration, Verdict::Kind::undecided) || !tried_all(ground, exploration.searched) ? undecided : clean;
}

} // namespace director::compiler::cli
