// Header: compiler/clang/bodies/values.hpp. Test: tests/compiler/clang/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/bodies/values.hpp"

#include "compiler/clang/ast/contexts.hpp"
#include "compiler/clang/ast/places.hpp"

#include <clang/AST/ASTContext.h>
#include <clang/AST/ExprCXX.h>

namespace director::scanning {

namespace {

using namespace clang;

// Limit for constants that refer to constants: more is not usual, and an initializer may refer to itself.
constexpr int deepest = 6;

/// The written expression, without implicit parts and the types of director that wrap it.
const Expr* stripped(const Expr* expr) {
  for (;;) {
    const Expr* inner = expr->IgnoreParenImpCasts();
    if (const auto* full = llvm::dyn_cast<FullExpr>(inner)) inner = full->getSubExpr();
    if (const auto* temporary = llvm::dyn_cast<MaterializeTemporaryExpr>(inner)) inner = temporary->getSubExpr();
    if (const auto* bound = llvm::dyn_cast<CXXBindTemporaryExpr>(inner)) inner = bound->getSubExpr();
    if (const auto* cast = llvm::dyn_cast<CXXFunctionalCastExpr>(inner)) {
      const auto* made = cast->getType()->getAsCXXRecordDecl();
      const bool changes = bare(cast->getType()) != bare(cast->getSubExpr()->getType());
      if (!changes || (made != nullptr && is_directors(*made))) inner = cast->getSubExpr();
    }
    if (const auto* substituted = llvm::dyn_cast<SubstNonTypeTemplateParmExpr>(inner))
      inner = substituted->getReplacement();
    if (const auto* made = llvm::dyn_cast<CXXConstructExpr>(inner)) {
      const bool wraps = made->getNumArgs() == 1 && is_directors(*made->getConstructor());
      if (wraps || (made->getNumArgs() == 1 && made->getConstructor()->isCopyOrMoveConstructor()))
        inner = made->getArg(0);
    }
    if (inner == expr) return expr;
    expr = inner;
  }
}

/// `names`: the enum that is the state's; null: a number.
Values::Names names_of(const llvm::APSInt& number, const EnumDecl* names) {
  Values::Names out;
  if (names != nullptr) {
    for (const EnumConstantDecl* each : names->enumerators()) {
      if (llvm::APSInt::isSameValue(each->getInitVal(), number)) out.push_back(each->getNameAsString());
    }
  }
  if (!out.empty()) return out;
  llvm::SmallString<24> digits;
  number.toString(digits, 10);
  return {digits.str().str()};
}

} // namespace

std::optional<std::set<Values::Names>> Values::of(const Expr* expr) const {
  if (expr == nullptr) return {};
  const auto* names = bare(stripped(expr->IgnoreUnlessSpelledInSource())->getType())->getAs<EnumType>();
  return of(expr, names == nullptr ? nullptr : names->getDecl(), deepest);
}

std::optional<std::set<Values::Names>> Values::of(const Expr* expr, const EnumDecl* names, int depth) const {
  if (expr == nullptr || depth == 0 || expr->isValueDependent()) return {};
  expr = stripped(expr);
  if (const auto* choice = llvm::dyn_cast<ConditionalOperator>(expr)) {
    bool holds = false;
    if (!choice->getCond()->isValueDependent() && choice->getCond()->EvaluateAsBooleanCondition(holds, context_))
      return of(holds ? choice->getTrueExpr() : choice->getFalseExpr(), names, depth - 1);
    auto left = of(choice->getTrueExpr(), names, depth - 1);
    const auto right = of(choice->getFalseExpr(), names, depth - 1);
    if (!left || !right) return {};
    left->insert(right->begin(), right->end());
    return left;
  }
  const auto* list = llvm::dyn_cast<InitListExpr>(expr);
  if (list != nullptr &&
      (list->getNumInits() != 0 || !list->getType()->isEnumeralType())) // an empty one of an enum is 0
    return list->getNumInits() == 1 ? of(list->getInit(0), names, depth - 1) : std::nullopt;
  if (const auto* made = llvm::dyn_cast<CXXParenListInitExpr>(expr))
    return made->getInitExprs().size() == 1 ? of(made->getInitExprs()[0], names, depth - 1) : std::nullopt;
  if (const auto* made = llvm::dyn_cast<CXXConstructExpr>(expr))
    return made->getNumArgs() >= 1 ? of(made->getArg(0), names, depth - 1) : std::nullopt;
  Expr::EvalResult result;
  const auto is_known = [&] {
    return expr->getType()->isIntegralOrEnumerationType() && expr->EvaluateAsInt(result, context_);
  };
  if (const auto* name = llvm::dyn_cast<DeclRefExpr>(expr)) {
    // Before its initializer, whose value the type of the variable may cut.
    if (is_known()) return std::set<Names>{names_of(result.Val.getInt(), names)};
    const auto* variable = llvm::dyn_cast<VarDecl>(name->getDecl());
    if (variable != nullptr && variable->getType().isConstQualified() && !variable->getType()->isReferenceType() &&
        variable->getInit() != nullptr && !llvm::isa<ParmVarDecl>(variable) && !variable->getInit()->isValueDependent())
      return of(variable->getInit(), names, depth - 1);
  }
  if (is_known()) return std::set<Names>{names_of(result.Val.getInt(), names)};
  // A cast to a smaller type may change the value.
  const auto* cast = llvm::dyn_cast<ExplicitCastExpr>(expr);
  const auto width = [&](QualType type) {
    return type->isIntegralOrEnumerationType() && !type->isBooleanType() ? context_.getIntWidth(type) : 0;
  };
  if (cast == nullptr || width(cast->getType()) < width(cast->getSubExpr()->getType())) return {};
  return of(cast->getSubExpr(), names, depth - 1);
}

std::string Values::state_of(const Expr* expr) const {
  expr = expr->IgnoreUnlessSpelledInSource();
  const QualType type = bare(stripped(expr)->getType());
  if (const TagDecl* tag = type->getAsTagDecl()) return name_of(*tag);
  return {};
}

} // namespace director::scanning
