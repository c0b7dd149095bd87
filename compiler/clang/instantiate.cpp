// Header: compiler/clang/book.hpp. Test: tests/compiler/clang/shapes_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/book.hpp"
#include "compiler/clang/contexts.hpp"

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

} // namespace

void instantiate_bodies(Sema& sema) {
  Unmade unmade;
  unmade.TraverseAST(sema.getASTContext());
  for (CXXMethodDecl* method : unmade.functions)
    sema.InstantiateFunctionDefinition(method->getLocation(), method, true, false, true);
  if (!unmade.functions.empty()) sema.PerformPendingInstantiations();
}

} // namespace director::scanning
