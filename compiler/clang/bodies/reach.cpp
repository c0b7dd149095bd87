// Header: compiler/clang/bodies/reach.hpp. Test: tests/compiler/clang/shapes_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/bodies/reach.hpp"

#include "compiler/clang/ast/contexts.hpp"
#include "compiler/clang/ast/places.hpp"
#include "compiler/clang/bodies/blocking.hpp"
#include "compiler/clang/bodies/live.hpp"

#include <clang/AST/ASTContext.h>
#include <clang/AST/Attr.h>
#include <clang/AST/RecursiveASTVisitor.h>

#include <algorithm>
#include <set>

namespace director::scanning {

using namespace clang;

namespace {

/// Limit: a function of the standard library may call a few hundred others; a search beyond this is given up.
constexpr std::size_t most_functions = 4000;

/// Whether it is `std::ostream&`, or a type derived from it.
bool is_stream(QualType type) {
  const CXXRecordDecl* record = bare(type)->getAsCXXRecordDecl();
  if (record == nullptr) return false;
  const std::string name = name_of(*record);
  if (name == "std::basic_ostream" || name == "std::basic_istream") return true;
  if (!record->hasDefinition()) return false;
  return std::any_of(record->bases_begin(), record->bases_end(),
                     [](const CXXBaseSpecifier& base) { return is_stream(base.getType()); });
}

/// Whether the user wrote it. What the compiler generates for a class of the user is examined like the library.
bool is_users(const FunctionDecl& function) {
  if (function.getLocation().isInvalid() || is_system(function)) return false;
  const auto* method = llvm::dyn_cast<CXXMethodDecl>(&function);
  const bool is_lambda = method != nullptr && method->getParent()->isLambda();
  return is_lambda || (!function.isImplicit() && !function.isDefaulted());
}

} // namespace

bool may_do_anything(const FunctionDecl& function) {
  if (function.getBuiltinID() != 0 || function.isNoReturn() || function.isTrivial() || is_standard(function))
    return false;
  // glibc declares functions such as strchr for C++ twice, with and without `const`, under another name for the linker.
  if (!function.isExternC() && !function.hasAttr<AsmLabelAttr>()) return true;
  const auto* type = function.getType()->getAs<FunctionProtoType>();
  return type == nullptr || !type->isNothrow();
}

const Expr* object_of(const CallExpr& call) {
  if (const auto* member = llvm::dyn_cast<CXXMemberCallExpr>(&call)) return member->getImplicitObjectArgument();
  const auto* method = llvm::dyn_cast_or_null<CXXMethodDecl>(call.getDirectCallee());
  const bool has_object = llvm::isa<CXXOperatorCallExpr>(call) && method != nullptr && method->isInstance();
  return has_object ? call.getArg(0) : nullptr;
}

const CXXMethodDecl* target_of(const CallExpr& call, const CXXMethodDecl& method) {
  const Expr* object = object_of(call);
  const auto* member = llvm::dyn_cast<MemberExpr>(call.getCallee()->IgnoreParens());
  if (!method.isVirtual() || object == nullptr || (member != nullptr && member->hasQualifier())) return &method;
  return const_cast<CXXMethodDecl&>(method).getDevirtualizedMethod(object, false);
}

std::string_view known_effect(const FunctionDecl& function) {
  const std::string name = name_of(function);
  const bool of_c =
      function.isExternC() || function.getBuiltinID() != 0 || function.isReplaceableGlobalAllocationFunction();
  if (name.find("::") == std::string::npos && !of_c) return {};
  if (function.isReservedGlobalPlacementOperator()) return {};
  if (function.isExternC() && function.getDeclName().isIdentifier()) return why_it_blocks(function.getName());
  const auto* const method = llvm::dyn_cast<CXXMethodDecl>(&function);
  // It uses the default memory resource, unless the program has set another one.
  if (name == "std::pmr::polymorphic_allocator::polymorphic_allocator" && function.getNumParams() == 0)
    return "uses the heap";
  if ((name == "std::operator<<" || name == "std::operator>>") && method == nullptr && function.getNumParams() > 0)
    return is_stream(function.getParamDecl(0)->getType()) ? "does input or output" : std::string_view{};
  return why_it_blocks(name);
}

/// Finds the functions that a definition calls.
class EdgeReader : public RecursiveASTVisitor<EdgeReader> {
public:
  EdgeReader(const FunctionDecl& function, Reach::Step& out)
      : context_(function.getASTContext()),
        live_(function),
        out_(out) {}

  bool shouldVisitImplicitCode() const { return true; }
  bool dataTraverseStmtPre(Stmt* stmt) { return live_.runs(stmt); }
  bool TraverseTypeLoc(TypeLoc) { return true; }
  bool TraverseUnaryExprOrTypeTraitExpr(UnaryExprOrTypeTraitExpr*) { return true; }
  bool TraverseCXXNoexceptExpr(CXXNoexceptExpr*) { return true; }
  bool TraverseRequiresExpr(RequiresExpr*) { return true; }
  bool TraverseConceptSpecializationExpr(ConceptSpecializationExpr*) { return true; }
  bool TraverseCXXThrowExpr(CXXThrowExpr*) { return true; }
  bool TraverseVarDecl(VarDecl* variable) {
    return variable->isConstexpr() || RecursiveASTVisitor::TraverseVarDecl(variable);
  }
  bool TraverseCXXRecordDecl(CXXRecordDecl*) { return true; }
  bool TraverseLambdaExpr(LambdaExpr*) { return true; } // it counts where it is called

  bool VisitCallExpr(CallExpr* expr) {
    const FunctionDecl* callee = expr->getDirectCallee();
    if (callee == nullptr) return true;
    if (const auto* method = llvm::dyn_cast<CXXMethodDecl>(callee)) {
      callee = target_of(*expr, *method);
      if (callee == nullptr) return true; // through a pointer: unknown
    }
    add(*callee, llvm::isa<CXXDestructorDecl>(callee));
    return true;
  }
  bool VisitCXXConstructExpr(CXXConstructExpr* expr) {
    add(*expr->getConstructor(), false);
    return true;
  }
  bool VisitCXXInheritedCtorInitExpr(CXXInheritedCtorInitExpr* expr) {
    add(*expr->getConstructor(), false);
    return true;
  }
  bool VisitCXXNewExpr(CXXNewExpr* expr) {
    if (const FunctionDecl* made_by = expr->getOperatorNew()) add(*made_by, false);
    return true;
  }
  bool VisitCXXDeleteExpr(CXXDeleteExpr* expr) {
    if (const FunctionDecl* freed_by = expr->getOperatorDelete()) add(*freed_by, false);
    if (!expr->getDestroyedType().isNull()) destroy(expr->getDestroyedType());
    return true;
  }
  bool VisitVarDecl(VarDecl* variable) {
    if (variable->hasLocalStorage() && !llvm::isa<ParmVarDecl>(variable)) destroy(variable->getType());
    return true;
  }
  bool VisitCXXBindTemporaryExpr(CXXBindTemporaryExpr* expr) {
    destroy(expr->getType());
    return true;
  }

  void destroy(QualType type) {
    if (type->isReferenceType() || type->isDependentType()) return;
    const CXXRecordDecl* record = context_.getBaseElementType(type)->getAsCXXRecordDecl();
    if (record == nullptr || !record->hasDefinition() || record->hasTrivialDestructor()) return;
    if (const CXXDestructorDecl* own = record->getDestructor()) add(*own, true);
  }

private:
  void add(const FunctionDecl& to, bool destroys) {
    if (!to.isNoReturn()) out_.edges.push_back({&to, destroys});
  }

  ASTContext& context_;
  Live live_;
  Reach::Step& out_;
};

const Reach::Step& Reach::step(const FunctionDecl& definition) {
  const auto [at, is_new] = steps_.try_emplace(&definition);
  if (!is_new) return at->second;
  EdgeReader reader(definition, at->second);
  if (const auto* maker = llvm::dyn_cast<CXXConstructorDecl>(&definition)) {
    for (const CXXCtorInitializer* part : maker->inits()) {
      if (part->getInit() != nullptr) reader.TraverseStmt(part->getInit());
    }
  }
  reader.TraverseStmt(definition.getBody());
  if (const auto* end = llvm::dyn_cast<CXXDestructorDecl>(&definition)) {
    for (const FieldDecl* field : end->getParent()->fields()) reader.destroy(field->getType());
    for (const CXXBaseSpecifier& base : end->getParent()->bases()) reader.destroy(base.getType());
  }
  return at->second;
}

Reached Reach::walk(const Edge& from) {
  Reached out;
  std::set<Edge> seen{from};
  std::vector<Edge> waiting{from};
  while (!waiting.empty()) {
    const Edge edge = waiting.back();
    waiting.pop_back();
    if (is_known_harmless(name_of(*edge.to))) continue;
    if (const std::string_view why = known_effect(*edge.to); !why.empty()) {
      // What an object of the library frees in its destructor is ignored: nearly every one would be reported.
      if (why != "frees" || !edge.destroys) out.why = worst_of(out.why, why);
      continue;
    }
    const FunctionDecl* definition = nullptr;
    const bool visible =
        edge.to->hasBody(definition) && !definition->isDependentContext() && !definition->hasSkippedBody();
    if (!visible) {
      if (!edge.to->isDefaulted() && may_do_anything(*edge.to)) out.unknown.push_back(edge.to);
      continue;
    }
    if (edge.to == from.to) out.has_definition = true;
    for (Edge next : step(*definition).edges) {
      next.destroys = next.destroys || edge.destroys;
      if (is_directors(*next.to) || !seen.insert(next).second || seen.size() > most_functions) continue;
      if (is_users(*next.to)) {
        out.users.push_back(next.to);
      } else {
        waiting.push_back(next);
      }
    }
  }
  return out;
}

const Reached& Reach::of(const FunctionDecl& callee, bool destroys) {
  const Edge from{&callee, destroys};
  const auto at = known_.find(from);
  return at != known_.end() ? at->second : known_.emplace(from, walk(from)).first->second;
}

} // namespace director::scanning
