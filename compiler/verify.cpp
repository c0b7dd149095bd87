// Header: compiler/verify.hpp. Test: tests/compiler/clang/faults_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/verify.hpp"

#include "compiler/base/absolute_path.hpp"
#include "compiler/base/version.hpp"
#include "compiler/checks/code_check.hpp"
#include "compiler/emit/artefact/notice.hpp"
#include "compiler/emit/cpp/cpp.hpp"
#include "compiler/facts/flags.hpp"
#include "compiler/facts/includes.hpp"
#include "compiler/facts/scanner.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/model/cpp_names.hpp"
#include "dsl/source/load_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace director::compiler {

namespace fs = std::filesystem;

namespace {

/// A file of the build, and the generated header that it would include.
struct Candidate {
  const CompileCommand* command = nullptr;
  Flags flags;
  std::string header; ///< path; empty: none is in its include folders
  bool scanned = false;
};

class Verifier {
public:
  Verifier(const Checked& checked, dsl::Sources& sources, VerifyWorld& world)
      : checked_(checked),
        sources_(sources),
        world_(world),
        scanner_(world.scanner, world.programs),
        compilers_(world.programs),
        includes_(world.files),
        cache_(world.store, world.files),
        code_files_(world.files, sources, world.shown),
        is_realtime_(std::any_of(checked.model.groups.begin(), checked.model.groups.end(),
                                 [](const Group& group) { return group.realtime; })) {}

  Verified run(const VerifyScope& scope) {
    if (!find_candidates(scope)) return std::move(out_);
    if (!compare_generated()) return std::move(out_);
    std::vector<Candidate*> wanted;
    for (Candidate& each : candidates_) {
      if (!each.header.empty()) wanted.push_back(&each);
    }
    while (!wanted.empty()) {
      if (!scan(wanted)) return std::move(out_);
      wanted = helpers(analysis::look_below(checked_.model, code_));
    }
    judge(scope.build);
    out_.depends.assign(depends_.begin(), depends_.end());
    return std::move(out_);
  }

private:
  bool fail(std::string fault) {
    out_.fault = std::move(fault);
    return false;
  }

  bool find_candidates(const VerifyScope& scope) {
    LoadedCommands loaded = load_compile_commands(scope.build, world_.files);
    if (!loaded.fault.empty()) return fail(std::move(loaded.fault));
    commands_ = std::move(loaded.commands);
    depends_.insert(absolute_path(loaded.path).lexically_normal().string());
    const std::string name = header_name(checked_.model.name);
    const fs::path only = scope.generated.empty() ? fs::path{} : whole(fs::path(scope.generated) / name);
    std::vector<fs::path> excluded;
    for (const std::string& each : scope.excluded) excluded.push_back(whole(each));
    std::vector<bool> met(excluded.size(), false);
    bool any = false;
    for (const CompileCommand& command : commands_) {
      if (is_excluded(command, excluded, met)) continue;
      Candidate each{&command, fit_for_clang(command), {}, false};
      const std::vector<std::string> folders = include_folders(each.flags.words, command.directory);
      for (const std::string& folder : folders) {
        const std::string header = (fs::path(folder) / name).string();
        if (!is_generated(header)) continue;
        each.header = header;
        break;
      }
      std::vector<std::string> begun = forced_includes(each.flags.words, command.directory);
      begun.push_back(command.file);
      for (const std::string& file : begun) {
        if (each.header.empty())
          each.header =
              includes_.find_named(file, folders, name, [&](const auto& header) { return is_generated(header); });
      }
      const bool is_other = !only.empty() && !each.header.empty() && whole(each.header) != only;
      const bool is_output =
          fs::path(command.file).parent_path() == fs::path(each.header).parent_path() && is_generated(command.file);
      if (is_other || is_output) each.header.clear();
      if (!each.header.empty()) depends_.insert(command.file); // it may include the header some day
      any = any || !each.header.empty();
      const bool may = std::any_of(begun.begin(), begun.end(), [&](const std::string& file) {
        return !each.header.empty() && includes_.may_include(file, folders, each.header);
      });
      if (!may && !each.header.empty()) note_unreadable(command.file);
      if (!may) each.header.clear();
      candidates_.push_back(std::move(each));
    }
    for (std::size_t i = 0; i < excluded.size(); ++i) {
      if (met[i]) continue;
      out_.remarks.push_back(fmt::format("`--exclude={}` leaves nothing out: no source of `{}` lies there, and none is "
                                         "compiled into it",
                                         scope.excluded[i], scope.build));
    }
    if (any) return true;
    return fail(
        fmt::format("no file of `{}`{} includes the generated `{}`, or has it in its include folders: has the program "
                    "been built?",
                    scope.build, excluded.empty() ? "" : " that is not excluded", name));
  }

  /// An unreadable file of the build may have bodies.
  void note_unreadable(const std::string& file) {
    const auto read = world_.files.read(file, dsl::largest_file, dsl::Kinds::ordinary);
    if (read || !unreadable_.insert(file).second) return;
    out_.not_decided.push_back(
        fmt::format("`{}`, a source of the build, cannot be read: {}; configure again if it is gone, "
                    "build if it is generated",
                    world_.shown(file), read.error().message));
  }

  static fs::path whole(const fs::path& path) {
    std::error_code fault; // one folder may have two names, by a symbolic link
    const fs::path canonical = fs::weakly_canonical(absolute_path(path), fault);
    const fs::path out = fault ? absolute_path(path).lexically_normal() : canonical;
    return out.has_filename() ? out : out.parent_path(); // "tests/" is tests
  }

  static bool lies_in(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
  }

  /// By its source or its output: CMake compiles a target into a folder of its own.
  static bool is_excluded(const CompileCommand& command, const std::vector<fs::path>& excluded,
                          std::vector<bool>& met) {
    if (excluded.empty()) return false;
    const fs::path output = command.output.empty() ? fs::path{} : whole(fs::path(command.directory) / command.output);
    const fs::path file = whole(command.file);
    bool out = false;
    for (std::size_t i = 0; i < excluded.size(); ++i) {
      const bool here = lies_in(file, excluded[i]) || (!output.empty() && lies_in(output, excluded[i]));
      met[i] = met[i] || here;
      out = out || here;
    }
    return out;
  }

  bool is_generated(const std::string& header) {
    const auto at = headers_.find(header);
    if (at != headers_.end()) return !at->second.empty();
    const auto text = world_.files.read(header, dsl::largest_file, dsl::Kinds::ordinary);
    const bool ours = text && has_notice(text.value());
    return !headers_.emplace(header, ours ? text.value() : std::string{}).first->second.empty();
  }

  /// False: the generated files are outdated, and all findings that follow would be useless.
  bool compare_generated() {
    const Lowered lowered = lower(checked_.model);
    const Deployment deployment{sources_, checked_.model, lowered};
    const std::string expected = header(deployment).text(), expected_facts = facts(deployment).text();
    std::set<std::string> reported;
    bool all_fresh = true;
    for (const Candidate& each : candidates_) {
      if (each.header.empty() || !reported.insert(each.header).second) continue;
      const auto found =
          world_.files.read(fs::path(each.header).replace_filename(facts_name(checked_.model.name)).string(),
                            dsl::largest_file, dsl::Kinds::ordinary);
      const bool fresh = headers_[each.header] == expected && found && found.value() == expected_facts;
      all_fresh = all_fresh && fresh;
      if (!fresh) code_.headers.push_back({code_files_.of(each.header), false});
    }
    if (!all_fresh) out_.findings = checks::run_code_checks(analysis::look_below(checked_.model, code_));
    return all_fresh;
  }

  bool scan(const std::vector<Candidate*>& wanted) {
    const Scan version = scanner_.version();
    if (!version) return fail(version.error().message);
    std::vector<std::string> questions;
    Json units = Json::list({});
    std::vector<Json> answers(wanted.size());
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      wanted[i]->scanned = true;
      Json unit = unit_of(*wanted[i]);
      questions.push_back(to_line(Json::object({{"unit", unit},
                                                {"namespace", Json::text(checked_.model.name_space)},
                                                {"format", Json::number(facts_format)},
                                                {"director", Json::text(compiler::version())},
                                                {"clang", version.value()["clang"]}})));
      if (std::optional<Json> known = cache_.recall(questions.back())) {
        answers[i] = std::move(*known);
      } else {
        units.add(std::move(unit));
        missing.push_back(i);
      }
    }
    if (!missing.empty()) {
      const Scan answer = scanner_.ask(
          "facts", Json::object({{"units", std::move(units)}, {"namespace", Json::text(checked_.model.name_space)}}));
      if (!answer) return fail(answer.error().message);
      const std::vector<Json>& scanned = answer.value()["units"].items();
      if (scanned.size() != missing.size()) return fail("director-clang left out some files");
      for (std::size_t i = 0; i < missing.size(); ++i) {
        cache_.keep(questions[missing[i]], scanned[i]);
        answers[missing[i]] = scanned[i];
      }
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      ++out_.files;
      add_unit(code_, answers[i], code_files_);
      for (const Json& file : answers[i]["files"].items()) {
        const bool system = file.items().size() == 2 && file.items()[1].as_boolean();
        if (!system) depends_.insert(fs::path(file.items()[0].as_text()).lexically_normal().string());
      }
      note_errors(*wanted[i], answers[i]);
    }
    return true;
  }

  Json unit_of(const Candidate& candidate) {
    Json out =
        unit_question(candidate.command->file, candidate.command->directory, compilers_.complete(candidate.flags));
    if (is_realtime_) out.add("deep", Json::boolean(true));
    return out;
  }

  void note_errors(const Candidate& candidate, const Json& answer) {
    const std::vector<Json>& errors = answer["errors"].items();
    if (errors.empty()) return;
    const Json& first = errors.front();
    const std::string& path = first["file"].as_text();
    const std::string place = path.empty() ? world_.shown(candidate.command->file)
                                           : fmt::format("{}:{}:{}", world_.shown(path), first["line"].as_number(),
                                                         first["column"].as_number());
    const std::string more = errors.size() > 1 ? fmt::format(", and {} more", errors.size() - 1) : "";
    out_.not_decided.push_back(fmt::format("Clang does not understand all of `{}`: {}: {}{}",
                                           world_.shown(candidate.command->file), place, first["message"].as_text(),
                                           more));
  }

  /// Files that may have the bodies of relevant functions: with the name of the header that declares them.
  std::vector<Candidate*> helpers(const analysis::CodeInput& input) {
    std::set<std::string> stems;
    for (const analysis::Body& body : input.bodies) {
      const bool realtime = checked_.model.groups[body.of.group].realtime;
      for (const analysis::Unseen& each : body.unseen) {
        if (!each.declared_in.empty() && (each.carries || realtime))
          stems.insert(fs::path(each.declared_in).stem().string());
      }
    }
    std::vector<Candidate*> out;
    std::set<std::string> files;
    for (Candidate& each : candidates_) {
      const fs::path file = each.command->file;
      if (each.scanned || stems.count(file.stem().string()) == 0 || !files.insert(file.string()).second) continue;
      out.push_back(&each);
    }
    return out;
  }

  void judge(const std::string& build) {
    const analysis::CodeInput input = analysis::look_below(checked_.model, code_);
    out_.findings = checks::run_code_checks(input);
    std::set<std::string> seen;
    for (const analysis::Body& body : input.bodies) {
      seen.insert(body.function->context);
      note_unseen(body);
      if (body.is_unwritten()) out_.unwritten.push_back(analysis::name_of(checked_.model, body.of));
    }
    out_.bodies = input.names.contexts.size();
    out_.seen = seen.size();
    // If there are classes, the build is the right one, and findings report what is missing.
    if (seen.empty() && code_.classes.empty() && !code_.has_templates) {
      if (out_.files == 0) {
        fail(fmt::format("no file that `{}` lists includes the generated `{}`: is the target with the bodies in it? "
                         "With CMake, set `CMAKE_EXPORT_COMPILE_COMMANDS` for all targets",
                         build, header_name(checked_.model.name)));
        return;
      }
      fail(fmt::format("no body of `{}` was found in the {} of `{}` that could have one", checked_.model.name,
                       out_.files == 1 ? "file" : fmt::format("{} files", out_.files), build));
      return;
    }
    std::vector<std::string> missing;
    for (const auto& [context, of] : input.names.contexts) {
      if (seen.count(context) == 0) missing.push_back(analysis::name_of(checked_.model, of));
    }
    if (!missing.empty()) out_.not_decided.push_back(fmt::format("no body was found for {}", fmt::join(missing, ", ")));
  }

  void note_unseen(const analysis::Body& body) {
    const bool realtime = checked_.model.groups[body.of.group].realtime;
    std::set<std::string> reported;
    for (const analysis::Unseen& each : body.unseen) {
      if ((!each.carries && !realtime) || !reported.insert(each.what).second) continue;
      const dsl::SourceFile& file = sources_[each.span.file];
      const dsl::Place place = file.place(each.span.begin);
      std::string line = fmt::format("{}: it is not known {}: {}:{}:{}: {}", analysis::name_of(checked_.model, body.of),
                                     each.carries ? "what else it may request" : "whether it blocks", file.path(),
                                     place.line, place.column, each.what);
      std::vector<std::string>& all = out_.not_decided; // instances of a template say the same
      if (std::find(all.begin(), all.end(), line) == all.end()) all.push_back(std::move(line));
    }
  }

  const Checked& checked_;
  dsl::Sources& sources_;
  VerifyWorld& world_;
  Scanner scanner_;
  Compilers compilers_;
  Includes includes_;
  FactCache cache_;
  CodeFiles code_files_;
  bool is_realtime_; ///< so that blocking calls matter
  std::vector<CompileCommand> commands_;
  std::vector<Candidate> candidates_;
  std::map<std::string, std::string> headers_; ///< path -> text; empty: it is not generated
  std::set<std::string> unreadable_, depends_;
  CodeFacts code_;
  Verified out_;
};

} // namespace

Verified verify(const Checked& checked, dsl::Sources& sources, const VerifyScope& scope, VerifyWorld& world) {
  return Verifier(checked, sources, world).run(scope);
}

} // namespace director::compiler
