// Header: compiler/cli/options/common.hpp. Test: tests/compiler/cli/options/parse_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/options/common.hpp"

#include <fmt/format.h>

#include <memory>

namespace director::compiler::cli {

Make simulate_options(CLI::App& app) {
  auto request = std::make_shared<Simulate>();
  app.add_option("FILE", request->file, "the scenario")->required();
  add_format(app, request->format, {"text", "json"});
  app.add_flag("--decisions", request->decisions, "also print what is queued, pushed, released and set");
  app.add_flag("--times", request->times, "also print when, in seconds; in JSON, in microseconds");
  app.add_option(
         "--trace", request->trace,
         "also write all that happens, as a robot's recorder does: JSON lines, or for ui.perfetto.dev where the name "
         "ends so, .perfetto-trace or .pftrace")
      ->type_name("FILE");
  add_cpp(app, request->cpp);
  return [=]() -> Request {
    if (const std::optional<Message> wrong = wrong_place("--trace", "a file", request->trace)) return *wrong;
    if (request->trace.ends_with(".html"))
      return Message{
          "directorc: --trace writes no page; record a .jsonl, and `directorc trace FILE.jsonl -o FILE.html` "
          "writes one\n",
          true};
    return *request;
  };
}

Make trace_options(CLI::App& app) {
  auto request = std::make_shared<Trace>();
  app.add_option("FILE", request->file, "what was recorded, JSON lines")->required();
  CLI::Option* to =
      app.add_option(
             "--to", request->to,
             "text, as `simulate --decisions --times` prints it; json, line by line; perfetto, for ui.perfetto.dev; "
             "html, the page of `directorc docs` with a timeline; without it, what the ending of -o names, or text")
          ->type_name("FORMAT")
          ->check(CLI::IsMember({"text", "json", "perfetto", "html"}));
  app.add_option("-o,--output", request->output, "the file to write; without it, or with -, the standard output")
      ->type_name("FILE");
  app.add_option("--behaviour", request->behaviour,
                 "for html: the file of the behaviour that was recorded; without it, the one that the trace names")
      ->type_name("FILE");
  add_link(app, request->link);
  add_cpp(app, request->cpp);
  const CLI::App* const subcommand = &app;
  return [=]() -> Request {
    const std::string by_ending = format_by_ending(request->output, {{".json", "json"},
                                                                     {".jsonl", "json"},
                                                                     {".html", "html"},
                                                                     {".perfetto-trace", "perfetto"},
                                                                     {".pftrace", "perfetto"}});
    if (to->empty() && !by_ending.empty()) request->to = by_ending;
    for (const char* option : {"--behaviour", "--link", "--build", "--flags"}) {
      if (request->to != "html" && !subcommand->get_option(option)->empty())
        return Message{
            fmt::format("directorc: {} has an effect only with --to=html: leave it out, or add that\n", option), true};
    }
    if (const std::optional<Message> wrong = wrong_link(request->link)) return *wrong;
    if (request->output == standard_output) request->output.clear();
    return *request;
  };
}

Make replay_options(CLI::App& app) {
  auto request = std::make_shared<Replay>();
  app.add_option("TRACE", request->trace, "what was recorded, JSON lines")->required();
  app.add_option("--behaviour", request->behaviour,
                 "the file of the behaviour, or of another version of it; without it, the one that the trace names")
      ->type_name("FILE");
  add_format(app, request->format, {"text", "json"});
  add_cpp(app, request->cpp);
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
  add_cpp(app, request->cpp);
  return [=]() -> Request {
    if (time->empty()) return *request;
    if (const std::optional<Message> wrong = parse_time(*time, request->time)) return *wrong;
    return *request;
  };
}

Make test_options(CLI::App& app) {
  auto request = std::make_shared<Test>();
  app.add_option("FILE", request->files,
                 "scenarios, or folders: then all *.scenario.yaml and *.scenario.yml below them")
      ->required();
  add_format(app, request->format, {"text", "json"});
  CLI::Option* coverage = app.add_flag("--coverage", request->coverage, "also print what no scenario exercises");
  app.add_option("--min", request->min, "fail where less of a behaviour is exercised")
      ->type_name("PERCENT")
      ->check(CLI::Range(0, 100))
      ->needs(coverage);
  CLI::Option* update = app.add_flag("--update", request->update,
                                     "write what happens into the scenarios: into each `expect` that differs, and into "
                                     "each step of a scenario without any");
  add_watch(app, request->watch)->excludes(update);
  add_cpp(app, request->cpp);
  return [=]() -> Request {
    if (const std::optional<Message> wrong = wrong_watch(request->watch, request->format)) return *wrong;
    return *request;
  };
}

Make explore_options(CLI::App& app) {
  auto request = std::make_shared<Explore>();
  app.add_option("FILE", request->file, "the behaviour; it must have `roots`")->required();
  add_bound(app, request->bound, "1000000");
  app.add_option("-o,--output", request->output, "folder for what is found, as scenarios")->type_name("FOLDER");
  add_cpp(app, request->cpp);
  return [=]() -> Request {
    if (const std::optional<Message> wrong = wrong_place("-o", "a folder", request->output)) return *wrong;
    return *request;
  };
}

} // namespace director::compiler::cli
