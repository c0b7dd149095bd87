#pragma once
// SPDX-License-Identifier: MIT
// The options of the subcommands: each function adds those of one, and says how they become a request. Only these files
// and parse.cpp know CLI11.

#include "compiler/cli/parse.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>

namespace director::compiler::cli {

using Make = std::function<Request()>;

// options_checking.cpp
Make check_options(CLI::App& app);
Make verify_options(CLI::App& app);
Make explain_options(CLI::App& app);
Make checks_options(CLI::App& app);
Make dump_options(CLI::App& app);
// options_diff.cpp
Make diff_options(CLI::App& app);
// options_code.cpp
Make generate_options(CLI::App& app);
Make stubs_options(CLI::App& app);
// options_pictures.cpp
Make graph_options(CLI::App& app);
Make docs_options(CLI::App& app);
// options_playing.cpp
Make simulate_options(CLI::App& app);
Make trace_options(CLI::App& app);
Make replay_options(CLI::App& app);
Make why_options(CLI::App& app);
Make test_options(CLI::App& app);
Make explore_options(CLI::App& app);

/// `--format` with some of the formats.
CLI::Option* add_format(CLI::App& app, Format& format, const std::vector<std::string>& names);

/// The endings of file names that say which format is meant where none is named, and the format's name.
using Endings = std::vector<std::pair<std::string, std::string>>;
/// Empty: the file's name says nothing, or there is none.
std::string format_by_ending(const std::string& file, const Endings& endings);
Format format_called(const std::string& name);

struct SelectionWords {
  std::vector<std::string> werror, lint, allow;
};

/// `--werror` is for all, `--werror=<id>` for one: flags that may carry a value, so that none of them takes the next
/// word.
void add_selection(CLI::App& app, SelectionWords& words);
checks::Selection selection_of(const SelectionWords& words);
/// The first id that no check has, with what was probably meant.
std::optional<Message> unknown_id(const SelectionWords& words);

void add_build(CLI::App& app, std::string& build);
CLI::Option* add_bound(CLI::App& app, std::size_t& bound);

CLI::Option* add_watch(CLI::App& app, bool& watch);
/// What programs read is one document, and no run after another.
std::optional<Message> wrong_watch(bool watch, Format format);

/// `-`: where one file is written, that is the standard output.
inline constexpr const char* standard_output = "-";
/// What is wrong with the name of something that is written beside what is printed, if something is. `what`: "a
/// folder", "a file".
std::optional<Message> wrong_place(const std::string& option, const std::string& what, const std::string& place);

/// `--link`, and what is wrong with it, if something is.
void add_link(CLI::App& app, std::string& link);
std::optional<Message> wrong_link(const std::string& link);

/// What is wrong with it, if something is.
std::optional<Message> parse_time(const std::string& text, std::optional<std::int64_t>& time);

} // namespace director::compiler::cli
