#pragma once
// SPDX-License-Identifier: MIT
// What several subcommands do first: check the behaviour that the command line names, and print the findings.

#include "compiler/cli/options/commands.hpp"
#include "compiler/pipeline.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler::cli {

/// A path in messages: relative for one inside the working directory, otherwise as it was written.
std::string shown_path(const std::string& path);

/// Sets `options.types`, which reads C++ as `cpp` says, only if types are needed. Empty, and prints why, if the file
/// itself or what `cpp` names cannot be read.
std::optional<Checked> load(const std::string& file, const CheckOptions& options, dsl::Sources& sources,
                            Console& console, const CppSource& cpp);

/// The same without printing anything: sets `fault` if what `cpp` names cannot be read.
Checked check_file(const std::string& path, CheckOptions options, dsl::Sources& sources, Console& console,
                   const CppSource& cpp, std::string& fault);

/// Prints to the stream; nothing if there is no finding. `width`: of its terminal, for source excerpts; 0: none.
void print_findings(const std::vector<dsl::Diagnostic>& findings, const dsl::Sources& sources, std::ostream& out,
                    bool colours, std::size_t width = 0);

/// Prints what was not decided, a line each, on the error stream. False if there is nothing.
bool print_undecided(const std::vector<std::string>& lines, Console& console);

/// Prints on the error stream why the types of C++ were not checked, where `-p` asked for that and no finding says it.
void print_unchecked_types(const Checked& checked, const CppSource& cpp, Console& console);

/// Only the errors among them.
std::vector<dsl::Diagnostic> errors_of(const std::vector<dsl::Diagnostic>& findings);

} // namespace director::compiler::cli
