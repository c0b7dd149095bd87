#pragma once
// SPDX-License-Identifier: MIT
// What several subcommands do first: check the behaviour that the command line names, and show what was found.

#include "compiler/cli/commands.hpp"
#include "compiler/pipeline.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler::cli {

/// A path as it is shown to people: one inside the working directory from there, any other as it was written.
std::string shown_path(const std::string& path);

/// `options.types` is filled in: with the flags of `build`, or of `flags` (a file with a word of the compiler's command
/// line in each line), else with those of a compile_commands.json beside the behaviour or above it, where they are
/// needed at all.
struct CppSource {
  std::string build, flags;
};

/// Says so and gives nothing where the file itself cannot be read, or `cpp`.
std::optional<Checked> load(const std::string& file, const CheckOptions& options, dsl::Sources& sources,
                            Console& console, const CppSource& cpp = {});

/// The same without a word about a file that cannot be read.
Checked check_file(const std::string& path, CheckOptions options, dsl::Sources& sources, Console& console);

/// To the stream, or nothing where there is no finding. `width`: of its terminal, for the source that is shown; 0:
/// none.
void print_findings(const std::vector<dsl::Diagnostic>& findings, const dsl::Sources& sources, std::ostream& out,
                    bool colours, std::size_t width = 0);

/// What was not decided, a line each, on the error stream. False if there is nothing.
bool print_undecided(const std::vector<std::string>& lines, Console& console);

/// Only the errors among them.
std::vector<dsl::Diagnostic> errors_of(const std::vector<dsl::Diagnostic>& findings);

} // namespace director::compiler::cli
