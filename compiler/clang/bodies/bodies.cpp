// Header: compiler/clang/bodies/book.hpp. Test: tests/compiler/clang/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/bodies/effects.hpp"
#include "compiler/clang/bodies/live.hpp"
#include "compiler/stubs/layout.hpp"

#include <clang/AST/Attr.h>
#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/Lex/Lexer.h>

#include <set>
#include <utility>

namespace director::scanning {

namespace {

using namespace clang;

constexpr int most_parts = 8; ///< limit for nested objects whose members are examined

class BodyReader : public RecursiveASTVisitor<BodyReader> {
public:
  BodyReader(Book& book, const FunctionDecl& function) : book_(book), effects_(book), live_(function) {}

  bool reaches_end() const { return live_.reaches_end(); }
  Effects effects() && { return std::move(effects_); }

  // Skips code that is never run.
  bool TraverseTypeLoc(TypeLoc) { return true; }
  bool TraverseUnaryExprOrTypeTraitExpr(UnaryExprOrTypeTraitExpr*) { return true; }
  bool TraverseCXXNoexceptExpr(CXXNoexceptExpr*) { return true; }
  bool TraverseCXXRecordDecl(CXXRecordDecl*) { return true; }
  bool TraverseRequiresExpr(RequiresExpr*) { return true; }
  bool TraverseConceptSpecializationExpr(ConceptSpecializationExpr*) { return true; }
  bool TraverseGenericSelectionExpr(GenericSelectionExpr* choice, DataRecursionQueue* = nullptr) {
    return choice->isResultDependent() || TraverseStmt(choice->getResultExpr());
  }
  bool TraverseCXXTypeidExpr(CXXTypeidExpr* expr) {
    return !expr->isPotentiallyEvaluated() || RecursiveASTVisitor::TraverseCXXTypeidExpr(expr);
  }

  // Reads what the compiler makes of these: initializers that are not written there, and operators that it chose.
  bool TraverseInitListExpr(InitListExpr* list, DataRecursionQueue* = nullptr) {
    if (!list->isSemanticForm()) list = list->getSemanticForm();
    if (!RecursiveASTVisitor::TraverseSynOrSemInitListExpr(list)) return false;
    return list->getArrayFiller() == nullptr || TraverseStmt(list->getArrayFiller());
  }
  bool TraverseCXXRewrittenBinaryOperator(CXXRewrittenBinaryOperator* expr, DataRecursionQueue* = nullptr) {
    return TraverseStmt(expr->getSemanticForm());
  }

  // ... and the calls with which a coroutine answers and waits. They contain what the user wrote there.
  bool TraverseCoreturnStmt(CoreturnStmt* answer, DataRecursionQueue* = nullptr) {
    Expr* operand = answer->getOperand();
    if (answer->getPromiseCall() == nullptr || (operand != nullptr && operand->getType()->isVoidType()))
      TraverseStmt(operand);
    return TraverseStmt(answer->getPromiseCall());
  }
  bool TraverseCoawaitExpr(CoawaitExpr* expr, DataRecursionQueue* = nullptr) { return suspend(*expr); }
  bool TraverseCoyieldExpr(CoyieldExpr* expr, DataRecursionQueue* = nullptr) { return suspend(*expr); }

  bool dataTraverseStmtPre(Stmt* stmt) { return live_.runs(stmt); }
  bool TraverseVarDecl(VarDecl* variable) {
    return variable->isConstexpr() || RecursiveASTVisitor::TraverseVarDecl(variable);
  }

  bool TraverseLambdaExpr(LambdaExpr* lambda) {
    // A lambda may be called by its receiver. One with `auto` has a body for each way in which it is called.
    if (!lambda->isGenericLambda()) {
      const FunctionDecl* body = lambda->getCallOperator();
      effects_.call(*body, lambda->getBeginLoc(), lambda->getBeginLoc(), true, run_at_once_.count(lambda) == 0, false);
    } else if (const FunctionTemplateDecl* many = lambda->getDependentCallOperator()) {
      for (const FunctionDecl* each : many->specializations())
        effects_.call(*each, lambda->getBeginLoc(), lambda->getBeginLoc(), true, run_at_once_.count(lambda) == 0,
                      false);
    }
    for (Expr* capture : lambda->capture_inits()) {
      if (capture != nullptr) TraverseStmt(capture);
    }
    return true;
  }

  // Where a context gets out of sight: it is stored in what outlives the function, or its type is lost.
  bool VisitBinaryOperator(BinaryOperator* expr) {
    if (expr->getOpcode() == BO_Assign) store(*expr->getLHS(), *expr->getRHS());
    return true;
  }
  bool VisitCastExpr(CastExpr* expr) {
    const CastKind kind = expr->getCastKind();
    const bool may_lose = kind == CK_BitCast || kind == CK_LValueBitCast || kind == CK_PointerToIntegral ||
                          kind == CK_DerivedToBase || kind == CK_UncheckedDerivedToBase;
    if (may_lose && given_.count(expr) == 0 && !book_.carriers().holds(expr->getType()) &&
        book_.carriers().holds(expr->getSubExpr()->getType()))
      effects_.stores = true;
    return true;
  }
  bool VisitMemberExpr(MemberExpr* expr) {
    give(expr->getBase());
    return true;
  }

  bool VisitCallExpr(CallExpr* expr) {
    callees_.insert(expr->getCallee()->IgnoreParenImpCasts());
    for (const Expr* argument : expr->arguments()) give(argument);
    const auto* sign = llvm::dyn_cast<CXXOperatorCallExpr>(expr);
    if (sign != nullptr && sign->getOperator() == OO_Equal) store(*sign->getArg(0), *sign->getArg(1));
    bool carries = false;
    for (const Expr* argument : expr->arguments()) carries = carries || book_.carriers().has(*argument);
    const Expr* object = object_of(*expr);
    if (object != nullptr) carries = carries || book_.carriers().has(*object);
    const FunctionDecl* callee = expr->getDirectCallee();
    if (callee == nullptr) {
      if (!llvm::isa<CXXPseudoDestructorExpr>(expr->getCallee()->IgnoreParens()) && !expr->isTypeDependent())
        effects_.hide("a call through a pointer", expr->getBeginLoc(), expr->getEndLoc(), carries);
      return true;
    }
    if (callee->getLocation().isInvalid()) { // built in
      if (const std::string_view why = known_effect(*callee); !why.empty())
        effects_.block(name_of(*callee), why, expr->getBeginLoc());
      return true;
    }
    const auto* method = llvm::dyn_cast<CXXMethodDecl>(callee);
    if (method != nullptr && object != nullptr && effects_.add_word(*expr, *method, *object)) return true;
    const SourceLocation at = name_place(*expr);
    if (is_directors(*callee)) return true;
    const CXXMethodDecl* target = method == nullptr ? nullptr : target_of(*expr, *method);
    if (target != nullptr) callee = target;
    const bool is_virtual = method != nullptr && target == nullptr;
    if (is_system(*callee)) {
      effects_.call_library(*expr, *callee, at);
      note_run_at_once(*expr, *callee);
      return true;
    }
    if (callee->isDefaulted()) go_into(callee->getBody(), at); // an assignment
    effects_.call(*callee, at, at, carries, false, is_virtual);
    return true;
  }

  bool VisitCXXConstructExpr(CXXConstructExpr* expr) {
    const CXXConstructorDecl& callee = *expr->getConstructor();
    Given given{types_given({expr->getArgs(), expr->getNumArgs()})};
    for (const Expr* argument : expr->arguments()) {
      give(argument);
      given.carries = given.carries || book_.carriers().has(*argument);
      given.outside = given.outside || book_.carriers().has_outside_of_lambdas(*argument);
      // Such as std::any.
      if (is_system(callee) && book_.carriers().holds(*argument) && !book_.carriers().holds(expr->getType()))
        effects_.stores = true;
    }
    given.any = expr->getNumArgs() > 0 && !callee.isDefaultConstructor() && !callee.isMoveConstructor();
    construct(callee, expr->getBeginLoc(), given);
    return true;
  }
  bool VisitCXXInheritedCtorInitExpr(CXXInheritedCtorInitExpr* expr) {
    const CXXConstructorDecl& callee = *expr->getConstructor();
    Given given;
    for (const ParmVarDecl* each : callee.parameters()) {
      given.types.push_back(each->getType());
      given.carries = given.carries || book_.carriers().has(each->getType());
    }
    given.outside = given.carries;
    given.any = callee.getNumParams() > 0;
    construct(callee, expr->getBeginLoc(), given);
    return true;
  }

  bool VisitCXXNewExpr(CXXNewExpr* expr) {
    const FunctionDecl* made_by = expr->getOperatorNew();
    if (made_by == nullptr) return true;
    // In memory that others may know.
    if (made_by->isReservedGlobalPlacementOperator() && book_.carriers().holds(expr->getAllocatedType()))
      effects_.stores = true;
    effects_.manage_memory(*made_by, expr->getBeginLoc());
    return true;
  }
  bool VisitCXXDeleteExpr(CXXDeleteExpr* expr) {
    if (const FunctionDecl* freed_by = expr->getOperatorDelete())
      effects_.manage_memory(*freed_by, expr->getBeginLoc());
    if (!expr->getDestroyedType().isNull()) effects_.destroy(expr->getDestroyedType(), expr->getBeginLoc(), true);
    return true;
  }

  // Code that runs without being written: destructors, and parts of loops and of objects.
  bool VisitVarDecl(VarDecl* variable) {
    if (!variable->hasLocalStorage() && variable->getInit() != nullptr && book_.carriers().holds(*variable->getInit()))
      effects_.stores = true;
    if (!variable->hasLocalStorage() || llvm::isa<ParmVarDecl>(variable)) return true;
    if (variable->getInit() != nullptr && !live_.runs(variable->getInit())) return true;
    if (variable->isCXXForRangeDecl() && variable->getInit() != nullptr)
      go_into(variable->getInit(), variable->getLocation());
    effects_.destroy(variable->getType(), variable->getLocation());
    for (const auto* last : variable->specific_attrs<CleanupAttr>())
      effects_.call(*last->getFunctionDecl(), variable->getLocation(), variable->getLocation(),
                    book_.carriers().has(variable->getType()), false, false);
    return true;
  }
  bool VisitDecompositionDecl(DecompositionDecl* several) {
    for (const BindingDecl* each : several->bindings()) {
      if (const VarDecl* held = each->getHoldingVar()) go_into(held->getInit(), each->getLocation());
    }
    return true;
  }
  bool VisitCXXBindTemporaryExpr(CXXBindTemporaryExpr* expr) {
    effects_.destroy(expr->getType(), expr->getBeginLoc());
    return true;
  }
  bool VisitCoroutineBodyStmt(CoroutineBodyStmt* coroutine) {
    for (const Stmt* part : coroutine->childrenExclBody()) {
      if (part != coroutine->getDeallocate()) go_into(part, coroutine->getBeginLoc());
    }
    if (const VarDecl* promise = coroutine->getPromiseDecl())
      effects_.destroy(promise->getType(), coroutine->getBeginLoc());
    return true;
  }
  bool VisitCXXForRangeStmt(CXXForRangeStmt* loop) {
    const auto made = [](const DeclStmt* each) -> const Stmt* {
      const auto* variable = each == nullptr ? nullptr : llvm::dyn_cast<VarDecl>(each->getSingleDecl());
      return variable == nullptr ? nullptr : variable->getInit();
    };
    const Stmt* const parts[]{made(loop->getBeginStmt()), made(loop->getEndStmt()), loop->getCond(), loop->getInc()};
    for (const Stmt* part : parts) go_into(part, loop->getColonLoc());
    return true;
  }
  bool VisitCXXDefaultInitExpr(CXXDefaultInitExpr* expr) {
    go_into(expr->getExpr(), expr->getBeginLoc());
    return true;
  }
  bool VisitCXXDefaultArgExpr(CXXDefaultArgExpr* expr) {
    go_into(expr->getExpr(), expr->getBeginLoc());
    return true;
  }

  /// A function that is named and not called here may be called by its receiver.
  bool VisitDeclRefExpr(DeclRefExpr* expr) {
    const auto* function = llvm::dyn_cast<FunctionDecl>(expr->getDecl());
    if (function == nullptr || callees_.count(expr) != 0 || is_system(*function) || is_directors(*function))
      return true;
    if (expr->isNonOdrUse() == NOUR_Unevaluated) return true;
    effects_.call(*function, expr->getLocation(), expr->getLocation(), false, true, false);
    return true;
  }

private:
  /// Notes the casts around what is given to a call, which has it by its type before them, or is read itself.
  void give(const Expr* value) {
    while (value != nullptr) {
      given_.insert(value);
      const auto* cast = llvm::dyn_cast<CastExpr>(value);
      const auto* full = llvm::dyn_cast<FullExpr>(value);
      const auto* temporary = llvm::dyn_cast<MaterializeTemporaryExpr>(value);
      const auto* parentheses = llvm::dyn_cast<ParenExpr>(value);
      value = cast != nullptr          ? cast->getSubExpr()
              : full != nullptr        ? full->getSubExpr()
              : temporary != nullptr   ? temporary->getSubExpr()
              : parentheses != nullptr ? parentheses->getSubExpr()
                                       : nullptr;
    }
  }

  void store(const Expr& to, const Expr& value) {
    const Expr* at = to.IgnoreParenImpCasts();
    for (;;) {
      const auto* member = llvm::dyn_cast<MemberExpr>(at);
      const auto* element = llvm::dyn_cast<ArraySubscriptExpr>(at);
      if (member != nullptr && !member->isArrow()) {
        at = member->getBase()->IgnoreParenImpCasts();
      } else if (element != nullptr && element->getBase()->IgnoreParenImpCasts()->getType()->isArrayType()) {
        at = element->getBase()->IgnoreParenImpCasts();
      } else {
        break;
      }
    }
    const auto* name = llvm::dyn_cast<DeclRefExpr>(at);
    const auto* variable = name == nullptr ? nullptr : llvm::dyn_cast<VarDecl>(name->getDecl());
    const bool is_local = variable != nullptr && variable->hasLocalStorage() && !variable->getType()->isReferenceType();
    if (!is_local && book_.carriers().holds(value)) effects_.stores = true;
  }

  /// What runs a lambda is found in its definition, but these do so through a pointer.
  void note_run_at_once(const CallExpr& expr, const FunctionDecl& callee) {
    const std::string name = name_of(callee);
    if (name != "std::visit" && name != "std::call_once") return;
    for (const Expr* argument : expr.arguments()) {
      if (const auto* lambda = llvm::dyn_cast<LambdaExpr>(argument->IgnoreUnlessSpelledInSource()))
        run_at_once_.insert(lambda);
    }
  }

  bool suspend(CoroutineSuspendExpr& expr) {
    for (Expr* part : {expr.getCommonExpr(), expr.getReadyExpr(), expr.getSuspendExpr(), expr.getResumeExpr()})
      TraverseStmt(part);
    return true;
  }

  void construct(const CXXConstructorDecl& callee, SourceLocation at, const Given& given) {
    const bool is_generated = callee.isImplicit() || callee.isDefaulted(); // a copy of a task copies its data
    if (is_directors(callee) && !is_generated) return;
    if (is_system(callee)) return effects_.make_of_library(callee, at, given);
    if (!is_generated) return effects_.call(callee, at, at, given.carries, false, false);
    for (const CXXCtorInitializer* part : callee.inits()) go_into(part->getInit(), at);
  }

  /// Reads something that is written elsewhere and runs here: this is its place.
  void go_into(const Stmt* part, SourceLocation here) {
    if (part == nullptr || inside_ == most_parts) return;
    const SourceLocation before = effects_.here;
    if (effects_.here.isInvalid()) effects_.here = here;
    ++inside_;
    TraverseStmt(const_cast<Stmt*>(part));
    --inside_;
    effects_.here = before;
  }

  Book& book_;
  Effects effects_;
  Live live_;
  std::set<const Expr*> callees_;
  std::set<const Expr*> given_; ///< to calls, and what is between that and a cast
  std::set<const LambdaExpr*> run_at_once_;
  int inside_ = 0;
};

/// `return run.keep();`, or `static_cast<void>(run);`
bool does_nothing(const Stmt& statement) {
  if (const auto* cast = llvm::dyn_cast<CXXStaticCastExpr>(&statement))
    return cast->getType()->isVoidType() && llvm::isa<DeclRefExpr>(cast->getSubExpr()->IgnoreParenImpCasts());
  const auto* answer = llvm::dyn_cast<ReturnStmt>(&statement);
  if (answer == nullptr || answer->getRetValue() == nullptr) return false;
  const auto* call = llvm::dyn_cast<CXXMemberCallExpr>(answer->getRetValue()->IgnoreUnlessSpelledInSource());
  const CXXMethodDecl* method = call == nullptr ? nullptr : call->getMethodDecl();
  return method != nullptr && is_directors(*method) && method->getDeclName().isIdentifier() &&
         method->getName() == "keep";
}

/// Whether it is as `directorc stubs` wrote it: with its comment, and nothing but its one statement.
bool is_unwritten(const ASTContext& context, const FunctionDecl& function) {
  const auto* body = llvm::dyn_cast_or_null<CompoundStmt>(function.getBody());
  if (body == nullptr || body->size() != 1 || !does_nothing(*body->body_front())) return false;
  const CharSourceRange range = CharSourceRange::getTokenRange(body->getSourceRange());
  return Lexer::getSourceText(range, context.getSourceManager(), context.getLangOpts())
      .contains(compiler::stubs::unwritten);
}

/// Whether it answers for a body.
bool returns_outcome(const FunctionDecl& function) {
  const CXXRecordDecl* record = function.getReturnType()->getAsCXXRecordDecl();
  return record != nullptr && name_of(*record) == "director::Outcome";
}

} // namespace

void read_function(Book& book, const FunctionDecl& function) {
  BodyReader reader(book, function);
  if (const auto* maker = llvm::dyn_cast<CXXConstructorDecl>(&function)) {
    for (const CXXCtorInitializer* initial : maker->inits()) {
      if (initial->getInit() != nullptr) reader.TraverseStmt(initial->getInit());
    }
  }
  reader.TraverseStmt(function.getBody());
  const SourceLocation at = function.getLocation();
  Json out = Json::object({{"key", Json::text(key_of(function))},
                           {"name", Json::text(name_of(function))},
                           {"at", book.places().of(at, at)}});
  if (const auto* method = llvm::dyn_cast<CXXMethodDecl>(&function)) {
    Json above = Json::list({});
    for (const CXXMethodDecl* each : method->overridden_methods()) above.add(Json::text(key_of(*each)));
    if (!above.items().empty()) out.add("overrides", std::move(above));
    if (promised_by(*method) != nullptr) {
      out.add("context", Json::text(parameter_context(*method)));
      out.add("class", Json::text(name_of(*method->getParent())));
      if (is_unwritten(book.context(), function)) out.add("unwritten", Json::boolean(true));
    }
  }
  if (returns_outcome(function) && reader.reaches_end()) {
    const SourceLocation brace = function.getBody()->getEndLoc();
    out.add("open_end", book.places().of(brace, brace));
  }
  std::move(reader).effects().add_to(out);
  book.functions.push_back(std::move(out));
}

} // namespace director::scanning
