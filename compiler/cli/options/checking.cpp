// Header: compiler/cli/options/common.hpp. Test: tests/compiler/cli/options/parse_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/options/common.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>

namespace director::compiler::cli {

namespace {

/// The check that explores.
constexpr const char* never_runs = "never_runs";

/// CLI::Range accepts nan, which compares as neither too small nor too large.
std::string is_number(const std::string& text) {
  return std::isnan(std::strtod(text.c_str(), nullptr)) ? fmt::format("Value {} is not a number", text) : std::string{};
}

} // namespace

Make check_options(CLI::App& app) {
  auto request = std::make_shared<Check>();
  auto words = std::make_shared<SelectionWords>();
  app.add_option("FILE", request->file, "the behaviour")->required();
  add_format(app, request->format, {"text", "json", "sarif"});
  add_selection(app, *words);
  app.add_option("--explain-reachable", request->reachable,
                 "also print how a group, a provider (Walk.halting) or a value ('Pose == standing') may be reached")
      ->type_name("X");
  add_cpp(app, request->cpp);
  CLI::Option* verbose =
      app.add_flag("--verbose", request->verbose, "also print how much memory, work and time the engine may need");
  app.add_option("--work-ns", request->work_ns,
                 "with --verbose: what a unit of work costs on your machine, in nanoseconds, as ./bench measures it; "
                 "without it 150")
      ->type_name("N")
      ->check(is_number)
      ->check(CLI::Range(0.01, 1e9))
      ->needs(verbose);
  auto explore = std::make_shared<bool>(false);
  auto bound = std::make_shared<std::size_t>(0); // as without it
  app.add_flag("--explore", *explore,
               "try everything that can happen, and report what never runs, and where the engine never comes to rest; "
               "--lint=never_runs does the same");
  add_bound(app, *bound, "100000 for the assertions, 1000000 with --explore");
  add_watch(app, request->watch);
  return [=]() -> Request {
    if (const std::optional<Message> wrong = unknown_id(*words)) return *wrong;
    if (const std::optional<Message> wrong = wrong_watch(request->watch, request->format)) return *wrong;
    if (request->verbose && request->format == Format::sarif)
      return Message{
          "directorc: --verbose prints text or JSON, and SARIF has no place for it: leave out one of the two\n", true};
    request->selection = selection_of(*words);
    if (*explore || request->selection.lints.contains(never_runs)) {
      request->selection.lints.emplace(never_runs);
      request->explore = *bound > 0 ? *bound : Explore{}.bound;
    }
    if (*bound > 0) request->bound = *bound;
    return *request;
  };
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
                 "leave out a source, all sources below a folder, or all compiled into it; may be given several times")
      ->type_name("PATH");
  CLI::Option* depfile = app.add_option("--depfile", request->depfile, "also write what was read, for Make and Ninja");
  depfile->type_name("FILE");
  app.add_option("--depfile-target", request->target, "the target of its rule")->type_name("FILE")->needs(depfile);
  add_format(app, request->format, {"text", "json", "sarif"});
  add_selection(app, *words);
  return [=]() -> Request {
    if (const std::optional<Message> wrong = unknown_id(*words)) return *wrong;
    if (const std::optional<Message> wrong = wrong_place("--depfile", "a file", request->depfile)) return *wrong;
    if (!request->depfile.empty() && request->target.empty())
      return Message{"directorc: --depfile needs --depfile-target, the file that the build makes after it\n", true};
    request->selection = selection_of(*words);
    return *request;
  };
}

Make explain_options(CLI::App& app) {
  auto request = std::make_shared<Explain>();
  app.add_option("ID", request->id, "the id in brackets behind a finding, or a key of the language, such as needs")
      ->required();
  return [=]() -> Request { return *request; };
}

Make checks_options(CLI::App&) {
  return []() -> Request { return ListChecks{}; };
}

Make dump_options(CLI::App& app) {
  auto request = std::make_shared<Dump>();
  app.add_option("FILE", request->file, "the behaviour")->required();
  app.add_option("--stage", request->stage,
                 "spec: as it was read; model: every name resolved; graph: which group leads to which; "
                 "tables: what the engine runs on")
      ->required()
      ->type_name("NAME")
      ->check(CLI::IsMember({"spec", "model", "graph", "tables"}));
  add_cpp(app, request->cpp);
  return [=]() -> Request { return *request; };
}

} // namespace director::compiler::cli
