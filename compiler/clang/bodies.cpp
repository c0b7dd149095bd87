// Header: compiler/clang/book.hpp. Test: tests/compiler/clang/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/blocking.hpp"
#include "compiler/clang/book.hpp"
#include "compiler/clang/contexts.hpp"
#include "compiler/clang/endings.hpp"
#include "compiler/clang/live.hpp"
#include "compiler/clang/values.hpp"
#include "compiler/stubs/layout.hpp"

#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/Lex/Lexer.h>

#include <algorithm>

namespace director::scanning {

namespace {

using namespace clang;

constexpr int most_parts = 8; ///< limit for nested objects whose members are examined

class BodyReader : public RecursiveASTVisitor<BodyReader> {
public:
  BodyReader(Book& book, const FunctionDecl& function) : book_(book), values_(book.context()), live_(function) {}

  bool reaches_end() const { return live_.reaches_end(); }

  bool stores = false; ///< a context, in what outlives the function, or in what does not show it
  Json does = Json::list({}), calls = Json::list({}), blocks = Json::list({}), hidden = Json::list({});

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
      call(*body, lambda->getBeginLoc(), lambda->getBeginLoc(), true, run_at_once_.count(lambda) == 0, false);
    } else if (const FunctionTemplateDecl* many = lambda->getDependentCallOperator()) {
      for (const FunctionDecl* each : many->specializations())
        call(*each, lambda->getBeginLoc(), lambda->getBeginLoc(), true, run_at_once_.count(lambda) == 0, false);
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
      stores = true;
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
        hide("a call through a pointer", expr->getBeginLoc(), expr->getEndLoc(), carries);
      return true;
    }
    if (callee->getLocation().isInvalid()) { // built in
      if (const std::string_view why = known_effect(*callee); !why.empty())
        report_block(name_of(*callee), why, expr->getBeginLoc());
      return true;
    }
    const auto* method = llvm::dyn_cast<CXXMethodDecl>(callee);
    if (method != nullptr && object != nullptr && add_word(*expr, *method, *object)) return true;
    const SourceLocation at = name_place(*expr);
    if (is_directors(*callee)) return true;
    const CXXMethodDecl* target = method == nullptr ? nullptr : target_of(*expr, *method);
    if (target != nullptr) callee = target;
    const bool is_virtual = method != nullptr && target == nullptr;
    if (is_system(*callee)) {
      system_call(*expr, *callee, at, carries);
      return true;
    }
    if (callee->isDefaulted()) go_into(callee->getBody(), at); // an assignment
    call(*callee, at, at, carries, false, is_virtual);
    return true;
  }

  bool VisitCXXConstructExpr(CXXConstructExpr* expr) {
    const CXXConstructorDecl& callee = *expr->getConstructor();
    bool carries = false;
    for (const Expr* argument : expr->arguments()) {
      give(argument);
      carries = carries || book_.carriers().has(*argument);
      // Such as std::any.
      if (is_system(callee) && book_.carriers().holds(*argument) && !book_.carriers().holds(expr->getType()))
        stores = true;
    }
    const bool is_given = expr->getNumArgs() > 0 && !callee.isDefaultConstructor() && !callee.isMoveConstructor();
    construct(callee, expr->getBeginLoc(), is_given, carries);
    return true;
  }
  bool VisitCXXInheritedCtorInitExpr(CXXInheritedCtorInitExpr* expr) {
    const CXXConstructorDecl& callee = *expr->getConstructor();
    bool carries = false;
    for (const ParmVarDecl* each : callee.parameters()) carries = carries || book_.carriers().has(each->getType());
    construct(callee, expr->getBeginLoc(), callee.getNumParams() > 0, carries);
    return true;
  }

  bool VisitCXXNewExpr(CXXNewExpr* expr) {
    const FunctionDecl* made_by = expr->getOperatorNew();
    if (made_by == nullptr) return true;
    // In memory that others may know.
    if (made_by->isReservedGlobalPlacementOperator() && book_.carriers().holds(expr->getAllocatedType())) stores = true;
    manage_memory(*made_by, expr->getBeginLoc());
    return true;
  }
  bool VisitCXXDeleteExpr(CXXDeleteExpr* expr) {
    if (const FunctionDecl* freed_by = expr->getOperatorDelete()) manage_memory(*freed_by, expr->getBeginLoc());
    if (!expr->getDestroyedType().isNull()) destroy(expr->getDestroyedType(), expr->getBeginLoc(), true);
    return true;
  }

  // Code that runs without being written: destructors, and parts of loops and of objects.
  bool VisitVarDecl(VarDecl* variable) {
    if (!variable->hasLocalStorage() && variable->getInit() != nullptr && book_.carriers().holds(*variable->getInit()))
      stores = true;
    if (!variable->hasLocalStorage() || llvm::isa<ParmVarDecl>(variable)) return true;
    if (variable->getInit() != nullptr && !live_.runs(variable->getInit())) return true;
    if (variable->isCXXForRangeDecl() && variable->getInit() != nullptr)
      go_into(variable->getInit(), variable->getLocation());
    destroy(variable->getType(), variable->getLocation());
    return true;
  }
  bool VisitDecompositionDecl(DecompositionDecl* several) {
    for (const BindingDecl* each : several->bindings()) {
      if (const VarDecl* held = each->getHoldingVar()) go_into(held->getInit(), each->getLocation());
    }
    return true;
  }
  bool VisitCXXBindTemporaryExpr(CXXBindTemporaryExpr* expr) {
    destroy(expr->getType(), expr->getBeginLoc());
    return true;
  }
  bool VisitCoroutineBodyStmt(CoroutineBodyStmt* coroutine) {
    for (const Stmt* part : coroutine->childrenExclBody()) {
      if (part != coroutine->getDeallocate()) go_into(part, coroutine->getBeginLoc());
    }
    if (const VarDecl* promise = coroutine->getPromiseDecl()) destroy(promise->getType(), coroutine->getBeginLoc());
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
    call(*function, expr->getLocation(), expr->getLocation(), false, true, false);
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
    if (!is_local && book_.carriers().holds(value)) stores = true;
  }

  static SourceLocation name_place(const CallExpr& expr) {
    const Expr* callee = expr.getCallee()->IgnoreParenImpCasts();
    SourceLocation out;
    if (const auto* member = llvm::dyn_cast<MemberExpr>(callee)) out = member->getMemberLoc();
    if (const auto* name = llvm::dyn_cast<DeclRefExpr>(callee)) out = name->getLocation();
    return out.isValid() ? out : expr.getBeginLoc(); // a conversion is called without its name
  }

  bool suspend(CoroutineSuspendExpr& expr) {
    for (Expr* part : {expr.getCommonExpr(), expr.getReadyExpr(), expr.getSuspendExpr(), expr.getResumeExpr()})
      TraverseStmt(part);
    return true;
  }

  void construct(const CXXConstructorDecl& callee, SourceLocation at, bool is_given, bool carries) {
    const bool is_generated = callee.isImplicit() || callee.isDefaulted(); // a copy of a task copies its data
    if (is_directors(callee) && !is_generated) return;
    if (is_system(callee)) return reach(callee, at, is_given);
    if (!is_generated) return call(callee, at, at, carries, false, false);
    for (const CXXCtorInitializer* part : callee.inits()) go_into(part->getInit(), at);
  }

  /// Reads something that is written elsewhere and runs here: this is its place.
  void go_into(const Stmt* part, SourceLocation here) {
    if (part == nullptr || inside_ == most_parts) return;
    const SourceLocation before = here_;
    if (here_.isInvalid()) here_ = here;
    ++inside_;
    TraverseStmt(const_cast<Stmt*>(part));
    --inside_;
    here_ = before;
  }

  /// Reads the user's functions that run when such an object is destroyed. `by_pointer`: or one of a class below.
  void destroy(QualType type, SourceLocation at, bool by_pointer = false) {
    const bool carries = book_.carriers().has(type);
    for (const Ending& each : endings_of(book_.context(), type, by_pointer, !book_.is_deep())) {
      switch (each.kind) {
      case Ending::Kind::own:
      case Ending::Kind::virtual_:
        call(*each.function, at, at, carries, false, each.kind == Ending::Kind::virtual_);
        break;
      case Ending::Kind::library: reach(*each.function, at, false, true); break;
      case Ending::Kind::unread: hide("a deleter that is a template", at, at, carries); break;
      }
    }
  }

  /// Records a use of a context. True: it is one, and nothing else.
  bool add_word(const CallExpr& expr, const CXXMethodDecl& method, const Expr& object) {
    const std::string context = context_of(object.getType());
    if (context.empty() || !method.getDeclName().isIdentifier()) return false;
    const CXXRecordDecl* of = method.getParent();
    const bool is_pack = !is_directors(*of) && context == name_of(*of);
    if (!is_pack && !is_directors(*of)) return false; // a class of the user with a context's functions
    const std::string word = method.getName().str();
    Json fact = Json::object({{"context", Json::text(context)}});
    const SourceLocation at = name_place(expr);
    if (is_pack || word == "request") {
      fact.add("word", Json::text(is_pack ? "pack" : "request"));
      if (is_pack) fact.add("pack", Json::text(word));
      Json tasks = Json::list({});
      for (const Expr* argument : expr.arguments()) tasks.add(Json::text(task_of(argument->getType())));
      fact.add("tasks", std::move(tasks));
      fact.add("at", book_.places().of(at, at));
    } else if (word == "set" || word == "try_set") {
      if (expr.getNumArgs() == 0) return true;
      fact.add("word", Json::text("set"));
      fact.add("state", Json::text(values_.state_of(expr.getArg(0))));
      if (const auto values = values_.of(expr.getArg(0))) {
        Json all = Json::list({});
        for (const Values::Names& names : *values) all.add(Json::texts(names));
        fact.add("values", std::move(all));
      }
      fact.add("at", book_.places().of(at, expr.getEndLoc()));
    } else if (word == "done" || word == "fail" || word == "keep") {
      fact.add("word", Json::text(word));
      fact.add("at", book_.places().of(at, at));
    } else {
      return true;
    }
    does.add(std::move(fact));
    return true;
  }

  /// `soccer::Walk`, also with keep.
  static std::string task_of(QualType type) {
    const CXXRecordDecl* record = bare(type)->getAsCXXRecordDecl();
    if (const auto* special = llvm::dyn_cast_or_null<ClassTemplateSpecializationDecl>(record)) {
      if (is_directors(*special) && special->getTemplateArgs().size() == 1 &&
          special->getTemplateArgs()[0].getKind() == TemplateArgument::Type)
        return task_of(special->getTemplateArgs()[0].getAsType());
    }
    return record == nullptr ? std::string{} : name_of(*record);
  }

  /// One without `auto`: it is read where it is written.
  static bool is_plain_lambda(const Expr& value) {
    const CXXRecordDecl* record = bare(value.getType())->getAsCXXRecordDecl();
    return record != nullptr && record->isLambda() && !record->isGenericLambda();
  }

  void system_call(const CallExpr& expr, const FunctionDecl& callee, SourceLocation at, bool carries) {
    const std::string name = name_of(callee);
    const auto* method = llvm::dyn_cast<CXXMethodDecl>(&callee);
    reach(callee, at, method == nullptr || !method->isMoveAssignmentOperator());
    if (name == "std::function::operator()" || name == "std::move_only_function::operator()")
      hide("a call of a `" + name.substr(0, name.rfind(':') - 1) + "`", at, at, false, true);
    if (carries) {
      static const std::set<std::string> passes_on{"std::forward",
                                                   "std::move",
                                                   "std::ref",
                                                   "std::cref",
                                                   "std::addressof",
                                                   "std::as_const",
                                                   "std::tie",
                                                   "std::get",
                                                   "std::get_if",
                                                   "std::holds_alternative",
                                                   "std::size",
                                                   "std::ssize",
                                                   "std::begin",
                                                   "std::end",
                                                   "std::data",
                                                   "std::empty",
                                                   "std::make_tuple",
                                                   "std::make_pair",
                                                   "std::forward_as_tuple",
                                                   "std::tuple_cat",
                                                   "std::operator==",
                                                   "std::operator!="};
      const bool only_applies =
          (name == "std::apply" || name == "std::invoke") && expr.getNumArgs() > 0 && is_plain_lambda(*expr.getArg(0));
      const bool only_lambdas = std::none_of(expr.arg_begin(), expr.arg_end(), [&](const Expr* argument) {
        return book_.carriers().has_outside_of_lambdas(*argument);
      });
      if (passes_on.count(name) == 0 && !only_lambdas && !only_applies)
        hide("what `" + name + "` does with it", at, at, true);
    }
    // What runs a lambda is found in its definition, but these do so through a pointer.
    if (name != "std::visit" && name != "std::call_once") return;
    for (const Expr* argument : expr.arguments()) {
      if (const auto* lambda = llvm::dyn_cast<LambdaExpr>(argument->IgnoreUnlessSpelledInSource()))
        run_at_once_.insert(lambda);
    }
  }

  /// Records the effects of a function of a system header as if all of them happened at the call. `is_given`: something
  /// that a container may have to hold.
  void reach(const FunctionDecl& callee, SourceLocation at, bool is_given, bool destroys = false) {
    if (!book_.is_deep()) return;
    const Reached& all = book_.reach().of(callee, destroys);
    const std::string name = name_of(callee);
    if (!all.why.empty()) {
      report_block(name, all.why, at);
    } else if (!all.has_definition && !destroys && (grows_container(name, is_given) || returns_container(callee))) {
      report_block(name, "uses the heap", at);
    }
    for (const FunctionDecl* user : all.users) {
      const auto* method = llvm::dyn_cast<CXXMethodDecl>(user);
      call(*user, at, at, false, false, method != nullptr && method->isVirtual());
    }
    for (const FunctionDecl* unknown : all.unknown)
      hide(unknown == &callee ? "`" + name + "`" : "`" + name_of(*unknown) + "`, which `" + name + "` calls", at, at,
           false);
  }

  static bool returns_container(const FunctionDecl& callee) {
    const CXXRecordDecl* record = callee.getReturnType()->getAsCXXRecordDecl();
    return record != nullptr && is_container(name_of(*record)) && name_of(callee) != "std::exchange";
  }

  /// Reads `new` and `delete`, also those of a class.
  void manage_memory(const FunctionDecl& function, SourceLocation at) {
    if (function.isReservedGlobalPlacementOperator()) return;
    if (function.getLocation().isValid() && !is_system(function)) return call(function, at, at, false, false, false);
    report_block(name_of(function), "uses the heap", at);
  }

  void report_block(const std::string& name, std::string_view why, SourceLocation at) {
    if (here_.isValid()) at = here_;
    if (why == "frees") why = "uses the heap";
    blocks.add(Json::object({{"name", Json::text(name)}, {"why", Json::text(why)}, {"at", book_.places().of(at, at)}}));
  }

  void call(const FunctionDecl& callee, SourceLocation begin, SourceLocation end, bool carries, bool maybe,
            bool is_virtual) {
    if (here_.isValid()) begin = end = here_;
    // Functions that the compiler generates have no such code.
    const auto* method = llvm::dyn_cast<CXXMethodDecl>(&callee);
    const bool is_lambda = method != nullptr && method->getParent()->isLambda();
    if (callee.getLocation().isInvalid() || (callee.isDefaulted() && !is_virtual) ||
        (callee.isImplicit() && !is_lambda && !is_virtual))
      return;
    // A lambda that becomes a function pointer: its body is recorded where it is written.
    if (is_lambda && (llvm::isa<CXXConversionDecl>(method) || method->isLambdaStaticInvoker())) return;
    Json fact = Json::object({{"to", Json::text(book_.want(callee))},
                              {"name", Json::text(name_of(callee))},
                              {"at", book_.places().of(begin, end)}});
    const FunctionDecl* body = nullptr;
    if (!callee.hasBody(body)) fact.add("declared", book_.places().of(callee.getLocation(), callee.getLocation()));
    if (carries) fact.add("carries", Json::boolean(true));
    if (maybe) fact.add("maybe", Json::boolean(true));
    if (is_virtual) fact.add("virtual", Json::boolean(true));
    calls.add(std::move(fact));
  }

  /// `if_stored`: it matters only if a context was stored before.
  void hide(std::string what, SourceLocation begin, SourceLocation end, bool carries, bool if_stored = false) {
    Json fact = Json::object({{"what", Json::text(what)}, {"at", book_.places().of(begin, end)}});
    if (if_stored) fact.add("if_stored", Json::boolean(true));
    if (carries) fact.add("carries", Json::boolean(true));
    hidden.add(std::move(fact));
  }

  Book& book_;
  Values values_;
  Live live_;
  std::set<const Expr*> callees_;
  std::set<const Expr*> given_; ///< to calls, and what is between that and a cast
  std::set<const LambdaExpr*> run_at_once_;
  SourceLocation here_; ///< while something is read that is written elsewhere: where it runs
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
  if (reader.stores) out.add("stores", Json::boolean(true));
  const auto add = [&](const char* name, Json& list) {
    if (!list.items().empty()) out.add(name, std::move(list));
  };
  add("does", reader.does);
  add("calls", reader.calls);
  add("blocks", reader.blocks);
  add("hidden", reader.hidden);
  book.functions.push_back(std::move(out));
}

} // namespace director::scanning
