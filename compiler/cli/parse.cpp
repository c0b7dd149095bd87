// Door: compiler/cli/parse.hpp. Test: tests/compiler/cli/parse_test.cpp.
// SPDX-License-Identifier: MIT
//
// The only place with CLI11. A row of the table is a subcommand: its name, its line in the help, and a function that
// adds its options and says how they become a request.
#include "compiler/cli/parse.hpp"

#include "compiler/base/version.hpp"
#include "dsl/duration.hpp"
#include "dsl/suggest.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <functional>
#include <memory>

namespace director::compiler::cli {

namespace {

using Make = std::function<Request()>;

/// A flag that may carry a value is written `--werror[=ID]`.
class Help : public CLI::Formatter {
public:
  std::string make_option_name(const CLI::Option* option, bool positional) const override {
    std::string name = CLI::Formatter::make_option_name(option, positional);
    const std::size_t at = name.find("{*}");
    if (at != std::string::npos) name.replace(at, 3, name == "--allow{*}" ? "=ID" : "[=ID]");
    return name;
  }
};

struct Subcommand {
  std::string name;
  std::string summary;
  Make (*options)(CLI::App& app);
};

const std::map<std::string, Format> formats{
    {"text", Format::text}, {"json", Format::json},       {"sarif", Format::sarif}, {"dot", Format::dot},
    {"svg", Format::svg},   {"mermaid", Format::mermaid}, {"html", Format::html},   {"markdown", Format::markdown}};

/// `--format` with some of the formats.
void add_format(CLI::App& app, Format& format, const std::vector<std::string>& names) {
  app.add_option_function<std::string>(
         "--format", [&format](const std::string& name) { format = formats.at(name); },
         fmt::format("one of {}; without it {}", fmt::join(names, ", "), names.front()))
      ->type_name("NAME")
      ->check(CLI::IsMember(names));
}

struct SelectionWords {
  std::vector<std::string> werror, lint, allow;
};

/// `--werror` is for all, `--werror=<id>` for one: flags that may carry a value, so that none of them takes the next
/// word.
void add_selection(CLI::App& app, SelectionWords& words) {
  app.add_flag("--werror{*}", words.werror, "warnings are errors, or those of one check");
  app.add_flag("--lint{*}", words.lint, "report lints too, or those of one check");
  app.add_flag("--allow{*}", words.allow, "do not report what this check finds; an error is reported all the same");
}

checks::Selection selection_of(const SelectionWords& words) {
  checks::Selection out;
  for (const std::string& id : words.werror) {
    if (id == "*") out.every_warning_is_error = true;
    if (id != "*") out.warnings_as_errors.insert(id);
  }
  for (const std::string& id : words.lint) {
    if (id == "*") out.every_lint = true;
    if (id != "*") out.lints.insert(id);
  }
  out.allowed.insert(words.allow.begin(), words.allow.end());
  return out;
}

/// The first id that no check has, with what was probably meant.
std::optional<Say> unknown_id(const SelectionWords& words) {
  std::vector<std::string> known;
  for (const checks::Registered& check : checks::registered()) known.emplace_back(check.id);
  for (const auto* list : {&words.werror, &words.lint, &words.allow}) {
    for (const std::string& id : *list) {
      const bool every = id == "*" && list != &words.allow;
      if (every || checks::find_registered(id) != nullptr) continue;
      if (id == "*") return Say{"directorc: --allow needs the id of a check, --allow=<id>\n", true};
      const std::optional<std::string> near = dsl::suggest(id, known);
      return Say{fmt::format("directorc: there is no check `{}`{}\n", id,
                             near ? fmt::format("; did you mean `{}`?", *near) : std::string{}),
                 true};
    }
  }
  return {};
}

void add_build(CLI::App& app, std::string& build) {
  app.add_option("-p,--build", build,
                 "compare the types of C++ too, as compile_commands.json of this build's folder has them compiled")
      ->type_name("FOLDER");
}

CLI::Option* add_bound(CLI::App& app, std::size_t& bound) {
  return app
      .add_option("--bound", bound, "end after so many different states, a few hundred bytes each; without it 1000000")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, std::size_t{4'000'000'000}));
}

/// The check that explores.
constexpr const char* never_runs = "never_runs";

Make check_options(CLI::App& app) {
  auto request = std::make_shared<Check>();
  auto words = std::make_shared<SelectionWords>();
  app.add_option("FILE", request->file, "the behaviour")->required();
  add_format(app, request->format, {"text", "json", "sarif"});
  add_selection(app, *words);
  app.add_option("--explain-reachable", request->reachable,
                 "also tell how a group, Walk.halting or 'Pose == standing' may be reached")
      ->type_name("X");
  add_build(app, request->build);
  app.add_flag("--verbose", request->verbose, "also print how much memory and work the engine may need");
  auto explore = std::make_shared<bool>(false);
  auto bound = std::make_shared<std::size_t>(Explore{}.bound);
  CLI::Option* exploring =
      app.add_flag("--explore", *explore, "try everything that can happen, and report what never runs");
  add_bound(app, *bound)->needs(exploring);
  return [=]() -> Request {
    if (const std::optional<Say> wrong = unknown_id(*words)) return *wrong;
    request->selection = selection_of(*words);
    if (*explore || request->selection.lints.contains(never_runs)) {
      request->selection.lints.emplace(never_runs);
      request->explore = *bound;
    }
    return *request;
  };
}

Make generate_options(CLI::App& app) {
  auto request = std::make_shared<Generate>();
  auto words = std::make_shared<SelectionWords>();
  app.add_option("FILE", request->file, "the behaviour; it must have `roots`")->required();
  app.add_option("-o,--output", request->folder,
                 "folder for what is generated; files there that directorc has not written stay as they are")
      ->type_name("FOLDER")
      ->required();
  CLI::Option* depfile = app.add_option("--depfile", request->depfile, "also write what was read, for Make and Ninja");
  depfile->type_name("FILE");
  app.add_option("--depfile-target", request->target,
                 "what depends on it there; without it, everything that is generated")
      ->type_name("FILE")
      ->needs(depfile);
  add_build(app, request->build);
  app.add_option("--flags", request->flags,
                 "the compiler and its flags, a word in each line, instead of a build's folder")
      ->type_name("FILE");
  add_selection(app, *words);
  return [=]() -> Request {
    if (const std::optional<Say> wrong = unknown_id(*words)) return *wrong;
    request->selection = selection_of(*words);
    return *request;
  };
}

/// What is wrong with it, if something is.
std::optional<Say> parse_time(const std::string& text, std::optional<std::int64_t>& time) {
  if (const std::optional<dsl::Duration> most = dsl::most_instead_of(text))
    return Say{fmt::format("directorc: `{}` is too long: at most {}\n", text, dsl::to_text(*most)), true};
  const std::optional<dsl::Duration> given = dsl::parse_duration(text);
  if (!given) return Say{fmt::format("directorc: `{}` is no time: a whole number and us, ms, s or min\n", text), true};
  time = given->microseconds();
  return {};
}

void add_link(CLI::App& app, std::string& link) {
  app.add_option("--link", link, "address behind each box, arrow and place, with {file} and {line} in it")
      ->type_name("ADDRESS");
}

std::optional<Say> wrong_link(const std::string& link) {
  if (link.empty() || link.find("{file}") != std::string::npos) return {};
  return Say{"directorc: --link needs {file} in it, and {line}: --link='https://example.org/{file}#L{line}'\n", true};
}

Make graph_options(CLI::App& app) {
  auto request = std::make_shared<DrawGraph>();
  app.add_option("FILE", request->file, "the behaviour")->required();
  add_format(app, request->format, {"dot", "svg", "json", "mermaid"});
  app.add_option("-o,--output", request->output,
                 "file to write, unless somebody else has written it; without it, to the terminal")
      ->type_name("FILE");
  app.add_option("--view", request->view, "only these arrows: tasks, needs, pushes or takes (who may take from whom)")
      ->type_name("NAME")
      ->check(CLI::IsMember({"all", "tasks", "needs", "pushes", "takes"}));
  app.add_option("--collapse", request->collapse, "one box for each: module or layer")
      ->type_name("NAME")
      ->check(CLI::IsMember({"module", "layer"}));
  CLI::Option* focus = app.add_option("--focus", request->focus,
                                      "only what can reach, hold, push or block one of these groups, GROUP,GROUP")
                           ->type_name("GROUP")
                           ->delimiter(',')
                           ->expected(1)
                           ->take_all();
  app.add_option("--depth", request->depth, "no further than so many arrows from the focus")
      ->type_name("N")
      ->check(CLI::Range(0, 1'000))
      ->needs(focus);
  add_link(app, request->link);
  CLI::Option* findings = app.add_flag("--findings", request->findings, "also what is found, each at its place");
  CLI::Option* page = app.add_flag("--page", request->page,
                                   "as JSON: also all else that a page of `directorc docs` tells, findings, who beats "
                                   "whom, verdicts of assertions and the transition matrix");
  auto time = std::make_shared<std::string>();
  CLI::Option* step = app.add_option("--step", request->step, "FILE is a scenario: the moment after this step of it")
                          ->type_name("N")
                          ->check(CLI::Range(1, 1'000'000));
  CLI::Option* at = app.add_option("--at", *time, "FILE is a scenario: the moment at this time of it, '1500 ms'")
                        ->type_name("TIME")
                        ->excludes(step);
  app.add_flag("--frames", request->frames, "FILE is a scenario: a picture for each step, into the folder of -o")
      ->excludes(step)
      ->excludes(at)
      ->excludes(findings)
      ->excludes(page);
  for (CLI::Option* moment : {step, at}) moment->excludes(findings)->excludes(page);
  return [=]() -> Request {
    if (!time->empty()) {
      if (const std::optional<Say> wrong = parse_time(*time, request->time)) return *wrong;
    }
    if (request->page && request->format != Format::json)
      return Say{"directorc: --page needs --format=json; `directorc docs` writes pages to read\n", true};
    if (request->frames && request->output.empty())
      return Say{"directorc: --frames writes many files: -o names a folder for them\n", true};
    if (const std::optional<Say> wrong = wrong_link(request->link)) return *wrong;
    return *request;
  };
}

Make docs_options(CLI::App& app) {
  auto request = std::make_shared<Docs>();
  app.add_option("FILE", request->files, "the behaviours")->required();
  app.add_option("-o,--output", request->folder, "folder for the pages, each named like its file")
      ->type_name("FOLDER")
      ->required();
  add_format(app, request->format, {"html", "markdown"});
  add_link(app, request->link);
  return [=]() -> Request {
    if (const std::optional<Say> wrong = wrong_link(request->link)) return *wrong;
    return *request;
  };
}

Make explain_options(CLI::App& app) {
  auto request = std::make_shared<Explain>();
  app.add_option("ID", request->id, "what stands in brackets behind a finding, or a key of the language: needs")
      ->required();
  return [=]() -> Request { return *request; };
}

Make checks_options(CLI::App&) {
  return []() -> Request { return ListChecks{}; };
}

Make simulate_options(CLI::App& app) {
  auto request = std::make_shared<Simulate>();
  app.add_option("FILE", request->file, "the scenario")->required();
  add_format(app, request->format, {"text", "json"});
  app.add_flag("--decisions", request->decisions, "also print what is queued, pushed, released and set");
  app.add_flag("--times", request->times, "also print when, in seconds; in JSON, in microseconds");
  return [=]() -> Request { return *request; };
}

Make why_options(CLI::App& app) {
  auto request = std::make_shared<Why>();
  auto time = std::make_shared<std::string>();
  app.add_option("SCENARIO", request->scenario, "the scenario; its behaviour is the one that it names")->required();
  app.add_option("GROUP", request->group, "the group that is asked about")->required();
  CLI::Option* step = app.add_option("--step", request->step, "after this step of the scenario; without it, in the end")
                          ->type_name("N")
                          ->check(CLI::Range(1, 1'000'000));
  app.add_option("--time", *time, "at this time, '1500 ms', where a step advances beyond it")
      ->type_name("TIME")
      ->excludes(step);
  add_format(app, request->format, {"text", "json"});
  return [=]() -> Request {
    if (time->empty()) return *request;
    if (const std::optional<Say> wrong = parse_time(*time, request->time)) return *wrong;
    return *request;
  };
}

Make test_options(CLI::App& app) {
  auto request = std::make_shared<Test>();
  app.add_option("FILE", request->files, "scenarios, or folders: then all *.scenario.yaml below them")->required();
  add_format(app, request->format, {"text", "json"});
  CLI::Option* coverage = app.add_flag("--coverage", request->coverage, "also print what no scenario exercises");
  app.add_option("--min", request->min, "fail where less of a behaviour is exercised")
      ->type_name("PERCENT")
      ->check(CLI::Range(0, 100))
      ->needs(coverage);
  app.add_flag("--update", request->update,
               "write what happens into the files: where it is not as expected, and in scenarios that expect nothing");
  return [=]() -> Request { return *request; };
}

Make explore_options(CLI::App& app) {
  auto request = std::make_shared<Explore>();
  app.add_option("FILE", request->file, "the behaviour; it must have `roots`")->required();
  add_bound(app, request->bound);
  app.add_option("-o,--output", request->output, "folder for what is found, as scenarios")->type_name("FOLDER");
  return [=]() -> Request { return *request; };
}

Make verify_options(CLI::App& app) {
  auto request = std::make_shared<Verify>();
  auto words = std::make_shared<SelectionWords>();
  app.add_option("FILE", request->file, "the behaviour; it must have `roots`")->required();
  app.add_option("-p,--build", request->build, "the build's folder, with compile_commands.json")
      ->type_name("FOLDER")
      ->required();
  app.add_option("--generated", request->generated,
                 "only files that are compiled with the generated header of this folder")
      ->type_name("FOLDER");
  app.add_option("--exclude", request->excluded,
                 "leave out sources below this folder, or compiled into it; or one file. May be given several times")
      ->type_name("PATH");
  add_format(app, request->format, {"text", "json", "sarif"});
  add_selection(app, *words);
  return [=]() -> Request {
    if (const std::optional<Say> wrong = unknown_id(*words)) return *wrong;
    request->selection = selection_of(*words);
    return *request;
  };
}

Make dump_options(CLI::App& app) {
  auto request = std::make_shared<Dump>();
  app.add_option("FILE", request->file, "the behaviour")->required();
  app.add_option("--stage", request->stage,
                 "spec: as it was read; model: every name resolved; graph: who leads to whom; "
                 "tables: what the engine runs on")
      ->required()
      ->type_name("NAME")
      ->check(CLI::IsMember({"spec", "model", "graph", "tables"}));
  return [=]() -> Request { return *request; };
}

Make stubs_options(CLI::App& app) {
  auto request = std::make_shared<Stubs>();
  app.add_option("FILE", request->file, "the behaviour; it must have `roots`")->required();
  app.add_option("-o,--output", request->folder,
                 "folder of the program's C++; what its files say stays as it is, more is only put between")
      ->type_name("FOLDER")
      ->required();
  app.add_option("-p,--build", request->build,
                 "folder with compile_commands.json, which says how the program is compiled; without it, the first "
                 "one above FOLDER, or in a folder `build` there")
      ->type_name("FOLDER");
  app.add_option("-I,--include", request->includes, "a folder to include from, where there is no such file")
      ->type_name("FOLDER")
      ->expected(1)
      ->take_all();
  app.add_flag("--main", request->main, "also write a main.cpp, if there is none");
  CLI::Option* dry_run = app.add_flag("--dry-run", request->dry_run, "write nothing, print it as a diff");
  app.add_flag("--check", request->check, "write nothing; exit status 1 if something is missing")->excludes(dry_run);
  app.footer(
      "Each module gets a class in a .hpp and a .cpp. Where the program has one already, only the functions that\n"
      "it lacks are added; what nothing asks for any more is reported. To read what is there, director-clang is\n"
      "needed.");
  return [=]() -> Request { return *request; };
}

const std::array<Subcommand, 13> subcommands{{
    {"check", "Look for mistakes in a behaviour", check_options},
    {"generate", "Write the C++ of a behaviour", generate_options},
    {"graph", "Draw a behaviour", graph_options},
    {"docs", "Write pages about behaviours, for a browser or as Markdown", docs_options},
    {"explain", "Print the page of a check, or what a key of the language says", explain_options},
    {"checks", "List all checks", checks_options},
    {"simulate", "Play a scenario and print what happens", simulate_options},
    {"why", "Say why a group runs, or does not, in a scenario", why_options},
    {"test", "Play scenarios and compare with what they expect", test_options},
    {"explore", "Try everything that can happen, and decide the assertions", explore_options},
    {"stubs", "Write the C++ that is for you to fill in, or add to it what is missing", stubs_options},
    {"verify", "Look for mistakes in the C++ of a behaviour", verify_options},
    {"dump", "Print what a stage of the compiler makes of a behaviour", dump_options},
}};

/// A word that is no subcommand, before CLI11 says something less helpful.
std::optional<Say> unknown_subcommand(const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front().starts_with('-')) return {};
  std::vector<std::string> names;
  for (const Subcommand& subcommand : subcommands) names.push_back(subcommand.name);
  const std::string& word = arguments.front();
  if (std::find(names.begin(), names.end(), word) != names.end()) return {};
  const std::optional<std::string> near = dsl::suggest(word, names);
  return Say{fmt::format("directorc: there is no subcommand `{}`{}\n", word,
                         near ? fmt::format("; did you mean `{}`?", *near)
                              : fmt::format("; there are {}", fmt::join(names, ", "))),
             true};
}

/// What stands below the list of subcommands.
std::string last_words(const std::string& schemas) {
  std::string out =
      "Exit status: 0 clean; 1 errors were found, a scenario does not hold, an assertion is refuted, or too little is\n"
      "covered; 2 wrong usage, or a file named on the command line cannot be read or written; 3 not decided.\n"
      "`directorc SUBCOMMAND --help` tells more.";
  if (!schemas.empty())
    out += fmt::format("\n\nAn editor with the YAML language server knows the keys where the first line is\n"
                       "# yaml-language-server: $schema={0}/behaviour.schema.json\n"
                       "or, in a scenario,\n"
                       "# yaml-language-server: $schema={0}/scenario.schema.json",
                       schemas);
  return out;
}

} // namespace

Request parse(const std::vector<std::string>& arguments, const std::string& schemas) {
  if (const std::optional<Say> wrong = unknown_subcommand(arguments)) return *wrong;
  CLI::App app{"directorc checks behaviours of robots and writes their C++.", "directorc"};
  app.set_version_flag("--version", fmt::format("directorc {}", version()), "Print the version");
  app.set_help_flag("--help,-h", "Print this help");
  app.require_subcommand(1);
  app.formatter(std::make_shared<Help>());
  app.footer(last_words(schemas));
  std::array<Make, subcommands.size()> make;
  std::array<CLI::App*, subcommands.size()> apps{};
  for (std::size_t i = 0; i < subcommands.size(); ++i) {
    apps[i] = app.add_subcommand(subcommands[i].name, subcommands[i].summary);
    make[i] = subcommands[i].options(*apps[i]);
  }
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend())); // CLI11 wants the last word first
  } catch (const CLI::CallForHelp&) {
    for (const CLI::App* subcommand : apps) {
      if (subcommand->parsed()) return Say{subcommand->help("directorc"), false};
    }
    return Say{app.help(), false};
  } catch (const CLI::CallForVersion&) {
    return Say{fmt::format("directorc {}\n", version()), false};
  } catch (const CLI::ParseError& error) {
    std::string with = "directorc";
    for (const CLI::App* subcommand : apps) {
      if (subcommand->parsed()) with += " " + subcommand->get_name();
    }
    return Say{fmt::format("{}: {}\nTry `{} --help`.\n", with, error.what(), with), true};
  }
  for (std::size_t i = 0; i < apps.size(); ++i) {
    if (apps[i]->parsed()) return make[i]();
  }
  return Say{app.help(), true};
}

} // namespace director::compiler::cli
