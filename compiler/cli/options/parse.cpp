// Header: compiler/cli/options/parse.hpp. Test: tests/compiler/cli/options/parse_test.cpp.
// SPDX-License-Identifier: MIT
//
// A row of the table is a subcommand: its name, its line in the help, and a function that adds its options and returns
// how they become a request; those are in the other files of this folder, by kind.
#include "compiler/cli/options/parse.hpp"

#include "compiler/base/version.hpp"
#include "compiler/cli/options/common.hpp"
#include "dsl/lexical/suggest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>

namespace director::compiler::cli {

namespace {

/// A flag with an optional value is printed as `--werror[=ID]`, and a name that may be repeated as `FILE...`.
class Help : public CLI::Formatter {
public:
  std::string make_option_name(const CLI::Option* option, bool positional) const override {
    std::string name = CLI::Formatter::make_option_name(option, positional);
    const std::size_t at = name.find("{*}");
    if (at != std::string::npos) name.replace(at, 3, name == "--allow{*}" ? "=ID" : "[=ID]");
    return name;
  }
  std::string make_option_usage(const CLI::Option* option) const override {
    const std::string name = make_option_name(option, true) + (option->get_expected_max() > 1 ? "..." : "");
    return option->get_required() ? name : "[" + name + "]";
  }
};

struct Subcommand {
  std::string name;
  std::string summary;
  Make (*options)(CLI::App& app);
};

const std::array<Subcommand, 16> subcommands{{
    {"check", "Look for mistakes in a behaviour", check_options},
    {"generate", "Write the C++ of a behaviour", generate_options},
    {"graph", "Draw a behaviour", graph_options},
    {"docs", "Write pages about behaviours, for a browser or as Markdown", docs_options},
    {"diff", "Print what changes in meaning from one behaviour to another", diff_options},
    {"explain", "Print the page of a check, or what a key of the language means", explain_options},
    {"checks", "List all checks", checks_options},
    {"simulate", "Play a scenario and print what happens", simulate_options},
    {"trace", "Print what was recorded, or write it for a browser or for Perfetto", trace_options},
    {"replay", "Play again what was recorded, and print where a behaviour decides otherwise", replay_options},
    {"why", "Print why a group runs, or does not, in a scenario", why_options},
    {"test", "Play scenarios and compare with what they expect", test_options},
    {"explore", "Try everything that can happen, and decide the assertions", explore_options},
    {"stubs", "Write the C++ that is for you to fill in, or add to it what is missing", stubs_options},
    {"verify", "Look for mistakes in the C++ of a behaviour", verify_options},
    {"dump", "Print what a stage of the compiler makes of a behaviour", dump_options},
}};

/// An error for an unknown subcommand, before CLI11 reports a less helpful one.
std::optional<Message> unknown_subcommand(const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().starts_with('-')) return {};
  std::vector<std::string> names;
  for (const Subcommand& subcommand : subcommands) names.push_back(subcommand.name);
  const std::string& word = arguments.front();
  if (std::find(names.begin(), names.end(), word) != names.end()) return {};
  if (word == "help") return Message{"directorc: there is no subcommand `help`; `directorc --help` lists them\n", true};
  const bool plays = word == "play" || word == "run"; // `play` is similar to `replay`, which takes a recording
  const std::optional<std::string> near = plays ? "simulate" : dsl::suggest(word, names);
  return Message{fmt::format("directorc: there is no subcommand `{}`{}\n", word,
                             near ? fmt::format("; did you mean `{}`?", *near)
                                  : fmt::format("; there are {}", fmt::join(names, ", "))),
                 true};
}

/// The words that no option or positional of the subcommand takes: the first unknown option, or else all of them.
std::string unexpected(const CLI::App& subcommand, std::vector<std::string> words) {
  const auto options_end = std::find(words.begin(), words.end(), "--");
  const auto option = std::find_if(words.begin(), options_end, [](const auto& word) { return word.starts_with('-'); });
  if (option == options_end) {
    words.erase(options_end, options_end + (options_end == words.end() ? 0 : 1));
    return fmt::format("unexpected {} `{}`", words.size() == 1 ? "argument" : "arguments", fmt::join(words, "`, `"));
  }
  const std::string name = option->substr(0, option->find('='));
  if (const CLI::App* parent = subcommand.get_parent(); parent && subcommand.get_option_no_throw(name))
    return fmt::format("`{0}` is before the subcommand; write `{1} {2} {0}`", name, parent->get_name(),
                       subcommand.get_name());
  std::vector<std::string> names;
  for (const CLI::Option* each : subcommand.get_options())
    for (const std::string& word : each->get_lnames()) names.push_back("--" + word);
  const std::optional<std::string> near = dsl::suggest(name, names);
  return fmt::format("there is no option `{}`{}", name, near ? fmt::format("; did you mean `{}`?", *near) : "");
}

Message empty_message(const CLI::App& subcommand, const CLI::Option& option) {
  const std::string with = "directorc " + subcommand.get_name();
  return {fmt::format("{}: {} is empty\nTry `{} --help`.\n", with, option.get_name(), with), true};
}

/// An error for `--build=`, as of --build="$BUILD" if BUILD is not set: CLI11 would take the next word as the value.
std::optional<Message> nothing_behind_equals(const std::array<CLI::App*, subcommands.size()>& apps,
                                             const std::vector<std::string>& arguments) {
  const auto subcommand = std::find_if(apps.begin(), apps.end(), [&](const CLI::App* each) {
    return !arguments.empty() && each->get_name() == arguments.front();
  });
  if (subcommand == apps.end()) return {};
  const auto options_end = std::find(arguments.begin(), arguments.end(), "--");
  const auto found = std::find_if(arguments.begin(), options_end, [&](const std::string& word) {
    return word.starts_with("--") && word.find('=') + 1 == word.size();
  });
  if (found == options_end) return {};
  const CLI::App& at = **subcommand;
  const CLI::Option* option = at.get_option_no_throw(found->substr(0, found->size() - 1));
  return option == nullptr ? std::nullopt : std::optional(empty_message(at, *option));
}

/// An error for an empty value, as of "$BUILD" if BUILD is not set.
std::optional<Message> empty_value(const CLI::App& subcommand) {
  for (const CLI::Option* option : subcommand.get_options()) {
    const std::vector<std::string>& values = option->results();
    if (std::find(values.begin(), values.end(), "") == values.end()) continue;
    return empty_message(subcommand, *option);
  }
  return {};
}

/// An error for `--werror ID`: such a flag takes a value only with `=`, and the id was taken for a file.
std::optional<Message> id_without_equals(const std::vector<std::string>& arguments) {
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string &flag = arguments[i - 1], &id = arguments[i];
    const bool takes_id = flag == "--werror" || flag == "--lint" || flag == "--allow";
    if (!takes_id || checks::find_registered(id) == nullptr) continue;
    return Message{fmt::format("directorc: `{}` is taken for a file: write `{}={}`\n", id, flag, id), true};
  }
  return {};
}

constexpr std::string_view exit_status =
    "Exit status: 0 clean; 1 errors were found, a scenario does not hold, the engine does not come to rest, an\n"
    "assertion is refuted, too little is covered, or a recording cannot be read or is decided otherwise; 2 wrong "
    "usage,\n"
    "or a file named on the command line cannot be read or written; 3 an assertion, or a part of a search, is not\n"
    "decided.";

/// The text below the list of subcommands.
std::string last_words(const std::string& schemas) {
  std::string out = fmt::format("{}\n`directorc SUBCOMMAND --help` lists its options.", exit_status);
  if (!schemas.empty())
    out += fmt::format("\n\nAn editor with the YAML language server knows the keys where the first line is\n"
                       "# yaml-language-server: $schema={0}/behaviour.schema.json\n"
                       "or, in a scenario,\n"
                       "# yaml-language-server: $schema={0}/scenario.schema.json\n"
                       "The same folder has the schemas of what `graph` and `diff` print as JSON, and of traces.",
                       schemas);
  return out;
}

} // namespace

Request parse(const std::vector<std::string>& arguments, const std::string& schemas) {
  if (const std::optional<Message> wrong = unknown_subcommand(arguments)) return *wrong;
  CLI::App app{"directorc checks behaviours of robots and writes their C++.", "directorc"};
  app.set_version_flag("--version", fmt::format("directorc {}", version()), "Print the version");
  app.set_help_flag("--help,-h", "Print this help");
  app.require_subcommand(1);
  app.formatter(std::make_shared<Help>());
  app.footer(std::string(exit_status)); // of each subcommand that has no other
  std::array<Make, subcommands.size()> make;
  std::array<CLI::App*, subcommands.size()> apps{};
  for (std::size_t i = 0; i < subcommands.size(); ++i) {
    apps[i] = app.add_subcommand(subcommands[i].name, subcommands[i].summary);
    make[i] = subcommands[i].options(*apps[i]);
  }
  app.footer(last_words(schemas));
  if (const std::optional<Message> wrong = nothing_behind_equals(apps, arguments)) return *wrong;
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend())); // CLI11 expects the last word first
  } catch (const CLI::CallForHelp&) {
    for (const CLI::App* subcommand : apps) {
      if (subcommand->parsed()) return Message{subcommand->help("directorc"), false};
    }
    return Message{app.help(), false};
  } catch (const CLI::CallForVersion&) {
    return Message{fmt::format("directorc {}\n", version()), false};
  } catch (const CLI::ParseError& error) {
    if (const std::optional<Message> wrong = id_without_equals(arguments)) return *wrong;
    const auto parsed =
        std::find_if(apps.begin(), apps.end(), [](const CLI::App* subcommand) { return subcommand->parsed(); });
    const CLI::App& at = parsed == apps.end() ? app : **parsed;
    const std::string with = parsed == apps.end() ? "directorc" : "directorc " + at.get_name();
    const std::vector<std::string> words = app.remaining(true);
    const std::string what = words.empty() ? error.what() : unexpected(at, words);
    return Message{fmt::format("{}: {}\nTry `{} --help`.\n", with, what, with), true};
  }
  for (std::size_t i = 0; i < apps.size(); ++i) {
    if (!apps[i]->parsed()) continue;
    if (const std::optional<Message> wrong = empty_value(*apps[i])) return *wrong;
    return make[i]();
  }
  return Message{app.help(), true};
}

int run(const Message& words, Console& console) {
  if (words.wrong) {
    print_message(console, words.text);
    return misused;
  }
  console.out << words.text;
  return clean;
}

} // namespace director::compiler::cli
