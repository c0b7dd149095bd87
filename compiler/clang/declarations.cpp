// Header: compiler/clang/subcommands.hpp. Test: tests/compiler/clang/stubs/orders_test.cpp.
// SPDX-License-Identifier: MIT
//
// Finds the classes of a program that implement the modules of a behaviour. Function bodies are skipped: errors in them
// do not matter here. The generated header may be newer than the program, so semantic errors do not count (an interface
// or a context that is gone, an override of nothing); only syntax errors are reported, because what follows them cannot
// be trusted. Also a class, or the behaviour itself, that is not declared where a body of it is defined: an #include is
// missing there, and what follows would count as missing.
#include "compiler/clang/implementers.hpp"
#include "compiler/clang/parse/invoke.hpp"
#include "compiler/clang/parse/user_text.hpp"
#include "compiler/clang/subcommands.hpp"
#include "compiler/emit/artefact/notice.hpp"

#include <clang/Basic/DiagnosticParse.h>
#include <clang/Basic/DiagnosticSema.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendAction.h>
#include <clang/Lex/Lexer.h>
#include <llvm/Support/Path.h>

#include <algorithm>
#include <tuple>

namespace director::scanning {

namespace {

constexpr const char* virtual_folder = "/director-stubs"; ///< of the generated header, which need not exist on the disk

/// Whether the error makes the meaning of the text uncertain. A missing base of a class does not.
bool is_fatal(const clang::Diagnostic& fault) {
  if (fault.getID() == clang::diag::err_expected_class_name) return false;
  const unsigned category = clang::DiagnosticIDs::getCategoryNumberForDiag(fault.getID());
  const llvm::StringRef name = clang::DiagnosticIDs::getCategoryNameFromID(category);
  return name == "Parse Issue" || name == "Lexical or Preprocessor Issue" || fault.getLocation().isInvalid();
}

/// A name before `::` that is not declared there.
struct Unknown {
  std::string name, scope; ///< in which it is searched; empty: in all enclosing ones
  Json row;                ///< its place
  bool is_ambiguous = false;
};

/// The words that a message quotes.
std::vector<std::string> quoted(llvm::StringRef message) {
  std::vector<std::string> out;
  for (auto [before, rest] = message.split('\''); !rest.empty(); std::tie(before, rest) = rest.split('\'')) {
    out.push_back(rest.split('\'').first.str());
    rest = rest.split('\'').second;
  }
  return out;
}

/// Keeps fatal errors, and the names before `::` that are not declared.
class FatalFaults final : public clang::DiagnosticConsumer {
public:
  explicit FatalFaults(std::string path) : path_(std::move(path)) {}

  void HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& fault) override {
    clang::DiagnosticConsumer::HandleDiagnostic(level, fault);
    if (level < clang::DiagnosticsEngine::Error) return;
    llvm::SmallString<256> message;
    fault.FormatDiagnostic(message);
    if (level != clang::DiagnosticsEngine::Fatal && !is_fatal(fault)) return note_unknown(fault, message);
    const bool has_place = fault.hasSourceManager() && fault.getLocation().isValid();
    if (!has_place) of_command_line.push_back(message.str().str());
    // An error in the command line is reported at the first line of the file.
    Json row =
        has_place ? row_at(fault.getSourceManager(), fault.getLocation())
                  : Json::object({{"path", Json::text(path_)}, {"line", Json::number(1)}, {"column", Json::number(1)}});
    row.add("message", Json::text(message.str().str()));
    problems.try_emplace(has_place ? place_of(fault.getSourceManager(), fault.getLocation())
                                   : Findings::Place{path_, 0},
                         std::move(row));
  }

  std::map<Findings::Place, Json> problems;
  std::vector<std::string> of_command_line;
  std::map<Findings::Place, Unknown> unknown;

private:
  void note_unknown(const clang::Diagnostic& fault, llvm::StringRef message) {
    namespace diag = clang::diag;
    const unsigned id = fault.getID();
    const bool is_ambiguous = id == diag::err_ambiguous_reference;
    if (id != diag::err_undeclared_var_use && id != diag::err_no_member && !is_ambiguous) return;
    const clang::SourceManager& sources = fault.getSourceManager();
    clang::LangOptions language;
    language.CPlusPlus = true;
    const auto next = clang::Lexer::findNextToken(fault.getLocation(), sources, language);
    if (!next || next->isNot(clang::tok::coloncolon)) return;
    const std::vector<std::string> words = quoted(message);
    if (words.empty()) return;
    unknown.try_emplace(place_of(sources, fault.getLocation()),
                        Unknown{words[0], words.size() > 1 ? words[1] : std::string{},
                                row_at(sources, fault.getLocation()), is_ambiguous});
  }

  std::string path_;
};

class FindImplementers final : public clang::ASTFrontendAction {
public:
  FindImplementers(Findings& out, const std::set<std::string>& interfaces, const std::string& header)
      : out_(out),
        interfaces_(interfaces),
        header_(header) {}

  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance& compiler, llvm::StringRef) override {
    compiler.getFrontendOpts().SkipFunctionBodies = true;
    watch(compiler.getPreprocessor(), structure_);
    return find_implementers(out_, interfaces_, header_, structure_, compiler);
  }

private:
  Findings& out_;
  const std::set<std::string>& interfaces_;
  const std::string& header_;
  Structure structure_;
};

/// The path of a generated file that need not exist on the disk.
std::string in_memory(const Json& file) { return std::string(virtual_folder) + "/" + file["path"].as_text(); }

/// The folders of the files of the request.
std::set<std::string> folders_of(const Json& request) {
  std::set<std::string> out;
  for (const char* key : {"units", "fresh", "insertions"}) {
    for (const Json& each : request[key].items())
      out.insert(llvm::sys::path::parent_path(each["path"].as_text()).str());
  }
  return out;
}

bool is_generated(llvm::vfs::FileSystem& disk, const std::string& path) {
  const auto text = disk.getBufferForFile(path);
  return text && compiler::has_notice((*text)->getBuffer());
}

/// The disk, with the header and its facts, the insertions and the new files of the request.
Files files_of(const Json& request, const std::string& header) {
  auto memory = llvm::makeIntrusiveRefCnt<llvm::vfs::InMemoryFileSystem>();
  const auto add = [&](const std::string& path, const std::string& text) {
    memory->addFile(path, 0, llvm::MemoryBuffer::getMemBufferCopy(text, path));
  };
  add(header, request["header"]["text"].as_text());
  add(in_memory(request["facts"]), request["facts"]["text"].as_text());
  // What was generated before, beside the user's files, is found first by an #include in quotes.
  const Files disk = ordinary_files();
  for (const std::string& folder : folders_of(request)) {
    for (const char* key : {"header", "facts"}) {
      const std::string path = folder + "/" + request[key]["path"].as_text();
      if (is_generated(*disk, path)) add(path, request[key]["text"].as_text());
    }
  }
  for (const Json& file : request["fresh"].items()) add(file["path"].as_text(), file["text"].as_text());
  const std::vector<compiler::stubs::Insertion> insertions = insertions_in(request["insertions"]);
  for (auto begin = insertions.begin(); begin != insertions.end();) {
    const auto end = std::find_if(begin, insertions.end(), [&](const auto& each) { return each.path != begin->path; });
    add(begin->path, user_text(begin->path, {begin, end}).text);
    begin = end;
  }
  auto out = llvm::makeIntrusiveRefCnt<llvm::vfs::OverlayFileSystem>(disk);
  out->pushOverlay(memory);
  return out;
}

Json list(const std::map<Findings::Place, Json>& rows) {
  Json out = Json::list({});
  for (const auto& [place, row] : rows) out.add(row);
  return out;
}

/// The names around the last one.
llvm::StringRef scope_of(llvm::StringRef name) { return name.substr(0, name.rfind("::")); }

void add_parts(llvm::StringRef name, std::set<std::string>& out) {
  for (; !name.empty(); name = name.split("::").second) out.insert(name.split("::").first.str());
}

/// Reports those unknown or ambiguous names that the bodies are qualified with: the behaviour's namespace, and names of
/// module classes; each once in a file. A name that the behaviour has no more is unknown within its namespace, and no
/// fault.
void report_unknown(const std::map<Findings::Place, Unknown>& unknown, const std::set<std::string>& interfaces,
                    Findings& out) {
  std::set<std::string> names, scopes;
  std::set<std::pair<std::string, std::string>> reported;
  for (const std::string& each : interfaces) {
    scopes.insert(scope_of(each).str());
    add_parts(scope_of(each), names);
  }
  for (const auto& [place, row] : out.classes) add_parts(row["name"].as_text(), names);
  for (const auto& [place, each] : unknown) {
    const bool within = std::any_of(scopes.begin(), scopes.end(), [&](const std::string& scope) {
      return each.scope == scope || each.scope.starts_with(scope + "::");
    });
    if (within || names.count(each.name) == 0 || !reported.emplace(place.first, each.name).second) continue;
    Json row = each.row;
    row.add("message",
            Json::text("`" + each.name +
                       (each.is_ambiguous ? "` is ambiguous here: write its namespace, as in `::" + each.name + "`"
                                          : "` is not declared here: an `#include` is missing")));
    out.problems.try_emplace(place, std::move(row));
  }
}

/// False: Clang does not start with such flags, and has not reported why.
bool read_unit(const Json& unit, Findings& out, std::map<Findings::Place, Unknown>& unknown,
               const std::set<std::string>& interfaces, const std::string& header, const Files& files,
               Frontend& frontend) {
  const std::string& path = unit["path"].as_text();
  std::vector<std::string> flags = unit["flags"].as_texts();
  flags.insert(flags.begin(), {std::string("-I") + virtual_folder, "-fno-spell-checking"});
  for (;;) {
    FatalFaults faults(path);
    FindImplementers action(out, interfaces, header);
    const bool understood = frontend.run({path, unit["directory"].as_text(), flags}, files, action, faults);
    if (drop_unknown(flags, faults.of_command_line)) continue;
    out.problems.merge(faults.problems);
    unknown.merge(faults.unknown);
    return understood || faults.getNumErrors() > 0;
  }
}

Json answer(const Json& request, Frontend& frontend) {
  Findings out;
  std::map<Findings::Place, Unknown> unknown;
  const std::vector<std::string> names = request["interfaces"].as_texts();
  const std::set<std::string> interfaces(names.begin(), names.end());
  const std::string header = in_memory(request["header"]);
  const Files files = files_of(request, header);
  for (const Json& unit : request["units"].items()) {
    const std::string& path = unit["path"].as_text();
    if (unit["only_unseen"].as_boolean() && out.seen.count(path) > 0) continue;
    if (!read_unit(unit, out, unknown, interfaces, header, files, frontend))
      return Json::object({{"error", Json::text("`" + path + "` cannot be read with these flags")}});
  }
  report_unknown(unknown, interfaces, out);
  return Json::object(
      {{"classes", list(out.classes)}, {"functions", list(out.functions)}, {"problems", list(out.problems)}});
}

} // namespace

Json read_declarations(const Json& request) {
  Frontend frontend;
  if (!request["requests"].is_list()) return answer(request, frontend);
  Json answers = Json::list({}); // many at once: starting this program costs more than reading a small file
  for (const Json& each : request["requests"].items()) answers.add(answer(each, frontend));
  return Json::object({{"answers", std::move(answers)}});
}

} // namespace director::scanning
