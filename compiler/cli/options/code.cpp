// Header: compiler/cli/options/common.hpp. Test: tests/compiler/cli/options/parse_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/options/common.hpp"

#include <memory>

namespace director::compiler::cli {

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
  app.add_option("--depfile-target", request->target, "the target of its rule; without it, all generated files")
      ->type_name("FILE")
      ->needs(depfile);
  add_bound(app, request->bound, bound_of_assertions);
  add_cpp(app, request->cpp);
  add_selection(app, *words);
  return [=]() -> Request {
    if (const std::optional<Message> wrong = unknown_id(*words)) return *wrong;
    if (const std::optional<Message> wrong = wrong_place("-o", "a folder", request->folder)) return *wrong;
    if (const std::optional<Message> wrong = wrong_place("--depfile", "a file", request->depfile)) return *wrong;
    request->selection = selection_of(*words);
    return *request;
  };
}

Make stubs_options(CLI::App& app) {
  auto request = std::make_shared<Stubs>();
  app.add_option("FILE", request->file, "the behaviour; it must have `roots`")->required();
  app.add_option("-o,--output", request->folder,
                 "folder of your C++; text that is there stays as it is, and what is missing is inserted")
      ->type_name("FOLDER")
      ->required();
  app.add_option("-p,--build", request->build,
                 "folder with compile_commands.json, which says how the program is compiled; without it, the first "
                 "one above FOLDER, or in a folder `build` there")
      ->type_name("FOLDER");
  app.add_option("-I,--include", request->includes,
                 "an include folder, if there is no compile_commands.json; may be given several times")
      ->type_name("FOLDER")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  app.add_flag("--main", request->main, "also write a main.cpp, if there is none");
  CLI::Option* dry_run = app.add_flag("--dry-run", request->dry_run, "write nothing, print it as a diff");
  app.add_flag("--check", request->check, "write nothing; exit status 1 if something is missing")->excludes(dry_run);
  app.footer(
      "Each module gets a class in a .hpp and a .cpp. Where the program has one already, only the functions that\n"
      "it lacks are added; what nothing requests any more is reported. To read what is there, director-clang is\n"
      "needed.\n"
      "\n"
      "Exit status: 0 clean; 1 the behaviour has errors, something is in the way, or, with --check, something is\n"
      "missing; 2 wrong usage, or a file that cannot be read or written.");
  return [=]() -> Request {
    if (const std::optional<Message> wrong = wrong_place("-o", "a folder", request->folder)) return *wrong;
    return *request;
  };
}

} // namespace director::compiler::cli
