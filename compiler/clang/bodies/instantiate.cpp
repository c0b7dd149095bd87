// Header: compiler/clang/bodies/book.hpp. Test: tests/compiler/clang/shapes_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/ast/contexts.hpp"
#include "compiler/clang/bodies/book.hpp"

#include <clang/AST/DeclTemplate.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/Sema/Sema.h>

namespace director::scanning {

namespace {

using namespace clang;

/// Virtual functions of templates that implement modules, which a compiler instantiates only if it needs their vtable.
class Unmade : public RecursiveASTVisitor<Unmade> {
public:
  bool shouldVisitTemplateInstantiations() const { return true; }

  bool VisitCXXRecordDecl(CXXRecordDecl* record) {
    if (!record->isThisDeclarationADefinition() || record->isDependentContext()) return true;
    if (interface_of(*record) == nullptr || is_directors(*record)) return true;
    for (CXXMethodDecl* method : record->methods()) {
      if (method->isVirtual() && method->isTemplateInstantiation() && !method->isDefined()) functions.push_back(method);
    }
    return true;
  }

  std::vector<CXXMethodDecl*> functions;
};

void add_calls(CXXRecordDecl* deleter, std::vector<CXXMethodDecl*>& out) {
  if (deleter == nullptr || !deleter->hasDefinition() || is_system(*deleter)) return;
  for (CXXMethodDecl* method : deleter->methods()) {
    const bool is_call = method->getOverloadedOperator() == OO_Call;
    if (is_call && method->isTemplateInstantiation() && !method->isDefined()) out.push_back(method);
  }
  for (const CXXBaseSpecifier& base : deleter->bases()) add_calls(base.getType()->getAsCXXRecordDecl(), out);
}

/// Deleters that are class templates, which only the library's code calls: of each `std::unique_ptr` that is destroyed
/// somewhere, as others may have a deleter that this file does not compile.
void add_deleters(ASTContext& context, std::vector<CXXMethodDecl*>& out) {
  const auto named = [&](const DeclContext& in, const char* name) { return in.lookup(&context.Idents.get(name)); };
  for (NamedDecl* space : named(*context.getTranslationUnitDecl(), "std")) {
    const auto* library = llvm::dyn_cast<NamespaceDecl>(space);
    if (library == nullptr) continue;
    for (NamedDecl* each : named(*library, "unique_ptr")) {
      auto* holders = llvm::dyn_cast<ClassTemplateDecl>(each);
      if (holders == nullptr) continue;
      for (const ClassTemplateSpecializationDecl* holder : holders->specializations()) {
        const CXXDestructorDecl* end = holder->hasDefinition() ? holder->getDestructor() : nullptr;
        const TemplateArgumentList& arguments = holder->getTemplateArgs();
        if (end == nullptr || !end->isUsed() || arguments.size() < 2) continue;
        add_calls(arguments[1].getAsType().getNonReferenceType()->getAsCXXRecordDecl(), out);
      }
    }
  }
}

} // namespace

void instantiate_bodies(Sema& sema) {
  Unmade unmade;
  unmade.TraverseAST(sema.getASTContext());
  add_deleters(sema.getASTContext(), unmade.functions);
  for (CXXMethodDecl* method : unmade.functions)
    sema.InstantiateFunctionDefinition(method->getLocation(), method, true, false, true);
  if (!unmade.functions.empty()) sema.PerformPendingInstantiations();
}

} // namespace director::scanning
