#pragma once
// SPDX-License-Identifier: MIT
// The options of the subcommands: each function adds those of one, and returns how they become a request. Only these
// files and parse.cpp use CLI11.

#include "compiler/cli/options/parse.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>

namespace director::compiler::cli {

using Make = std::function<Request()>;

// checking.cpp
Make check_options(CLI::App& app);
Make verify_options(CLI::App& app);
Make explain_options(CLI::App& app);
Make checks_options(CLI::App& app);
Make dump_options(CLI::App& app);
// diff.cpp
Make diff_options(CLI::App& app);
// code.cpp
Make generate_options(CLI::App& app);
Make stubs_options(CLI::App& app);
// pictures.cpp
Make graph_options(CLI::App& app);
Make docs_options(CLI::App& app);
// playing.cpp
Make simulate_options(CLI::App& app);
Make trace_options(CLI::App& app);
Make replay_options(CLI::App& app);
Make why_options(CLI::App& app);
Make test_options(CLI::App& app);
Make explore_options(CLI::App& app);

/// `--format` with some of the formats.
CLI::Option* add_format(CLI::App& app, Format& format, const std::vector<std::string>& names);

/// The endings of file names that select a format, in lower case, and its name.
using Endings = std::vector<std::pair<std::string, std::string>>;
/// Empty: the file has no such ending, or there is no file.
std::string format_by_ending(const std::string& file, const Endings& endings);
Format format_called(const std::string& name);

struct SelectionWords {
  std::vector<std::string> werror, lint, allow;
};

/// `--werror` is for all, `--werror=<id>` for one: flags with an optional value, so that none of them takes the next
/// argument.
void add_selection(CLI::App& app, SelectionWords& words);
checks::Selection selection_of(const SelectionWords& words);
/// An error for the first unknown id, with a suggestion.
std::optional<Message> unknown_id(const SelectionWords& words);

void add_cpp(CLI::App& app, CppSource& cpp);
/// `without`: what it says of no such option.
void add_bound(CLI::App& app, std::size_t& bound, const std::string& without);
inline constexpr const char* bound_of_assertions = "100000; only for the assertions";

CLI::Option* add_watch(CLI::App& app, bool& watch);
/// Formats for programs are one document, not one after each run.
std::optional<Message> wrong_watch(bool watch, Format format);

/// `-` instead of a file that is written: the standard output.
inline constexpr const char* standard_output = "-";
/// An error, if the name of an output beside the printed one is wrong. `what`: "a folder", "a file".
std::optional<Message> wrong_place(const std::string& option, const std::string& what, const std::string& place);

/// Adds `--link`; the other function returns an error, if it is wrong.
void add_link(CLI::App& app, std::string& link);
std::optional<Message> wrong_link(const std::string& link);

/// Returns an error, if it is wrong.
std::optional<Message> parse_time(const std::string& text, std::optional<std::int64_t>& time);

} // namespace director::compiler::cli
