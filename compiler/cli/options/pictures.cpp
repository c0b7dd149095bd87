// Header: compiler/cli/options/common.hpp. Test: tests/compiler/cli/options/parse_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/for_shell.hpp"
#include "compiler/cli/options/common.hpp"

#include <fmt/format.h>

#include <memory>

namespace director::compiler::cli {

namespace {

CLI::Option* add_transitions(CLI::App& app, std::vector<std::string>& groups) {
  return app
      .add_option("--transitions", groups,
                  "only these groups in the transition matrix, GROUP,GROUP; without it all, if there are at most 100")
      ->type_name("GROUP")
      ->delimiter(',')
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

/// The file name's ending, without the dot, if Graphviz makes such a picture of `dot`; otherwise empty.
std::string drawn_by_graphviz(const std::string& file) {
  return format_by_ending(
      file, {{".png", "png"}, {".pdf", "pdf"}, {".ps", "ps"}, {".jpg", "jpg"}, {".jpeg", "jpg"}, {".gif", "gif"}});
}

/// Takes the format from the file's name, if none is named; or returns why there is no such picture.
std::optional<Message> take_format_of(DrawGraph& request) {
  const std::string name = format_by_ending(
      request.output,
      {{".svg", "svg"}, {".json", "json"}, {".mmd", "mermaid"}, {".mermaid", "mermaid"}, {".dot", "dot"}});
  if (!name.empty()) request.format = format_called(name);
  if (!format_by_ending(request.output, {{".html", "html"}, {".htm", "html"}}).empty())
    return Message{fmt::format("directorc: `{}`: there is no format html; `directorc docs` writes a page\n",
                               request.output),
                   true};
  const std::string other = drawn_by_graphviz(request.output);
  if (other.empty()) return {};
  const std::string dot = request.output.substr(0, request.output.rfind('.')) + ".dot";
  return Message{fmt::format("directorc: `{0}`: there is no format {1}; Graphviz makes it: write a dot file, with -o "
                             "{2}, then `dot -T{1} -o {3} {2}`\n",
                             request.output, other, for_shell(dot), for_shell(request.output)),
                 true};
}

} // namespace

Make graph_options(CLI::App& app) {
  auto request = std::make_shared<DrawGraph>();
  app.add_option("FILE", request->file, "the behaviour")->required();
  CLI::Option* format = add_format(app, request->format, {"dot", "svg", "json", "mermaid"});
  format->description("one of dot, svg, json, mermaid; without it, the one that the ending of -o names, or dot");
  app.add_option(
         "-o,--output", request->output,
         "the file to write (not one that another program has written); without it, or with -, the standard output")
      ->type_name("FILE");
  app.add_option("--view", request->view, "only these arrows: tasks, needs, pushes or takes (what may take from what)")
      ->type_name("NAME")
      ->check(CLI::IsMember({"all", "tasks", "needs", "pushes", "takes"}));
  app.add_option("--collapse", request->collapse, "one box for each: module or layer")
      ->type_name("NAME")
      ->check(CLI::IsMember({"module", "layer"}));
  CLI::Option* focus = app.add_option("--focus", request->focus,
                                      "only these groups, GROUP,GROUP, and those that lead to them, that they may hold "
                                      "or push, that may push them, or that need the same groups")
                           ->type_name("GROUP")
                           ->delimiter(',')
                           ->expected(1)
                           ->take_all()
                           ->allow_extra_args(false);
  app.add_option("--depth", request->depth, "only what is at most N arrows away from these groups")
      ->type_name("N")
      ->check(CLI::Range(0, 1'000))
      ->needs(focus);
  add_link(app, request->link);
  add_cpp(app, request->cpp);
  CLI::Option* findings =
      app.add_flag("--findings", request->findings, "draw also what `check` finds, each at its place");
  CLI::Option* page =
      app.add_flag("--page", request->page,
                   "with --format=json: add everything else that a page of `directorc docs` has: findings, which "
                   "task goes before which, verdicts of assertions and the transition matrix");
  add_transitions(app, request->transitions)->needs(page);
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
      if (const std::optional<Message> wrong = parse_time(*time, request->time)) return *wrong;
    }
    if (format->empty() && !request->frames) {
      if (const std::optional<Message> wrong = take_format_of(*request)) return *wrong;
    }
    if (request->page && request->format != Format::json)
      return Message{"directorc: --page needs --format=json; `directorc docs` writes pages to read\n", true};
    if (request->frames && request->output.empty())
      return Message{"directorc: --frames writes many files: -o names a folder for them\n", true};
    if (request->frames) {
      if (const std::optional<Message> wrong = wrong_place("-o", "a folder", request->output)) return *wrong;
    } else if (request->output == standard_output) {
      request->output.clear();
    }
    if (const std::optional<Message> wrong = wrong_link(request->link)) return *wrong;
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
  add_transitions(app, request->transitions);
  add_link(app, request->link);
  add_bound(app, request->bound, bound_of_assertions);
  add_cpp(app, request->cpp);
  return [=]() -> Request {
    if (const std::optional<Message> wrong = wrong_place("-o", "a folder", request->folder)) return *wrong;
    if (const std::optional<Message> wrong = wrong_link(request->link)) return *wrong;
    return *request;
  };
}

} // namespace director::compiler::cli
