// Header: compiler/clang/implementers.hpp. Test: tests/compiler/clang/stubs/command_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/implementers.hpp"

#include "compiler/clang/ast/contexts.hpp"

#include <clang/AST/ASTContext.h>
#include <clang/AST/CXXInheritance.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Lex/Lexer.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace director::scanning {

namespace {

using clang::SourceLocation;

class Implementers final : public clang::ASTConsumer {
public:
  Implementers(Findings& out, const std::set<std::string>& interfaces, const std::string& header,
               const Structure& structure, clang::CompilerInstance& compiler)
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

private:
  void problem(SourceLocation at, const std::string& message) {
    Json row = row_at(sources_, at);
    row.add("message", Json::text(message));
    out_.problems.try_emplace(place(at), std::move(row));
  }

  Findings::Place place(SourceLocation at) const { return place_of(sources_, at); }

  bool is_users(SourceLocation at) const {
    if (at.isInvalid()) return false;
    const SourceLocation where = sources_.getExpansionLoc(at);
    return !sources_.isInSystemHeader(where) && place(where).first != header_;
  }

  std::int64_t inside(SourceLocation at) const {
    const auto [file, offset] = sources_.getDecomposedExpansionLoc(at);
    return structure_.inside(file, offset);
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
        // The user's declarations may be inside what another header opens: only namespaces are searched.
        if (!llvm::isa<clang::LinkageSpecDecl>(decl)) continue;
      }
      if (const auto* name_space = llvm::dyn_cast<clang::NamespaceDecl>(decl)) walk(*name_space);
      if (const auto* linkage = llvm::dyn_cast<clang::LinkageSpecDecl>(decl)) walk(*linkage);
      if (const auto* type_template = llvm::dyn_cast<clang::ClassTemplateDecl>(decl)) {
        templates_[type_template->getNameAsString()] = type_template->getTemplatedDecl();
        read(*type_template->getTemplatedDecl());
      }
      if (const auto* type = llvm::dyn_cast<clang::CXXRecordDecl>(decl)) read(*type);
      if (const auto* function = llvm::dyn_cast<clang::CXXMethodDecl>(decl)) read(*function);
    }
  }

  void read(const clang::CXXRecordDecl& type) {
    if (!type.isThisDeclarationADefinition()) return;
    // The text of an explicit instantiation is that of its template, whose functions are read there.
    const clang::CXXRecordDecl& written = as_written(type);
    read(type, written);
    if (&written == &type) walk(type);
  }

  using Bases = std::set<const clang::CXXRecordDecl*>; ///< as they are written

  /// The template that a class is an instance of; otherwise the class.
  static const clang::CXXRecordDecl& as_written(const clang::CXXRecordDecl& type) {
    const clang::CXXRecordDecl* const pattern = type.getTemplateInstantiationPattern();
    return pattern == nullptr ? type : *pattern;
  }

  /// Each once, in order of path and place.
  Json places_of(const Bases& bases) const {
    std::map<Findings::Place, Json> rows;
    for (const clang::CXXRecordDecl* base : bases) {
      const SourceLocation at = base->getLocation();
      rows.try_emplace(place(at), row_at(sources_, at));
    }
    Json out = Json::list({});
    for (const auto& [place, row] : rows) out.add(row);
    return out;
  }

  void read(const clang::CXXRecordDecl& type, const clang::CXXRecordDecl& written) {
    std::set<std::string> interfaces;
    Bases bases;
    look_up(type, interfaces, bases);
    if (type.isInvalidDecl()) look_up_words(type, interfaces, bases);
    const SourceLocation end = written.getBraceRange().getEnd();
    if (!interfaces.empty() && end.isValid() && is_users(written.getLocation())) {
      Json row = row_at(sources_, written.getLocation());
      row.add("name", Json::text(written.getQualifiedNameAsString()));
      row.add("interfaces", Json::texts({interfaces.begin(), interfaces.end()}));
      row.add("bases", places_of(bases));
      row.add("end", Json::count(place(end).second));
      row.add("inside", Json::number(inside(end)));
      row.add("public", Json::boolean(access_at_end(written) == clang::AS_public));
      row.add("macro", Json::boolean(end.isMacroID()));
      row.add("given", Json::texts(given_by_templates(type)));
      row.add("only_inline", Json::boolean(written.isDependentContext() || written.isLocalClass() != nullptr));
      row.add("hides", Json::boolean(hides_behaviour(written)));
      out_.classes.try_emplace(place(written.getLocation()), std::move(row));
    }
  }

  void look_up(const clang::CXXRecordDecl& type, std::set<std::string>& interfaces, Bases& bases) {
    if (!type.hasDefinition()) return; // with errors in it
    for (const clang::CXXBaseSpecifier& specifier : type.bases()) {
      const clang::CXXRecordDecl* base = specifier.getType()->getAsCXXRecordDecl();
      if (base == nullptr || !base->hasDefinition()) continue;
      base = base->getDefinition();
      const std::string name = base->getQualifiedNameAsString();
      if (interfaces_.count(name) > 0) {
        interfaces.insert(name);
      } else if (is_users(base->getLocation())) {
        bases.insert(&as_written(*base)); // a template may be there again, with other arguments
        look_up(*base, interfaces, bases);
      }
    }
  }

  /// Clang makes no base of a template with an error in it, as with a body whose provider is gone: then the interfaces
  /// and templates count that the text names behind the colon.
  void look_up_words(const clang::CXXRecordDecl& type, std::set<std::string>& interfaces, Bases& bases) {
    const auto is_last_part = [](const std::string& name, llvm::StringRef word) {
      return llvm::StringRef(name).rsplit("::").second == word;
    };
    bool behind_colon = false;
    auto next = clang::Lexer::findNextToken(type.getLocation(), sources_, compiler_.getLangOpts());
    while (next && !next->isOneOf(clang::tok::l_brace, clang::tok::eof)) {
      behind_colon = behind_colon || next->is(clang::tok::colon);
      if (behind_colon && next->is(clang::tok::raw_identifier)) {
        const llvm::StringRef word = next->getRawIdentifier();
        for (const std::string& name : interfaces_) {
          if (is_last_part(name, word)) interfaces.insert(name);
        }
        const auto found = templates_.find(word.str());
        if (found != templates_.end() && bases.insert(found->second).second) look_up(*found->second, interfaces, bases);
      }
      next = clang::Lexer::findNextToken(next->getLocation(), sources_, compiler_.getLangOpts());
    }
  }

  /// Bodies that a template gives it, whatever the text of that calls the context: `provide soccer::Walk::Halting`.
  static std::vector<std::string> given_by_templates(const clang::CXXRecordDecl& type) {
    std::vector<std::string> out;
    if (type.isDependentContext() || type.isInvalidDecl()) return out;
    clang::CXXFinalOverriderMap overriders;
    type.getFinalOverriders(overriders);
    for (const auto& [method, by_subobject] : overriders) {
      for (const auto& [subobject, last] : by_subobject) {
        const clang::CXXMethodDecl& body = *last.front().Method;
        if (body.isPureVirtual() || !is_called_like_body(body) || body.getNumParams() != 1) continue;
        if (llvm::isa<clang::ClassTemplateSpecializationDecl>(body.getParent()))
          out.push_back(body.getNameAsString() + " " + context_of(*body.getParamDecl(0)));
      }
    }
    return out;
  }

  /// Whether the class, or a namespace around it, has a name of its own that is that of the behaviour's namespace.
  bool hides_behaviour(const clang::CXXRecordDecl& type) const {
    const llvm::StringRef outermost = llvm::StringRef(*interfaces_.begin()).split("::").first;
    const clang::DeclarationName name(&compiler_.getASTContext().Idents.get(outermost));
    for (const clang::DeclContext* scope = &type; !scope->isTranslationUnit(); scope = scope->getParent()) {
      if (!scope->isTransparentContext() && !scope->lookup(name).empty()) return true;
    }
    return false;
  }

  static clang::AccessSpecifier access_at_end(const clang::CXXRecordDecl& type) {
    clang::AccessSpecifier out = type.isClass() ? clang::AS_private : clang::AS_public;
    for (const clang::Decl* decl : type.decls())
      if (const auto* label = llvm::dyn_cast<clang::AccessSpecDecl>(decl)) out = label->getAccess();
    return out;
  }

  /// Other functions of a class than those with the name of a body and one parameter are ignored.
  void read(const clang::CXXMethodDecl& function) {
    const clang::FunctionTypeLoc type = function.getFunctionTypeLoc();
    if (!is_called_like_body(function) || function.getNumParams() != 1 || !type) return;

    const bool body = function.isThisDeclarationADefinition() && !function.isDeleted() && !function.isDefaulted();
    const bool within = !function.isOutOfLine();
    const End end = body ? end_of_body(type.getRParenLoc()) : end_of_declaration(type.getRParenLoc());
    const SourceLocation begin = function.getBeginLoc(), at = function.getLocation();
    const clang::ParmVarDecl& parameter = *function.getParamDecl(0);
    const bool known = !parameter.isInvalidDecl();
    if (known && !may_override(function)) return;

    Json row = row_at(sources_, at);
    const clang::CXXRecordDecl* const type_of = function.getParent()->getDefinition();
    row.add("class", Json::text(function.getParent()->getQualifiedNameAsString()));
    row.add("class_at", row_at(sources_, (type_of == nullptr ? function.getParent() : type_of)->getLocation()));
    row.add("name", Json::text(function.getNameAsString()));
    row.add("context", Json::text(known ? context_of(parameter) : written(type)));
    row.add("begin", Json::count(place(begin).second));
    row.add("end", Json::count(end.offset));
    row.add("inside", Json::number(end.inside));
    row.add("known", Json::boolean(known));
    row.add("within", Json::boolean(within));
    row.add("defines", Json::boolean(body || function.isPureVirtual() || function.isDeleted()));
    row.add("pure", Json::boolean(function.isPureVirtual()));
    row.add("overrides", Json::boolean(has_override(type.getRParenLoc())));
    row.add("macro", Json::boolean(begin.isMacroID() || at.isMacroID() || end.in_macro));
    row.add("inline", Json::boolean(!within && function.isInlineSpecified()));
    row.add("for_any",
            Json::boolean(function.getParent()->hasDefinition() && function.getParent()->hasAnyDependentBases()));
    row.add("result", Json::text(result_of(function)));
    row.add("qualifier",
            Json::text(within ? std::string{} : one_line(text(function.getQualifierLoc().getBeginLoc(), at))));
    out_.functions.try_emplace(place(at), std::move(row));
  }

  /// Whether it is declared as interfaces declare theirs: with `const`, or a context by value, it overrides nothing.
  static bool may_override(const clang::CXXMethodDecl& function) {
    const clang::QualType context = function.getParamDecl(0)->getType();
    return !function.isConst() && !function.isVolatile() && function.getRefQualifier() == clang::RQ_None &&
           context->isLValueReferenceType() && !context->getPointeeType().isConstQualified();
  }

  struct End {
    std::uint64_t offset = 0;
    std::int64_t inside = -1;
    bool in_macro = true;
  };

  End end_at(SourceLocation last) const {
    if (last.isInvalid() || last.isMacroID()) return {};
    const SourceLocation end = behind_token(last);
    return {place(end).second, inside(last), false};
  }

  /// A body begins with the first brace behind the parameters; a function-try-block continues with its handlers.
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

  /// Clang drops the keyword if there is nothing to override, as when the interface is gone.
  bool has_override(SourceLocation parameters) const {
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

  /// The parameter's type as it is written there: `soccer::Walk::Halting`.
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

  /// The name of director::Outcome as the user writes it there.
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
  std::map<std::string, const clang::CXXRecordDecl*> templates_; ///< of the user's, by name
  const std::set<std::string>& interfaces_;
  const std::string& header_;
  const Structure& structure_;
  clang::CompilerInstance& compiler_;
  const clang::SourceManager& sources_;
};

} // namespace

std::unique_ptr<clang::ASTConsumer> find_implementers(Findings& out, const std::set<std::string>& interfaces,
                                                      const std::string& header, const Structure& structure,
                                                      clang::CompilerInstance& compiler) {
  return std::make_unique<Implementers>(out, interfaces, header, structure, compiler);
}

} // namespace director::scanning
