// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/clang/stubs/command_test.cpp.
// SPDX-License-Identifier: MIT
//
// Everything is planned before anything is written, and the changed user files are parsed once more in memory: only if
// nothing is missing then do all files change, together.
#include "compiler/cli/input/load.hpp"
#include "compiler/cli/input/stub_program.hpp"
#include "compiler/emit/cpp/cpp.hpp"
#include "compiler/facts/scanner.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/model/cpp_names.hpp"
#include "compiler/stubs/layout.hpp"
#include "compiler/stubs/merge.hpp"
#include "compiler/stubs/scan.hpp"
#include "compiler/stubs/stale.hpp"
#include "compiler/stubs/text_place.hpp"
#include "dsl/lexical/characters.hpp"
#include "dsl/lexical/cpp_type.hpp"
#include "dsl/source/harmless.hpp"
#include "dsl/source/load_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace director::compiler::cli {

namespace {

namespace fs = std::filesystem;
using namespace director::compiler::stubs;

/// A file where a new class would be written.
struct InTheWay {
  std::string path, message, help;
};

/// The planned changes. If a file is in the way, none of them is made: what is new may include what would be there.
struct Plan {
  std::vector<Artefact> fresh; ///< whole paths
  std::vector<Insertion> insertions;
  std::vector<Remark> leftovers, obstacles, stale;
  std::vector<InTheWay> in_the_way{};
  bool is_empty() const { return fresh.empty() && insertions.empty(); }
};

/// Thrown with the exit status; the reason was printed.
struct Refusal {
  int status = misused;
  std::string text;
};

std::string shown(const SourcePlace& place) {
  return fmt::format("{}:{}:{}", shown_path(place.path), place.line, place.column);
}

class Run {
public:
  Run(const Stubs& request, const Wanted& wanted, const Deployment& deployment, const dsl::Spec& spec, Console& console)
      : request_(request),
        wanted_(wanted),
        sources_(deployment.sources),
        spec_(spec),
        header_{wanted.header, header(deployment).text()},
        facts_{facts_name(wanted.behaviour), facts(deployment).text()},
        console_(console),
        scanner_(console.scanner, console.programs) {}

  int run() {
    try {
      program_ = read_program(request_, wanted_, console_);
      if (!program_.fault.empty()) throw refused(misused, program_.fault);
      const Plan plan = formatted_plan(planned());
      return carry_out(plan);
    } catch (const Refusal& refusal) {
      print_message(console_, refusal.text);
      return refusal.status;
    }
  }

private:
  static Refusal refused(int status, const std::string& text) { return {status, fmt::format("directorc: {}\n", text)}; }

  Json ask(const std::string& subcommand, const Json& question) {
    const Scan answer = scanner_.ask(subcommand, question);
    if (!answer) throw refused(misused, answer.error().message);
    return answer.value();
  }

  /// What the program would have after the changes.
  Found found_with(const Merge& added) {
    DeclarationsRequest question{header_, facts_, {}, program_.units, added.insertions, added.sources};
    for (const WantedModule& module : wanted_.modules) question.interfaces.push_back(module.interface);
    for (const Artefact& file : added.sources) question.units.push_back(unit_for(program_, file.path));
    return found_in(ask("declarations", to_json(question)));
  }

  /// The line of the generated header at which the problem is, if it is there.
  std::string_view line_of_header(const Problem& problem) const {
    if (fs::path(problem.place.path).filename() != header_.path) return {};
    std::string_view rest = header_.text;
    for (std::uint32_t line = 1; line < problem.place.line && !rest.empty(); ++line)
      rest.remove_prefix(std::min(rest.size(), rest.find('\n') + 1));
    return rest.substr(0, rest.find('\n'));
  }

  /// Of a problem with one of the behaviour's `headers`: where it is listed there, as the generated header need not
  /// exist on the disk.
  std::string place_in_behaviour(const Problem& problem) const {
    const std::string_view line = line_of_header(problem);
    for (const dsl::BehaviourSpec& file : spec_.files) {
      for (const dsl::Word& header : file.cpp.headers) {
        if (line.empty() || dsl::include_line(header.value) != line) continue;
        const dsl::SourceFile& source = sources_[header.span.file];
        const dsl::Place place = source.place(header.span.begin);
        return shown({source.path(), place.line, place.column});
      }
    }
    return {};
  }

  Refusal not_understood(const std::vector<Problem>& problems, std::string_view consequence) const {
    Refusal out{compiler::cli::found, {}};
    constexpr std::size_t most = 5;
    bool is_told = false;
    for (std::size_t i = 0; i < std::min(problems.size(), most); ++i) {
      const std::string listed = place_in_behaviour(problems[i]);
      out.text +=
          fmt::format("{}: error: {}\n", listed.empty() ? shown(problems[i].place) : listed, problems[i].message);
      const bool may_lack_folders = !listed.empty() || program_.compiled.empty();
      if (is_told || !may_lack_folders || !problems[i].message.ends_with("' file not found")) continue;
      out.text += "  help: name the folder from which it is included with `-I`, or with `-p` the folder of "
                  "compile_commands.json\n";
      is_told = true;
    }
    out.text += fmt::format("directorc: {}\n", consequence);
    return out;
  }

  /// Problems in texts with these insertions, at their places in the files as they are.
  std::vector<Problem> in_users_text(std::vector<Problem> problems, const std::vector<Insertion>& insertions) const {
    for (const std::vector<Insertion>& each : stubs::by_file(insertions)) {
      const std::string& text = program_.texts.at(each[0].path);
      const Applied applied = insert_into(text, each);
      for (Problem& problem : problems) {
        if (problem.place.path != each[0].path) continue;
        const std::size_t offset = offset_at(applied.text, problem.place.line, problem.place.column);
        const Origin origin = origin_of(applied, offset);
        problem.place.line = line_of(text, origin.offset);
        problem.place.column = static_cast<std::uint32_t>(1 + dsl::column_of(text, origin.offset));
        if (origin.is_inserted) problem.message = "in what would be added here: " + problem.message;
      }
    }
    return problems;
  }

  Merge merged() {
    if (program_.units.empty()) return merge(wanted_, {}, program_.texts);
    if (const Scan version = scanner_.version(); !version) {
      throw refused(misused, fmt::format("what is missing in `{}` can only be told by reading its C++: {}",
                                         request_.folder, version.error().message));
    }
    Found first = found_with({});
    // What one class leaves undefined, a derived one may define in a file that does not mention the behaviour.
    while (first.problems.empty() && add_heirs(program_, first.classes)) first = found_with({});
    if (!first.problems.empty()) throw not_understood(first.problems, "nothing is written: this C++ cannot be read");
    Merge out = merge(wanted_, first, program_.texts);
    classes_ = first.classes;
    if (request_.check) stale_ = stale_comments(wanted_, first, program_.texts);
    if (out.insertions.empty() && out.sources.empty()) return out;

    const Found then = found_with(out);
    const std::string_view consequence = "nothing is written: with the insertions this C++ cannot be read";
    if (!then.problems.empty()) throw not_understood(in_users_text(then.problems, out.insertions), consequence);
    Texts texts = program_.texts;
    for (const Artefact& file : out.sources) texts[file.path] = file.text;
    const Merge again = merge(wanted_, then, texts);
    if (!again.insertions.empty() || !again.sources.empty()) {
      const std::string& path = again.insertions.empty() ? again.sources[0].path : again.insertions[0].path;
      throw refused(
          compiler::cli::found,
          fmt::format("nothing is written: what would be added to `{}` would not be found there by the compiler; "
                      "`directorc generate` first if it includes what an earlier version of the behaviour "
                      "generated, otherwise add it by hand",
                      shown_path(path)));
    }
    return out;
  }

  bool is_free(const std::string& path) const {
    const auto there = console_.files.read(path, 0, dsl::Kinds::ordinary);
    return !there && there.error().kind == dsl::FileError::Kind::not_found;
  }

  /// Why a file that was read, or could not be, is in the way of a class that implements the module.
  InTheWay in_the_way(const std::string& path, const WantedModule& module) const {
    if (const auto there = console_.files.read(path, dsl::largest_file, dsl::Kinds::ordinary); !there)
      return {path,
              fmt::format("this file cannot be read: {}; a class that implements `{}` would be written here, unless it "
                          "has one already",
                          there.error().message, module.interface),
              "move it away, or give the module another name"};
    return {path,
            fmt::format("this file is in the way: it has no class that implements `{}`, which would be written here",
                        module.interface),
            "put the class into it, or give the module another name"};
  }

  void add_first_files(const WantedModule& module, Plan& plan) {
    std::vector<Artefact> files = first_files(wanted_, module);
    for (Artefact& file : files) {
      file.path = (fs::path(program_.folder) / file.path).string();
      if (is_free(file.path)) continue;
      plan.in_the_way.push_back(in_the_way(file.path, module));
      return;
    }
    std::move(files.begin(), files.end(), std::back_inserter(plan.fresh));
  }

  void add_main(Plan& plan) const {
    const std::string path = (fs::path(program_.folder) / "main.cpp").string();
    if (!request_.main || !is_free(path)) return;
    std::vector<ModuleClass> modules;
    for (const WantedModule& module : wanted_.modules) {
      modules.push_back({module.class_name, module.stem + ".hpp"});
      for (const FoundClass& type : classes_) {
        const bool implements =
            std::find(type.interfaces.begin(), type.interfaces.end(), module.interface) != type.interfaces.end();
        if (implements)
          modules.back() = {type.name, fs::path(type.place.path).lexically_relative(program_.folder).generic_string()};
      }
    }
    plan.fresh.push_back({path, main_file(wanted_, modules).text});
  }

  Plan planned() {
    Merge merge = merged();
    Plan out{std::move(merge.sources), std::move(merge.insertions), std::move(merge.leftovers),
             std::move(merge.obstacles), std::move(stale_)};
    for (const std::size_t module : merge.fresh) add_first_files(wanted_.modules[module], out);
    for (const Remark& each : program_.unread) {
      const auto is_told = [&](const InTheWay& file) { return file.path == each.place.path; };
      if (std::none_of(out.in_the_way.begin(), out.in_the_way.end(), is_told)) out.leftovers.push_back(each);
    }
    add_main(out);
    return out;
  }

  /// Formats it with the user's .clang-format, if director-clang is available.
  Plan formatted_plan(Plan plan) {
    if (plan.is_empty() || !scanner_.version()) return plan;
    std::vector<FormatRequest> files;
    for (const Artefact& file : plan.fresh) files.push_back({file.path, file.text, {}});
    const std::vector<std::vector<Insertion>> by_file = stubs::by_file(plan.insertions);
    for (const std::vector<Insertion>& insertions : by_file) files.push_back({insertions[0].path, {}, insertions});
    const auto replacements = replacements_in(ask("format", to_json(files)));
    if (replacements.size() != files.size()) throw refused(misused, "director-clang has not formatted all files");

    for (std::size_t i = 0; i < plan.fresh.size(); ++i)
      if (!replacements[i].empty()) plan.fresh[i].text = replacements[i].front().text;
    plan.insertions.clear();
    for (std::size_t i = 0; i < by_file.size(); ++i) {
      const Applied applied = insert_into(program_.texts.at(by_file[i][0].path), by_file[i]);
      for (Insertion& each : formatted(by_file[i], applied, replacements[plan.fresh.size() + i]))
        plan.insertions.push_back(std::move(each));
    }
    return plan;
  }

  void print(const Plan& plan) {
    for (const Remark& each : plan.obstacles)
      print_message(console_, fmt::format("{}: error: {}\n", shown(each.place), each.message));
    for (const InTheWay& each : plan.in_the_way)
      print_message(console_,
                    fmt::format("{}: error: {}\n  help: {}\n", shown({each.path, 1, 1}), each.message, each.help));
    for (const Remark& each : plan.leftovers)
      print_message(console_, fmt::format("{}: warning: {}\n", shown(each.place), each.message));
    for (const Remark& each : plan.stale)
      print_message(console_, fmt::format("{}: warning: {}\n", shown(each.place), each.message));
  }

  /// Text of user files is escaped for a terminal; a program, such as `patch`, gets every byte.
  void print_diff(const Plan& plan) {
    const auto print = [&](const std::string& text) {
      console_.out << (console_.out_width == 0 ? text : dsl::harmless_code(text));
    };
    for (const Artefact& file : plan.fresh) print(diff_of_new(shown_path(file.path), file.text));
    for (const std::vector<Insertion>& each : stubs::by_file(plan.insertions))
      print(diff(shown_path(each[0].path), program_.texts.at(each[0].path), each));
  }

  void list(const Plan& plan, std::string_view fresh, std::string_view added) {
    for (const Artefact& file : plan.fresh)
      console_.out << fmt::format("{} {}\n", fresh, dsl::harmless(shown_path(file.path)));
    for (const std::vector<Insertion>& each : stubs::by_file(plan.insertions))
      console_.out << fmt::format("{} {}\n", added, dsl::harmless(shown_path(each[0].path)));
  }

  int carry_out(const Plan& plan) {
    print(plan);
    const int status = plan.obstacles.empty() && plan.in_the_way.empty() ? clean : compiler::cli::found;
    if (request_.check) {
      list(plan, "missing:", "to be added to:");
      return plan.is_empty() ? status : compiler::cli::found;
    }
    if (!plan.in_the_way.empty()) {
      if (!plan.is_empty()) print_message(console_, "directorc: nothing is written\n");
      return status;
    }
    if (request_.dry_run) {
      print_diff(plan);
      return status;
    }
    std::vector<Change> changes;
    for (const Artefact& file : plan.fresh) changes.push_back({file.path, {}, file.text});
    for (const std::vector<Insertion>& each : stubs::by_file(plan.insertions)) {
      const std::string& text = program_.texts.at(each[0].path);
      changes.push_back({each[0].path, text, insert_into(text, each).text});
    }
    if (const auto fault = console_.outputs.change(changes))
      throw refused(misused, fmt::format("nothing is written; cannot write {}", *fault));
    list(plan, "new:", "added to:");
    return status;
  }

  const Stubs& request_;
  const Wanted& wanted_;
  const dsl::Sources& sources_;
  const dsl::Spec& spec_;
  const Artefact header_, facts_;
  Console& console_;
  Scanner scanner_;
  Program program_;
  std::vector<FoundClass> classes_;
  std::vector<Remark> stale_;
};

} // namespace

int run(const Stubs& request, Console& console) {
  dsl::Sources sources;
  const std::optional<Checked> checked = load(request.file, only_errors(), sources, console, {});
  if (!checked) return misused;
  print_findings(checked->findings, sources, console.err, console.err_colours, console.err_width);
  if (dsl::has_errors(checked->findings)) return found;
  if (!checked->model.deployment) {
    print_message(console,
                  fmt::format("directorc: `{}` has no `roots`: what its modules are called is decided where they are "
                              "imported\n",
                              shown_path(request.file)));
    return misused;
  }
  const Lowered lowered = lower(checked->model);
  const Deployment deployment{sources, checked->model, lowered};
  return Run(request, wanted(deployment), deployment, checked->spec, console).run();
}

} // namespace director::compiler::cli
