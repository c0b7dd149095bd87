// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/cli/commands/diff_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/absolute_path.hpp"
#include "compiler/base/for_shell.hpp"
#include "compiler/cli/input/load.hpp"
#include "compiler/cli/system/git_files.hpp"
#include "dsl/source/harmless.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace director::compiler::cli {

namespace {

std::optional<Checked> load_from(dsl::FileAccess& files, const std::string& file, const Diff& request,
                                 dsl::Sources& sources, Console& console) {
  Console other = with_files(console, files, console.outputs);
  return load(file, {}, sources, other, request.cpp);
}

/// `lost`: gets the file because of which the old behaviour is not known from git.
std::optional<Checked> load_before(const Diff& request, dsl::Sources& sources, Console& console, LostFile& lost) {
  if (request.revision.empty()) {
    FilesBeside files(console.files, shown_path(request.before), shown_path(request.after));
    return load_from(files, request.before, request, sources, console);
  }
  GitFiles files(console.programs, console.files, request.revision);
  if (const std::optional<std::string> wrong =
          files.open(request.after, request.staged ? Newer::staged : Newer::lying_there)) {
    print_message(console, fmt::format("directorc: {}\n", *wrong));
    return {};
  }
  Diff there = request;
  for (std::string* path : {&there.cpp.build, &there.cpp.flags}) {
    if (!path->empty()) *path = absolute_path(*path).string(); // it is no part of a revision
  }
  std::optional<Checked> out = load_from(files, files.path(), there, sources, console);
  lost = files.lost();
  if (!out)
    print_message(
        console, fmt::format("  help: where it was called otherwise, `git add {}` lets git see that; any two files are "
                             "compared with `directorc diff OLD NEW`\n",
                             for_shell(shown_path(request.after))));
  return out;
}

std::optional<Checked> load_after(const Diff& request, dsl::Sources& sources, Console& console, LostFile& lost) {
  if (!request.staged) return load(request.after, {}, sources, console, request.cpp);
  StagedFiles files(console.programs, console.files);
  if (const std::optional<std::string> wrong = files.open(request.after)) {
    print_message(console, fmt::format("directorc: {}\n", *wrong));
    return {};
  }
  std::optional<Checked> out = load_from(files, request.after, request, sources, console);
  lost = files.lost();
  return out;
}

/// git's difftool names no file for a new or deleted one. The text for that; empty: there are two files.
std::string only_side(const Diff& request) {
  const std::string nothing = "/dev/null";
  if (request.before == nothing) return fmt::format("`{}` is new: there is nothing to compare\n", request.after);
  if (request.after == nothing) return fmt::format("`{}` is gone: there is nothing to compare\n", request.before);
  return {};
}

/// Whether the second half of the files has the texts of the first one.
bool have_same_text(const dsl::Sources& sources, std::size_t first_half) {
  const auto middle = sources.begin() + static_cast<std::ptrdiff_t>(first_half);
  return std::equal(
      sources.begin(), middle, middle, sources.end(),
      [](const dsl::SourceFile& before, const dsl::SourceFile& after) { return before.text() == after.text(); });
}

void print(const std::vector<BehaviourChange>& changes, bool compared, const Diff& request, const dsl::Sources& sources,
           Console& console) {
  switch (request.format) {
  case Format::json: console.out << to_lines(changes_json(changes, compared, request.breaking, sources)); return;
  case Format::sarif: console.out << to_lines(changes_sarif(changes, request.breaking, sources)); return;
  default: console.out << dsl::harmless_lines(changes_text(changes, request.breaking, sources)); return;
  }
}

} // namespace

int run(const Diff& request, Console& console) {
  dsl::Sources sources;
  if (const std::string text = only_side(request); !text.empty()) {
    if (request.format == Format::text)
      console.out << dsl::harmless_lines(text);
    else
      print({}, false, request, sources, console);
    return clean;
  }
  LostFile lost_before, lost_after;
  const std::optional<Checked> before = load_before(request, sources, console, lost_before);
  if (!before) return misused;
  const std::size_t of_before = sources.size();
  const std::optional<Checked> after = load_after(request, sources, console, lost_after);
  if (!after) return misused;
  // What has errors only because a file cannot be read here is neither accepted nor refused.
  const LostFile& lost = before->resolved ? lost_after : lost_before;
  if (before->resolved != after->resolved && !lost.empty()) {
    print_message(console, fmt::format("directorc: cannot read `{}`: {}\n", lost.path, lost.why));
    return misused;
  }
  const bool are_broken = !before->resolved && !after->resolved;
  // A hook has nothing to say of what a commit does not touch.
  if (are_broken && !(request.staged && have_same_text(sources, of_before))) {
    console.err << "directorc: neither of the two can be compared: both have errors in their text or their names\n";
    for (const Checked* side : {&*before, &*after})
      print_findings(errors_of(side->findings), sources, console.err, console.err_colours, console.err_width);
  }
  TransitionsPlayed transitions;
  const std::vector<BehaviourChange> changes = find_changes(*before, *after, &transitions);
  print(changes, before->resolved && after->resolved, request, sources, console);
  if (transitions.played < transitions.wanted)
    print_message(console,
                  fmt::format("directorc: not compared: {} of {} transitions between groups that may have changed; "
                              "the behaviour is too large to play them all\n",
                              transitions.wanted - transitions.played, transitions.wanted));
  const bool breaks = std::any_of(changes.begin(), changes.end(), [&](const BehaviourChange& change) {
    return request.breaking.has(change) || change.kind == ChangeKind::refused;
  });
  return breaks ? found : clean;
}

} // namespace director::compiler::cli
