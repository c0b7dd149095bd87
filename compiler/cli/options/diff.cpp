// Header: compiler/cli/options/common.hpp. Test: tests/compiler/cli/options/parse_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/options/common.hpp"
#include "dsl/lexical/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace director::compiler::cli {

namespace {

/// Returns an error, if the kinds are wrong.
std::optional<Message> parse_kinds(const std::vector<std::string>& words, Breaking& breaking) {
  std::vector<std::string> known{"all", "code"};
  for (const ChangeKindPage& page : change_kinds()) known.emplace_back(page.id);
  for (const std::string& word : words) {
    if (std::find(known.begin(), known.end(), word) == known.end()) {
      const std::optional<std::string> near = dsl::suggest(word, known);
      return Message{fmt::format("directorc: there is no kind of change `{}`{}\n", word,
                                 near ? fmt::format("; did you mean `{}`?", *near)
                                      : std::string("; `directorc diff --help` lists them")),
                     true};
    }
    if (word == "code") breaking.code = true;
    for (const ChangeKindPage& page : change_kinds()) {
      if (word == "all" || word == page.id) breaking.kinds.insert(page.kind);
    }
  }
  return {};
}

std::string footer() {
  std::string out = "Kinds of changes, the most dangerous first:\n";
  for (const ChangeKindPage& page : change_kinds()) out += fmt::format("  {:20}{}\n", page.id, page.meaning);
  return out +
         "\nExit status: 0 no change, or none of --breaking; 1 one of --breaking, or the new one has errors in its\n"
         "text or its names, and the old one has none; 2 wrong usage, or a file or revision that cannot be read.\n"
         "As a tool of git: git difftool -x 'directorc diff'";
}

} // namespace

Make diff_options(CLI::App& app) {
  auto request = std::make_shared<Diff>();
  auto files = std::make_shared<std::vector<std::string>>();
  auto kinds = std::make_shared<std::vector<std::string>>();
  app.add_option("FILE", *files, "the old behaviour and the new one; with --git the new one alone")
      ->required()
      ->expected(1, 2);
  app.add_option("--git", request->revision, "the old one is FILE, and what it imports, in this revision of git")
      ->type_name("REVISION");
  app.add_flag("--staged", request->staged,
               "the new one is FILE, and what it imports, as git has it staged; without --git the old one is in HEAD");
  add_format(app, request->format, {"text", "json", "sarif"});
  app.add_option("--breaking", *kinds,
                 "end with status 1 on changes of these kinds, KIND,KIND; `code`: whatever C++ has to follow; `all`")
      ->type_name("KIND")
      ->delimiter(',')
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  add_cpp(app, request->cpp);
  app.footer(footer());
  return [=]() -> Request {
    if (const std::optional<Message> wrong = parse_kinds(*kinds, request->breaking)) return *wrong;
    if (request->staged && request->revision.empty()) request->revision = "HEAD";
    const bool by_git = !request->revision.empty();
    if (files->size() != (by_git ? 1U : 2U))
      return Message{by_git
                         ? "directorc: with --git or --staged there is one file: directorc diff --git REVISION FILE\n"
                         : "directorc: diff needs two files, the old one and the new one; or --git REVISION FILE\n",
                     true};
    if (!by_git) request->before = files->front();
    request->after = files->back();
    return *request;
  };
}

} // namespace director::compiler::cli
