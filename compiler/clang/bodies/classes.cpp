// Header: compiler/clang/bodies/book.hpp. Test: tests/compiler/clang/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/ast/contexts.hpp"
#include "compiler/clang/bodies/book.hpp"

#include <clang/AST/CXXInheritance.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/Lex/Lexer.h>

#include <algorithm>
#include <set>

namespace director::scanning {

namespace {

using namespace clang;

/// Finds classes that implement modules, and functions to begin with.
class Finder : public RecursiveASTVisitor<Finder> {
public:
  explicit Finder(Book& book) : book_(book) {}
  bool shouldVisitTemplateInstantiations() const { return true; }

  bool VisitFunctionDecl(FunctionDecl* function) {
    if (!function->isThisDeclarationADefinition() || function->isDependentContext()) return true;
    const auto* method = llvm::dyn_cast<CXXMethodDecl>(function);
    const bool is_body = method != nullptr && promised_by(*method) != nullptr;
    const SourceManager& sources = book_.context().getSourceManager();
    if (is_body || sources.isInMainFile(sources.getFileLoc(function->getLocation()))) book_.want(*function);
    return true;
  }

  bool VisitVarDecl(VarDecl* variable) {
    add_object(variable->getType());
    return true;
  }

  bool VisitFieldDecl(FieldDecl* field) {
    add_object(field->getType());
    return true;
  }

  bool VisitCXXConstructExpr(CXXConstructExpr* expr) {
    if (expr->getConstructionKind() == CXXConstructionKind::Complete) add_object(expr->getType());
    return true;
  }

  /// The library's bodies, such as that of `std::make_unique`, may not be read.
  bool VisitCallExpr(CallExpr* expr) {
    const FunctionDecl* callee = expr->getDirectCallee();
    if (callee == nullptr || !is_system(*callee) || callee->getTemplateSpecializationArgs() == nullptr ||
        !callee->getDeclName().isIdentifier())
      return true;
    const llvm::StringRef name = callee->getName();
    if (!name.starts_with("make_") && !name.starts_with("allocate_") && !name.starts_with("emplace")) return true;
    for (const TemplateArgument& each : callee->getTemplateSpecializationArgs()->asArray()) {
      if (each.getKind() == TemplateArgument::Type) add_object(each.getAsType());
    }
    return true;
  }

  bool VisitCXXRecordDecl(CXXRecordDecl* record) {
    if (record->isThisDeclarationADefinition() && record->isDependentContext() && !is_directors(*record)) {
      book_.has_templates = book_.has_templates || interface_of(*record) != nullptr || has_body(*record);
      for (const CXXBaseSpecifier& base : record->bases()) {
        const CXXRecordDecl* above = base.getType()->getAsCXXRecordDecl();
        if (above != nullptr && !above->isDependentContext()) book_.continued.insert(key_of(*above));
      }
    }
    if (!record->isThisDeclarationADefinition() || record->isDependentContext() || record->getNumBases() == 0)
      return true;
    const CXXRecordDecl* module = interface_of(*record);
    if (module == nullptr || is_directors(*record)) return true;
    Json bases = Json::list({}), missing = Json::list({}), stray = Json::list({});
    for (const CXXBaseSpecifier& base : record->bases()) {
      if (const CXXRecordDecl* above = base.getType()->getAsCXXRecordDecl()) bases.add(Json::text(key_of(*above)));
    }
    CXXFinalOverriderMap overriders;
    record->getFinalOverriders(overriders);
    bool is_base = is_made_below(*record);
    for (const auto& [method, by_subobject] : overriders) {
      for (const auto& [subobject, last] : by_subobject) {
        const CXXMethodDecl* final_one = last.front().Method;
        is_base = is_base ||
                  (final_one->isPureVirtual() && !is_called_like_body(*final_one) && !record->isEffectivelyFinal());
        if (final_one->isPureVirtual() && is_called_like_body(*final_one) &&
            (is_interface(*final_one->getParent()) || promised_by(*final_one) != nullptr))
          missing.add(Json::text(parameter_context(*final_one)));
      }
    }
    if (is_base) missing = Json::list({});
    for (const CXXMethodDecl* method : record->methods()) {
      if (!is_called_like_body(*method) || method->size_overridden_methods() != 0 || method->isDeleted()) continue;
      const std::string context = parameter_context(*method);
      const bool is_lost = context.empty() && method->getNumParams() == 1 &&
                           (method->isInvalidDecl() || method->getParamDecl(0)->isInvalidDecl());
      if (context.empty() && !is_lost) continue;
      Json each = Json::object({{"key", Json::text(key_of(*method))},
                                {"at", book_.places().of(method->getLocation(), method->getLocation())}});
      if (is_lost) {
        each.add("wrote", Json::text(written(*method->getParamDecl(0))));
      } else {
        each.add("context", Json::text(context));
        const CXXMethodDecl* promise = declared_for(*record, method->getName(), context);
        if (promise == nullptr) promise = declared_for(*record, {}, context);
        if (promise != nullptr) each.add("unlike", Json::text(difference(*method, *promise)));
      }
      stray.add(std::move(each));
    }
    book_.classes.push_back(Json::object({{"key", Json::text(key_of(*record))},
                                          {"name", Json::text(name_of(*record))},
                                          {"module", Json::text(name_of(*module))},
                                          {"at", book_.places().of(record->getLocation(), record->getLocation())},
                                          {"bases", std::move(bases)},
                                          {"missing", std::move(missing)},
                                          {"stray", std::move(stray)}}));
    return true;
  }

private:
  /// Records the bodies that an object of exactly this type has.
  void add_object(QualType type) {
    if (type.isNull() || type->isDependentType()) return;
    const CXXRecordDecl* record = book_.context().getBaseElementType(type)->getAsCXXRecordDecl();
    if (record == nullptr || !record->hasDefinition() || record->getDefinition()->isInvalidDecl() ||
        record->getNumBases() == 0 || !made_.insert(record->getCanonicalDecl()).second)
      return;
    record = record->getDefinition();
    if (record->isDependentContext() || is_system(*record) || interface_of(*record) == nullptr) return;
    CXXFinalOverriderMap overriders;
    record->getFinalOverriders(overriders);
    for (const auto& [method, by_subobject] : overriders) {
      for (const auto& [subobject, last] : by_subobject) {
        if (is_called_like_body(*last.front().Method)) book_.runs.insert(key_of(*last.front().Method));
      }
    }
  }

  /// Whether only derived classes can have objects, as its constructors are protected.
  static bool is_made_below(const CXXRecordDecl& record) {
    const auto any = [&](AccessSpecifier access) {
      return std::any_of(record.ctor_begin(), record.ctor_end(), [&](const CXXConstructorDecl* each) {
        return !each->isCopyOrMoveConstructor() && each->getAccess() == access;
      });
    };
    const bool has_public_template = std::any_of(record.decls_begin(), record.decls_end(), [](const Decl* each) {
      const auto* many = llvm::dyn_cast<FunctionTemplateDecl>(each);
      return many != nullptr && llvm::isa<CXXConstructorDecl>(many->getTemplatedDecl()) &&
             many->getAccess() == AS_public;
    });
    return !record.isEffectivelyFinal() && any(AS_protected) && !any(AS_public) && !has_public_template;
  }

  static bool has_body(const CXXRecordDecl& record) {
    return std::any_of(record.method_begin(), record.method_end(), [](const CXXMethodDecl* method) {
      return is_called_like_body(*method) && !parameter_context(*method).empty();
    });
  }

  /// Why a function does not override the one with the same context.
  static std::string difference(const CXXMethodDecl& method, const CXXMethodDecl& promise) {
    if (method.getName() != promise.getName())
      return "it is called `" + method.getName().str() + "` instead of `" + promise.getName().str() + "`";
    if (method.isConst()) return "it is `const`";
    if (method.isVolatile()) return "it is `volatile`";
    if (method.getRefQualifier() != RQ_None) return "it has a `&` behind its parameters";
    const QualType own = method.getParamDecl(0)->getType(), wanted = promise.getParamDecl(0)->getType();
    if (own.getCanonicalType() == wanted.getCanonicalType()) return "it has another result";
    if (own->isPointerType()) return "it takes a pointer";
    if (own->isRValueReferenceType()) return "it takes a `&&`";
    if (!own->isReferenceType()) return "it takes its context by value";
    return own->getPointeeType().isConstQualified() ? "it takes a `const` context" : "it takes another context";
  }

  std::string written(const ParmVarDecl& parameter) const {
    const CharSourceRange range = CharSourceRange::getTokenRange(parameter.getSourceRange());
    return Lexer::getSourceText(range, book_.context().getSourceManager(), book_.context().getLangOpts()).str();
  }

  Book& book_;
  std::set<const CXXRecordDecl*> made_; ///< of which an object was found
};

} // namespace

void find_classes(Book& book) { Finder(book).TraverseAST(book.context()); }

} // namespace director::scanning
