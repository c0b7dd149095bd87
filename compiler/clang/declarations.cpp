// Door: compiler/clang/subcommands.hpp. Test: tests/clang/stubs/orders_test.cpp.
//
// Which classes of a program implement the modules of a behaviour, and where. Function bodies are skipped: they are the
// user's affair, and what is wrong in them is not asked. The generated header may be newer than the program, so errors
// of meaning do not count (an interface or a context that is gone, an override of nothing); only what cannot be parsed
// is told, because then nothing that stands behind it can be trusted.
#include "compiler/clang/subcommands.hpp"
#include "compiler/clang/user_text.hpp"

#include <clang/AST/ASTConsumer.h>
#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclCXX.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/Basic/DiagnosticParse.h>
#include <clang/Basic/DiagnosticSema.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendAction.h>
#include <clang/Frontend/Utils.h>
#include <clang/Lex/Lexer.h>
#include <clang/Lex/PPCallbacks.h>
#include <clang/Lex/Preprocessor.h>
#include <llvm/Support/VirtualFileSystem.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace director::scanning {

namespace {

namespace fs = std::filesystem;
using clang::SourceLocation;

constexpr const char* virtual_folder = "/director-stubs";

Json number(std::uint64_t value) { return Json::number(static_cast<std::int64_t>(value)); }

Json texts(const std::set<std::string>& words) { return Json::texts({words.begin(), words.end()}); }

std::string canonical(clang::FileEntryRef file) {
  std::error_code fault;
  const llvm::StringRef real = file.getFileEntry().tryGetRealPathName();
  return fs::weakly_canonical(real.empty() ? file.getName().str() : real.str(), fault).string();
}

/// What is known after some units. A place that several units see counts once.
struct Findings {
  using Place = std::pair<std::string, std::uint64_t>;
  std::map<Place, Json> classes, functions, problems;
  std::set<std::string> seen; ///< files, by their canonical paths

  static Json list(const std::map<Place, Json>& rows) {
    Json out = Json::list({});
    for (const auto& [place, row] : rows) out.add(row);
    return out;
  }
};

/// A pair of braces, or one that is still open.
struct Braces {
  SourceLocation close;
  bool in_macro = false;
};

/// Beginnings and ends of what stands under one #if, #elif or #else, per file.
struct Region {
  unsigned begin = 0, end = ~0U;
};

/// What the tokens of a unit say that its tree does not, because bodies are skipped.
struct Structure {
  std::map<SourceLocation, Braces> braces; ///< by where the first one expands
  std::vector<SourceLocation> open;
  std::map<clang::FileID, std::vector<Region>> regions;
  std::map<clang::FileID, std::vector<std::size_t>> entered;
};

class Conditionals final : public clang::PPCallbacks {
public:
  Conditionals(Structure& structure, const clang::SourceManager& sources) : structure_(structure), sources_(sources) {}
  void If(SourceLocation at, clang::SourceRange, ConditionValueKind) override { enter(at); }
  void Ifdef(SourceLocation at, const clang::Token&, const clang::MacroDefinition&) override { enter(at); }
  void Ifndef(SourceLocation at, const clang::Token&, const clang::MacroDefinition&) override { enter(at); }
  void Elif(SourceLocation at, clang::SourceRange, ConditionValueKind, SourceLocation) override { next(at); }
  void Elifdef(SourceLocation at, const clang::Token&, const clang::MacroDefinition&) override { next(at); }
  void Elifdef(SourceLocation at, clang::SourceRange, SourceLocation) override { next(at); }
  void Elifndef(SourceLocation at, const clang::Token&, const clang::MacroDefinition&) override { next(at); }
  void Elifndef(SourceLocation at, clang::SourceRange, SourceLocation) override { next(at); }
  void Else(SourceLocation at, SourceLocation) override { next(at); }
  void Endif(SourceLocation at, SourceLocation) override { leave(at); }

private:
  void enter(SourceLocation at) {
    const auto [file, offset] = sources_.getDecomposedLoc(at);
    structure_.entered[file].push_back(structure_.regions[file].size());
    structure_.regions[file].push_back({offset, ~0U});
  }
  void leave(SourceLocation at) {
    const auto [file, offset] = sources_.getDecomposedLoc(at);
    std::vector<std::size_t>& entered = structure_.entered[file];
    if (entered.empty()) return;
    structure_.regions[file][entered.back()].end = offset;
    entered.pop_back();
  }
  void next(SourceLocation at) {
    leave(at);
    enter(at);
  }

  Structure& structure_;
  const clang::SourceManager& sources_;
};

class Reader final : public clang::ASTConsumer {
public:
  Reader(Findings& out, const std::set<std::string>& interfaces, const std::string& header, Structure& structure,
         clang::CompilerInstance& compiler)
      : out_(out),
        interfaces_(interfaces),
        header_(header),
        structure_(structure),
        compiler_(compiler),
        sources_(compiler.getSourceManager()) {}

  void HandleTranslationUnit(clang::ASTContext& context) override {
    for (auto file = sources_.fileinfo_begin(); file != sources_.fileinfo_end(); ++file)
      out_.seen.insert(canonical(file->first));
    for (const SourceLocation at : structure_.open) problem(sources_.getExpansionLoc(at), "this brace is never closed");
    walk(*context.getTranslationUnitDecl());
  }

  void problem(SourceLocation at, const std::string& message) {
    const auto [path, offset] = place(at);
    Json row = row_at(at);
    row.add("message", Json::text(message));
    out_.problems.try_emplace({path, offset}, std::move(row));
  }

private:
  std::pair<std::string, unsigned> place(SourceLocation at) const {
    const auto [file, offset] = sources_.getDecomposedExpansionLoc(at);
    const clang::OptionalFileEntryRef entry = sources_.getFileEntryRefForID(file);
    return {entry ? canonical(*entry) : std::string{}, offset};
  }

  Json row_at(SourceLocation at) const {
    return Json::object({{"path", Json::text(place(at).first)},
                         {"line", number(sources_.getExpansionLineNumber(at))},
                         {"column", number(sources_.getExpansionColumnNumber(at))}});
  }

  bool is_users(SourceLocation at) const {
    if (at.isInvalid()) return false;
    const SourceLocation where = sources_.getExpansionLoc(at);
    return !sources_.isInSystemHeader(where) && place(where).first != header_;
  }

  std::int64_t inside(SourceLocation at) const {
    const auto [file, offset] = sources_.getDecomposedExpansionLoc(at);
    const auto regions = structure_.regions.find(file);
    std::int64_t innermost = -1;
    if (regions == structure_.regions.end()) return innermost;
    for (const Region& region : regions->second)
      if (region.begin <= offset && offset < region.end) innermost = region.begin;
    return innermost;
  }

  std::string text(SourceLocation begin, SourceLocation end) const {
    if (begin.isMacroID() || end.isMacroID() || begin.isInvalid() || end.isInvalid()) return {};
    const auto range = clang::CharSourceRange::getCharRange(begin, end);
    return clang::Lexer::getSourceText(range, sources_, compiler_.getLangOpts()).str();
  }

  SourceLocation behind_token(SourceLocation at) const {
    return clang::Lexer::getLocForEndOfToken(at, 0, sources_, compiler_.getLangOpts());
  }

  void walk(const clang::DeclContext& context) {
    for (const clang::Decl* decl : context.decls()) {
      if (decl->isImplicit() || !is_users(decl->getLocation())) {
        // What another header opens, the user's may go on in: only namespaces are looked through.
        if (!llvm::isa<clang::LinkageSpecDecl>(decl)) continue;
      }
      if (const auto* name_space = llvm::dyn_cast<clang::NamespaceDecl>(decl)) walk(*name_space);
      if (const auto* linkage = llvm::dyn_cast<clang::LinkageSpecDecl>(decl)) walk(*linkage);
      if (const auto* type_template = llvm::dyn_cast<clang::ClassTemplateDecl>(decl))
        read(*type_template->getTemplatedDecl());
      if (const auto* type = llvm::dyn_cast<clang::CXXRecordDecl>(decl)) read(*type);
      if (const auto* function = llvm::dyn_cast<clang::CXXMethodDecl>(decl)) read(*function);
    }
  }

  void read(const clang::CXXRecordDecl& type) {
    if (!type.isThisDeclarationADefinition()) return;
    std::set<std::string> interfaces, bases;
    look_up(type, interfaces, bases);
    const SourceLocation end = type.getBraceRange().getEnd();
    if (!interfaces.empty() && end.isValid()) {
      const auto [path, offset] = place(type.getLocation());
      Json row = row_at(type.getLocation());
      row.add("name", Json::text(type.getQualifiedNameAsString()));
      row.add("interfaces", texts(interfaces));
      row.add("bases", texts(bases));
      row.add("end", number(place(end).second));
      row.add("inside", Json::number(inside(end)));
      row.add("public", Json::boolean(access_at_end(type) == clang::AS_public));
      row.add("macro", Json::boolean(end.isMacroID()));
      row.add("only_inline", Json::boolean(type.isDependentContext() || type.isLocalClass() != nullptr));
      out_.classes.try_emplace({path, offset}, std::move(row));
    }
    walk(type);
  }

  void look_up(const clang::CXXRecordDecl& type, std::set<std::string>& interfaces, std::set<std::string>& bases) {
    for (const clang::CXXBaseSpecifier& specifier : type.bases()) {
      const clang::CXXRecordDecl* base = specifier.getType()->getAsCXXRecordDecl();
      if (base == nullptr || !base->hasDefinition()) continue;
      base = base->getDefinition();
      const std::string name = base->getQualifiedNameAsString();
      if (interfaces_.count(name) > 0) {
        interfaces.insert(name);
      } else if (is_users(base->getLocation()) && bases.insert(name).second) {
        look_up(*base, interfaces, bases);
      }
    }
  }

  static clang::AccessSpecifier access_at_end(const clang::CXXRecordDecl& type) {
    clang::AccessSpecifier out = type.isClass() ? clang::AS_private : clang::AS_public;
    for (const clang::Decl* decl : type.decls())
      if (const auto* label = llvm::dyn_cast<clang::AccessSpecDecl>(decl)) out = label->getAccess();
    return out;
  }

  /// `provide`, `start` or `stop` with one parameter; what else a class has is not asked.
  void read(const clang::CXXMethodDecl& function) {
    const clang::IdentifierInfo* const name = function.getIdentifier();
    const clang::FunctionTypeLoc type = function.getFunctionTypeLoc();
    if (name == nullptr || function.getNumParams() != 1 || !type) return;
    if (!name->isStr("provide") && !name->isStr("start") && !name->isStr("stop")) return;

    const bool body = function.isThisDeclarationADefinition() && !function.isDeleted() && !function.isDefaulted();
    const bool within = !function.isOutOfLine();
    const End end = body ? end_of_body(type.getRParenLoc()) : end_of_declaration(type.getRParenLoc());
    const SourceLocation begin = function.getBeginLoc(), at = function.getLocation();
    const clang::ParmVarDecl& parameter = *function.getParamDecl(0);
    const bool known = !parameter.isInvalidDecl();

    Json row = row_at(at);
    row.add("class", Json::text(function.getParent()->getQualifiedNameAsString()));
    row.add("name", Json::text(name->getName().str()));
    row.add("context", Json::text(known ? context_of(parameter) : written(type)));
    row.add("begin", number(place(begin).second));
    row.add("end", number(end.offset));
    row.add("inside", Json::number(end.inside));
    row.add("known", Json::boolean(known));
    row.add("within", Json::boolean(within));
    row.add("defines", Json::boolean(body || function.isPureVirtual() || function.isDeleted()));
    row.add("overrides", Json::boolean(says_override(type.getRParenLoc())));
    row.add("macro", Json::boolean(begin.isMacroID() || at.isMacroID() || end.in_macro));
    row.add("inline", Json::boolean(!within && function.isInlineSpecified()));
    row.add("result", Json::text(result_of(function)));
    row.add("qualifier",
            Json::text(within ? std::string{} : one_line(text(function.getQualifierLoc().getBeginLoc(), at))));
    const auto [path, offset] = place(at);
    out_.functions.try_emplace({path, offset}, std::move(row));
  }

  struct End {
    unsigned offset = 0;
    std::int64_t inside = -1;
    bool in_macro = true;
  };

  End end_at(SourceLocation last) const {
    if (last.isInvalid() || last.isMacroID()) return {};
    const SourceLocation end = behind_token(last);
    return {place(end).second, inside(last), false};
  }

  /// A body begins with the first brace behind the parameters; a function-try-block goes on with its handlers.
  End end_of_body(SourceLocation parameters) const {
    if (parameters.isInvalid() || parameters.isMacroID()) return {};
    auto pair = structure_.braces.upper_bound(parameters);
    while (pair != structure_.braces.end()) {
      if (pair->second.in_macro || pair->second.close.isInvalid()) return {};
      const auto next = clang::Lexer::findNextToken(pair->second.close, sources_, compiler_.getLangOpts());
      const bool handles = next && next->is(clang::tok::raw_identifier) && next->getRawIdentifier() == "catch";
      if (!handles) return end_at(pair->second.close);
      pair = structure_.braces.upper_bound(pair->second.close);
    }
    return {};
  }

  /// Clang forgets the word where there is nothing to override, as when the interface is gone.
  bool says_override(SourceLocation parameters) const {
    if (parameters.isInvalid() || parameters.isMacroID()) return false;
    auto next = clang::Lexer::findNextToken(parameters, sources_, compiler_.getLangOpts());
    while (next && !next->isOneOf(clang::tok::eof, clang::tok::semi, clang::tok::l_brace, clang::tok::r_brace)) {
      if (next->is(clang::tok::raw_identifier) && next->getRawIdentifier() == "override") return true;
      next = clang::Lexer::findNextToken(next->getLocation(), sources_, compiler_.getLangOpts());
    }
    return false;
  }

  End end_of_declaration(SourceLocation parameters) const {
    if (parameters.isInvalid() || parameters.isMacroID()) return {};
    SourceLocation at = parameters;
    while (true) {
      const auto next = clang::Lexer::findNextToken(at, sources_, compiler_.getLangOpts());
      if (!next || next->isOneOf(clang::tok::eof, clang::tok::l_brace, clang::tok::r_brace)) return {};
      at = next->getLocation();
      if (next->is(clang::tok::semi)) return end_at(at);
    }
  }

  static std::string context_of(const clang::ParmVarDecl& parameter) {
    const clang::QualType type = parameter.getType().getNonReferenceType().getCanonicalType().getUnqualifiedType();
    if (const clang::CXXRecordDecl* const record = type->getAsCXXRecordDecl())
      return record->getQualifiedNameAsString();
    return type.getAsString();
  }

  /// The parameter's type as it stands there: `soccer::Walk::Halting`.
  std::string written(const clang::FunctionTypeLoc& type) const {
    std::string out = text(behind_token(type.getLParenLoc()), type.getRParenLoc());
    out = out.substr(0, out.find_first_of("&,"));
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    out.erase(std::remove_if(out.begin(), out.end(), is_blank), out.end());
    return out;
  }

  static std::string one_line(const std::string& text) {
    return text.find('\n') == std::string::npos ? text : std::string{};
  }

  /// As the user calls director::Outcome there.
  std::string result_of(const clang::CXXMethodDecl& function) const {
    const clang::CXXRecordDecl* const record = function.getReturnType()->getAsCXXRecordDecl();
    const auto* const type = function.getType()->getAs<clang::FunctionProtoType>();
    if (record == nullptr || record->getQualifiedNameAsString() != "director::Outcome") return {};
    if (type == nullptr || type->hasTrailingReturn()) return {};
    const clang::SourceRange range = function.getReturnTypeSourceRange();
    if (range.isInvalid() || range.getEnd().isMacroID()) return {};
    return one_line(text(range.getBegin(), behind_token(range.getEnd())));
  }

  Findings& out_;
  const std::set<std::string>& interfaces_;
  const std::string& header_;
  Structure& structure_;
  clang::CompilerInstance& compiler_;
  const clang::SourceManager& sources_;
};

/// Errors that leave it open what the text means. That a class has a base which is gone is none.
bool is_fatal(const clang::Diagnostic& fault) {
  if (fault.getID() == clang::diag::err_expected_class_name) return false;
  const unsigned category = clang::DiagnosticIDs::getCategoryNumberForDiag(fault.getID());
  const llvm::StringRef name = clang::DiagnosticIDs::getCategoryNameFromID(category);
  return name == "Parse Issue" || name == "Lexical or Preprocessor Issue" || fault.getLocation().isInvalid();
}

class Faults final : public clang::DiagnosticConsumer {
public:
  Faults(Findings& out, std::string path) : out_(out), path_(std::move(path)) {}

  void HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& fault) override {
    clang::DiagnosticConsumer::HandleDiagnostic(level, fault);
    if (level < clang::DiagnosticsEngine::Error) return;
    if (level != clang::DiagnosticsEngine::Fatal && !is_fatal(fault)) return;
    llvm::SmallString<256> message;
    fault.FormatDiagnostic(message);
    std::string path = path_;
    unsigned line = 1, column = 1, offset = 0;
    if (fault.hasSourceManager() && fault.getLocation().isValid()) {
      const clang::SourceManager& sources = fault.getSourceManager();
      const SourceLocation at = sources.getExpansionLoc(fault.getLocation());
      line = sources.getExpansionLineNumber(at);
      column = sources.getExpansionColumnNumber(at);
      offset = sources.getFileOffset(at);
      if (const auto file = sources.getFileEntryRefForID(sources.getFileID(at))) path = canonical(*file);
    }
    out_.problems.try_emplace({path, offset}, Json::object({{"path", Json::text(path)},
                                                            {"line", number(line)},
                                                            {"column", number(column)},
                                                            {"message", Json::text(message.str().str())}}));
  }

private:
  Findings& out_;
  std::string path_;
};

class ReadAction final : public clang::ASTFrontendAction {
public:
  ReadAction(Findings& out, const std::set<std::string>& interfaces, const std::string& header)
      : out_(out),
        interfaces_(interfaces),
        header_(header) {}

  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance& compiler, llvm::StringRef) override {
    compiler.getFrontendOpts().SkipFunctionBodies = true;
    clang::Preprocessor& preprocessor = compiler.getPreprocessor();
    const clang::SourceManager& sources = compiler.getSourceManager();
    preprocessor.addPPCallbacks(std::make_unique<Conditionals>(structure_, sources));
    preprocessor.setTokenWatcher([&](const clang::Token& token) {
      if (token.is(clang::tok::l_brace)) structure_.open.push_back(token.getLocation());
      if (!token.is(clang::tok::r_brace) || structure_.open.empty()) return;
      const SourceLocation open = structure_.open.back(), close = token.getLocation();
      structure_.open.pop_back();
      structure_.braces[sources.getExpansionLoc(open)] = {close, open.isMacroID() || close.isMacroID()};
    });
    return std::make_unique<Reader>(out_, interfaces_, header_, structure_, compiler);
  }

private:
  Findings& out_;
  const std::set<std::string>& interfaces_;
  const std::string& header_;
  Structure structure_;
};

/// The disk, with the header, the insertions and the new files of the request.
llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> files_of(const Json& request, const std::string& header) {
  auto memory = llvm::makeIntrusiveRefCnt<llvm::vfs::InMemoryFileSystem>();
  const auto add = [&](const std::string& path, const std::string& text) {
    memory->addFile(path, 0, llvm::MemoryBuffer::getMemBufferCopy(text, path));
  };
  add(header, request["header"]["text"].as_text());
  for (const Json& file : request["fresh"].items()) add(file["path"].as_text(), file["text"].as_text());
  const std::vector<compiler::stubs::Insertion> insertions = insertions_in(request["insertions"]);
  for (auto begin = insertions.begin(); begin != insertions.end();) {
    const auto end = std::find_if(begin, insertions.end(), [&](const auto& each) { return each.path != begin->path; });
    add(begin->path, user_text(begin->path, {begin, end}).text);
    begin = end;
  }
  auto out = llvm::makeIntrusiveRefCnt<llvm::vfs::OverlayFileSystem>(llvm::vfs::createPhysicalFileSystem());
  out->pushOverlay(memory);
  return out;
}

using Files = llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem>;

/// What Clang's driver makes of flags. To ask it takes longer than to read a small file, and most files of a program
/// are compiled alike.
class Invocations {
public:
  /// Null where the flags are not understood, which the faults have been told.
  std::shared_ptr<clang::CompilerInvocation> make(const Json& unit, const Files& files, Faults& faults) {
    const std::string& path = unit["path"].as_text();
    std::vector<std::string> key = unit["flags"].as_texts();
    key.insert(key.end(), {unit["directory"].as_text(), fs::path(path).extension().string()});
    auto at = known_.find(key);
    if (at == known_.end()) {
      std::unique_ptr<clang::CompilerInvocation> fresh = ask(unit, files, faults);
      if (fresh == nullptr || faults.getNumErrors() > 0) return nullptr;
      at = known_.emplace(std::move(key), std::move(fresh)).first;
    }
    auto out = std::make_shared<clang::CompilerInvocation>(*at->second);
    clang::FrontendOptions& options = out->getFrontendOpts();
    options.Inputs = {clang::FrontendInputFile(path, options.Inputs.front().getKind())};
    return out;
  }

private:
  static std::unique_ptr<clang::CompilerInvocation> ask(const Json& unit, const Files& files, Faults& faults) {
    std::vector<std::string> command{DIRECTOR_CLANG_COMPILER, std::string("-I") + virtual_folder};
    for (std::string& flag : unit["flags"].as_texts()) command.push_back(std::move(flag));
    for (const char* const flag : {"-fno-spell-checking", "-fno-caret-diagnostics", "-ferror-limit=0", "-w"})
      command.emplace_back(flag);
    command.push_back(unit["path"].as_text());
    std::vector<const char*> words;
    for (const std::string& word : command) words.push_back(word.c_str());
    clang::CreateInvocationOptions options;
    options.Diags = clang::CompilerInstance::createDiagnostics(new clang::DiagnosticOptions, &faults, false);
    options.VFS = files;
    auto out = clang::createInvocation(words, options);
    if (out != nullptr) out->getFrontendOpts().DisableFree = false; // there are more files to come
    return out;
  }

  std::map<std::vector<std::string>, std::unique_ptr<clang::CompilerInvocation>> known_;
};

bool read(std::shared_ptr<clang::CompilerInvocation> invocation, const Files& files, Faults& faults,
          ReadAction&& action) {
  clang::CompilerInstance compiler;
  compiler.setInvocation(std::move(invocation));
  compiler.setFileManager(new clang::FileManager(clang::FileSystemOptions{}, files));
  compiler.createDiagnostics(&faults, false);
  compiler.createSourceManager(compiler.getFileManager());
  return compiler.ExecuteAction(action);
}

Json answer(const Json& request, Invocations& invocations) {
  Findings out;
  const std::vector<std::string> names = request["interfaces"].as_texts();
  const std::set<std::string> interfaces(names.begin(), names.end());
  const std::string header = std::string(virtual_folder) + "/" + request["header"]["path"].as_text();
  const Files files = files_of(request, header);
  for (const Json& unit : request["units"].items()) {
    const std::string& path = unit["path"].as_text();
    if (unit["only_unseen"].as_boolean() && out.seen.count(path) > 0) continue;
    files->setCurrentWorkingDirectory(unit["directory"].as_text());
    Faults faults(out, path);
    auto invocation = invocations.make(unit, files, faults);
    const bool understood =
        invocation != nullptr && read(std::move(invocation), files, faults, ReadAction(out, interfaces, header));
    if (!understood && faults.getNumErrors() == 0)
      return Json::object({{"error", Json::text("`" + path + "` cannot be read with these flags")}});
  }
  return Json::object({{"classes", Findings::list(out.classes)},
                       {"functions", Findings::list(out.functions)},
                       {"problems", Findings::list(out.problems)}});
}

} // namespace

Json read_declarations(const Json& request) {
  Invocations invocations;
  if (!request["requests"].is_list()) return answer(request, invocations);
  Json answers = Json::list({}); // many at once: to start this program costs more than to read a small file
  for (const Json& each : request["requests"].items()) answers.add(answer(each, invocations));
  return Json::object({{"answers", std::move(answers)}});
}

} // namespace director::scanning
